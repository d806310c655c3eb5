// SPDX-License-Identifier: BSD-3-Clause
// Translucent surfaces in order with sliced smoke by vtkShadowedScenePass, and the light that they
// take, against the double-precision reference of mixed scenes.
#include "Pictures/MixedScene.h"
#include "Pictures/ReferenceMixedPicture.h"
#include "Reference/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace reference;
using Vector = std::array<double, 3>;

constexpr int PIXELS = 64;
constexpr double SIZE = 1.6;
constexpr double EXTINCTION = 2.0;

// A pane of half the light, orange, around a place and perpendicular to a direction.
vtkSmartPointer<vtkActor> MakePane(
  const Vector& center, Vector normal, double edge, double opacity = 0.5)
{
  vtkMath::Normalize(normal.data());
  Vector first;
  Vector second;
  vtkMath::Perpendiculars(normal.data(), first.data(), second.data(), 0.0);
  Vector origin;
  for (int i = 0; i < 3; ++i)
  {
    first[i] *= edge;
    second[i] *= edge;
    origin[i] = center[i] - 0.5 * (first[i] + second[i]);
  }
  vtkSmartPointer<vtkActor> pane = MakeRectangle(origin, first, second);
  pane->GetProperty()->SetOpacity(opacity);
  pane->GetProperty()->SetColor(0.9, 0.6, 0.2);
  return pane;
}

std::unique_ptr<SceneStage> MakeStage(
  const std::vector<vtkSmartPointer<vtkActor>>& panes, vtkLight* light, bool hasFloor = true)
{
  auto stage = std::make_unique<SceneStage>(PIXELS, SIZE);
  if (hasFloor)
  {
    stage->Add(
      MakeRectangle({ { -3.0, -3.0, -0.8 } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } }));
  }
  for (const vtkSmartPointer<vtkActor>& pane : panes)
  {
    stage->Add(pane);
  }
  stage->AddSmoke({ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } }, EXTINCTION, 24);
  stage->Stage.SetLights({ vtkSmartPointer<vtkLight>(light) });
  return stage;
}

// What the reference knows of a stage.
MixedScene MakeMixed(SceneStage& stage, vtkLight* light)
{
  MixedScene scene;
  scene.Size = { { PIXELS, PIXELS } };
  scene.Camera = stage.Stage.GetRenderer()->GetActiveCamera();
  scene.Lights.push_back({ light, {} });
  SceneVolume smoke;
  smoke.Image = vtkImageData::SafeDownCast(stage.Mapper->GetInput());
  smoke.Property = stage.Stage.GetVolume()->GetProperty();
  if (stage.Stage.GetVolume()->GetVisibility())
  {
    scene.Volumes.push_back(smoke);
  }
  vtkActorCollection* actors = stage.Stage.GetRenderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    scene.Surfaces.push_back({ actor, {} });
  }
  return scene;
}

// Compares the picture with the reference. Pixels that are off lie at edges: of surfaces, of smoke,
// and of shadows; at most \a edges of them.
void Compare(
  Check& check, SceneStage& stage, vtkLight* light, const std::string& name, double edges)
{
  const RgbaPicture found = stage.Draw();
  const RgbaPicture expected = MakeMixedPicture(MakeMixed(stage, light));
  std::vector<double> errors;
  double mean = 0.0;
  for (std::size_t i = 0; i < found.Values.size(); i += 4)
  {
    double largest = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      largest = std::max(largest, std::abs(found.Values[i + k] - expected.Values[i + k]));
    }
    errors.push_back(largest);
    mean += largest / (PIXELS * PIXELS);
  }
  const double above = static_cast<double>(std::count_if(errors.begin(), errors.end(),
                         [](double error) { return error > 0.002; })) /
    (PIXELS * PIXELS);
  std::sort(errors.begin(), errors.end());
  const vtkShadowedSceneReport& report = stage.GetReport();
  std::cout << name << ": mean " << mean << ", median " << errors[errors.size() / 2] << ", 95 % "
            << errors[errors.size() * 95 / 100] << ", largest " << errors.back()
            << ", above 0.002: " << above << ", layers " << report.EyeLayers << " "
            << report.LightLayers << ", sweeps " << stage.Mapper->GetReport().Sweeps << " "
            << stage.Mapper->GetReport().FrontToBackSweeps << std::endl;
  check.Near(above, 0.0, edges, name + ": share of pixels off by 0.002", 1.0);
  check.Near(mean, 0.0, 0.002, name + ": mean error", 1.0);
}

void TestPlaces(Check& check)
{
  const vtkSmartPointer<vtkLight> lights[3] = { MakeSun({ { 0.5, 0.2, -1.0 } }),
    MakeSun({ { 0.6, 0.1, 0.8 } }), MakeLamp({ { -1.0, 0.2, 2.0 } }, { { 0.0, 0.0, 0.0 } }) };
  const char* names[3] = { "sun", "sun from below", "lamp" };
  const Vector up{ { 0.0, 0.0, 1.0 } };
  const Vector tilted{ { -0.8, 0.1, 0.6 } };
  for (int i = 0; i < 3; ++i)
  {
    const std::string name = std::string(names[i]) + ", pane ";
    const auto compare = [&](const std::vector<vtkSmartPointer<vtkActor>>& panes,
                           const std::string& place, double edges)
    {
      // A floor would keep light from below out.
      const auto stage = MakeStage(panes, lights[i], i != 1);
      Compare(check, *stage, lights[i], name + place, edges);
    };
    compare({}, "none", 0.1);
    compare({ MakePane({ { 0.05, 0.0, 0.5 } }, up, 0.6) }, "before", 0.1);
    compare({ MakePane({ { 0.05, 0.0, 0.1 } }, up, 0.6) }, "inside", 0.1);
    compare({ MakePane({ { 0.05, 0.0, -0.5 } }, up, 0.6) }, "behind", 0.1);
    compare({ MakePane({ { 0.0, 0.0, 0.05 } }, tilted, 0.9) }, "across", 0.1);
    compare({ MakePane({ { 0.0, 0.0, 0.05 } }, tilted, 0.9),
              MakePane({ { 0.1, 0.0, 0.0 } }, { { 0.6, 0.2, 0.7 } }, 0.7, 0.3) },
      "across another", 0.15);
  }
}

}

int TestTranslucentScene(int, char*[])
{
  Check check;
  TestPlaces(check);
  return check.Result();
}
