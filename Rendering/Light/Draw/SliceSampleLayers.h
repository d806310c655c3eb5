// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceSampleLayers_h
#define interlume_SliceSampleLayers_h

#include "Plan/SlicePlan.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace interlume
{

/**
 * @class   SliceSampleLayers
 * @brief   the transmittance from each sample of an area light's emitter to a slice
 *
 * A sample c has a layer T_c in the coordinates of a light at c. The matter of some slabs, the
 * batch, has one transmittance A from the emitter's centre, drawn once for all samples and put into
 * each layer as seen from its sample: T_c(p) <- T_c(p) A(q), q the place in the centre's
 * coordinates of the point that p is in the batch's middle plane. Planes are seen from two places a
 * homography apart. So no layer is resampled from slab to slab, and what is seen is exact for the
 * sample but for the thickness of a batch, whose shadows go apart by no more than a texel. The
 * light's buffer gets the weighted mean of the layers, each seen from its sample in the middle of
 * the next batch. Within that one it is multiplied as that of a light without extent.
 */
class SliceSampleLayers
{
public:
  SliceSampleLayers();
  ~SliceSampleLayers();

  /**
   * Makes empty layers, and the batch, for a sweep. \a channels are those of light. Returns what is
   * wrong, or nothing.
   */
  std::string Prepare(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light, int channels);

  /// Returns the transmittance of the batch, in the coordinates of the light's buffer; slabs
  /// multiply it.
  vtkTextureObject* GetBatch() const { return this->Batch; }
  int GetNumberOfLayers() const { return static_cast<int>(this->Layers.size()); }
  vtkIdType GetBytes() const { return this->Bytes; }

  /**
   * Begins a slab with something in it. Where the batch is full it goes into the layers, and
   * \a buffer gets their mean. Returns the number of passes over layers that this took.
   */
  int Begin(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light, vtkTextureObject* buffer, int slab);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Clear(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* target, vtkTextureObject* map,
    const std::array<double, 16>& targetFromUnit, const std::array<double, 16>& mapFromUnit,
    const std::array<double, 4>& plane, double factor);

  std::vector<vtkSmartPointer<vtkTextureObject>> Layers;
  vtkNew<vtkTextureObject> Batch;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkIdType Bytes = 0;
  /// The number of slabs of a batch, its first slab and the last one that was begun.
  int Period = 1;
  int First = 0;
  int Last = -1;
};

}

#endif
