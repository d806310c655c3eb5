// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPieceLight_h
#define vtkPieceLight_h

#include "vtkNew.h"

#include <vector>

class vtkImageData;
class vtkLight;
class vtkMatrix4x4;
class vtkMatterGrid;
class vtkProjectiveLight;

/**
 * @class   vtkPieceLight
 * @brief   a light as it reaches one piece of a volume, through the pieces of other processes
 *
 * It is a vtkProjectiveLight that takes the place of the light while the piece is drawn: its screen
 * covers the piece, and its image is the transmittance of the matter outside along each ray of the
 * light, up to where the ray enters the piece, times what the light's own screen has, in 128 by 128
 * samples. Since pieces
 * are convex, no ray leaves one and comes back.
 */
class vtkPieceLight
{
public:
  vtkPieceLight();
  ~vtkPieceLight();

  /**
   * Returns the light that shines on the box \a bounds, in coordinates of the grid, which \a matrix
   * takes to the world; \a version changes with the grid. Returns \a light itself where nothing
   * outside takes any of it, and where no screen can cover the piece, as from inside of it, or an
   * area light with an extent, whose shadows would be hard.
   */
  vtkLight* Update(vtkLight* light, const vtkMatterGrid& grid, unsigned long version,
    const double bounds[6], vtkMatrix4x4* matrix);

private:
  struct View;

  void Aim(vtkLight* light, const View& view);
  /// Fills the image; returns whether any of the light is taken.
  bool Fill(vtkLight* light, const View& view, const vtkMatterGrid& grid);

  vtkNew<vtkProjectiveLight> Light;
  vtkNew<vtkImageData> Image;
  /// What the image was made for.
  std::vector<double> Key;
  bool IsUsed = false;
};

#endif
