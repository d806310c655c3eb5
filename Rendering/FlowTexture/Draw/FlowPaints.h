// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowPaints_h
#define interlume_FlowPaints_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace interlume
{

class FlowGrid;

/**
 * @class   FlowPaints
 * @brief   which image paints which surface
 *
 * Images are numbered from 1 in the order of ids that they are set for; 0 is the colour of surfaces
 * without an image. An image of several ids has the name of the first, so that images keep theirs
 * when others come and go.
 */
class FlowPaints
{
public:
  using Images = std::map<int, vtkSmartPointer<vtkImageData>>;

  struct Paint
  {
    /// The id, or `all`.
    std::string Name;
    vtkImageData* Image = nullptr;
    /// The texels along u and v.
    std::array<int, 2> Size{};
  };

  /// Finds the images that the grid's surfaces have, and what each surface has.
  void Assign(const Images& images, const FlowGrid& grid);

  std::vector<Paint> Paints;
  /// Four numbers for each label, 0 too: the image's number, whether u and v are periodic, 0.
  std::vector<float> Surfaces;
  /// Grows when Surfaces change.
  vtkMTimeType Version = 0;
  int WithoutTexture = 0;
  /// Whether all surfaces have the same numbers.
  bool IsOne = true;
};

}

#endif
