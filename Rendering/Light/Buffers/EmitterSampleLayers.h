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
 * @brief   transmittance from each sample of an area light's emitter to a slice
 *
 * Each sample c of the emitter has a layer T_c, in the light buffer coordinates of a light at c.
 * The slabs of a volume are processed in batches. The transmittance A of a batch is drawn once, as
 * seen from the emitter's center, and then multiplied into each layer as seen from the layer's
 * sample: T_c(p) <- T_c(p) A(q)^s. Here q is the position, in the center's coordinates, of the
 * point at p in the batch's middle plane. The exponent s is the path length through a slab on a ray
 * from c, divided by the path length on a ray from the center. Two views of a plane differ by a
 * homography, so layers need no resampling from slab to slab. T_c is exact except that a batch is
 * treated as a plane, which displaces shadows slightly; see LayerBatches.
 *
 * When a batch begins, the oldest pending batch is multiplied into the layers. The light buffer
 * becomes B A1 A2. B is the weighted mean of the layers, each seen from its sample in the middle
 * plane of the new batch. A1 and A2 are the batches that are still pending, with shadows as seen
 * from the center. Layers are interpolated and coarser than the buffer. A batch therefore enters
 * them only when its penumbra is wider than their texels, so that surfaces are not blurred into
 * their own shadows. If a sufficiently wide empty gap precedes the new batch, all earlier batches
 * are multiplied into the layers. Only tiles that contain a medium are drawn.
 */
class EmitterSampleLayers
{
public:
  /// Layers of consecutive samples, stacked vertically in one texture, and the program that
  /// computes their mean.
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
  /// Returns the number of texels of all layers and batches, excluding the light buffer.
  static vtkIdType GetTexels(const SlicePlan::ShadowedLight& light);

  /**
   * Creates empty layers and batches for a sweep through \a polygons. \a polygons and the plan must
   * remain valid. \a channels is the number of color channels of light. If \a isSampledOutside is
   * true, the buffer is also sampled outside the medium. Returns an error if the GPU runs out of
   * memory or a shader cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light, const std::vector<const SlicePolygons*>& polygons,
    int channels, bool isSampledOutside);

  /// Returns the transmittance of the current batch, in the coordinates of the light buffer. Slabs
  /// are multiplied into it. Successive batches use different textures.
  vtkTextureObject* GetBatch() const { return this->Batches[this->Current].Texture; }
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /// Returns the number of columns and rows of a layer.
  int GetLayerSize() const { return this->LayerSize; }
  /// Returns the stacks of layers, in the order of the samples.
  const std::vector<std::unique_ptr<Stack>>& GetStacks() const { return this->Stacks; }
  vtkIdType GetBytes() const { return this->Bytes; }

  /**
   * Begins a nonempty slab. If the slab is the first of a batch, updates \a buffer, changes the
   * texture of GetBatch and returns true. Adds the number of passes drawn to \a passes.
   */
  bool Begin(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int slab, int& passes);

  /// Multiplies all pending batches into the layers. Returns the number of passes drawn.
  int Finish(vtkOpenGLRenderWindow* window);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Transmittance of the slabs of a batch. Number is the index of the batch, or -1 if nothing was
  /// drawn.
  struct Batch
  {
    vtkNew<vtkTextureObject> Texture;
    int Number = -1;
  };

  Error Allocate(
    vtkOpenGLRenderWindow* window, const SlicePlan::ShadowedLight& light, int channels);
  Error Compile(vtkOpenGLRenderWindow* window, int channels);
  void Clear(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);
  /// Multiplies a batch into the layers and clears it. Returns the number of passes drawn.
  int MultiplyIntoLayers(vtkOpenGLRenderWindow* window, Batch& batch);
  /// Draws into \a buffer the product of the pending batches and the mean of the layers, as seen in
  /// the middle plane of batch \a number. Returns the number of passes drawn.
  int DrawMean(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int number);
  /// Draws the tiles of batch \a number, textured with \a map, into the current viewport.
  void DrawTiles(vtkOpenGLRenderWindow* window, SlicePass& pass, vtkTextureObject* map,
    const glm::dmat3& targetFromBuffer, int number);
  void Bind(vtkOpenGLRenderWindow* window, vtkTextureObject* target);

  const SlicePlan::Sweep* Sweep = nullptr;
  const SlicePlan::ShadowedLight* Planned = nullptr;
  std::vector<std::unique_ptr<Stack>> Stacks;
  int NumberOfLayers = 0;
  int LayerSize = 0;
  /// Number of batches before the current one that may be pending: complete, but not yet multiplied
  /// into the layers.
  static constexpr int PendingBatches = 2;
  /// The current batch and the pending ones.
  std::array<Batch, PendingBatches + 1> Batches;
  std::size_t Current = 0;
  /// Number of batches that have begun, and whether any batch has been multiplied into the layers.
  int Begun = 0;
  bool HasLayers = false;
  LayerBatches Plan;
  vtkNew<vtkOpenGLBufferObject> Tiles;
  /// Weighted mean of the layers, at the resolution of one layer.
  vtkNew<vtkTextureObject> Sum;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  SlicePass Fill;
  SlicePass Join;
  vtkIdType Bytes = 0;
};

}

#endif
