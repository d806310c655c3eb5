// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EmitterSampleLayers_h
#define interlume_EmitterSampleLayers_h

#include "Buffers/SlicePass.h"
#include "Common/Error.h"
#include "Common/Vectors.h"
#include "Plan/LayerBatches.h"
#include "Plan/SlicePlan.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace interlume
{

class SlicePolygons;

/**
 * @class   EmitterSampleLayers
 * @brief   the transmittance from each sample of an area light's emitter to a slice
 *
 * A sample c has a layer T_c in the coordinates of a light at c. The matter of some slabs, a
 * batch, has one transmittance A from the emitter's centre, drawn once for all samples and put into
 * each layer as seen from its sample: T_c(p) <- T_c(p) A(q)^s, q the place in the
 * centre's coordinates of the point that p is in the batch's middle plane, s the way through a slab
 * on a ray from c over that on a ray from the centre. Planes are seen from two places a
 * homography apart. So no layer is resampled from slab to slab, and what is seen is exact for the
 * sample but for the thickness of a batch, whose shadows go apart by Apart texels at most.
 *
 * Where a batch begins, the oldest of those that are kept goes into the layers. The light's buffer
 * becomes B A1 A2: B the weighted mean of the layers, each seen from its sample in the middle of
 * the new batch, and A1 and A2 what is left, which casts the shadows of the centre as the new batch
 * does. So matter goes into layers, which are interpolated and coarser than the buffer, only where
 * its penumbra is wider than their texels: surfaces are not blurred into their own shadows. Behind
 * a gap of matter all of it is in the layers. Only tiles with matter are drawn.
 */
class EmitterSampleLayers
{
public:
  /// Layers from a first sample on, one over the other in one texture, and their mean.
  struct Stack
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    std::size_t First = 0;
    int Layers = 0;
    SlicePass Mean;
  };

  EmitterSampleLayers();
  ~EmitterSampleLayers();

  /// Returns the number of columns and rows of a layer.
  static int GetLayerSize(const SlicePlan::ShadowedLight& light);
  /// Returns the number of texels beside the light's buffer, over all layers and batches.
  static vtkIdType GetTexels(const SlicePlan::ShadowedLight& light);

  /**
   * Creates empty layers and batches for a sweep through \a polygons, which must stay valid as must
   * the plan. \a channels are those of light. If \a isWhole, the buffer is also looked up where
   * there is no medium. Returns an error if there is no memory or a shader cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light, const std::vector<const SlicePolygons*>& polygons,
    int channels, bool isWhole);

  /// Returns the transmittance of the batch, in the coordinates of the light's buffer; slabs
  /// multiply it. It is another texture after each batch.
  vtkTextureObject* GetBatch() const { return this->Batches[this->Current].Texture; }
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /// Returns the number of columns and rows of a layer.
  int GetLayerSize() const { return this->LayerSize; }
  /// Returns all layers, in the order of the samples.
  const std::vector<std::unique_ptr<Stack>>& GetStacks() const { return this->Stacks; }
  vtkIdType GetBytes() const { return this->Bytes; }

  /**
   * Begins a slab with something in it. Where it is the first of a batch, \a buffer is made anew,
   * and GetBatch is another texture. Returns whether it is, and adds the passes that this took.
   */
  bool Begin(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int slab, int& passes);

  /// Puts all batches into the layers, which then have all matter. Returns the number of passes
  /// over layers that this took.
  int Finish(vtkOpenGLRenderWindow* window);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// What the slabs of a batch let through; nothing was drawn where the number is -1.
  struct Batch
  {
    vtkNew<vtkTextureObject> Texture;
    int Number = -1;
  };

  Error Allocate(
    vtkOpenGLRenderWindow* window, const SlicePlan::ShadowedLight& light, int channels);
  Error Compile(vtkOpenGLRenderWindow* window, int channels);
  void Clear(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);
  /// Puts a batch into the layers and empties it.
  int FillLayers(vtkOpenGLRenderWindow* window, Batch& batch);
  /// Draws the mean of the layers as seen in the middle of a batch, and times another one into
  /// \a buffer.
  int DrawMean(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int number);
  /// Draws the tiles of a batch, of what \a map has, into a square of \a target.
  void DrawTiles(vtkOpenGLRenderWindow* window, SlicePass& pass, vtkTextureObject* map,
    const glm::dmat3& targetFromBuffer, int number);
  void Bind(vtkOpenGLRenderWindow* window, vtkTextureObject* target);

  const SlicePlan::Sweep* Sweep = nullptr;
  const SlicePlan::ShadowedLight* Planned = nullptr;
  std::vector<std::unique_ptr<Stack>> Stacks;
  int NumberOfLayers = 0;
  int LayerSize = 0;
  /// The number of batches that are not in the layers yet, beside the one that is drawn.
  static constexpr int Kept = 2;
  /// The batch that is drawn and those before.
  std::array<Batch, Kept + 1> Batches;
  std::size_t Current = 0;
  /// How many batches have begun, and whether one is in the layers.
  int Begun = 0;
  bool HasLayers = false;
  LayerBatches Plan;
  vtkNew<vtkOpenGLBufferObject> Tiles;
  /// The mean of the layers, as large as a layer.
  vtkNew<vtkTextureObject> Sum;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  SlicePass Fill;
  SlicePass Join;
  vtkIdType Bytes = 0;
};

}

#endif
