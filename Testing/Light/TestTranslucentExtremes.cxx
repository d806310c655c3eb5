// SPDX-License-Identifier: BSD-3-Clause
// Extremes of translucent actors in vtkShadowedScenePass, each by its name: opacities 0 and 1, many
// panes, panes in one plane, on slices, on walls and behind all, actors without triangles, depth
// peeling, samples, sizes, volumes out of sight, random changes.
#include "Support/Pages/StabilityCase.h"
#include "Support/Drawing/ShadowPicture.h"
#include "Support/Checks/ReferenceRandom.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace reference;
using Change = std::function<void(SceneStage&)>;
using Vector = std::array<double, 3>;

constexpr int PIXELS = 48;
const Vector UP{ { 0.0, 0.0, 1.0 } };
const std::array<double, 6> SMOKE{ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } };

vtkSmartPointer<vtkActor> MakeFloor()
{
  return MakeRectangle({ { -2.0, -2.0, -0.6 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } });
}

// A floor, smoke and a sun, and what is changed of them.
RgbaPicture Draw(const Change& change)
{
  SceneStage stage(PIXELS, 1.6);
  stage.Add(MakeFloor());
  stage.AddSmoke(SMOKE, 2.0, 12);
  stage.Stage.SetLights({ MakeSun({ { 0.5, 0.2, -1.0 } }) });
  change(stage);
  return stage.Draw();
}

void Nothing(SceneStage&) {}

class Table
{
public:
  Table(int argc, char* argv[])
    : Catalogue("TestTranslucentExtremes", argc, argv)
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
  void EqualInMean(const std::string& name, const std::string& extreme, const Change& change,
    const Change& expected, double bound, const std::string& as)
  {
    this->Catalogue.Measure(name, extreme, "mean difference from " + as,
      ComparePictures(Draw(change), Draw(expected)).Mean, bound);
  }

  StabilityCatalogue Catalogue;
};

Change AddPane(const Vector& center, const Vector& normal, double edge, double opacity = 0.5)
{
  return [=](SceneStage& stage) { stage.Add(MakePane(center, normal, edge, opacity)); };
}

void TestOpacities(Table& table)
{
  table.Equal("translucent-opacity-0", "an actor of opacity 0",
    AddPane({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.0), Nothing, 1e-5, "none");
  const auto solid = [](bool isForced)
  {
    return [isForced](SceneStage& stage)
    {
      vtkSmartPointer<vtkActor> pane = MakePane({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 1.0);
      pane->SetForceTranslucent(isForced);
      stage.Add(pane);
    };
  };
  // Maps fit around other actors, so that edges of shadows differ.
  table.EqualInMean("translucent-opacity-1", "an actor of opacity 1 forced to be translucent",
    solid(true), solid(false), 2e-3, "an opaque one");

  const auto stack = [](int panes, double opacity)
  {
    return [=](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 0.0, 0.0, -1.0 } }) });
      stage.Stage.GetVolume()->VisibilityOff();
      for (int i = 0; i < panes; ++i)
      {
        stage.Add(MakePane({ { 0.0, 0.0, 0.08 * i - 0.4 } }, UP, 0.7, opacity));
      }
    };
  };
  // Black panes over a white floor: the light passes them twice.
  for (const bool hasSmoke : { false, true })
  {
    const RgbaPicture many = Draw(
      [&](SceneStage& stage)
      {
        stack(9, 0.05)(stage);
        stage.Pass->SetMaximumNumberOfLayers(4);
        stage.Stage.GetVolume()->SetVisibility(hasSmoke);
        stage.Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
        vtkActorCollection* actors = stage.Stage.GetRenderer()->GetActors();
        actors->InitTraversal();
        actors->GetNextActor();
        while (vtkActor* actor = actors->GetNextActor())
        {
          actor->GetProperty()->SetDiffuse(0.0);
        }
      });
    const double expected = std::pow(0.95, 18.0) * (hasSmoke ? std::exp(-2.0 * 2.0 * 0.6) : 1.0);
    table.Catalogue.Measure(std::string("translucent-many") + (hasSmoke ? "-in-smoke" : ""),
      "nine panes behind each other, of which four are layers", "error of the floor behind all",
      many.At(PIXELS / 2, PIXELS / 2)[0] - expected, 1e-3);
  }
}

void TestPlaces(Table& table)
{
  // Slices of a sweep along z have their planes at these heights and between.
  double most = 0.0;
  RgbaPicture before;
  for (int i = 0; i < 3; ++i)
  {
    const RgbaPicture picture = Draw(
      [i](SceneStage& stage)
      {
        stage.Mapper->SetSliceSpacing(0.1);
        stage.Stage.SetLights({ MakeSun({ { 0.0, 0.0, -1.0 } }) });
        AddPane({ { 0.0, 0.0, 0.0 + 1e-7 * (i - 1) } }, UP, 0.7)(stage);
      });
    most = i == 0 ? 0.0 : std::max(most, ComparePictures(picture, before).Max);
    before = picture;
  }
  table.Catalogue.Measure("translucent-on-slice", "a pane in the plane of a slice's face",
    "largest difference between planes 1e-7 apart", most, 1e-4);
  table.Equal(
    "translucent-coplanar", "two panes in one plane",
    [](SceneStage& stage)
    {
      stage.Add(MakePane({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.3));
      stage.Add(MakePane({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.5));
    },
    AddPane({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.65), 1e-4, "one of both opacities");
  table.Equal("translucent-hidden", "a pane behind the floor",
    AddPane({ { 0.0, 0.0, -0.7 } }, UP, 0.7), Nothing, 0.01, "none");
  table.Equal("translucent-aside", "a pane out of the eye's sight and of light's way",
    AddPane({ { 3.0, 3.0, 0.0 } }, UP, 0.5), Nothing, 0.01, "none");
  table.EqualInMean(
    "translucent-edge-on", "a pane that eye and light see by its edge",
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 0.5, 0.0, -1.0 } }) });
      stage.Add(MakePane({ { 0.0, 0.01, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.5));
    },
    [](SceneStage& stage) {
      stage.Stage.SetLights({ MakeSun({ { 0.5, 0.0, -1.0 } }) });
    },
    5e-3, "none");
  const auto sum = [](const RgbaPicture& picture)
  {
    double all = 0.0;
    for (const double value : picture.Values)
    {
      all += value;
    }
    return all;
  };
  const double onPane = sum(Draw(
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeLamp({ { 0.0, 0.0, 0.5 } }, { { 0.0, 0.0, 0.0 } }) });
      stage.Add(MakePane({ { 0.0, 0.0, 0.5 } }, UP, 0.7));
    }));
  table.Catalogue.Check("translucent-lamp-on-pane", "a lamp in the plane of a pane",
    "a picture of finite values", std::to_string(onPane), std::isfinite(onPane) && onPane > 0.0);
  // A closed ball takes light twice and hides twice.
  const RgbaPicture ball = Draw(
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 0.0, 0.0, -1.0 } }) });
      stage.Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
      vtkSmartPointer<vtkActor> around = MakeBall({ { 0.0, 0.0, 0.0 } }, 0.58, 64);
      around->GetProperty()->SetOpacity(0.4);
      around->GetProperty()->SetDiffuse(0.0);
      stage.Add(around);
    });
  table.Catalogue.Measure("translucent-around", "a ball around all of the smoke",
    "error of the floor behind it",
    ball.At(PIXELS / 2, PIXELS / 2)[0] - std::pow(0.6, 4.0) * std::exp(-2.0 * 2.0 * 0.6), 1e-3);
  // A pane at the eye's near plane is cut by it.
  table.Equal(
    "translucent-before-near", "a pane before the near plane",
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -0.2 } }) });
      stage.Stage.GetRenderer()->GetActiveCamera()->SetClippingRange(5.5, 12.0);
      stage.Add(MakePane({ { 0.0, 0.0, 1.2 } }, UP, 0.7));
    },
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -0.2 } }) });
      stage.Stage.GetRenderer()->GetActiveCamera()->SetClippingRange(5.5, 12.0);
    },
    0.01, "none");
}

void TestMeshes(Table& table)
{
  const auto addMesh = [](vtkPolyData* mesh)
  {
    vtkSmartPointer<vtkPolyData> kept = mesh;
    return [kept](SceneStage& stage)
    {
      vtkSmartPointer<vtkActor> actor = MakeActor(nullptr);
      vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(kept);
      actor->GetProperty()->SetOpacity(0.5);
      stage.Add(actor);
    };
  };
  vtkNew<vtkPolyData> empty;
  table.Equal("translucent-empty", "a translucent actor of no triangle", addMesh(empty), Nothing,
    0.0, "none");
}

void TestRenderers(Table& table)
{
  const auto scene = [](bool isPeeled)
  {
    return [isPeeled](SceneStage& stage)
    {
      vtkRenderer* renderer = stage.Stage.GetRenderer();
      renderer->SetUseDepthPeeling(isPeeled);
      renderer->SetMaximumNumberOfPeels(20);
      AddPane({ { 0.0, 0.0, 0.05 } }, { { 0.3, 0.1, 1.0 } }, 0.7)(stage);
      AddPane({ { 0.1, 0.0, 0.05 } }, { { -0.3, 0.1, 1.0 } }, 0.5)(stage);
    };
  };
  table.Equal("translucent-depth-peeling", "a renderer with depth peeling", scene(true),
    scene(false), 0.0, "one without");

  RgbaPicture pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    SceneStage stage(PIXELS, 1.6);
    stage.Add(MakeFloor());
    stage.AddSmoke(SMOKE, 2.0, 12);
    stage.Stage.SetLights({ MakeSun({ { 0.5, 0.2, -1.0 } }) });
    scene(false)(stage);
    stage.Stage.GetWindow()->SetMultiSamples(8 * i);
    stage.Stage.GetRenderer()->SetPass(stage.Pass);
    pictures[i] = ReadWindow(stage.Stage.GetWindow());
    stage.Stage.GetRenderer()->SetPass(nullptr);
  }
  table.Catalogue.Measure("translucent-samples", "eight samples a pixel",
    "mean difference from a picture with one", ComparePictures(pictures[1], pictures[0]).Mean,
    5e-3);

  // No volume shows the picture: the pane is there all the same.
  const RgbaPicture away = Draw(
    [](SceneStage& stage)
    {
      stage.Stage.GetVolume()->SetPosition(0.0, 30.0, 0.0);
      AddPane({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
    });
  const RgbaPicture without = Draw(
    [](SceneStage& stage)
    {
      stage.Stage.GetVolume()->VisibilityOff();
      AddPane({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
    });
  // VTK's own blending leaves another opacity in the picture.
  double largest = 0.0;
  for (std::size_t i = 0; i < away.Values.size(); ++i)
  {
    const double difference = std::abs(away.Values[i] - without.Values[i]);
    largest = i % 4 == 3 ? largest : std::max(largest, difference);
  }
  table.Catalogue.Measure("translucent-volume-away", "a volume out of the eye's sight",
    "largest difference from a scene without it", largest, 1e-4);
  table.Equal(
    "translucent-no-light", "no light at all",
    [](SceneStage& stage)
    {
      AddPane({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
      stage.Stage.SetLights({});
      stage.Stage.GetVolume()->VisibilityOff();
    },
    [](SceneStage& stage)
    {
      AddPane({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
      stage.Stage.SetLights({});
      stage.Stage.GetVolume()->VisibilityOff();
      stage.Pass->ShadowsOff();
    },
    0.0, "the picture without the pass");

  SceneStage stage(PIXELS, 1.6);
  stage.Add(MakeFloor());
  stage.AddSmoke(SMOKE, 2.0, 12);
  stage.Stage.SetLights({ MakeSun({ { 0.5, 0.2, -1.0 } }) });
  scene(false)(stage);
  const RgbaPicture before = stage.Draw();
  stage.Stage.GetWindow()->Finalize();
  table.Catalogue.Measure("translucent-context-remade", "a context that is lost and made again",
    "largest difference from before", ComparePictures(stage.Draw(), before).Max, 0.0);
}

// What random changes change.
struct Numbers
{
  std::vector<Vector> Places{ { { 0.0, 0.0, 0.05 } }, { { 0.1, 0.0, 0.3 } } };
  std::vector<double> Opacities{ 0.5, 0.3 };
  Vector Light{ { 0.5, 0.2, -1.0 } };
  Vector View{ { 0.0, 0.0, -1.0 } };
  bool HasSmoke = true;
  bool IsPositional = false;
  int Resolution = 256;
};

struct ChangingStage
{
  ChangingStage()
    : Stage(PIXELS, 1.6)
  {
    this->Stage.Add(MakeFloor());
    this->Stage.AddSmoke(SMOKE, 2.0, 12);
    for (int i = 0; i < 2; ++i)
    {
      this->Panes.push_back(MakePane({ { 0.0, 0.0, 0.0 } }, { { 0.2, 0.1, 1.0 } }, 0.7));
      this->Stage.Add(this->Panes.back());
    }
  }

  RgbaPicture Draw(const Numbers& numbers)
  {
    for (std::size_t i = 0; i < this->Panes.size(); ++i)
    {
      this->Panes[i]->SetPosition(numbers.Places[i][0], numbers.Places[i][1], numbers.Places[i][2]);
      this->Panes[i]->GetProperty()->SetOpacity(numbers.Opacities[i]);
    }
    this->Stage.Stage.GetVolume()->SetVisibility(numbers.HasSmoke);
    this->Stage.Pass->SetDepthMapResolution(numbers.Resolution);
    this->Stage.Stage.SetLights({ numbers.IsPositional
        ? MakeLamp({ { -numbers.Light[0], -numbers.Light[1], 2.0 } }, { { 0.0, 0.0, 0.0 } })
        : MakeSun(numbers.Light) });
    this->Stage.LookAlong(numbers.View);
    return this->Stage.Draw();
  }

  SceneStage Stage;
  std::vector<vtkSmartPointer<vtkActor>> Panes;
};

void TestChanges(Table& table)
{
  Random random(7);
  Numbers numbers;
  ChangingStage stage;
  double largest = 0.0;
  int lit = 0;
  constexpr int changes = 12;
  for (int i = 0; i < changes; ++i)
  {
    const auto pane = static_cast<std::size_t>(i % 2);
    switch (static_cast<int>(6.999 * random.Get(0.0, 1.0)))
    {
      case 0:
        numbers.Places[pane] = { { 0.4 * random.Get(0.0, 1.0) - 0.2, 0.0,
          1.2 * random.Get(0.0, 1.0) - 0.6 } };
        break;
      case 1:
        numbers.Opacities[pane] = random.Get(0.0, 1.0) < 0.3 ? 1.0 : random.Get(0.0, 1.0);
        break;
      case 2:
        numbers.Light = { { random.Get(0.0, 1.0) - 0.5, random.Get(0.0, 1.0) - 0.5, -1.0 } };
        break;
      case 3:
        numbers.View = { { 2.0 * random.Get(0.0, 1.0) - 1.0, random.Get(0.0, 1.0),
          -random.Get(0.0, 1.0) } };
        break;
      case 4:
        numbers.HasSmoke = !numbers.HasSmoke;
        break;
      case 5:
        numbers.IsPositional = !numbers.IsPositional;
        break;
      default:
        numbers.Resolution = numbers.Resolution == 256 ? 128 : 256;
        break;
    }
    ChangingStage fresh;
    const RgbaPicture expected = fresh.Draw(numbers);
    largest = std::max(largest, ComparePictures(stage.Draw(numbers), expected).Max);
    lit += expected.At(PIXELS / 2, PIXELS / 2)[0] > 0.02 ? 1 : 0;
  }
  table.Catalogue.Measure("translucent-random-changes", "12 random changes of one scene",
    "largest difference from scenes made anew", largest, 0.0);
  table.Catalogue.Measure("translucent-random-light", "12 random changes of one scene",
    "pictures with something dark in their middle", changes - lit, changes / 3);
}

}

int TestTranslucentExtremes(int argc, char* argv[])
{
  Table table(argc, argv);
  TestOpacities(table);
  TestPlaces(table);
  TestMeshes(table);
  TestRenderers(table);
  TestChanges(table);
  return table.Catalogue.GetExitCode();
}
