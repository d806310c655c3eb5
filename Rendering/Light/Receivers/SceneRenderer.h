// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneRenderer_h
#define interlume_SceneRenderer_h

#include "Casters/PropDepths.h"
#include "Casters/SceneCasters.h"
#include "Lights/LightSource.h"
#include "Receivers/ActorShader.h"
#include "Receivers/LightTransmittance.h"
#include "Receivers/SceneScreens.h"
#include "Receivers/SliceScene.h"

#include "vtkNew.h"
#include "vtkShadowedSceneReport.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

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

  /// Draws the maps of lights. Returns what is wrong, or nothing.
  std::string DrawMaps(vtkRenderer* renderer, vtkShadowedSceneReport& report);
  /// Draws the depth that the eye sees, where there is something to see, for volumes whose light
  /// has so many channels. Returns what is wrong, or nothing.
  std::string DrawEyeDepth(vtkRenderer* renderer, int channels, vtkShadowedSceneReport& report);
  /// What volumes of this frame are drawn with, after DrawEyeDepth.
  SliceScene& GetScene() { return this->Scene; }
  /// Makes the shaders of props; \a isShadowed is false where something was wrong.
  void MakeShader(vtkRenderer* renderer, bool isShadowed, vtkShadowedSceneReport& report);

  /// Binds the textures that shaders of props read.
  void Activate();
  void End();

  ActorShader& GetShader() { return this->Shader; }
  vtkMTimeType GetShaderTime() const { return this->ShaderTime.GetMTime(); }
  /// Sets the uniforms of a prop's program.
  void SetUniforms(vtkShaderProgram* program, vtkProp* prop);
  /// Remembers that the shader of a prop has no place for light of a scene.
  void SetFailed(vtkProp* prop) { this->Failed.insert(prop); }
  /// Returns the opaque actors that are drawn without shadows, each of them once.
  std::vector<vtkProp*> TakeUnreached();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string UpdateContext(vtkOpenGLRenderWindow* window);

  Request Settings;
  std::vector<vtkProp*> Props;
  std::vector<vtkProp*> Casters;
  std::vector<LightSource> Lights;
  SceneCasters Maps;
  PropDepths EyeDepth;
  LightTransmittance Transmittance;
  SceneScreens Screens;
  SliceScene Scene;
  ActorShader Shader;
  vtkTimeStamp ShaderTime;
  bool IsMixed = false;
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
