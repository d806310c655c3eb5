// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneRenderer_h
#define interlume_SceneRenderer_h

#include "Casters/PropDepths.h"
#include "Casters/SceneCasters.h"
#include "Casters/SceneReport.h"
#include "Common/Error.h"
#include "Lights/LightSource.h"
#include "Receivers/ActorShader.h"
#include "Receivers/LightTransmittance.h"
#include "Receivers/SceneFields.h"
#include "Receivers/SceneScreens.h"
#include "Receivers/SliceScene.h"
#include "Translucent/EyeLayers.h"
#include "Translucent/LayerShader.h"
#include "Translucent/PaneMaps.h"

#include "vtkNew.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   SceneRenderer
 * @brief   draws what surfaces and volumes leave of the lights of a scene, before it is drawn
 */
class SceneRenderer
{
public:
  /// The settings of the pass.
  struct Request
  {
    int MaximumNumberOfShadows = 16;
    int Resolution = 1024;
    double Bias = 1.0;
    int Samples = 16;
    int Layers = 16;
    /// Whether a prop casts shadows, and whether it receives them.
    bool (*Casts)(vtkProp* prop) = nullptr;
    bool (*Receives)(vtkProp* prop) = nullptr;
  };

  SceneRenderer();
  ~SceneRenderer();

  /// Finds the props that cast shadows and the lights that they cast them of. Returns whether there
  /// are both, or lights whose light so many \a volumes may take from them, or from each other, or
  /// lights with images.
  bool Begin(vtkRenderer* renderer, const Request& request, int volumes);

  /// Whether volumes are part of the scene: else they are drawn as without it.
  bool HasVolumes() const { return this->IsMixed; }

  /// The props whose shaders are changed: all visible ones that have surfaces.
  std::vector<vtkProp*>& GetProps() { return this->Props; }

  /// Draws the maps of lights, of opaque and translucent surfaces. Returns an error if that fails.
  Error DrawMaps(vtkRenderer* renderer);
  /// Draws the depth that the eye sees, where there is something to see, for volumes whose light
  /// has so many channels. Returns an error if there is no memory for it.
  Error DrawEyeDepth(vtkRenderer* renderer, int channels);

  /**
   * Draws translucent surfaces and volumes in order into one picture, which the volumes show then:
   * \a drawVolumes draws them for GetScene(), \a showVolumes lays what it drew over the framebuffer
   * that is bound. Without translucent surfaces that the eye sees it only calls the first. Returns
   * an error if the surfaces cannot be drawn.
   */
  Error DrawSegments(vtkRenderer* renderer, const std::function<void()>& drawVolumes,
    const std::function<void()>& showVolumes);

  /// What volumes of this frame are drawn with, after DrawEyeDepth.
  SliceScene& GetScene() { return this->Scene; }
  /// Makes the shaders of props. \a isShadowed is false after an error.
  void MakeShader(vtkRenderer* renderer, bool isShadowed);

  /// Binds the textures that shaders of props read.
  void Activate();
  /// Shows what no volume has shown, and unbinds the textures.
  void End(vtkRenderer* renderer);

  /// Marks where sources go, in a shader without VTK's parts.
  static void Mark(std::string& fragmentShader);
  /// Puts the sources in the shader of a prop.
  void Replace(std::string& fragmentShader, vtkProp* prop);
  vtkMTimeType GetShaderTime() const { return this->ShaderTime.GetMTime(); }
  /// Sets the uniforms of a prop's program.
  void SetUniforms(vtkShaderProgram* program, vtkProp* prop);
  /// Returns the opaque actors that are drawn without shadows, each of them once.
  std::vector<vtkProp*> TakeUnreached();
  /// Returns the translucent actors that are drawn before volumes and cast no shadows, each once.
  std::vector<vtkProp*> TakeUnsliced();

  /// Returns the report of the image since Begin, which the pass completes.
  SceneReport& GetReport() { return this->Report; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// The boxes of opaque and of translucent props that cast shadows, and of all props.
  struct Boxes
  {
    std::vector<CasterView::Box> Opaque;
    std::vector<CasterView::Box> Panes;
    std::vector<CasterView::Box> All;
  };

  /// Sorts the visible props of the renderer. Returns whether there are others that hide volumes.
  bool SortProps(vtkRenderer* renderer, Boxes& boxes);
  Error UpdateContext(vtkOpenGLRenderWindow* window);
  Error DrawPanes(vtkRenderer* renderer);
  Error PeelLayers(vtkRenderer* renderer);
  void BeginSegment(std::size_t segment);
  void Deactivate();
  void ShadeLayer(vtkRenderer* renderer, std::size_t layer);
  void UpdateShader(vtkRenderer* renderer, bool isShadowed);
  void ReportFields();

  Request Settings;
  SceneReport Report;
  std::vector<vtkProp*> Props;
  std::vector<vtkProp*> Opaque;
  std::vector<vtkProp*> Panes;
  /// Those of both that cast shadows, and props that receive none.
  std::vector<vtkProp*> Casters;
  std::vector<vtkProp*> PaneCasters;
  std::vector<vtkProp*> Lit;
  std::vector<vtkProp*> Unsliced;
  std::vector<LightSource> Lights;
  SceneCasters Maps;
  PropDepths EyeDepth;
  LightTransmittance Transmittance;
  CasterViews PaneViews;
  PaneMaps PaneLight;
  LayerShader Layering;
  EyeLayers Layers;
  /// What volumes leave of the lights at a layer.
  LightTransmittance LayerLight;
  std::vector<float> OpaqueDepths;
  SceneScreens Screens;
  SceneFields Fields;
  SliceScene Scene;
  ActorShader Shader;
  vtkTimeStamp ShaderTime;
  bool IsMixed = false;
  bool IsLayered = false;
  bool IsOfDepths = false;
  std::vector<vtkTextureObject*> Active;
  vtkNew<vtkTextureObject> Placeholder;
  vtkWeakPointer<vtkWindow> Window;
  std::set<vtkProp*> Reached;
  std::set<vtkProp*> Failed;
  std::set<vtkProp*> Named;
};

}

#endif
