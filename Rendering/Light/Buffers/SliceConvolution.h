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
 * @brief   soft shadows by convolving the light buffer from slice to slice
 *
 * Implements the method of C. Zhang, dissertation, Ohio State University, 2006, section 2.4. The
 * virtual light, of width L, is the emitter projected onto the plane of the slices. Between the
 * slice of the last convolution, at distance Z from the light, and a slice dZ behind it, the
 * penumbra widens by dx = L dZ / Z (equation 2.14). dx accumulates along each axis of the buffer
 * until it exceeds two texels. The buffer is then convolved with a box whose width is the integer
 * part of dx, and the remainder is retained.
 *
 * The spread of n convolutions with boxes of width w is w sqrt(n / 12), not n w / sqrt(12).
 * Penumbras therefore become narrower as the slice spacing and the texel size decrease.
 */
class SliceConvolution
{
public:
  SliceConvolution();
  ~SliceConvolution();

  /// Prepares a sweep for a light with the given number of color channels. The plan must remain
  /// valid during the sweep. Returns an error if the GPU runs out of memory or the shader cannot be
  /// compiled.
  Error Prepare(vtkOpenGLRenderWindow* window, const LightSource& source,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light, int channels);

  vtkIdType GetBytes() const { return this->Bytes; }

  /// Begins a nonempty slab and convolves \a buffer if the penumbra has widened enough. Returns the
  /// number of passes.
  int Begin(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int slab);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Accumulates the penumbra's width up to \a height along the normal, and convolves the buffer if
  /// the penumbra is wide enough.
  int WidenPenumbra(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, double height);
  void Convolve(
    vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, std::size_t axis, int width);

  LightSource Source;
  const SlicePlan::Sweep* Sweep = nullptr;
  const SlicePlan::ShadowedLight* Planned = nullptr;
  vtkNew<vtkTextureObject> Temporary;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkIdType Bytes = 0;
  /// The last slab that has begun, or -1.
  int Slab = -1;
  /// For each axis, the position of the last convolution along the normal, and the part of the
  /// penumbra's width, in texels, that has not been applied yet.
  std::array<double, 2> Last{};
  std::array<double, 2> Remainder{};
};

}

#endif
