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
 * @brief   draws a picture of slices with OpenGL 3.2, in one window
 *
 * Several volumes may share the slices. In each slab one volume after the other draws into the
 * picture and then takes from the lights' buffers, so that it is lit through what the volumes
 * before it have in the slab, and in their shadow; SlabOrder says which one is first.
 *
 * The picture's buffer holds colour times opacity, and opacity, in floats: with thousands of thin
 * slices little opacity keeps its digits, where a transmittance near 1 would lose them.
 */
class SliceRasterizer
{
public:
  SliceRasterizer();
  ~SliceRasterizer();

  /// Returns an error if nothing can be drawn in this window.
  static Error FindError(vtkOpenGLRenderWindow* window);

  /// A volume of an image.
  struct Volume
  {
    const VolumeRenderState* State;
    SliceTextures* Textures;
  };

  /**
   * Draws all sweeps into the image's buffer, through volumes that are numbered one by one. Stops
   * between slabs if the user aborts. Returns an error if the image is not complete.
   */
  Error Draw(vtkRenderer* renderer, const ImageState& image, const std::vector<Volume>& volumes,
    SliceReport& report);

  /// Returns whether opaque surfaces occluded volumes of the last image.
  bool IsOccluded() const { return this->Opaque != nullptr; }

  /// Lays the last image over the scene, or shows to the renderer's selector where it has something
  /// of the volume.
  void Show(vtkRenderer* renderer);

  /// Implements vtkShadowedSliceMapper::ReadLightBuffer for the last image, which was in \a space.
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
  /// Finds the order in which volumes are drawn, and what some of them need.
  void FindOrder(std::size_t sweepIndex);
  /// Prepares the programs of all volumes.
  Error PrepareVolumes(std::size_t sweepIndex);
  Error PrepareVolume(std::size_t sweepIndex, std::size_t number);
  /// Binds the textures that all volumes share.
  void ActivateTextures(std::size_t sweepIndex, vtkShaderProgram* program);
  void DeactivateTextures();
  void BindImage(vtkTextureObject* image);
  /// Attaches the sweep's image, cleared or with what is before the sweep.
  void BeginSweep(std::size_t sweepIndex);
  /// Culls fragments behind the opaque part of the image from now on.
  void MarkImage();
  /// Returns whether no volume has anything in a slab.
  bool IsEmpty(int slab) const;
  /// Updates layers of light buffers before a slab is drawn, or skipped as empty.
  void KeepLayers(const SlicePlan::Sweep& sweep, int slab);
  /// Draws a slab with something in it: surfaces of the scene, then each volume into the image and
  /// into the lights' buffers.
  void DrawSlab(const SlicePlan::Sweep& sweep, int slab);
  /// Draws the surfaces of the scene up to the end of a slab.
  void DrawReceivers(int slab);
  /// Binds the textures of one volume only, if there are several.
  void BindVolume(std::size_t number);
  void AddSweep();

  ///@{
  /// What Draw is called with.
  vtkOpenGLRenderWindow* Window = nullptr;
  const ImageState* State = nullptr;
  SliceReport* Report = nullptr;
  ///@}
  std::vector<std::unique_ptr<VolumeSlices>> Slices;
  /// The volume whose textures are bound.
  std::size_t Bound = 0;
  SlabOrder Order;
  vtkNew<vtkOpenGLFramebufferObject> ImageFramebuffer;
  vtkNew<vtkTextureObject> Image;
  vtkNew<vtkTextureObject> SweepImage;
  /// The depth of occluding surfaces without a scene, and with or without one; the latter is null
  /// if there are none.
  vtkNew<vtkTextureObject> OpaqueDepth;
  vtkTextureObject* Opaque = nullptr;
  bool HasThickPart = false;
  /// If true, some volume hides what is behind it within few slabs.
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
