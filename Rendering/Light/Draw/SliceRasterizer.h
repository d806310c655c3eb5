// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceRasterizer_h
#define interlume_SliceRasterizer_h

#include "Draw/CoarsePicture.h"
#include "Draw/SliceFrame.h"
#include "Draw/SliceLightBuffer.h"
#include "Draw/SliceOcclusion.h"
#include "Draw/SlicePart.h"
#include "Draw/SliceReceivers.h"
#include "Draw/SliceTextures.h"
#include "Plan/SlabOrder.h"

#include "vtkImageQuad.h"
#include "vtkNew.h"
#include "vtkPropSelection.h"
#include "vtkShadowedSliceReport.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkHardwareSelector;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

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

  /// Returns why nothing can be drawn in this window, or nothing.
  static std::string FindFault(vtkOpenGLRenderWindow* window);

  /// A volume of a picture.
  struct Volume
  {
    const SliceFrame* Frame;
    SliceTextures* Textures;
  };

  /**
   * Draws all sweeps into the picture's buffer, through volumes that share plan, lights, eye, size
   * and scene, numbered one by one. Returns what is wrong, or nothing. It stops between slabs and
   * returns where \a isAborted.
   */
  std::string Draw(vtkRenderer* renderer, const std::vector<Volume>& volumes,
    const std::function<bool()>& isAborted, vtkShadowedSliceReport& report);

  /// Lays the last picture over the scene. Returns false where there is none.
  bool Show(vtkOpenGLRenderWindow* window);

  /// Shows where the last picture has something of the volume to a selector.
  void ShowSelection(vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window);

  /// Reads the texels of the buffer of \a light of the last picture; empty where there is none.
  std::vector<float> ReadLightBuffer(
    vtkOpenGLRenderWindow* window, int light, int& size, int& channels);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string PrepareImage(
    vtkOpenGLRenderWindow* window, const SliceFrame& frame, vtkShadowedSliceReport& report);
  SliceLightBuffer& GetLightBuffer(int light);
  std::string PrepareLights(
    vtkOpenGLRenderWindow* window, const SliceFrame& frame, std::size_t sweepIndex);
  void ReleaseUnusedLights(vtkWindow* window);
  std::string DrawSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    std::size_t sweepIndex, const std::function<bool()>& isAborted, vtkShadowedSliceReport& report);
  /// Makes the programs of all volumes ready, and finds the order in which they draw.
  std::string PrepareParts(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    std::size_t sweepIndex, vtkShadowedSliceReport& report);
  /// Makes the programs of one volume ready.
  std::string PreparePart(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    std::size_t sweepIndex, std::size_t number, vtkShadowedSliceReport& report);
  /// Binds the textures that all volumes share.
  void ActivateTextures(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    std::size_t sweepIndex, vtkShaderProgram* program, vtkShadowedSliceReport& report);
  void DeactivateTextures();
  /// Attaches the sweep's picture, cleared or with what is before the sweep.
  void BeginSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame, std::size_t sweepIndex,
    vtkShadowedSliceReport& report);
  /// Spares what lies behind the opaque part of the picture from now on.
  void MarkPicture(vtkOpenGLRenderWindow* window);
  /// Whether no volume has something in a slab.
  bool IsEmpty(int slab) const;
  /// Before a slab is drawn, or passed over as empty.
  void KeepLayers(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep, int slab);
  /// Draws a slab with something in it: surfaces of the scene, then each volume into the picture
  /// and into the lights' buffers.
  void DrawSlab(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    const SlicePlan::Sweep& sweep, int slab, vtkShadowedSliceReport& report);
  /// Draws the surfaces of the scene up to the end of a slab.
  void DrawReceivers(vtkOpenGLRenderWindow* window, int slab, vtkShadowedSliceReport& report);
  /// Binds the textures of a volume alone, where there are several.
  void BindPart(vtkOpenGLRenderWindow* window, std::size_t number);
  void AddSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame);

  std::vector<std::unique_ptr<SlicePart>> Parts;
  /// The volume whose textures are bound.
  std::size_t Bound = 0;
  SlabOrder Order;
  vtkNew<vtkOpenGLFramebufferObject> ImageFramebuffer;
  vtkNew<vtkTextureObject> Image;
  vtkNew<vtkTextureObject> SweepImage;
  vtkNew<vtkTextureObject> OpaqueDepth;
  bool HasThickPart = false;
  /// If true, some volume hides what is behind it within few slabs.
  bool IsDense = false;
  /// Whether some volume has two programs, and slices depths of their own.
  bool HasMarks = false;
  bool HasReceivers = false;
  SliceReceivers Receivers;
  SliceOcclusion Occlusion;
  std::vector<std::unique_ptr<SliceLightBuffer>> Lights;
  std::vector<vtkTextureObject*> Active;
  vtkImageQuad Quad;
  vtkImageQuad SumQuad;
  CoarsePicture Coarse;
  vtkPropSelection Selection;
  bool HasOpaqueDepth = false;
  bool HasImage = false;
};

}

#endif
