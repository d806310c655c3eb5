// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceRasterizer_h
#define interlume_SliceRasterizer_h

#include "Draw/SliceFrame.h"
#include "Draw/SliceLightBuffer.h"
#include "Draw/SliceOcclusion.h"
#include "Draw/SlicePass.h"
#include "Draw/SliceReceivers.h"
#include "Draw/SliceTextures.h"
#include "Plan/SlicePolygons.h"

#include "vtkImageQuad.h"
#include "vtkNew.h"
#include "vtkShadowedSliceReport.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
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

  SliceTextures& GetTextures() { return this->Textures; }

  /**
   * Draws all sweeps into the picture's buffer. Returns what is wrong, or nothing. It stops between
   * slabs and returns where \a isAborted.
   */
  std::string Draw(vtkRenderer* renderer, const SliceFrame& frame,
    const std::function<bool()>& isAborted, vtkShadowedSliceReport& report);

  /// Lays the last picture over the scene. Returns false where there is none.
  bool Show(vtkOpenGLRenderWindow* window);

  /// Shows where the last picture has something of the volume, in one colour, for a selection.
  void ShowSelection(vtkOpenGLRenderWindow* window, const std::array<float, 3>& color);

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
  std::string PrepareEye(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    std::size_t sweepIndex, vtkShadowedSliceReport& report);
  /// Makes the surfaces of the scene ready, where there is one.
  std::string BeginReceivers(
    vtkOpenGLRenderWindow* window, const SliceFrame& frame, std::size_t sweepIndex);
  void ActivateTextures(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    std::size_t sweepIndex, vtkShaderProgram* program, vtkShadowedSliceReport& report);
  void DeactivateTextures();
  /// Attaches the sweep's picture, cleared or with what is before the sweep.
  void BeginSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame, std::size_t sweepIndex,
    vtkShadowedSliceReport& report);
  /// Spares what lies behind the opaque part of the picture from now on.
  void MarkPicture(vtkOpenGLRenderWindow* window);
  /// Before a slab is drawn, or passed over as empty.
  void KeepLayers(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep, int slab);
  void DrawEyeSlab(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
    const SlicePlan::Sweep& sweep, int slab);
  /// Marks what is already opaque. Returns the passes that this took.
  int MarkOccluded(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep);
  void AddSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame);

  SliceTextures Textures;
  SlicePolygons Polygons;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkNew<vtkOpenGLFramebufferObject> ImageFramebuffer;
  vtkNew<vtkTextureObject> Image;
  vtkNew<vtkTextureObject> SweepImage;
  vtkNew<vtkTextureObject> OpaqueDepth;
  /// All matter, or all that is thin, or none, where the thick has a program of its own.
  SlicePass Eye;
  SlicePass ThickEye;
  bool HasThickPart = false;
  bool HasThinPart = true;
  SliceReceivers Receivers;
  SliceOcclusion Occlusion;
  std::vector<std::unique_ptr<SliceLightBuffer>> Lights;
  std::vector<vtkTextureObject*> Active;
  vtkImageQuad Quad;
  vtkImageQuad SumQuad;
  vtkImageQuad SelectionQuad;
  bool HasOpaqueDepth = false;
  bool HasImage = false;
};

}

#endif
