// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceOcclusion_h
#define interlume_SliceOcclusion_h

#include "vtkNew.h"
#include "vtkType.h"

#include <memory>
#include <string>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   SliceOcclusion
 * @brief   spares fragments behind what is already opaque
 *
 * It keeps a depth buffer beside a buffer of slices: where that buffer lets nothing through any
 * more, the depth buffer gets a depth that nothing is nearer than, so that the test of depth drops
 * what comes behind before its shader runs.
 */
class SliceOcclusion
{
public:
  /// The number of slabs between two looks at the buffer; thick ones cost more to draw.
  static constexpr int Interval = 16;
  static constexpr int ThickInterval = 4;

  /// What a buffer holds.
  enum Contents
  {
    /// In the fourth channel: the picture's.
    OPACITY,
    /// A light's.
    TRANSMITTANCE,
    /// Optical depth times the cosine with the normal, in a half space: a wide light's.
    DEPTH
  };

  SliceOcclusion();
  ~SliceOcclusion();

  /// Gives the depth buffer the framebuffer's size and attaches it to \a framebuffer, which is
  /// bound then. \a hasDepths is the same each time: it tells that slices draw depths of their own,
  /// one for each slab. Returns its bytes.
  vtkIdType Prepare(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
    int width, int height, bool hasDepths);

  /// Clears the depth of the framebuffer that is bound: nothing is opaque.
  static void Clear(vtkOpenGLRenderWindow* window);

  /// Looks at \a buffer.
  void Mark(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, Contents contents);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string QuadFeatures;
};

}

#endif
