// SPDX-License-Identifier: BSD-3-Clause
// A random sequence of changes to a scene with vtkShadowedScenePass: lights, actors, smoke, window,
// settings of pass and mapper. After each change, the frame equals the frame of a new pass, new
// mappers and new actors.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string>

namespace
{
using namespace reference;

struct State
{
  double LightSize = 0.5;
  int Shape = vtkAreaLight::ROUND;
  std::array<double, 3> LightPosition{ { 0.6, 0.3, 2.0 } };
  bool IsPositional = true;
  bool HasSun = false;
  std::array<double, 3> SpherePosition{ { 0.1, 0.0, 0.1 } };
  bool HasPlate = true;
  bool HasSmoke = true;
  double Opacity = 0.1;
  int Pixels = 48;
  int Method = vtkShadowedSliceMapper::SAMPLE_LAYERS;
  int Samples = 4;
  int MapperSamples = 4;
  int Resolution = 256;
  double Bias = 1.0;
};

// A scene that can be drawn in any state. The test compares a scene that is reused for many states
// with a new scene for each state.
class Scene
{
public:
  Scene()
    : Stage(48)
  {
    this->Stage.Add(
      MakeRectangle({ { -2.0, -2.0, -0.5 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }));
    this->Sphere = MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.25, 24);
    this->Plate = MakeBox({ { -0.7, -0.1, -0.4, 0.4, 0.5, 0.55 } });
    this->Stage.Add(this->Sphere);
    this->Stage.Add(this->Plate);
    this->Stage.AddSmoke({ { -0.4, 0.4, -0.4, 0.4, -0.3, 0.3 } }, 1.5, 8);
    this->Stage.LookAlong({ { 0.1, 0.7, -1.0 } });
    this->Sun = MakeSun({ { -0.5, 0.3, -1.0 } });
  }

  RgbaImage Draw(const State& state)
  {
    this->Light->SetSize(state.LightSize, state.LightSize);
    this->Light->SetShape(state.Shape);
    this->Light->SetPosition(state.LightPosition.data());
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Light->SetPositional(state.IsPositional);
    this->Light->SetConeAngle(180.0);
    this->Stage.Stage.SetLights({ this->Light.Get() });
    if (state.HasSun)
    {
      this->Stage.Stage.SetLights({ this->Light.Get(), this->Sun });
    }
    this->Sphere->SetPosition(
      state.SpherePosition[0], state.SpherePosition[1], state.SpherePosition[2]);
    this->Plate->SetVisibility(state.HasPlate);
    vtkVolume* volume = this->Stage.Stage.GetVolume();
    volume->SetVisibility(state.HasSmoke);
    vtkPiecewiseFunction* opacity = volume->GetProperty()->GetScalarOpacity();
    if (opacity->GetValue(1.0) != state.Opacity)
    {
      opacity->RemoveAllPoints();
      opacity->AddPoint(0.0, state.Opacity);
      opacity->AddPoint(2.0, state.Opacity);
    }
    this->Stage.Stage.GetWindow()->SetSize(state.Pixels, state.Pixels);
    this->Stage.Mapper->SetSoftShadowMethod(state.Method);
    this->Stage.Mapper->SetNumberOfLightSamples(state.MapperSamples);
    this->Stage.Pass->SetNumberOfLightSamples(state.Samples);
    this->Stage.Pass->SetDepthMapResolution(state.Resolution);
    this->Stage.Pass->SetDepthBias(state.Bias);
    return this->Stage.Draw();
  }

  SceneStage Stage;

private:
  vtkSmartPointer<vtkActor> Sphere;
  vtkSmartPointer<vtkActor> Plate;
  vtkSmartPointer<vtkLight> Sun;
  vtkNew<vtkAreaLight> Light;
};

}

int TestSceneChanges(int, char*[])
{
  constexpr int changes = 29;
  Check check;
  Random numbers(5);
  const auto pick = [&numbers](int number)
  { return std::min(static_cast<int>(numbers.Get(0.0, number)), number - 1); };
  State state;
  Scene reused;
  int soft = 0;
  for (int i = 0; i < changes; ++i)
  {
    const RgbaImage found = reused.Draw(state);
    soft += reused.Stage.GetReport()->GetNumber("SampleMaps") > 0 ? 1 : 0;
    Scene fresh;
    check.Near(
      CompareImages(found, fresh.Draw(state)).Max, 0.0, 0.0, "image " + std::to_string(i), 1.0);
    switch (i % 14)
    {
      case 0:
        state.LightSize = i == 0 ? 0.0 : 0.8;
        break;
      case 1:
        state.Shape = pick(2);
        break;
      case 2:
        state.LightPosition = { { numbers.Get(-1.0, 1.0), numbers.Get(-1.0, 1.0),
          numbers.Get(0.5, 2.5) } };
        break;
      case 3:
        state.IsPositional = !state.IsPositional;
        break;
      case 4:
        state.HasSun = !state.HasSun;
        break;
      case 5:
        state.SpherePosition = { { numbers.Get(-0.5, 0.5), numbers.Get(-0.5, 0.5),
          numbers.Get(-0.2, 0.3) } };
        break;
      case 6:
        state.HasPlate = !state.HasPlate;
        break;
      case 7:
        state.HasSmoke = !state.HasSmoke;
        break;
      case 8:
        state.Opacity = numbers.Get(0.05, 0.3);
        break;
      case 9:
        state.Pixels = 32 + 8 * pick(4);
        break;
      case 10:
        state.Method = pick(3);
        break;
      case 11:
        state.Samples = 1 << pick(5);
        break;
      case 12:
        state.MapperSamples = state.Samples;
        break;
      default:
        state.Resolution = 64 << pick(4);
        state.Bias = 0.5 * (1 + pick(4));
        break;
    }
  }
  std::cout << soft << " images of " << changes << " with soft shadows on surfaces\n";
  check.That(soft > changes / 3 && soft < changes, "some images have soft shadows");
  return check.Result();
}
