// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneRenderer_h
#define interlume_SceneRenderer_h

#include "ShadowMaps/PropDepths.h"
#include "ShadowMaps/SceneOccluders.h"
#include "ShadowMaps/SceneReport.h"
#include "Common/Error.h"
#include "Lights/LightSource.h"
#include "Receivers/ActorShader.h"
#include "Receivers/LightTransmittance.h"
#include "Receivers/SceneScatteredLight.h"
#include "Receivers/SceneLightImages.h"
#include "Receivers/SliceScene.h"
#include "Translucent/CameraLayers.h"
#include "Translucent/LayerShader.h"
#include "Translucent/TranslucentShadowMaps.h"

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
 * @brief   renders the shadows of a scene's surfaces and volumes before the scene is drawn
 */
class SceneRenderer
{
public:
  /// Settings of the pass.
  struct Request
  {
    int MaximumNumberOfShadowLights = 16;
    int Resolution = 1024;
    double Bias = 1.0;
    int Samples = 16;
    int Layers = 16;
    /// Return true if a prop casts or receives shadows, respectively.
    bool (*Casts)(vtkProp* prop) = nullptr;
    bool (*Receives)(vtkProp* prop) = nullptr;
    /// Returns true if a prop casts shadows even if it is invisible.
    bool (*CastsWhenInvisible)(vtkProp* prop) = nullptr;
  };

  SceneRenderer();
  ~SceneRenderer();

  /// Finds the props that cast shadows and the lights of the scene. Returns true if this pass
  /// is needed: surfaces cast shadows, volumes must be drawn together with surfaces or with each
  /// other, or lights have images. \a volumes is the number of volumes.
  bool Begin(vtkRenderer* renderer, const Request& request, int volumes);

  /// Returns true if volumes are rendered as a part of the scene. Otherwise they are drawn as if
  /// the pass did not exist.
  bool HasVolumes() const { return this->IsMixed; }

  /// Returns the props whose shaders are modified: all props with surfaces that are visible or cast
  /// shadows.
  std::vector<vtkProp*>& GetProps() { return this->Props; }

  /// Draws the shadow maps of opaque and translucent surfaces. Returns an error if the maps cannot
  /// be drawn.
  Error DrawShadowMaps(vtkRenderer* renderer);
  /// Draws the depth buffer of the camera's view if there are surfaces. \a channels is the number
  /// of color channels of the volumes' light. Returns an error if the GPU runs out of memory.
  Error DrawEyeDepth(vtkRenderer* renderer, int channels);

  /**
   * Draws translucent surfaces and volumes in depth order into one image, which the volumes then
   * show. \a drawVolumes draws the volumes for GetScene(). \a showVolumes composites the result
   * over the bound framebuffer. If no translucent surfaces are in view, only calls \a drawVolumes.
   * Returns an error if the surfaces cannot be drawn.
   */
  Error DrawInDepthOrder(vtkRenderer* renderer, const std::function<void()>& drawVolumes,
    const std::function<void()>& showVolumes);

  /// Returns the input and output of the volumes in this frame. Call DrawEyeDepth first.
  SliceScene& GetScene() { return this->Scene; }
  /// Updates the shaders of props. Pass false for \a isShadowed after an error.
  void UpdatePropShaders(vtkRenderer* renderer, bool isShadowed);

  /// Binds the textures that the shaders of props read.
  void Activate();
  /// Shows the image from DrawSegments if no volume has shown it, and unbinds the textures.
  void End(vtkRenderer* renderer);

  /// Marks where Replace inserts GLSL code. Call this before VTK replaces its tags.
  static void Mark(std::string& fragmentShader);
  /// Inserts the GLSL code for lights and layers into the shader of a prop.
  void Replace(std::string& fragmentShader, vtkProp* prop);
  vtkMTimeType GetShaderTime() const { return this->ShaderTime.GetMTime(); }
  /// Sets the uniforms of a prop's shader program.
  void SetUniforms(vtkShaderProgram* program, vtkProp* prop);
  /// Returns the opaque actors on which shadows could not be drawn. Each actor is returned only
  /// once.
  std::vector<vtkProp*> PopUnshadowedActors();
  /// Returns the translucent actors that are drawn before volumes and cast no shadows. Each actor
  /// is returned only once.
  std::vector<vtkProp*> PopNonPeelableActors();

  /// Returns the report of the frame that Begin started. vtkShadowedScenePass completes it.
  SceneReport& GetReport() { return this->Report; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Bounding boxes of opaque props that cast shadows, of translucent props that cast shadows, and
  /// of all props.
  struct Boxes
  {
    std::vector<ShadowMapView::Box> Opaque;
    std::vector<ShadowMapView::Box> Translucent;
    std::vector<ShadowMapView::Box> All;
  };

  /// Sorts the renderer's props that are visible or cast shadows into the lists of this class.
  /// Returns true if props without surfaces can hide volumes.
  bool SortProps(vtkRenderer* renderer, Boxes& boxes);
  Error UpdateContext(vtkOpenGLRenderWindow* window);
  Error DrawTranslucentShadowMaps(vtkRenderer* renderer);
  Error PeelLayers(vtkRenderer* renderer);
  void BeginSegment(std::size_t segment);
  void Deactivate();
  void ShadeLayer(vtkRenderer* renderer, std::size_t layer);
  void UpdateShader(vtkRenderer* renderer, bool isShadowed);
  void ReportScattering();

  Request Settings;
  SceneReport Report;
  std::vector<vtkProp*> Props;
  std::vector<vtkProp*> Opaque;
  std::vector<vtkProp*> Translucent;
  /// Opaque props that cast shadows, translucent props that cast shadows, and props that receive no
  /// shadows.
  std::vector<vtkProp*> Occluders;
  std::vector<vtkProp*> TranslucentOccluders;
  std::vector<vtkProp*> NonReceivers;
  std::vector<vtkProp*> Unsliced;
  std::vector<LightSource> Lights;
  SceneOccluders Maps;
  PropDepths CameraDepth;
  LightTransmittance Transmittance;
  ShadowMapViews TranslucentViews;
  TranslucentShadowMaps TranslucentMaps;
  LayerShader Layering;
  CameraLayers Layers;
  /// Transmittance of volumes from each light to the surfaces of a translucent layer.
  LightTransmittance LayerLight;
  std::vector<float> OpaqueDepths;
  SceneLightImages Screens;
  SceneScatteredLight Fields;
  SliceScene Scene;
  ActorShader Shader;
  vtkTimeStamp ShaderTime;
  bool IsMixed = false;
  bool IsLayered = false;
  bool IsDepthOnly = false;
  std::vector<vtkTextureObject*> Active;
  vtkNew<vtkTextureObject> Placeholder;
  vtkWeakPointer<vtkWindow> Window;
  std::set<vtkProp*> Reached;
  std::set<vtkProp*> Failed;
  std::set<vtkProp*> Reported;
};

}

#endif
