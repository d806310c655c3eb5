// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceOcclusion_h
#define interlume_SliceOcclusion_h

#include "vtkNew.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

class SlicePass;

/**
 * @class   SliceOcclusion
 * @brief   culls fragments behind opaque samples
 *
 * This class maintains a depth buffer for an image or light buffer of slices. It writes the nearest
 * depth at the pixels where that buffer is opaque. The depth test then rejects later fragments
 * before their shader runs.
 */
class SliceOcclusion
{
public:
  /// Number of slabs between two updates. ThickInterval applies if slabs have thick fragments or a
  /// dense medium and therefore cost more to draw.
  static constexpr int Interval = 16;
  static constexpr int ThickInterval = 4;

  /// Meaning of a buffer's texels.
  enum Contents
  {
    /// Opacity in the fourth channel: an image buffer.
    OPACITY,
    /// Transmittance: a light buffer.
    TRANSMITTANCE,
    /// Optical depth times the cosine between ray and normal: the buffer of a wide light.
    DEPTH
  };

  SliceOcclusion();
  ~SliceOcclusion();

  /// Resizes the depth buffer to the framebuffer's size, attaches it to \a framebuffer and binds
  /// that framebuffer. If \a hasDepths is true, slices write one depth per slab. \a hasDepths must
  /// not change between calls. Returns the size of the depth buffer in bytes.
  vtkIdType Prepare(vtkOpenGLRenderWindow* window, vtkOpenGLFramebufferObject* framebuffer,
    int width, int height, bool hasDepths);

  /// Clears the depth of the bound framebuffer, so that no pixel counts as opaque.
  static void Clear(vtkOpenGLRenderWindow* window);

  /// Returns the fragment shader of a pass that marks the opaque pixels of a buffer. \a channels is
  /// the number of color channels of light.
  static std::string GetShaderSource(Contents contents, int channels);

  /// Marks the pixels of \a buffer that are opaque and inside the triangles of a slab. \a pass and
  /// \a starts are as in SlicePass. \a clipFromUnit is the matrix of the slices drawn into \a
  /// buffer.
  void Mark(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, const glm::dmat4& clipFromUnit,
    SlicePass& pass, const std::vector<std::size_t>& starts, int slab);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};

}

#endif
