// SPDX-License-Identifier: BSD-3-Clause
// Extreme translucent actors in vtkShadowedScenePass: opacities 0 and 1, many layers, coplanar
// actors, actors on slice planes and behind the floor, actors without triangles, depth peeling,
// multisampling, invisible volumes, random changes.
#include "Support/Checks/LargestError.h"
#include "Support/Pages/StabilityCase.h"
#include "Support/Drawing/ShadowImage.h"
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

// Draws a floor and smoke, lit by a sun, after applying a change to the scene.
RgbaImage Draw(const Change& change)
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

  /// Compares the images of two scenes.
  void Equal(const std::string& name, const std::string& extreme, const Change& change,
    const Change& expected, double bound, const std::string& reference)
  {
    this->Catalogue.Measure(name, extreme, "largest difference from " + reference,
      CompareImages(Draw(change), Draw(expected)).Max, bound);
  }
  void EqualInMean(const std::string& name, const std::string& extreme, const Change& change,
    const Change& expected, double bound, const std::string& reference)
  {
    this->Catalogue.Measure(name, extreme, "mean difference from " + reference,
      CompareImages(Draw(change), Draw(expected)).Mean, bound);
  }

  StabilityCatalogue Catalogue;
};

Change AddSquare(const Vector& center, const Vector& normal, double edge, double opacity = 0.5)
{
  return [=](SceneStage& stage)
  { stage.Add(MakeTranslucentSquare(center, normal, edge, opacity)); };
}

void TestOpacities(Table& table)
{
  table.Equal("translucent-opacity-0", "an actor of opacity 0",
    AddSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.0), Nothing, 1e-5, "no actor");
  const auto solid = [](bool isForced)
  {
    return [isForced](SceneStage& stage)
    {
      vtkSmartPointer<vtkActor> square =
        MakeTranslucentSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 1.0);
      square->SetForceTranslucent(isForced);
      stage.Add(square);
    };
  };
  // Shadow maps are fitted to the actors, so shadow edges differ.
  table.EqualInMean("translucent-opacity-1", "an actor of opacity 1 forced to be translucent",
    solid(true), solid(false), 2e-3, "an opaque actor");

  const auto stack = [](int squares, double opacity)
  {
    return [=](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 0.0, 0.0, -1.0 } }) });
      stage.Stage.GetVolume()->VisibilityOff();
      for (int i = 0; i < squares; ++i)
      {
        stage.Add(MakeTranslucentSquare({ { 0.0, 0.0, 0.08 * i - 0.4 } }, UP, 0.7, opacity));
      }
    };
  };
  // Black squares above a white floor. Light passes through each square twice: on the way to the
  // floor and from there to the camera.
  for (const bool hasSmoke : { false, true })
  {
    const RgbaImage many = Draw(
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
      "nine squares behind each other, with a maximum of four layers",
      "error of the floor behind all squares", many.At(PIXELS / 2, PIXELS / 2)[0] - expected, 1e-3);
  }
}

void TestPositions(Table& table)
{
  // The square is just below, in and just above the plane of a slice.
  double largest = 0.0;
  RgbaImage before;
  for (int i = 0; i < 3; ++i)
  {
    const RgbaImage image = Draw(
      [i](SceneStage& stage)
      {
        stage.Mapper->SetSliceSpacing(0.1);
        stage.Stage.SetLights({ MakeSun({ { 0.0, 0.0, -1.0 } }) });
        AddSquare({ { 0.0, 0.0, 0.0 + 1e-7 * (i - 1) } }, UP, 0.7)(stage);
      });
    largest = i == 0 ? 0.0 : std::max(largest, CompareImages(image, before).Max);
    before = image;
  }
  table.Catalogue.Measure("translucent-on-slice",
    "a translucent square in the plane of a slice's face",
    "largest difference between planes at a distance of 1e-7", largest, 1e-4);
  table.Equal(
    "translucent-coplanar", "two coplanar squares",
    [](SceneStage& stage)
    {
      stage.Add(MakeTranslucentSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.3));
      stage.Add(MakeTranslucentSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.5));
    },
    AddSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7, 0.65), 1e-4, "one square of both opacities");
  table.Equal("translucent-hidden", "a square behind the floor",
    AddSquare({ { 0.0, 0.0, -0.7 } }, UP, 0.7), Nothing, 0.01, "no square");
  table.Equal("translucent-aside", "a square outside the view and outside the light's path",
    AddSquare({ { 3.0, 3.0, 0.0 } }, UP, 0.5), Nothing, 0.01, "no square");
  table.EqualInMean(
    "translucent-edge-on", "a square seen and lit edge-on",
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 0.5, 0.0, -1.0 } }) });
      stage.Add(MakeTranslucentSquare({ { 0.0, 0.01, 0.0 } }, { { 0.0, 1.0, 0.0 } }, 0.5));
    },
    [](SceneStage& stage) {
      stage.Stage.SetLights({ MakeSun({ { 0.5, 0.0, -1.0 } }) });
    },
    5e-3, "no square");
  const auto sum = [](const RgbaImage& image)
  {
    double all = 0.0;
    for (const double value : image.Values)
    {
      all += value;
    }
    return all;
  };
  const double onSquare = sum(Draw(
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakePointLight({ { 0.0, 0.0, 0.5 } }, { { 0.0, 0.0, 0.0 } }) });
      stage.Add(MakeTranslucentSquare({ { 0.0, 0.0, 0.5 } }, UP, 0.7));
    }));
  table.Catalogue.Check("translucent-lamp-on-pane",
    "a point light in the plane of a translucent square", "finite values", std::to_string(onSquare),
    std::isfinite(onSquare) && onSquare > 0.0);
  // A closed sphere attenuates light twice on the way to the floor, and twice on the way to the
  // camera.
  const RgbaImage sphere = Draw(
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 0.0, 0.0, -1.0 } }) });
      stage.Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
      vtkSmartPointer<vtkActor> actor = MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.58, 64);
      actor->GetProperty()->SetOpacity(0.4);
      actor->GetProperty()->SetDiffuse(0.0);
      stage.Add(actor);
    });
  table.Catalogue.Measure("translucent-around", "a sphere around all of the smoke",
    "error of the floor behind the sphere",
    sphere.At(PIXELS / 2, PIXELS / 2)[0] - std::pow(0.6, 4.0) * std::exp(-2.0 * 2.0 * 0.6), 1e-3);
  // A square in front of the near plane is clipped.
  table.Equal(
    "translucent-before-near", "a square in front of the near plane",
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -0.2 } }) });
      stage.Stage.GetRenderer()->GetActiveCamera()->SetClippingRange(5.5, 12.0);
      stage.Add(MakeTranslucentSquare({ { 0.0, 0.0, 1.2 } }, UP, 0.7));
    },
    [](SceneStage& stage)
    {
      stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -0.2 } }) });
      stage.Stage.GetRenderer()->GetActiveCamera()->SetClippingRange(5.5, 12.0);
    },
    0.01, "no square");
}

void TestMeshes(Table& table)
{
  const auto addMesh = [](vtkPolyData* mesh)
  {
    vtkSmartPointer<vtkPolyData> mesh1 = mesh;
    return [mesh1](SceneStage& stage)
    {
      vtkSmartPointer<vtkActor> actor = MakeActor(nullptr);
      vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(mesh1);
      actor->GetProperty()->SetOpacity(0.5);
      stage.Add(actor);
    };
  };
  vtkNew<vtkPolyData> empty;
  table.Equal("translucent-empty", "a translucent actor without triangles", addMesh(empty), Nothing,
    0.0, "no actor");
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
      AddSquare({ { 0.0, 0.0, 0.05 } }, { { 0.3, 0.1, 1.0 } }, 0.7)(stage);
      AddSquare({ { 0.1, 0.0, 0.05 } }, { { -0.3, 0.1, 1.0 } }, 0.5)(stage);
    };
  };
  table.Equal("translucent-depth-peeling", "a renderer with depth peeling", scene(true),
    scene(false), 0.0, "a renderer without depth peeling");

  RgbaImage images[2];
  for (int i = 0; i < 2; ++i)
  {
    SceneStage stage(PIXELS, 1.6);
    stage.Add(MakeFloor());
    stage.AddSmoke(SMOKE, 2.0, 12);
    stage.Stage.SetLights({ MakeSun({ { 0.5, 0.2, -1.0 } }) });
    scene(false)(stage);
    stage.Stage.GetWindow()->SetMultiSamples(8 * i);
    stage.Stage.GetRenderer()->SetPass(stage.Pass);
    images[i] = stage.Stage.CaptureBytes();
    stage.Stage.GetRenderer()->SetPass(nullptr);
  }
  table.Catalogue.Measure("translucent-samples", "eight samples per pixel",
    "mean difference from an image with one sample", CompareImages(images[1], images[0]).Mean,
    5e-3);

  // If no volume is visible, the square is still drawn.
  const RgbaImage outside = Draw(
    [](SceneStage& stage)
    {
      stage.Stage.GetVolume()->SetPosition(0.0, 30.0, 0.0);
      AddSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
    });
  const RgbaImage without = Draw(
    [](SceneStage& stage)
    {
      stage.Stage.GetVolume()->VisibilityOff();
      AddSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
    });
  // VTK's own blending results in a different alpha, which is not compared.
  double largest = 0.0;
  for (std::size_t i = 0; i < outside.Values.size(); ++i)
  {
    const double difference = std::abs(outside.Values[i] - without.Values[i]);
    largest = i % 4 == 3 ? largest : std::max(largest, difference);
  }
  table.Catalogue.Measure("translucent-volume-away", "a volume outside the view",
    "largest difference from a scene without it", largest, 1e-4);
  table.Equal(
    "translucent-no-light", "no light",
    [](SceneStage& stage)
    {
      AddSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
      stage.Stage.SetLights({});
      stage.Stage.GetVolume()->VisibilityOff();
    },
    [](SceneStage& stage)
    {
      AddSquare({ { 0.0, 0.0, 0.05 } }, UP, 0.7)(stage);
      stage.Stage.SetLights({});
      stage.Stage.GetVolume()->VisibilityOff();
      stage.Pass->ShadowsOff();
    },
    0.0, "the image without the pass");

  SceneStage stage(PIXELS, 1.6);
  stage.Add(MakeFloor());
  stage.AddSmoke(SMOKE, 2.0, 12);
  stage.Stage.SetLights({ MakeSun({ { 0.5, 0.2, -1.0 } }) });
  scene(false)(stage);
  const RgbaImage before = stage.Draw();
  stage.Stage.GetWindow()->Finalize();
  table.Catalogue.Measure("translucent-context-remade",
    "an OpenGL context that is lost and created again",
    "largest difference from the previous image", CompareImages(stage.Draw(), before).Max, 0.0);
}

// Settings that are changed at random.
struct Settings
{
  std::vector<Vector> Positions{ { { 0.0, 0.0, 0.05 } }, { { 0.1, 0.0, 0.3 } } };
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
      this->Squares.push_back(
        MakeTranslucentSquare({ { 0.0, 0.0, 0.0 } }, { { 0.2, 0.1, 1.0 } }, 0.7));
      this->Stage.Add(this->Squares.back());
    }
  }

  RgbaImage Draw(const Settings& numbers)
  {
    for (std::size_t i = 0; i < this->Squares.size(); ++i)
    {
      this->Squares[i]->SetPosition(
        numbers.Positions[i][0], numbers.Positions[i][1], numbers.Positions[i][2]);
      this->Squares[i]->GetProperty()->SetOpacity(numbers.Opacities[i]);
    }
    this->Stage.Stage.GetVolume()->SetVisibility(numbers.HasSmoke);
    this->Stage.Pass->SetDepthMapResolution(numbers.Resolution);
    this->Stage.Stage.SetLights({ numbers.IsPositional
        ? MakePointLight({ { -numbers.Light[0], -numbers.Light[1], 2.0 } }, { { 0.0, 0.0, 0.0 } })
        : MakeSun(numbers.Light) });
    this->Stage.LookAlong(numbers.View);
    return this->Stage.Draw();
  }

  SceneStage Stage;
  std::vector<vtkSmartPointer<vtkActor>> Squares;
};

void TestChanges(Table& table)
{
  Random random(7);
  Settings numbers;
  ChangingStage stage;
  double largest = 0.0;
  int lit = 0;
  constexpr int changes = 12;
  for (int i = 0; i < changes; ++i)
  {
    const auto square = static_cast<std::size_t>(i % 2);
    switch (static_cast<int>(6.999 * random.Get(0.0, 1.0)))
    {
      case 0:
        numbers.Positions[square] = { { 0.4 * random.Get(0.0, 1.0) - 0.2, 0.0,
          1.2 * random.Get(0.0, 1.0) - 0.6 } };
        break;
      case 1:
        numbers.Opacities[square] = random.Get(0.0, 1.0) < 0.3 ? 1.0 : random.Get(0.0, 1.0);
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
    const RgbaImage expected = fresh.Draw(numbers);
    reference::KeepLargest(largest, CompareImages(stage.Draw(numbers), expected).Max);
    lit += expected.At(PIXELS / 2, PIXELS / 2)[0] > 0.02 ? 1 : 0;
  }
  table.Catalogue.Measure("translucent-random-changes", "12 random changes of one scene",
    "largest difference from new scenes", largest, 0.0);
  table.Catalogue.Measure("translucent-random-light", "12 random changes of one scene",
    "images with a dark center", changes - lit, changes / 3);
}

}

int TestTranslucentExtremes(int argc, char* argv[])
{
  Table table(argc, argv);
  TestOpacities(table);
  TestPositions(table);
  TestMeshes(table);
  TestRenderers(table);
  TestChanges(table);
  return table.Catalogue.GetExitCode();
}
