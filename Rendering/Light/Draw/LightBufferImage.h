// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightBufferImage_h
#define interlume_LightBufferImage_h

#include "Lights/LightSource.h"
#include "Plan/SlicePlan.h"

#include <vector>

class vtkImageData;
class vtkLight;
class vtkOpenGLRenderWindow;

namespace interlume
{

class SliceRasterizer;
class UnitSpace;

/**
 * @class   LightBufferImage
 * @brief   reads the light buffers of a picture of slices
 */
class LightBufferImage
{
public:
  /// What the last picture of a rasterizer was drawn with.
  struct Picture
  {
    const SlicePlan& Plan;
    const std::vector<LightSource>& Lights;
    const UnitSpace& Space;
  };

  /// Does what vtkShadowedSliceMapper::ReadLightBuffer documents.
  static bool Read(SliceRasterizer& rasterizer, const Picture& picture,
    vtkOpenGLRenderWindow* window, vtkLight* light, vtkImageData* image);
};

}

#endif
