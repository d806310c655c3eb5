// SPDX-License-Identifier: BSD-3-Clause
// A random sequence of changes to a scene of vtkShadowedSliceMapper: lights, light buffers, data,
// opacities, camera, window. After each change, the frame equals the frame of a new scene. With
// progressive rendering, the refined frame does, and it is shown again if nothing has changed.
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace
{

using namespace reference;

constexpr int Changes = 200;
constexpr int ProgressiveChanges = 40;
constexpr std::size_t MaximumLights = 3;

/// Returns true if some pixel is brighter than the background.
bool IsLit(const RgbaImage& image)
{
  for (std::size_t i = 0; i < image.Values.size(); ++i)
  {
    if (i % 4 != 3 && image.Values[i] > 0.05)
    {
      return true;
    }
  }
  return false;
}

/// Returns a property with opacity steps instead of a ramp. The first step has the opacity \a haze.
vtkSmartPointer<vtkVolumeProperty> MakeStepProperty(double haze)
{
  auto property = MakeTranslucentProperty(0.6, true);
  vtkNew<vtkPiecewiseFunction> steps;
  steps->AddPoint(0.0, 0.0);
  steps->AddPoint(0.2, 0.0);
  steps->AddPoint(0.2 + 1e-5, haze);
  steps->AddPoint(0.4, haze);
  steps->AddPoint(0.4 + 1e-5, 0.99);
  property->SetScalarOpacity(steps);
  return property;
}

/// A scene that can be changed at random, with its mapper and window.
class ChangingScene
{
public:
  ChangingScene(unsigned seed, bool isProgressive)
    : Numbers(seed)
    , Images{ MakeImage(40, MakeSphere(0.15, 0.45)), MakeImage(70, TwoBoxes),
      MakeImage({ { 90, 30, 55 } }, { { 0.02, 0.03, 0.01 } }, MakeSphere(0.2, 0.5)) }
    , Properties{ MakeTranslucentProperty(0.6, true), MakeStepProperty(0.0), MakeStepProperty(0.1) }
    , Scene(MakeScene(this->Images[0], this->Properties[0]))
    , Stage(this->Scene.Size)
  {
    vtkNew<vtkSphereSource> sphere;
    vtkNew<vtkPolyDataMapper> surface;
    surface->SetInputConnection(sphere->GetOutputPort());
    auto ball = vtkSmartPointer<vtkActor>::New();
    ball->SetMapper(surface);
    ball->SetScale(0.3);
    ball->VisibilityOff();
    this->Scene.Actors = { ball };
    this->Scene.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    SetScene(this->Stage, this->Mapper, this->Scene);
    this->Mapper->SetProgressiveRendering(isProgressive);
  }

  /// Applies a random change and returns its name.
  std::string Change()
  {
    const auto& [name, change] = this->Kinds[this->Pick(this->Kinds.size())];
    change();
    return name;
  }

  RgbaImage DrawChanged()
  {
    Configure(this->Mapper, this->Scene);
    this->Stage.GetVolume()->SetProperty(this->Scene.Property);
    this->Stage.SetCamera(this->Scene.Camera);
    this->Stage.SetLights(this->Scene.Lights);
    this->Stage.GetWindow()->SetSize(this->Scene.Size.data());
    return this->Stage.CaptureBytes();
  }

  /// Renders a coarse image and then all passes until the image is final. The next rendering shows
  /// this image again.
  RgbaImage DrawRefined(Check& check)
  {
    vtkRenderWindow* window = this->Stage.GetWindow();
    window->SetDesiredUpdateRate(1e9);
    const RgbaImage coarse = this->DrawChanged();
    this->CoarseFrames += this->Mapper->GetRefinementPending() ? 1 : 0;
    window->SetDesiredUpdateRate(1e-4);
    int passes = 0;
    RgbaImage refined = coarse;
    for (; this->Mapper->GetRefinementPending() && passes < 3; ++passes)
    {
      refined = ReadWindow(window);
    }
    check.That(!this->Mapper->GetRefinementPending(), "the image becomes final");
    const RgbaImage again = ReadWindow(window);
    check.That(again.Values == refined.Values, "the final image is shown again");
    check.Equal(
      this->Mapper->GetReport()->GetCount("ImagePasses"), 0, "nothing is drawn without a change");
    return again;
  }
  int GetCoarseFrames() const { return this->CoarseFrames; }

  RgbaImage DrawNewScene() const
  {
    ShadowScene scene = this->Scene;
    for (vtkSmartPointer<vtkLight>& light : scene.Lights)
    {
      auto copy = vtkSmartPointer<vtkLight>::Take(light->ShallowClone());
      // ShallowClone() does not copy the shadow attenuation.
      copy->SetShadowAttenuation(light->GetShadowAttenuation());
      light = copy;
    }
    scene.Camera = vtkSmartPointer<vtkCamera>::New();
    scene.Camera->DeepCopy(this->Scene.Camera);
    vtkNew<vtkShadowedSliceMapper> mapper;
    mapper->SetLightBufferSize(this->Mapper->GetLightBufferSize());
    mapper->SetSliceSpacing(this->Mapper->GetSliceSpacing());
    VolumeStage stage(scene.Size);
    SetScene(stage, mapper, scene);
    return stage.CaptureBytes();
  }

private:
  std::size_t Pick(std::size_t number)
  {
    return std::min(
      static_cast<std::size_t>(this->Numbers.Get(0.0, static_cast<double>(number))), number - 1);
  }

  vtkLight* PickLight() { return this->Scene.Lights[this->Pick(this->Scene.Lights.size())]; }

  void Move(double distance)
  {
    const Double3 direction = this->Numbers.GetDirection();
    this->PickLight()->SetPosition(
      distance * direction[0], distance * direction[1], distance * direction[2]);
  }

  void Look()
  {
    const bool isParallel = this->Scene.Camera->GetParallelProjection() != 0;
    this->Scene.Camera = LookAt(this->Scene.Image, this->Numbers.GetDirection(), isParallel);
  }

  Random Numbers;
  std::array<vtkSmartPointer<vtkImageData>, 3> Images;
  std::array<vtkSmartPointer<vtkVolumeProperty>, 3> Properties;
  ShadowScene Scene;
  vtkNew<vtkShadowedSliceMapper> Mapper;
  VolumeStage Stage;
  int CoarseFrames = 0;
  std::vector<std::pair<std::string, std::function<void()>>> Kinds = {
    { "light buffer size",
      [this]
      {
        const std::array<int, 4> sizes = { { 0, 64, 200, 500 } };
        this->Mapper->SetLightBufferSize(sizes[this->Pick(sizes.size())]);
      } },
    { "light outside", [this] { this->Move(this->Numbers.Get(1.5, 4.0)); } },
    { "light inside", [this] { this->Move(this->Numbers.Get(0.0, 0.4)); } },
    { "positional or directional light",
      [this]
      {
        vtkLight* light = this->PickLight();
        light->SetPositional(!light->GetPositional());
        light->SetConeAngle(180.0);
      } },
    { "headlight or not",
      [this]
      {
        vtkLight* light = this->PickLight();
        light->SetLightType(
          light->LightTypeIsHeadlight() ? VTK_LIGHT_TYPE_SCENE_LIGHT : VTK_LIGHT_TYPE_HEADLIGHT);
      } },
    { "shadow of a light",
      [this]
      {
        vtkLight* light = this->PickLight();
        light->SetShadowAttenuation(light->GetShadowAttenuation() > 0.0f ? 0.0f : 1.0f);
      } },
    { "one more light",
      [this]
      {
        if (this->Scene.Lights.size() < MaximumLights)
        {
          this->Scene.Lights.push_back(MakeDirectionalLight(this->Numbers.GetDirection()));
        }
      } },
    { "one light fewer",
      [this]
      {
        if (this->Scene.Lights.size() > 1)
        {
          this->Scene.Lights.erase(this->Scene.Lights.begin());
        }
      } },
    { "data",
      [this]
      {
        this->Scene.Image = this->Images[this->Pick(this->Images.size())];
        this->Look();
      } },
    { "opacities",
      [this] { this->Scene.Property = this->Properties[this->Pick(this->Properties.size())]; } },
    { "camera", [this] { this->Look(); } },
    { "projection",
      [this] {
        this->Scene.Camera->SetParallelProjection(!this->Scene.Camera->GetParallelProjection());
      } },
    { "window size",
      [this]
      {
        this->Scene.Size = { { 24 + static_cast<int>(this->Pick(60)),
          24 + static_cast<int>(this->Pick(60)) } };
      } },
    { "slice spacing", [this] { this->Mapper->SetSliceSpacing(this->Pick(2) == 0 ? 0.0 : 0.07); } },
    { "transmission color",
      [this]
      {
        this->Scene.TransmissionColor =
          this->Scene.TransmissionColor ? nullptr : this->Scene.Property->GetRGBTransferFunction();
      } },
    { "opaque surface",
      [this]
      {
        const Double3 direction = this->Numbers.GetDirection();
        this->Scene.Actors[0]->SetPosition(
          0.4 * direction[0], 0.4 * direction[1], 0.4 * direction[2]);
        this->Scene.Actors[0]->SetVisibility(this->Pick(4) > 0 ? 1 : 0);
      } },
    { "position of the volume",
      [this] { this->Scene.Matrix->SetElement(0, 3, this->Numbers.Get(-0.1, 0.1)); } },
    { "clipping plane",
      [this]
      {
        this->Scene.ClippingPlanes.clear();
        if (this->Pick(2) == 0)
        {
          this->Scene.ClippingPlanes.push_back(vtkSmartPointer<vtkPlane>::New());
          this->Scene.ClippingPlanes[0]->SetNormal(this->Numbers.GetDirection().data());
        }
      } },
    { "color of a light",
      [this] { this->PickLight()->SetColor(1.0, this->Numbers.Get(0.5, 1.0), 0.7); } },
    { "selection",
      [this]
      {
        vtkNew<vtkHardwareSelector> selector;
        selector->SetRenderer(this->Stage.GetRenderer());
        selector->SetArea(0, 0, 10, 10);
        selector->CaptureBuffers();
      } },
  };
};

void TestChanges(Check& check, bool isProgressive, int changes)
{
  check.SetContext(isProgressive ? "progressive" : "complete images");
  ChangingScene scene(17, isProgressive);
  int seen = 0;
  std::string name = "no setting";
  for (int i = 0; i < changes; ++i)
  {
    const RgbaImage found = isProgressive ? scene.DrawRefined(check) : scene.DrawChanged();
    check.Near(CompareImages(found, scene.DrawNewScene()).Max, 0.0, 0.0,
      "image " + std::to_string(i) + ", after a change of " + name, 1.0);
    seen += IsLit(found) ? 1 : 0;
    name = scene.Change();
  }
  check.That(seen > changes * 9 / 10, "images show the volume");
  check.That(!isProgressive || scene.GetCoarseFrames() > changes / 2, "coarse images are drawn");
}

}

int TestShadowChanges(int, char*[])
{
  Check check;
  TestChanges(check, false, Changes);
  TestChanges(check, true, ProgressiveChanges);
  return check.Result();
}
