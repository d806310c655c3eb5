// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceRasterizer_h
#define interlume_SliceRasterizer_h

#include "Buffers/SliceLightBuffer.h"
#include "Buffers/SliceOcclusion.h"
#include "Buffers/VolumeSlices.h"
#include "Common/Error.h"
#include "Offscreen/ImageQuad.h"
#include "Offscreen/PropSelection.h"
#include "Plan/SlabOrder.h"
#include "Shaders/SliceTextures.h"
#include "Shaders/VolumeRenderState.h"
#include "Sweeps/ImageUpsampler.h"
#include "Sweeps/SliceReceivers.h"

#include "vtkNew.h"

#include <memory>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

struct SliceReport;

/**
 * @class   SliceRasterizer
 * @brief   draws an image of slices with OpenGL 3.2, in one window
 *
 * Several volumes may share the slices. In each slab, one volume after the other draws into the
 * image and then attenuates the light buffers. Each volume is therefore in the shadow of the
 * preceding volumes of the slab. SlabOrder determines the order.
 *
 * The image buffer contains color times opacity, and opacity, in single precision. With thousands
 * of thin slices, small opacities retain their digits, whereas a transmittance close to 1 would
 * lose them.
 */
class SliceRasterizer
{
public:
  SliceRasterizer();
  ~SliceRasterizer();

  /// Returns an error if the window does not support this class.
  static Error FindError(vtkOpenGLRenderWindow* window);

  /// A volume of an image.
  struct Volume
  {
    const VolumeRenderState* State;
    SliceTextures* Textures;
  };

  /**
   * Draws all sweeps into the image's buffer. The volumes must be numbered consecutively. Stops
   * between slabs if the user aborts. Returns an error if the image is not complete.
   */
  Error Draw(vtkRenderer* renderer, const ImageState& image, const std::vector<Volume>& volumes,
    SliceReport& report);

  /// Returns true if opaque surfaces occluded volumes in the last image.
  bool IsOccluded() const { return this->Opaque != nullptr; }

  /// Composites the last image over the scene. If the renderer has a selector, draws the pixels
  /// that contain the volume for it.
  void Show(vtkRenderer* renderer);

  /// Implements vtkShadowedSliceMapper::ReadLightBuffer for the last image, which was drawn in \a
  /// space.
  bool ReadLightBuffer(vtkOpenGLRenderWindow* window, const ImageState& state,
    const UnitSpace& space, vtkLight* light, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetVolumes(const std::vector<Volume>& volumes);
  /// Finds the depth of the surfaces that occlude volumes.
  void UpdateOpaqueDepth(vtkRenderer* renderer);
  Error PrepareImage();
  SliceLightBuffer& GetLightBuffer(int light);
  Error PrepareLights(const SlicePlan::Sweep& sweep);
  void ReleaseUnusedLights();
  Error DrawSweeps();
  Error DrawSweep(std::size_t sweepIndex);
  /// Finds the order of the volumes, and the features that some of them require.
  void FindOrder(std::size_t sweepIndex);
  /// Prepares the programs of all volumes.
  Error PrepareVolumes(std::size_t sweepIndex);
  Error PrepareVolume(std::size_t sweepIndex, std::size_t number);
  /// Binds the textures that all volumes share.
  void ActivateTextures(std::size_t sweepIndex, vtkShaderProgram* program);
  void DeactivateTextures();
  void BindImage(vtkTextureObject* image);
  /// Attaches the sweep's image buffer, which is cleared or contains the sweeps in front.
  void BeginSweep(std::size_t sweepIndex);
  /// Culls fragments behind the opaque part of the image in the following slabs.
  void MarkOpaquePixels();
  /// Returns true if a slab is empty for all volumes.
  bool IsEmpty(int slab) const;
  /// Updates layers of light buffers before a slab is drawn, or is skipped because it is empty.
  void KeepLayers(const SlicePlan::Sweep& sweep, int slab);
  /// Draws a nonempty slab: surfaces of the scene, then each volume into the image and into the
  /// light buffers.
  void DrawSlab(const SlicePlan::Sweep& sweep, int slab);
  /// Draws the surfaces of the scene up to the end of a slab.
  void DrawReceivers(int slab);
  /// Binds the textures of one volume. Does nothing for a single volume.
  void BindVolume(std::size_t number);
  void AddSweep();

  ///@{
  /// Arguments of Draw.
  vtkOpenGLRenderWindow* Window = nullptr;
  const ImageState* State = nullptr;
  SliceReport* Report = nullptr;
  ///@}
  std::vector<std::unique_ptr<VolumeSlices>> Slices;
  /// Index of the volume whose textures are bound.
  std::size_t Bound = 0;
  SlabOrder Order;
  vtkNew<vtkOpenGLFramebufferObject> ImageFramebuffer;
  vtkNew<vtkTextureObject> Image;
  vtkNew<vtkTextureObject> SweepImage;
  /// Depth of occluding surfaces if there is no scene. Opaque is the depth in use: OpaqueDepth, the
  /// scene's depth, or null if no surfaces occlude volumes.
  vtkNew<vtkTextureObject> OpaqueDepth;
  vtkTextureObject* Opaque = nullptr;
  bool HasThickPart = false;
  /// If true, some volume becomes opaque within a few slabs.
  bool IsDense = false;
  /// If true, some volume has two programs, and slices have separate depths.
  bool HasMarks = false;
  bool HasReceivers = false;
  SliceReceivers Receivers;
  SliceOcclusion Occlusion;
  std::vector<std::unique_ptr<SliceLightBuffer>> Lights;
  std::vector<vtkTextureObject*> Active;
  ImageQuad Quad;
  ImageQuad SumQuad;
  ImageUpsampler Upsampler;
  PropSelection Selection;
  bool HasImage = false;
};

}

#endif
