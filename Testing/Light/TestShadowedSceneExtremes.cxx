// SPDX-License-Identifier: BSD-3-Clause
// Extreme and invalid input of vtkShadowedScenePass: actors without area, inverted, open, mirrored,
// far away, tiny and huge; lights inside and on actors; smoke inside a solid; a recreated OpenGL
// context.
#include "Support/Checks/LargestError.h"
#include "Support/Pages/StabilityCase.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCellArray.h"
#include "vtkLight.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkReverseSense.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace
{
using namespace reference;
using Change = std::function<void(SceneStage&)>;

void Nothing(SceneStage&) {}

vtkSmartPointer<vtkActor> MakeFloor()
{
  return MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } });
}

// Draws a floor lit by a sun, after applying a change to the scene.
RgbaImage Draw(const Change& change, bool hasPass = true)
{
  SceneStage stage(64);
  stage.Add(MakeFloor());
  stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
  change(stage);
  return stage.Draw(hasPass);
}

vtkSmartPointer<vtkActor> MakeMesh(
  const std::vector<std::array<double, 3>>& positions, const std::vector<vtkIdType>& triangles)
{
  vtkNew<vtkPoints> points;
  for (const std::array<double, 3>& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < triangles.size(); i += 3)
  {
    cells->InsertNextCell(3, &triangles[i]);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  vtkSmartPointer<vtkActor> actor = MakeActor(nullptr);
  vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(mesh);
  return actor;
}

class SceneTable
{
public:
  SceneTable(int argc, char* argv[])
    : Catalogue("TestShadowedSceneExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkShadowedScenePass");
  }

  /// Compares the images of two scenes.
  void Equal(const std::string& name, const std::string& extreme, const Change& change,
    const Change& expected, double bound, const std::string& reference)
  {
    this->Catalogue.Measure(name, extreme, "largest difference from " + reference,
      CompareImages(Draw(change), Draw(expected)).Max, bound);
  }

  StabilityCatalogue Catalogue;
};

void AddSphere(SceneStage& stage)
{
  stage.Add(MakeSphereActor({ { -0.3, 0.0, 0.4 } }, 0.25, 32));
}

void TestMeshes(SceneTable& table)
{
  const Change zeroArea = [](SceneStage& stage)
  {
    stage.Add(MakeMesh({ { { -0.5, 0.0, 0.5 } }, { { 0.5, 0.0, 0.5 } }, { { 0.5, 0.0, 0.5 } } },
      { 0, 1, 2, 0, 0, 0 }));
  };
  table.Equal("scene-zero-area", "triangles without area", zeroArea, Nothing, 0.0, "no actor");
  table.Equal(
    "scene-no-triangles", "an actor without triangles",
    [](SceneStage& stage) { stage.Add(MakeMesh({}, {})); }, Nothing, 0.0, "no actor");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  table.Equal(
    "scene-nan", "a triangle with NaN points",
    [nan](SceneStage& stage)
    {
      stage.Add(MakeMesh(
        { { { nan, nan, nan } }, { { nan, 0.0, 0.5 } }, { { 0.5, nan, 0.5 } } }, { 0, 1, 2 }));
    },
    Nothing, 0.0, "no actor");

  const auto addSphere = [](SceneStage& stage, int kind)
  {
    vtkNew<vtkSphereSource> source;
    source->SetCenter(0.0, 0.0, 0.0);
    source->SetRadius(0.25);
    source->SetThetaResolution(32);
    source->SetPhiResolution(16);
    // The open mesh is the upper half of the sphere.
    source->SetEndPhi(kind == 1 ? 90.0 : 180.0);
    vtkNew<vtkReverseSense> reverse;
    reverse->SetInputConnection(source->GetOutputPort());
    vtkSmartPointer<vtkActor> sphere =
      MakeActor(kind == 2 ? reverse->GetOutputPort() : source->GetOutputPort());
    sphere->SetPosition(-0.3, 0.0, 0.4);
    if (kind == 3)
    {
      sphere->SetScale(-1.0, 1.0, 1.0);
    }
    stage.Add(sphere);
  };
  const Change full = [&](SceneStage& stage) { addSphere(stage, 0); };
  // The shadow on the floor does not depend on the orientation of the faces.
  for (const auto& [kind, name, extreme] :
    { std::tuple<int, const char*, const char*>{ 1, "scene-open", "an open mesh" },
      { 2, "scene-inside-out", "an inverted mesh" },
      { 3, "scene-mirrored", "an actor with a negative scale" } })
  {
    const RgbaImage found = Draw([&, kind = kind](SceneStage& stage) { addSphere(stage, kind); });
    const RgbaImage expected = Draw(full);
    if (kind == 1)
    {
      double darkest = 1.0;
      for (int i = 20; i < 50; ++i)
      {
        darkest = std::min(darkest, found.At(i, 34)[0]);
      }
      table.Catalogue.Measure(name, extreme, "light in the shadow", darkest, 0.0);
    }
    else
    {
      double largest = 0.0;
      // The sphere's shadow is to its right.
      for (int i = 34; i < 64; ++i)
      {
        largest = std::max(largest, std::abs(found.At(i, 34)[0] - expected.At(i, 34)[0]));
      }
      table.Catalogue.Measure(
        name, extreme, "largest difference from the sphere's shadow", largest, 0.05);
    }
  }
  table.Catalogue.Measure("scene-million-triangles", "a sphere of a million triangles",
    "mean difference from a sphere of ten thousand triangles",
    CompareImages(Draw(
                    [](SceneStage& stage) {
                      stage.Add(MakeSphereActor({ { -0.3, 0.0, 0.4 } }, 0.25, 1000));
                    }),
      Draw(
        [](SceneStage& stage) {
          stage.Add(MakeSphereActor({ { -0.3, 0.0, 0.4 } }, 0.25, 100));
        }))
      .Mean,
    1e-3);
}

void TestLights(SceneTable& table)
{
  SceneStage empty(64);
  empty.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
  table.Catalogue.Measure(
    "scene-empty", "no actor and no volume", "largest channel", LargestAlpha(empty.Draw()), 0.0);
  const Change dark = [](SceneStage& stage)
  {
    AddSphere(stage);
    stage.Stage.SetLights({});
  };
  table.Catalogue.Measure("scene-no-light", "no light",
    "largest difference from the image without the pass",
    CompareImages(Draw(dark), Draw(dark, false)).Max, 0.0);
  // A closed box around a point light blocks all light.
  const RgbaImage closed = Draw(
    [](SceneStage& stage)
    {
      stage.Add(MakeBox({ { -0.2, 0.2, -0.2, 0.2, 0.3, 0.7 } }));
      stage.Stage.SetLights({ MakePointLight({ { 0.05, 0.02, 0.5 } }, { { 0.0, 0.0, 0.0 } }) });
    });
  double brightest = 0.0;
  for (const double value : { closed.At(5, 5)[0], closed.At(60, 30)[0], closed.At(32, 55)[0] })
  {
    brightest = std::max(brightest, value);
  }
  table.Catalogue.Measure(
    "scene-lamp-in-box", "a point light in a closed box", "light outside the box", brightest, 0.0);
  const RgbaImage touching = Draw(
    [](SceneStage& stage)
    {
      AddSphere(stage);
      stage.Stage.SetLights({ MakePointLight({ { 0.3, 0.0, 0.0 } }, { { 0.0, 0.0, 0.0 } }) });
    });
  double sum = 0.0;
  for (const double value : touching.Values)
  {
    sum += value;
  }
  table.Catalogue.Check("scene-lamp-on-floor", "a point light in the plane of a floor",
    "finite values", std::to_string(sum), std::isfinite(sum));
  // The interior of a solid is not visible.
  const Change solid = [](SceneStage& stage) {
    stage.Add(MakeBox({ { -0.3, 0.1, -0.2, 0.2, 0.2, 0.7 } }));
  };
  table.Equal(
    "scene-smoke-in-solid", "smoke inside a solid",
    [&solid](SceneStage& stage)
    {
      solid(stage);
      stage.AddSmoke({ { -0.2, 0.0, -0.1, 0.1, 0.3, 0.6 } }, 3.0);
    },
    solid, 1e-6, "only the solid");
}

vtkSmartPointer<vtkAreaLight> MakeAreaLight(
  const std::array<double, 3>& position, double width, double height)
{
  vtkNew<vtkAreaLight> areaLight;
  areaLight->SetPositional(true);
  areaLight->SetPosition(position[0], position[1], position[2]);
  areaLight->SetFocalPoint(position[0], position[1], position[2] - 1.0);
  areaLight->SetConeAngle(180.0);
  areaLight->SetSize(width, height);
  return areaLight;
}

// Under area lights, the brightness is never negative and never exceeds the unshadowed brightness,
// and light does not leak from a closed box.
void TestSoftLights(SceneTable& table)
{
  const auto expectBounded = [&table](const std::string& name, const std::string& extreme,
                               const std::array<double, 3>& position, double width, double height,
                               int samples)
  {
    RgbaImage images[2];
    for (int i = 0; i < 2; ++i)
    {
      images[i] = Draw(
        [&](SceneStage& stage)
        {
          AddSphere(stage);
          stage.Pass->SetNumberOfLightSamples(samples);
          stage.Pass->SetShadows(i == 0);
          stage.Stage.SetLights({ MakeAreaLight(position, width, height) });
        });
    }
    double excess = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < images[0].Values.size(); ++i)
    {
      const double with = images[0].Values[i];
      excess = std::max({ excess, -with, with - images[1].Values[i] });
      sum += with;
    }
    table.Catalogue.Measure(name, extreme,
      "largest deviation below zero or above the unshadowed light",
      std::isfinite(sum) ? excess : 1e9, 1e-6);
  };
  expectBounded("scene-soft-large", "an area light larger than the scene", { { 0.0, 0.0, 2.0 } },
    20.0, 20.0, 16);
  expectBounded("scene-soft-touching", "an area light in the plane of a floor",
    { { 0.3, 0.0, 0.0 } }, 0.5, 0.5, 16);
  expectBounded("scene-soft-in-ball", "an area light that intersects an actor",
    { { -0.3, 0.0, 0.5 } }, 1.0, 1.0, 16);
  expectBounded(
    "scene-soft-line", "an area light of zero width", { { 0.2, 0.0, 2.0 } }, 0.0, 0.7, 16);
  expectBounded(
    "scene-soft-many", "the maximum number of samples", { { 0.2, 0.0, 2.0 } }, 0.7, 0.7, 256);
  expectBounded("scene-soft-tiny", "an area light with a width of a millionth of its distance",
    { { 0.2, 0.0, 2.0 } }, 2e-6, 2e-6, 16);

  const RgbaImage closed = Draw(
    [](SceneStage& stage)
    {
      stage.Add(MakeBox({ { -0.3, 0.3, -0.3, 0.3, 0.3, 0.9 } }));
      stage.Stage.SetLights({ MakeAreaLight({ { 0.0, 0.0, 0.6 } }, 0.4, 0.4) });
    });
  double brightest = 0.0;
  for (const double value : { closed.At(5, 5)[0], closed.At(60, 30)[0], closed.At(32, 55)[0] })
  {
    brightest = std::max(brightest, value);
  }
  table.Catalogue.Measure(
    "scene-soft-in-box", "an area light in a closed box", "light outside the box", brightest, 0.0);

  // A plate that lies on the floor has no penumbra, and its shadow is hidden below it.
  RgbaImage images[2];
  for (int i = 0; i < 2; ++i)
  {
    images[i] = Draw(
      [i](SceneStage& stage)
      {
        stage.Add(MakeBox({ { -0.4, 0.4, -0.4, 0.4, -0.001, 0.001 } }));
        stage.Pass->SetShadows(i == 0);
        stage.Stage.SetLights({ MakeAreaLight({ { 0.3, 0.1, 2.0 } }, 0.8, 0.8) });
      });
  }
  table.Catalogue.Measure("scene-soft-contact", "a plate on a floor under an area light",
    "largest difference from the image without shadows", CompareImages(images[0], images[1]).Max,
    1e-6);

  // The shadow of a sphere does not depend on the orientation of its faces, or on an opening toward
  // the light.
  const auto drawSphere = [](int kind)
  {
    return Draw(
      [kind](SceneStage& stage)
      {
        vtkNew<vtkSphereSource> source;
        source->SetRadius(0.25);
        source->SetThetaResolution(32);
        // The open sphere has the same rows of points as the closed one, starting at 60 degrees.
        source->SetPhiResolution(kind == 1 ? 11 : 16);
        source->SetStartPhi(kind == 1 ? 60.0 : 0.0);
        vtkNew<vtkReverseSense> reverse;
        reverse->SetInputConnection(source->GetOutputPort());
        vtkSmartPointer<vtkActor> sphere =
          MakeActor(kind == 2 ? reverse->GetOutputPort() : source->GetOutputPort());
        sphere->SetPosition(0.0, 0.0, 0.6);
        stage.Add(sphere);
        stage.Stage.SetLights({ MakeAreaLight({ { 0.0, 0.0, 2.0 } }, 0.3, 0.3) });
      });
  };
  const RgbaImage full = drawSphere(0);
  for (const auto& [kind, name, extreme] : { std::tuple<int, const char*, const char*>{
                                               1, "scene-soft-open", "an open mesh, soft shadows" },
         { 2, "scene-soft-inside-out", "an inverted mesh, soft shadows" } })
  {
    const RgbaImage found = drawSphere(kind);
    double largest = 0.0;
    for (int i = 0; i < 64; ++i)
    {
      // Compares only pixels outside the sphere.
      const bool isFloor = std::abs(i - 31.5) > 9.0;
      reference::KeepLargest(
        largest, isFloor ? std::abs(found.At(i, 32)[0] - full.At(i, 32)[0]) : 0.0);
    }
    table.Catalogue.Measure(
      name, extreme, "largest difference from the sphere's shadow", largest, 0.02);
  }
}

void TestSizes(SceneTable& table)
{
  for (const double size : { 1e-5, 1e5 })
  {
    RgbaImage images[2];
    for (int i = 0; i < 2; ++i)
    {
      const double scale = i == 0 ? 1.0 : size;
      SceneStage stage(64, 2.0 * scale);
      for (const vtkSmartPointer<vtkActor>& actor :
        { MakeFloor(), MakeSphereActor({ { -0.3, 0.0, 0.4 } }, 0.25, 32) })
      {
        actor->SetScale(scale);
        stage.Add(actor);
      }
      stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
      images[i] = stage.Draw();
    }
    table.Catalogue.Measure("scene-size-" + std::string(size < 1.0 ? "small" : "large"),
      "a scene " + std::string(size < 1.0 ? "1e-5" : "1e5") + " times the size", "mean difference",
      CompareImages(images[1], images[0]).Mean, 1e-3);
  }
}

void TestContext(SceneTable& table)
{
  SceneStage stage(64);
  stage.Add(MakeFloor());
  AddSphere(stage);
  stage.AddSmoke({ { -0.5, 0.5, -0.5, 0.5, 0.1, 0.6 } }, 1.0);
  stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
  const RgbaImage before = stage.Draw();
  stage.Stage.GetWindow()->Finalize();
  const RgbaImage after = stage.Draw();
  table.Catalogue.Measure("scene-context-remade",
    "an OpenGL context that is lost and created again",
    "largest difference from the previous image", CompareImages(after, before).Max, 0.0);
}

}

int TestShadowedSceneExtremes(int argc, char* argv[])
{
  SceneTable table(argc, argv);
  TestMeshes(table);
  TestLights(table);
  TestSoftLights(table);
  TestSizes(table);
  TestContext(table);
  return table.Catalogue.GetExitCode();
}
