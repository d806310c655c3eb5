// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfacePaintTextures_h
#define interlume_SurfacePaintTextures_h

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
 * @class   SurfacePaintTextures
 * @brief   assignment of inflow textures to termination surfaces
 *
 * Images are numbered from 1 in the order of the grid's ids. Number 0 means DefaultColor. An image
 * set for several ids is named after the first of them, so that its name does not depend on other
 * images.
 */
class SurfacePaintTextures
{
public:
  using Images = std::map<int, vtkSmartPointer<vtkImageData>>;

  struct Paint
  {
    /// The first surface id that the image is set for, or `all`.
    std::string Name;
    vtkImageData* Image = nullptr;
    /// Number of texels along u and v.
    std::array<int, 2> Size{};
  };

  /// Finds the images for the grid's surfaces, and fills Paints and Surfaces.
  void Assign(const Images& images, const FlowGrid& grid);

  std::vector<Paint> Paints;
  /// Four values per label, including label 0: image number, periodicity of u, periodicity of v,
  /// and 0.
  std::vector<float> Surfaces;
  /// Incremented when Surfaces changes.
  vtkMTimeType Version = 0;
  int WithoutTexture = 0;
  /// Whether all labels except 0 have the same values in Surfaces.
  bool IsUniform = true;
};

}

#endif
