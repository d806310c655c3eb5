// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceLightBuffer_h
#define interlume_SliceLightBuffer_h

#include "Draw/SliceConvolution.h"
#include "Draw/SliceOcclusion.h"
#include "Draw/SlicePass.h"
#include "Draw/SliceSampleLayers.h"
#include "Plan/LightTiles.h"
#include "Plan/SlicePlan.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkWindow;

namespace interlume
{

class SlicePolygons;
class SliceTextures;
struct SliceFrame;

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

  /// Returns the number of textures that a light's soft shadows take beside its buffer.
  static int GetNumberOfSoftBuffers(const SlicePlan::ShadowedLight& light)
  {
    return light.SoftMethod == SlicePlan::LAYERS   ? static_cast<int>(light.Samples.size()) + 1
      : light.SoftMethod == SlicePlan::CONVOLUTION ? 1
                                                   : 0;
  }

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
   * Makes the buffer ready for a sweep: all light passes. \a light is the light of this buffer in
   * the sweep; \a hasLayers says that GetLayer is asked for. Returns what is wrong, or nothing.
   */
  std::string Prepare(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light, SliceTextures& textures,
    vtkOpenGLBufferObject* vertices, bool hasLayers);

  ///@{
  /// Return the buffer as it was some slabs before, and the first slab that is not in it; not for
  /// wide lights.
  vtkTextureObject* GetLayer() const { return this->Layers[0]; }
  int GetLayerSlab() const { return this->LayerSlabs[0]; }
  ///@}
  /// Keeps the buffer as a layer where the last layer is old enough; to be called before a slab is
  /// drawn, or passed over as empty. Returns whether the layer is another one.
  bool KeepLayer(int slab, bool isEmpty);

  /// Makes an area light's buffer ready for a slab with something in it, before that is drawn.
  /// Returns the passes that this took.
  int Begin(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePlan::ShadowedLight& light, int slab);

  /// Returns the layers of an area light's samples, or null where it has none.
  SliceSampleLayers* GetSampleLayers() const { return this->Samples.get(); }

  /// Takes what a slab lets through. Returns whether there is matter for the light to meet.
  bool Draw(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
    const SlicePolygons& polygons, int slab);

  /// Spares what lies behind opaque matter from now on. An area light's buffer is looked at where
  /// its samples are put together instead.
  void MarkOccluded(vtkOpenGLRenderWindow* window);

  /// Reads the texels, \a size times \a size; empty for a light inside the volume.
  std::vector<float> Read(vtkOpenGLRenderWindow* window, int& size, int& channels);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string PrepareSoftShadows(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light);
  void CopyTo(vtkTextureObject* layer);

  int Light;
  int Size = 0;
  vtkIdType Bytes = 0;
  vtkNew<vtkTextureObject> Texture;
  /// The older and the newer layer.
  std::array<vtkSmartPointer<vtkTextureObject>, 2> Layers;
  std::array<int, 2> LayerSlabs{ { 0, 0 } };
  bool IsLayerSet = false;
  /// The number of slabs from layer to layer.
  int Period = 1;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  SlicePass Slices;
  SliceOcclusion Occlusion;
  /// What makes an area light's shadows soft: one of both, or none for other lights.
  std::unique_ptr<SliceSampleLayers> Samples;
  std::unique_ptr<SliceConvolution> Convolution;
  /// Of a wide light, instead of the slices' triangles.
  LightTiles Tiles;
  vtkNew<vtkOpenGLBufferObject> TileVertices;
  bool IsWide = false;
};

}

#endif
