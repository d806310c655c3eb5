// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceRasterizer_h
#define interlume_SliceRasterizer_h

#include "Buffers/SliceLightBuffer.h"
#include "Buffers/SliceOcclusion.h"
#include "Buffers/VolumeSlices.h"
#include "Common/Error.h"
#include "Offscreen/ImageQuad.h"
#include "Offscreen/PropSelection.h"
#include "Plan/VolumeOrder.h"
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

class RenderProgress;
struct SliceReport;

/**
 * @class   SliceRasterizer
 * @brief   draws the slices of volumes into an image with OpenGL 3.2
 *
 * Several volumes may share the slices. In each slab, the volumes are drawn one after the other,
 * each into the image and then into the light buffers. A volume is therefore in the shadow of the
 * volumes drawn before it. VolumeOrder determines their order.
 *
 * The image buffer contains premultiplied color and opacity in single precision. It stores opacity
 * instead of transmittance because small opacities keep their precision over thousands of thin
 * slices, whereas a transmittance close to 1 would lose it.
 */
class SliceRasterizer
{
public:
  SliceRasterizer();
  ~SliceRasterizer();

  /// Returns an error if the window is not a vtkOpenGLRenderWindow or its OpenGL version is too
  /// old.
  static Error FindError(vtkOpenGLRenderWindow* window);

  /// A volume to draw.
  struct Volume
  {
    const VolumeRenderState* State;
    SliceTextures* Textures;
  };

  /**
   * Draws all sweeps into the image buffer. The Number of each volume's state must be its index in
   * \a volumes. Stops between slabs if \a progress is aborted. Returns an error if the image is
   * incomplete for another reason.
   */
  Error Draw(vtkRenderer* renderer, const ImageState& image, const std::vector<Volume>& volumes,
    RenderProgress& progress, SliceReport& report);

  /// Returns true if the last image was drawn without errors and was not aborted.
  bool IsComplete() const { return this->HasImage; }

  /// Returns true if opaque surfaces occluded volumes in the last image.
  bool IsOccluded() const { return this->Opaque != nullptr; }

  /// Composites the last image over the scene. If the renderer has a hardware selector, draws the
  /// nontransparent pixels in the selector's color instead.
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
  /// Reports the progress before the next slab. Returns true if the image is aborted.
  bool CheckAbort();
  /// Finds the order of the volumes, and sets HasThickPart, IsDense and HasMarks.
  void FindOrder(std::size_t sweepIndex);
  /// Prepares the programs of all volumes.
  Error PrepareVolumes(std::size_t sweepIndex);
  Error PrepareVolume(std::size_t sweepIndex, std::size_t number);
  /// Binds the textures that all volumes share.
  void ActivateTextures(std::size_t sweepIndex, vtkShaderProgram* program);
  void DeactivateTextures();
  void BindImage(vtkTextureObject* image);
  /// Attaches the sweep's image buffer. Clears it unless it contains a sweep in front of this one.
  void BeginSweep(std::size_t sweepIndex);
  /// Marks the opaque pixels of the image in a slab, so that this slab and the following ones are
  /// not drawn there.
  void MarkOpaquePixels(int slab);
  /// Returns true if all volumes are empty in a slab.
  bool IsEmpty(int slab) const;
  /// Updates the layers of the light buffers. Call this before each slab, even if the slab is empty
  /// and therefore not drawn.
  void UpdateLayers(const SlicePlan::Sweep& sweep, int slab);
  /// Draws a nonempty slab: first the surfaces of the scene, then each volume into the image and
  /// into the light buffers.
  void DrawSlab(const SlicePlan::Sweep& sweep, int slab);
  /// Computes the light on the surfaces of the scene up to the end of a slab.
  void DrawReceivers(int slab);
  /// Binds the textures of a volume in place of the bound volume's textures.
  void BindVolume(std::size_t number);
  void AddSweepImage();

  ///@{
  /// Arguments of Draw.
  vtkOpenGLRenderWindow* Window = nullptr;
  const ImageState* State = nullptr;
  RenderProgress* Progress = nullptr;
  SliceReport* Report = nullptr;
  ///@}
  /// Number of slabs of all sweeps, and number of slabs that are complete.
  int Slabs = 0;
  int CompleteSlabs = 0;
  bool IsAborted = false;
  std::vector<std::unique_ptr<VolumeSlices>> Slices;
  /// Index of the volume whose textures are bound.
  std::size_t Bound = 0;
  VolumeOrder Order;
  vtkNew<vtkOpenGLFramebufferObject> ImageFramebuffer;
  vtkNew<vtkTextureObject> Image;
  vtkNew<vtkTextureObject> SweepImage;
  /// Depth of the surfaces that occlude volumes outside a vtkShadowedScenePass. Opaque is the depth
  /// in use: OpaqueDepth, the depth from the vtkShadowedScenePass, or null if no surfaces occlude
  /// volumes.
  vtkNew<vtkTextureObject> OpaqueDepth;
  vtkTextureObject* Opaque = nullptr;
  bool HasThickPart = false;
  /// If true, some volume becomes opaque within a few slabs.
  bool IsDense = false;
  /// If true, each slab is drawn at a separate depth. This is required if a volume has two programs
  /// or if the far plane cuts the volumes.
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
