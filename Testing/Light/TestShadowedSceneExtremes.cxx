// SPDX-License-Identifier: BSD-3-Clause
// Extremes of vtkShadowedScenePass, each by its name: actors without area, turned inside out, open,
// mirrored, far away, tiny and huge, lamps in and on actors, smoke in a solid, a context remade.
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

// A floor and a sun, and what is changed of them.
RgbaPicture Draw(const Change& change, bool hasPass = true)
{
  SceneStage stage(64);
  stage.Add(MakeFloor());
  stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
  change(stage);
  return stage.Draw(hasPass);
}

vtkSmartPointer<vtkActor> MakeMesh(
  const std::vector<std::array<double, 3>>& places, const std::vector<vtkIdType>& triangles)
{
  vtkNew<vtkPoints> points;
  for (const std::array<double, 3>& place : places)
  {
    points->InsertNextPoint(place.data());
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

  /// Two scenes have the same picture.
  void Equal(const std::string& name, const std::string& extreme, const Change& change,
    const Change& expected, double bound, const std::string& as)
  {
    this->Catalogue.Measure(name, extreme, "largest difference from " + as,
      ComparePictures(Draw(change), Draw(expected)).Max, bound);
  }

  StabilityCatalogue Catalogue;
};

void AddBall(SceneStage& stage)
{
  stage.Add(MakeBall({ { -0.3, 0.0, 0.4 } }, 0.25, 32));
}

void TestMeshes(SceneTable& table)
{
  const Change zeroArea = [](SceneStage& stage)
  {
    stage.Add(MakeMesh({ { { -0.5, 0.0, 0.5 } }, { { 0.5, 0.0, 0.5 } }, { { 0.5, 0.0, 0.5 } } },
      { 0, 1, 2, 0, 0, 0 }));
  };
  table.Equal("scene-zero-area", "triangles without area", zeroArea, Nothing, 0.0, "none");
  table.Equal(
    "scene-no-triangles", "an actor of no triangle",
    [](SceneStage& stage) { stage.Add(MakeMesh({}, {})); }, Nothing, 0.0, "none");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  table.Equal(
    "scene-nan", "a triangle at places that are no numbers",
    [nan](SceneStage& stage)
    {
      stage.Add(MakeMesh(
        { { { nan, nan, nan } }, { { nan, 0.0, 0.5 } }, { { 0.5, nan, 0.5 } } }, { 0, 1, 2 }));
    },
    Nothing, 0.0, "none");

  const auto addBall = [](SceneStage& stage, int kind)
  {
    vtkNew<vtkSphereSource> source;
    source->SetCenter(0.0, 0.0, 0.0);
    source->SetRadius(0.25);
    source->SetThetaResolution(32);
    source->SetPhiResolution(16);
    // Its upper half alone.
    source->SetEndPhi(kind == 1 ? 90.0 : 180.0);
    vtkNew<vtkReverseSense> reverse;
    reverse->SetInputConnection(source->GetOutputPort());
    vtkSmartPointer<vtkActor> ball =
      MakeActor(kind == 2 ? reverse->GetOutputPort() : source->GetOutputPort());
    ball->SetPosition(-0.3, 0.0, 0.4);
    if (kind == 3)
    {
      ball->SetScale(-1.0, 1.0, 1.0);
    }
    stage.Add(ball);
  };
  const Change whole = [&](SceneStage& stage) { addBall(stage, 0); };
  // The floor alone: what a ball casts does not depend on which way its faces turn.
  for (const auto& [kind, name, extreme] :
    { std::tuple<int, const char*, const char*>{ 1, "scene-open", "an open mesh" },
      { 2, "scene-inside-out", "a mesh turned inside out" },
      { 3, "scene-mirrored", "an actor with a negative scale" } })
  {
    const RgbaPicture found = Draw([&, kind = kind](SceneStage& stage) { addBall(stage, kind); });
    const RgbaPicture expected = Draw(whole);
    double largest = 0.0;
    for (int i = 34; i < 64; ++i)
    {
      // Right of the ball lies its shadow; the lower half of an open one is missing from it.
      largest =
        std::max(largest, std::abs(found.At(i, kind == 1 ? 40 : 34)[0] - expected.At(i, 34)[0]));
    }
    if (kind == 1)
    {
      double darkest = 1.0;
      for (int i = 20; i < 50; ++i)
      {
        darkest = std::min(darkest, found.At(i, 34)[0]);
      }
      table.Catalogue.Measure(name, extreme, "light in its shadow", darkest, 0.0);
    }
    else
    {
      table.Catalogue.Measure(
        name, extreme, "largest difference from the ball's shadow", largest, 0.05);
    }
  }
  table.Catalogue.Measure("scene-million-triangles", "a ball of a million triangles",
    "mean difference from a ball of ten thousand",
    ComparePictures(Draw(
                      [](SceneStage& stage) {
                        stage.Add(MakeBall({ { -0.3, 0.0, 0.4 } }, 0.25, 1000));
                      }),
      Draw(
        [](SceneStage& stage) {
          stage.Add(MakeBall({ { -0.3, 0.0, 0.4 } }, 0.25, 100));
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
    AddBall(stage);
    stage.Stage.SetLights({});
  };
  table.Catalogue.Measure("scene-no-light", "no light at all",
    "largest difference from the picture without the pass",
    ComparePictures(Draw(dark), Draw(dark, false)).Max, 0.0);
  // A closed box around a lamp lets nothing out.
  const RgbaPicture closed = Draw(
    [](SceneStage& stage)
    {
      stage.Add(MakeBox({ { -0.2, 0.2, -0.2, 0.2, 0.3, 0.7 } }));
      stage.Stage.SetLights({ MakeLamp({ { 0.05, 0.02, 0.5 } }, { { 0.0, 0.0, 0.0 } }) });
    });
  double lightest = 0.0;
  for (const double value : { closed.At(5, 5)[0], closed.At(60, 30)[0], closed.At(32, 55)[0] })
  {
    lightest = std::max(lightest, value);
  }
  table.Catalogue.Measure(
    "scene-lamp-in-box", "a lamp in a closed box", "light outside of it", lightest, 0.0);
  const RgbaPicture touching = Draw(
    [](SceneStage& stage)
    {
      AddBall(stage);
      stage.Stage.SetLights({ MakeLamp({ { 0.3, 0.0, 0.0 } }, { { 0.0, 0.0, 0.0 } }) });
    });
  double sum = 0.0;
  for (const double value : touching.Values)
  {
    sum += value;
  }
  table.Catalogue.Check("scene-lamp-on-floor", "a lamp in the plane of a floor",
    "a picture of finite values", std::to_string(sum), std::isfinite(sum));
  // What happens in a solid does not show outside.
  const Change solid = [](SceneStage& stage) {
    stage.Add(MakeBox({ { -0.3, 0.1, -0.2, 0.2, 0.2, 0.7 } }));
  };
  table.Equal(
    "scene-smoke-in-solid", "smoke wholly within a solid",
    [&solid](SceneStage& stage)
    {
      solid(stage);
      stage.AddSmoke({ { -0.2, 0.0, -0.1, 0.1, 0.3, 0.6 } }, 3.0);
    },
    solid, 1e-6, "the solid alone");
}

vtkSmartPointer<vtkAreaLight> MakeSoftLamp(
  const std::array<double, 3>& position, double width, double height)
{
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPositional(true);
  lamp->SetPosition(position[0], position[1], position[2]);
  lamp->SetFocalPoint(position[0], position[1], position[2] - 1.0);
  lamp->SetConeAngle(180.0);
  lamp->SetSize(width, height);
  return lamp;
}

// Lights with an extent: what is between all and none of the light, and what leaks nowhere.
void TestSoftLights(SceneTable& table)
{
  const auto isBetween = [&table](const std::string& name, const std::string& extreme,
                           const std::array<double, 3>& place, double width, double height,
                           int samples)
  {
    RgbaPicture pictures[2];
    for (int i = 0; i < 2; ++i)
    {
      pictures[i] = Draw(
        [&](SceneStage& stage)
        {
          AddBall(stage);
          stage.Pass->SetNumberOfLightSamples(samples);
          stage.Pass->SetShadows(i == 0);
          stage.Stage.SetLights({ MakeSoftLamp(place, width, height) });
        });
    }
    double beyond = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < pictures[0].Values.size(); ++i)
    {
      const double with = pictures[0].Values[i];
      beyond = std::max({ beyond, -with, with - pictures[1].Values[i] });
      sum += with;
    }
    table.Catalogue.Measure(name, extreme, "least and most light beyond none and all of it",
      std::isfinite(sum) ? beyond : 1e9, 1e-6);
  };
  isBetween("scene-soft-large", "an area light larger than the scene", { { 0.0, 0.0, 2.0 } }, 20.0,
    20.0, 16);
  isBetween("scene-soft-touching", "an area light in the plane of a floor", { { 0.3, 0.0, 0.0 } },
    0.5, 0.5, 16);
  isBetween("scene-soft-in-ball", "an area light with an actor through it", { { -0.3, 0.0, 0.5 } },
    1.0, 1.0, 16);
  isBetween("scene-soft-line", "an area light without width", { { 0.2, 0.0, 2.0 } }, 0.0, 0.7, 16);
  isBetween("scene-soft-many", "the most samples", { { 0.2, 0.0, 2.0 } }, 0.7, 0.7, 256);
  isBetween("scene-soft-tiny", "an area light a millionth of its distance wide",
    { { 0.2, 0.0, 2.0 } }, 2e-6, 2e-6, 16);

  const RgbaPicture closed = Draw(
    [](SceneStage& stage)
    {
      stage.Add(MakeBox({ { -0.3, 0.3, -0.3, 0.3, 0.3, 0.9 } }));
      stage.Stage.SetLights({ MakeSoftLamp({ { 0.0, 0.0, 0.6 } }, 0.4, 0.4) });
    });
  double lightest = 0.0;
  for (const double value : { closed.At(5, 5)[0], closed.At(60, 30)[0], closed.At(32, 55)[0] })
  {
    lightest = std::max(lightest, value);
  }
  table.Catalogue.Measure(
    "scene-soft-in-box", "an area light in a closed box", "light outside of it", lightest, 0.0);

  // A plate that lies on the floor has no penumbra: it hides what is under it, and nothing else.
  RgbaPicture pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    pictures[i] = Draw(
      [i](SceneStage& stage)
      {
        stage.Add(MakeBox({ { -0.4, 0.4, -0.4, 0.4, -0.001, 0.001 } }));
        stage.Pass->SetShadows(i == 0);
        stage.Stage.SetLights({ MakeSoftLamp({ { 0.3, 0.1, 2.0 } }, 0.8, 0.8) });
      });
  }
  table.Catalogue.Measure("scene-soft-contact", "a plate on a floor under an area light",
    "largest difference from no shadow", ComparePictures(pictures[0], pictures[1]).Max, 1e-6);

  // What a ball casts does not depend on which way its faces turn, and an open one, whose
  // opening turns to the light, casts the same.
  const auto drawBall = [](int kind)
  {
    return Draw(
      [kind](SceneStage& stage)
      {
        vtkNew<vtkSphereSource> source;
        source->SetRadius(0.25);
        source->SetThetaResolution(32);
        // The same rows, of which an open one has those from the fifth on.
        source->SetPhiResolution(kind == 1 ? 11 : 16);
        source->SetStartPhi(kind == 1 ? 60.0 : 0.0);
        vtkNew<vtkReverseSense> reverse;
        reverse->SetInputConnection(source->GetOutputPort());
        vtkSmartPointer<vtkActor> ball =
          MakeActor(kind == 2 ? reverse->GetOutputPort() : source->GetOutputPort());
        ball->SetPosition(0.0, 0.0, 0.6);
        stage.Add(ball);
        stage.Stage.SetLights({ MakeSoftLamp({ { 0.0, 0.0, 2.0 } }, 0.3, 0.3) });
      });
  };
  const RgbaPicture whole = drawBall(0);
  for (const auto& [kind, name, extreme] :
    { std::tuple<int, const char*, const char*>{ 1, "scene-soft-open", "an open mesh, soft" },
      { 2, "scene-soft-inside-out", "a mesh turned inside out, soft" } })
  {
    const RgbaPicture found = drawBall(kind);
    double largest = 0.0;
    for (int i = 0; i < 64; ++i)
    {
      // Beside the ball itself.
      const bool isFloor = std::abs(i - 31.5) > 9.0;
      largest =
        std::max(largest, isFloor ? std::abs(found.At(i, 32)[0] - whole.At(i, 32)[0]) : 0.0);
    }
    table.Catalogue.Measure(
      name, extreme, "largest difference from the ball's shadow", largest, 0.02);
  }
}

void TestSizes(SceneTable& table)
{
  for (const double size : { 1e-5, 1e5 })
  {
    RgbaPicture pictures[2];
    for (int i = 0; i < 2; ++i)
    {
      const double scale = i == 0 ? 1.0 : size;
      SceneStage stage(64, 2.0 * scale);
      for (const vtkSmartPointer<vtkActor>& actor :
        { MakeFloor(), MakeBall({ { -0.3, 0.0, 0.4 } }, 0.25, 32) })
      {
        actor->SetScale(scale);
        stage.Add(actor);
      }
      stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
      pictures[i] = stage.Draw();
    }
    table.Catalogue.Measure("scene-size-" + std::string(size < 1.0 ? "small" : "large"),
      "a scene " + std::string(size < 1.0 ? "1e-5" : "1e5") + " times as large", "mean difference",
      ComparePictures(pictures[1], pictures[0]).Mean, 1e-3);
  }
}

void TestContext(SceneTable& table)
{
  SceneStage stage(64);
  stage.Add(MakeFloor());
  AddBall(stage);
  stage.AddSmoke({ { -0.5, 0.5, -0.5, 0.5, 0.1, 0.6 } }, 1.0);
  stage.Stage.SetLights({ MakeSun({ { 0.6, 0.2, -1.0 } }) });
  const RgbaPicture before = stage.Draw();
  stage.Stage.GetWindow()->Finalize();
  const RgbaPicture after = stage.Draw();
  table.Catalogue.Measure("scene-context-remade", "a context that is lost and made again",
    "largest difference from before", ComparePictures(after, before).Max, 0.0);
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
