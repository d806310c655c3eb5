// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceConvolution_h
#define interlume_SliceConvolution_h

#include "Common/Error.h"
#include "Lights/LightSource.h"
#include "Plan/SlicePlan.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <memory>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   SliceConvolution
 * @brief   soft shadows by convolving a light's buffer from slice to slice
 *
 * This is the method of C. Zhang, dissertation, Ohio State 2006, 2.4: the virtual light, the
 * emitter projected onto the slices' plane, has a penumbra of width dx = L dZ / Z (2.14) between
 * the slice that was convolved last, at Z from the light, and one dZ behind it. Along each axis of
 * the buffer dx is accumulated until it is two texels; then the buffer is convolved with a box of
 * its whole texels, and the rest is kept. What n convolutions with boxes of width w spread is
 * w sqrt(n / 12) and not n w / sqrt(12): penumbrae shrink as slices and texels do.
 */
class SliceConvolution
{
public:
  SliceConvolution();
  ~SliceConvolution();

  /// Begins a sweep for a light with the given number of channels. Returns an error if there is
  /// no memory or the shader cannot be compiled. The plan must stay valid during the sweep.
  Error Prepare(vtkOpenGLRenderWindow* window, const LightSource& source,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light, int channels);

  vtkIdType GetBytes() const { return this->Bytes; }

  /// Begins a slab with something in it: \a buffer is convolved where that is due. Returns the
  /// number of passes that this took.
  int Begin(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int slab);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Accumulates the penumbra as far as \a height along the normal, and convolves where it is wide
  /// enough.
  int Widen(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, double height);
  void Convolve(
    vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, std::size_t axis, int width);

  LightSource Source;
  const SlicePlan::Sweep* Sweep = nullptr;
  const SlicePlan::ShadowedLight* Planned = nullptr;
  vtkNew<vtkTextureObject> Spare;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkIdType Bytes = 0;
  /// The slab that was begun last, or -1.
  int Slab = -1;
  /// Of each axis, where along the normal the buffer was convolved last, and what is left of the
  /// penumbra's width, in texels.
  std::array<double, 2> Last{};
  std::array<double, 2> Rest{};
};

}

#endif
