// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceSampleLayers_h
#define interlume_SliceSampleLayers_h

#include "Common/Vectors.h"
#include "Plan/SlicePlan.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <cstddef>
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
 * each layer as seen from its sample: T_c(p) <- T_c(p) A(q)^s, q the place in the
 * centre's coordinates of the point that p is in the batch's middle plane, s the way through a slab
 * on a ray from c over that on a ray from the centre. Planes are seen from two places a
 * homography apart. So no layer is resampled from slab to slab, and what is seen is exact for the
 * sample but for the thickness of a batch, whose shadows go apart by no more than a texel. The
 * light's buffer gets the weighted mean of the layers, each seen from its sample in the middle of
 * the next batch. Within that one it is multiplied as that of a light without extent. Up to sixteen
 * layers stand one over the other in a texture, and take one pass together.
 */
class SliceSampleLayers
{
public:
  /// Layers from a first sample on, in one texture.
  struct Stack
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    std::size_t First = 0;
    int Layers = 0;
  };

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
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /// Returns all layers, in the order of the samples.
  const std::vector<Stack>& GetStacks() const { return this->Stacks; }
  vtkIdType GetBytes() const { return this->Bytes; }

  /**
   * Begins a slab with something in it. Where the batch is full it goes into the layers, and
   * \a buffer gets their mean. Returns the number of passes over layers that this took.
   */
  int Begin(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light, vtkTextureObject* buffer, int slab);

  /// Puts the last batch into the layers, which then have all matter. Returns the number of passes
  /// over layers that this took.
  int Finish(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Clear(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);
  /// Puts the batch into the layers.
  void FillLayers(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light);
  /// Draws into \a target what the program makes of \a map, with a homography for each layer.
  void Draw(vtkOpenGLRenderWindow* window, vtkOpenGLQuadHelper& quad, vtkTextureObject* target,
    vtkTextureObject* map, const std::vector<glm::dmat3>& homographies);

  std::vector<Stack> Stacks;
  int NumberOfLayers = 0;
  vtkNew<vtkTextureObject> Batch;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  /// The program that puts a batch into layers, and the one that adds layers up.
  std::unique_ptr<vtkOpenGLQuadHelper> Fill;
  std::unique_ptr<vtkOpenGLQuadHelper> Mean;
  vtkIdType Bytes = 0;
  /// The number of slabs of a batch, its first slab and the last one that was begun.
  int Period = 1;
  int First = 0;
  int Last = -1;
};

}

#endif
