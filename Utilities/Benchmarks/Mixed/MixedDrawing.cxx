// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedDrawing.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace mixed
{
namespace
{
vtkSmartPointer<vtkRenderPass> MakeShadowMaps(int resolution)
{
  vtkNew<vtkShadowMapPass> shadows;
  shadows->GetShadowMapBakerPass()->SetResolution(static_cast<unsigned int>(resolution));
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  return camera;
}

/// Returns a copy of \a actor with a new mapper, so that each window has its own graphics
/// resources.
vtkSmartPointer<vtkActor> Copy(vtkActor* actor)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(actor->GetMapper()->GetInputConnection(0, 0));
  mapper->ScalarVisibilityOff();
  auto copy = vtkSmartPointer<vtkActor>::New();
  copy->ShallowCopy(actor);
  copy->SetMapper(mapper);
  return copy;
}
}

Drawing::Drawing(const reference::MixedScene& scene, Method method, int resolution)
  : Scene(scene)
  , Stage(scene.Size)
{
  vtkRenderer* renderer = this->Stage.GetRenderer();
  this->Stage.GetVolume()->VisibilityOff();
  for (const reference::SceneVolume& one : scene.Volumes)
  {
    vtkNew<vtkShadowedSliceMapper> mapper;
    mapper->SetInputData(one.Image.Get());
    mapper->AutoAdjustSampleDistancesOff();
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->SetProperty(one.Property);
    renderer->AddVolume(volume);
    this->Slices = this->Slices ? this->Slices : vtkSmartPointer<vtkShadowedSliceMapper>(mapper);
  }
  for (const reference::SceneSurface& surface : scene.Surfaces)
  {
    this->Stage.AddActor(Copy(surface.Actor));
  }
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (const reference::SceneLight& light : scene.Lights)
  {
    lights.push_back(light.Light);
    this->Positions.emplace_back();
    light.Light->GetPosition(this->Positions.back().data());
  }
  this->SetLights(lights);
  this->SetCamera(scene.Camera);
  if (method == Method::ScenePass)
  {
    this->ScenePass = vtkSmartPointer<vtkShadowedScenePass>::New();
    this->ScenePass->SetDepthMapResolution(resolution);
    this->Pass = this->ScenePass;
  }
  else if (method == Method::ShadowMaps)
  {
    this->Pass = MakeShadowMaps(resolution);
  }
  else
  {
    this->Pass = vtkSmartPointer<vtkRenderStepsPass>::New();
  }
}

Drawing::~Drawing()
{
  this->Pass->ReleaseGraphicsResources(this->Stage.GetWindow());
}

reference::RgbaImage Drawing::Capture()
{
  this->Stage.SetPass(this->Pass);
  return this->Stage.Capture(2);
}

void Drawing::MoveLights()
{
  const double angle = vtkMath::RadiansFromDegrees(0.2 * (this->Frames % 40));
  for (std::size_t i = 0; i < this->Positions.size(); ++i)
  {
    const reference::Double3& from = this->Positions[i];
    this->Scene.Lights[i].Light->SetPosition(std::cos(angle) * from[0] - std::sin(angle) * from[1],
      std::sin(angle) * from[0] + std::cos(angle) * from[1], from[2]);
  }
}

BenchWork Drawing::GetFrame(int threads, bool areLightsMoved)
{
  return WithThreads(threads,
    [this, areLightsMoved]()
    {
      vtkNew<vtkCamera> moved;
      moved->DeepCopy(this->Scene.Camera);
      moved->Azimuth(0.5 * (++this->Frames % 40));
      this->SetCamera(moved);
      if (areLightsMoved)
      {
        this->MoveLights();
      }
      this->Stage.GetRenderer()->SetPass(this->Pass);
      this->Stage.GetWindow()->Render();
      this->Stage.GetWindow()->WaitForCompletion();
      return vtkSmartPointer<vtkObjectBase>(this->Pass);
    });
}

vtkInterlumeReport* Drawing::GetReport() const
{
  return this->ScenePass ? this->ScenePass->GetReport() : nullptr;
}
}
