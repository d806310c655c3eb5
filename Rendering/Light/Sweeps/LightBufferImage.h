// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightBufferImage_h
#define interlume_LightBufferImage_h

class vtkImageData;
class vtkLight;
class vtkOpenGLRenderWindow;

namespace interlume
{

class SliceRasterizer;
class UnitSpace;
struct ImageState;

/**
 * @class   LightBufferImage
 * @brief   reads the light buffers of an image
 */
class LightBufferImage
{
public:
  /// Implements vtkShadowedSliceMapper::ReadLightBuffer, for the last image of a rasterizer.
  static bool Read(SliceRasterizer& rasterizer, const ImageState& state, const UnitSpace& space,
    vtkOpenGLRenderWindow* window, vtkLight* light, vtkImageData* image);
};

}

#endif
