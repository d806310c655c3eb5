// SPDX-License-Identifier: BSD-3-Clause
#include "MixedSceneWindow.h"

#include "Support/Drawing/ShadowImage.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace reference
{

MixedSceneWindow::MixedSceneWindow(const MixedScene& scene, bool isReversed)
  : Stage(scene.Size)
{
  this->Stage.GetVolume()->VisibilityOff();
  for (const SceneVolume& sceneVolume : scene.Volumes)
  {
    ShadowScene shadowScene;
    static_cast<SceneVolume&>(shadowScene) = sceneVolume;
    shadowScene.Shadows = scene.Shadows;
    const auto mapper = vtkSmartPointer<vtkShadowedSliceMapper>::New();
    Configure(mapper, shadowScene);
    mapper->AutoAdjustSampleDistancesOff();
    const auto volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(mapper);
    volume->SetProperty(sceneVolume.Property);
    volume->SetUserMatrix(sceneVolume.Matrix);
    this->Mappers.push_back(mapper);
    this->Volumes.push_back(volume);
  }
  std::vector<vtkSmartPointer<vtkVolume>> ordered = this->Volumes;
  if (isReversed)
  {
    std::reverse(ordered.begin(), ordered.end());
  }
  for (const vtkSmartPointer<vtkVolume>& volume : ordered)
  {
    this->Stage.GetRenderer()->AddVolume(volume);
  }
  for (const SceneSurface& surface : scene.Surfaces)
  {
    this->Stage.AddActor(surface.Actor);
  }
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (const SceneLight& light : scene.Lights)
  {
    lights.push_back(light.Light);
  }
  this->Stage.SetLights(lights);
  this->Stage.SetCamera(scene.Camera);
  this->Stage.SetPass(this->Pass);
}

MixedSceneWindow::~MixedSceneWindow()
{
  this->Pass->ReleaseGraphicsResources(this->Stage.GetWindow());
}

}
