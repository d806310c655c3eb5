// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPieceLight_h
#define vtkPieceLight_h

#include "vtkNew.h"

#include <vector>

class vtkImageData;
class vtkLight;
class vtkMatrix4x4;
class vtkExtinctionGrid;
class vtkProjectiveLight;

/**
 * @class   vtkPieceLight
 * @brief   represents the light that reaches one piece of a volume through the other pieces
 *
 * A vtkProjectiveLight replaces the light while the piece is rendered. Its screen covers the piece.
 * The image on the screen has 128 x 128 samples. Each sample stores the transmittance of the medium
 * outside the piece along one light ray, up to the point where the ray enters the piece. If the
 * light is itself a projective light, the transmittance is multiplied by the color of its screen.
 * Pieces are convex, so no ray reenters a piece.
 */
class vtkPieceLight
{
public:
  vtkPieceLight();
  ~vtkPieceLight();

  /**
   * Returns the light that replaces \a light for the piece in the box \a bounds. The box is in grid
   * coordinates, which \a matrix transforms to world coordinates. Increment \a version when the
   * grid changes. Returns \a light itself in these cases: the medium outside the piece does not
   * attenuate it; no screen can cover the piece, because the light is inside or next to it; or it
   * is an area light with an extent, whose soft shadows would become hard.
   */
  vtkLight* Update(vtkLight* light, const vtkExtinctionGrid& grid, unsigned long version,
    const double bounds[6], vtkMatrix4x4* matrix);

private:
  struct View;

  /// Copies the properties of the light and places the screen.
  void PlaceScreen(vtkLight* light, const View& view);
  /// Fills the image. Returns true if the light is attenuated anywhere.
  bool Fill(vtkLight* light, const View& view, const vtkExtinctionGrid& grid);

  vtkNew<vtkProjectiveLight> Light;
  vtkNew<vtkImageData> Image;
  /// Parameters for which the image was computed.
  std::vector<double> Key;
  bool IsAttenuated = false;
};

#endif
