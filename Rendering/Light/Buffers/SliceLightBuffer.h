// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceLightBuffer_h
#define interlume_SliceLightBuffer_h

#include "Buffers/EmitterSampleLayers.h"
#include "Buffers/SliceConvolution.h"
#include "Buffers/SliceOcclusion.h"
#include "Buffers/SlicePass.h"
#include "Common/Error.h"
#include "Plan/LightTiles.h"
#include "Plan/PlaneTiles.h"
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

class VolumeSlices;
class SlicePolygons;
struct ImageState;

/**
 * @class   SliceLightBuffer
 * @brief   the transmittance from one light to a slice
 *
 * A wide light's buffer holds optical depth times the cosine between ray and normal.
 */
class SliceLightBuffer
{
public:
  /// Makes a buffer; \a light is the light's index in the picture's list.
  explicit SliceLightBuffer(int light);
  ~SliceLightBuffer();

  /// Returns the number of texels that a light's soft shadows take beside its buffer.
  static vtkIdType GetSoftTexels(const SlicePlan::ShadowedLight& light);

  int GetLight() const { return this->Light; }
  vtkTextureObject* GetTexture() const { return this->Texture; }
  vtkIdType GetBytes() const { return this->Bytes; }
  /// Returns what an area light's soft shadows have beside the buffer, and their bytes.
  int GetNumberOfSampleLayers() const;
  vtkIdType GetSoftBytes() const;
  /// Returns whether a sweep of the picture uses the buffer.
  bool IsUsed() const { return this->Bytes > 0; }
  void SetUnused() { this->Bytes = 0; }

  /**
   * Prepares the buffer for a sweep: all light passes. \a light is the light of this buffer in the
   * sweep, \a polygons are those of the volumes that attenuate it. The plan must stay valid during
   * the sweep. Returns an error if there is no memory or a shader cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, const ImageState& image,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
    const std::vector<const SlicePolygons*>& polygons);

  /// Prepares a volume's program, if it has triangles, after Prepare. Returns an error as Prepare
  /// does.
  Error PrepareVolume(vtkOpenGLRenderWindow* window, std::size_t volume, VolumeSlices& slices);

  ///@{
  /// Return the buffer without what a volume has taken for some slabs, and the first slab of which
  /// that is not in it; not for wide lights.
  vtkTextureObject* GetLayer(std::size_t volume) const { return this->Volumes[volume]->Layers[0]; }
  int GetLayerSlab(std::size_t volume) const { return this->Volumes[volume]->LayerSlabs[0]; }
  ///@}
  /// Keeps the buffer as a volume's layer where the last layer is old enough; to be called before a
  /// slab is drawn, or passed over as empty of this volume. Returns whether the layer is another
  /// one.
  bool KeepLayer(int slab, bool isEmpty, std::size_t volume);

  /// Makes an area light's buffer ready for a slab with something in it, before that is drawn.
  /// Returns the passes that this took.
  int Begin(vtkOpenGLRenderWindow* window, int slab);

  /// Returns the layers of an area light's samples, or null where it has none.
  EmitterSampleLayers* GetSampleLayers() const { return this->Samples.get(); }

  /// Takes what a volume lets through in a slab, also from the layers of other volumes. Returns the
  /// passes that this took: none where there is no matter for the light to meet.
  int Draw(
    vtkOpenGLRenderWindow* window, const SlicePolygons& polygons, int slab, std::size_t volume);

  /// Spares what lies behind opaque matter from now on. An area light's buffer is looked at where
  /// its samples are put together instead.
  void MarkOccluded(vtkOpenGLRenderWindow* window);

  /// Reads the texels, \a size times \a size; empty for a light inside the volume.
  std::vector<float> Read(vtkOpenGLRenderWindow* window, int& size, int& channels);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// What is kept for a volume that takes from the light.
  struct Volume
  {
    SlicePass Slices;
    /// Of a wide light, or of another one, instead of the slices' triangles.
    LightTiles WideTiles;
    PlaneTiles Tiles;
    bool HasTiles = false;
    vtkNew<vtkOpenGLBufferObject> TileVertices;
    /// The older and the newer layer.
    std::array<vtkSmartPointer<vtkTextureObject>, 2> Layers;
    std::array<int, 2> LayerSlabs{ { 0, 0 } };
    bool HasLayers = false;
    bool IsLayerSet = false;
  };

  Error PrepareSoftShadows(vtkOpenGLRenderWindow* window, const ImageState& image,
    const std::vector<const SlicePolygons*>& polygons);
  void CopyTo(vtkTextureObject* layer);
  /// Returns what is drawn of a volume whose slices have these triangles.
  const SlabTriangles& GetDrawn(const Volume& volume, const SlicePolygons& polygons) const;
  static void Release(Volume& volume, vtkWindow* window);

  int Light;
  const SlicePlan::Sweep* Sweep = nullptr;
  const SlicePlan::ShadowedLight* Planned = nullptr;
  int Size = 0;
  vtkIdType Bytes = 0;
  vtkNew<vtkTextureObject> Texture;
  std::vector<std::unique_ptr<Volume>> Volumes;
  /// The number of slabs from layer to layer.
  int Period = 1;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  /// For layers that other volumes take from.
  vtkNew<vtkOpenGLFramebufferObject> LayerFramebuffer;
  SliceOcclusion Occlusion;
  /// What makes an area light's shadows soft: one of both, or none for other lights.
  std::unique_ptr<EmitterSampleLayers> Samples;
  std::unique_ptr<SliceConvolution> Convolution;
  bool IsWide = false;
};

}

#endif
