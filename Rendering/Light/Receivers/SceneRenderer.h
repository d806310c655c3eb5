// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneRenderer_h
#define interlume_SceneRenderer_h

#include "Casters/CasterMaps.h"
#include "Casters/CasterViews.h"
#include "Lights/LightSource.h"
#include "Receivers/ActorShader.h"
#include "Receivers/LightTransmittance.h"

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
  };

  SceneRenderer();
  ~SceneRenderer();

  /// Finds the props that cast shadows and the lights that they cast them of. Returns whether there
  /// are both. All are forgotten at the end of the frame, by End.
  bool Begin(vtkRenderer* renderer, const Request& request);

  /// The props whose shaders are changed: all visible ones that have surfaces.
  std::vector<vtkProp*>& GetProps() { return this->Props; }

  /// Draws the maps. Returns what is wrong, or nothing.
  std::string Draw(vtkRenderer* renderer, const Request& request, vtkShadowedSceneReport& report);

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
  bool UpdatePlaceholder(vtkOpenGLRenderWindow* window);

  std::vector<vtkProp*> Props;
  std::vector<vtkProp*> Casters;
  std::vector<LightSource> Lights;
  CasterViews Views;
  CasterMaps Maps;
  LightTransmittance Transmittance;
  ActorShader Shader;
  vtkTimeStamp ShaderTime;
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
