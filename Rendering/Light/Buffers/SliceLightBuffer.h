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
 * @brief   light buffer: the transmittance from one light to a slice
 *
 * The buffer of a wide light (see SlicePlan) contains optical depth times the cosine between ray
 * and normal.
 */
class SliceLightBuffer
{
public:
  using AllSlices = std::vector<std::unique_ptr<VolumeSlices>>;

  /// \a light is the index of the light in the image's list of lights.
  explicit SliceLightBuffer(int light);
  ~SliceLightBuffer();

  /// Returns the number of texels that soft shadows require in addition to the light buffer.
  static vtkIdType GetNumberOfSoftShadowTexels(const SlicePlan::ShadowedLight& light);

  int GetLight() const { return this->Light; }
  vtkTextureObject* GetTexture() const { return this->Texture; }
  vtkIdType GetBytes() const { return this->Bytes; }
  /// Return the number of layers, and their size in bytes, that soft shadows require in addition to
  /// the buffer.
  int GetNumberOfSampleLayers() const;
  vtkIdType GetSoftShadowBytes() const;
  /// Returns true if a sweep of the image uses the buffer.
  bool IsUsed() const { return this->Bytes > 0; }
  void SetUnused() { this->Bytes = 0; }

  /**
   * Prepares the buffer for a sweep, with a transmittance of 1. \a light is the plan of this
   * light in the sweep. \a polygons are the slices of the volumes that attenuate the light. The
   * plan must remain valid during the sweep. Returns an error if the GPU runs out of memory or a
   * shader cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, const ImageState& image,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
    const std::vector<const SlicePolygons*>& polygons);

  /// Prepares a volume's program if the volume has triangles. Call Prepare first. Returns an error
  /// if the GPU runs out of memory or the program cannot be compiled.
  Error PrepareVolume(vtkOpenGLRenderWindow* window, std::size_t volume, VolumeSlices& slices);

  ///@{
  /// Return a layer: an earlier copy of the buffer without a volume's last slabs, and the first
  /// slab that the copy excludes. Not available for wide lights.
  vtkTextureObject* GetLayer(std::size_t volume) const { return this->Volumes[volume]->Layers[0]; }
  int GetLayerSlab(std::size_t volume) const { return this->Volumes[volume]->LayerSlabs[0]; }
  ///@}
  /// Copies the buffer to a volume's layer if the last layer is old enough. Call this before a slab
  /// is drawn, or skipped because the volume is empty there. Returns true if the layer has changed.
  bool UpdateLayer(int slab, bool isEmpty, std::size_t volume);

  /// Prepares an area light's buffer for a nonempty slab of \a slices, before the slab is drawn.
  /// Returns the number of passes.
  int Begin(vtkOpenGLRenderWindow* window, const AllSlices& slices, int slab);

  /// Returns the layers of an area light's samples, or null if it has none.
  EmitterSampleLayers* GetSampleLayers() const { return this->Samples.get(); }

  /// Multiplies the transmittance of a volume's slab into the buffer and into the other volumes'
  /// layers. Returns the number of passes, or 0 if the slab contains no medium that the light
  /// reaches.
  int Draw(
    vtkOpenGLRenderWindow* window, const SlicePolygons& polygons, int slab, std::size_t volume);

  /// Marks opaque pixels of the buffer in a slab of the volumes \a slices. Fragments behind them
  /// are culled in this slab and the following ones. Does nothing for area lights with soft
  /// shadows: for these, Begin marks the pixels whenever it updates the buffer. Returns the number
  /// of passes.
  int MarkOccluded(vtkOpenGLRenderWindow* window, const AllSlices& slices, int slab);

  /// Returns the texels of the buffer. Sets \a size, the number of columns and rows, and \a
  /// channels. Returns an empty vector for a wide light or an unused buffer.
  std::vector<float> Read(vtkOpenGLRenderWindow* window, int& size, int& channels);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Data of a volume that attenuates the light.
  struct Volume
  {
    SlicePass Slices;
    SlicePass Marks;
    /// Tiles that replace the triangles of the slices: WideTiles for a wide light, otherwise Tiles.
    LightTiles WideTiles;
    PlaneTiles Tiles;
    bool HasTiles = false;
    vtkNew<vtkOpenGLBufferObject> TileVertices;
    /// The older layer, which GetLayer returns, and the newer one, which will replace it.
    std::array<vtkSmartPointer<vtkTextureObject>, 2> Layers;
    std::array<int, 2> LayerSlabs{ { 0, 0 } };
    bool HasLayers = false;
    bool IsLayerSet = false;
  };

  Error PrepareSoftShadows(vtkOpenGLRenderWindow* window, const ImageState& image,
    const std::vector<const SlicePolygons*>& polygons);
  void CopyTo(vtkTextureObject* layer);
  /// Marks opaque pixels of the buffer in a slab. Returns the number of passes.
  int Mark(vtkOpenGLRenderWindow* window, const AllSlices& slices, int slab);
  /// Returns the triangles to draw for a volume with the slices \a polygons.
  const SlabTriangles& GetDrawn(const Volume& volume, const SlicePolygons& polygons) const;
  static void Release(Volume& volume, vtkWindow* window);

  int Light;
  const SlicePlan::Sweep* Sweep = nullptr;
  const SlicePlan::ShadowedLight* Planned = nullptr;
  int Size = 0;
  vtkIdType Bytes = 0;
  vtkNew<vtkTextureObject> Texture;
  std::vector<std::unique_ptr<Volume>> Volumes;
  /// Number of slabs between two updates of a layer.
  int Period = 1;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  /// Framebuffer for drawing other volumes into a layer.
  vtkNew<vtkOpenGLFramebufferObject> LayerFramebuffer;
  SliceOcclusion Occlusion;
  /// Soft shadows of an area light. At most one of these two pointers is set.
  std::unique_ptr<EmitterSampleLayers> Samples;
  std::unique_ptr<SliceConvolution> Convolution;
  bool IsWide = false;
};

}

#endif
