// SPDX-License-Identifier: BSD-3-Clause
// Translucent surfaces in vtkShadowedScenePass, composited in depth order with sliced smoke, and
// the light that they absorb. Images are compared with the double-precision reference of mixed
// scenes.
#include "Support/Checks/LargestError.h"
#include "Support/Images/MixedScene.h"
#include "Support/Images/ReferenceMixedImage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShaderProperty.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeMapper.h"
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

std::unique_ptr<SceneStage> MakeStage(
  const std::vector<vtkSmartPointer<vtkActor>>& squares, vtkLight* light, bool hasFloor = true)
{
  auto stage = std::make_unique<SceneStage>(PIXELS, SIZE);
  if (hasFloor)
  {
    stage->Add(
      MakeRectangle({ { -3.0, -3.0, -0.8 } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } }));
  }
  for (const vtkSmartPointer<vtkActor>& square : squares)
  {
    stage->Add(square);
  }
  stage->AddSmoke({ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } }, EXTINCTION, 24);
  stage->Stage.SetLights({ vtkSmartPointer<vtkLight>(light) });
  return stage;
}

// Converts the scene of a stage for the reference renderer.
MixedScene MakeMixed(SceneStage& stage, vtkLight* light)
{
  MixedScene scene;
  scene.Size = { { PIXELS, PIXELS } };
  scene.Camera = stage.Stage.GetRenderer()->GetActiveCamera();
  scene.Lights.push_back({ light, {} });
  SceneVolume smoke;
  vtkVolumeCollection* volumes = stage.Stage.GetRenderer()->GetVolumes();
  volumes->InitTraversal();
  while (vtkVolume* volume = volumes->GetNextVolume())
  {
    smoke.Image = vtkImageData::SafeDownCast(volume->GetMapper()->GetDataObjectInput());
    smoke.Property = volume->GetProperty();
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

// Returns the fraction of pixels with an error above 0.002. Such pixels are at edges of surfaces,
// smoke and shadows.
double Compare(SceneStage& stage, vtkLight* light, const std::string& name)
{
  const RgbaImage found = stage.Draw();
  const RgbaImage expected = MakeMixedImage(MakeMixed(stage, light));
  std::vector<double> errors;
  for (std::size_t i = 0; i < found.Values.size(); i += 4)
  {
    double largest = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      reference::KeepLargest(largest, std::abs(found.Values[i + k] - expected.Values[i + k]));
    }
    errors.push_back(largest);
  }
  const double fraction = static_cast<double>(std::count_if(errors.begin(), errors.end(),
                            [](double error) { return error > 0.002; })) /
    (PIXELS * PIXELS);
  std::sort(errors.begin(), errors.end());
  vtkInterlumeReport* report = stage.GetReport();
  std::cout << name << ": 90 % " << errors[errors.size() * 9 / 10] << ", largest " << errors.back()
            << ", above 0.002: " << fraction << " of the pixels, layers "
            << report->GetNumber("CameraLayers") << " " << report->GetNumber("LightLayers")
            << ", sweeps " << stage.Mapper->GetReport()->GetNumber("Sweeps") << " "
            << stage.Mapper->GetReport()->GetNumber("FrontToBackSweeps") << std::endl;
  return fraction;
}

void TestPositions(Check& check)
{
  const vtkSmartPointer<vtkLight> lights[3] = { MakeSun({ { 0.5, 0.2, -1.0 } }),
    MakeSun({ { 0.6, 0.1, 0.8 } }), MakePointLight({ { -1.0, 0.2, 2.0 } }, { { 0.0, 0.0, 0.0 } }) };
  const char* names[3] = { "sun", "sun from below", "point light" };
  const Vector up{ { 0.0, 0.0, 1.0 } };
  const Vector tilted{ { -0.8, 0.1, 0.6 } };
  const Vector other{ { 0.6, 0.2, 0.7 } };
  struct Case
  {
    const char* Name;
    std::vector<vtkSmartPointer<vtkActor>> Squares;
  };
  for (int i = 0; i < 3; ++i)
  {
    const std::vector<Case> cases{ { "without squares", {} },
      { "a square in front", { MakeTranslucentSquare({ { 0.05, 0.0, 0.5 } }, up, 0.6) } },
      { "a square inside", { MakeTranslucentSquare({ { 0.05, 0.0, 0.1 } }, up, 0.6) } },
      { "a square behind", { MakeTranslucentSquare({ { 0.05, 0.0, -0.5 } }, up, 0.6) } },
      { "a square across", { MakeTranslucentSquare({ { 0.0, 0.0, 0.05 } }, tilted, 0.9) } },
      { "two intersecting squares",
        { MakeTranslucentSquare({ { 0.0, 0.0, 0.05 } }, tilted, 0.9),
          MakeTranslucentSquare({ { 0.1, 0.0, 0.0 } }, other, 0.7, 0.3) } } };
    double edges = 0.0;
    for (const Case& one : cases)
    {
      // A floor would block light from below.
      const auto stage = MakeStage(one.Squares, lights[i], i != 1);
      const std::string name = std::string(names[i]) + ", " + one.Name;
      const double fraction = Compare(*stage, lights[i], name);
      // Edges of smoke cause errors even without squares. Edges of a square cause errors in one
      // more row of pixels.
      edges = one.Squares.empty() ? fraction : edges;
      check.Near(
        fraction, 0.0, edges + 0.02, name + ": fraction of pixels with an error above 0.002", 1.0);
      check.Equal(stage->GetReport()->GetCount("CameraLayers"),
        static_cast<int>(one.Squares.size()), name + ": camera layers");
      check.Equal(stage->GetReport()->GetCount("LightLayers"), static_cast<int>(one.Squares.size()),
        name + ": light layers");
    }
    check.Near(edges, 0.0, 0.08, std::string(names[i]) + ": edges of smoke", 1.0);
  }
}

// Tests two overlapping volumes in shared slices, with a square that intersects both.
void TestTwoVolumes(Check& check)
{
  const auto sun = MakeSun({ { 0.5, 0.2, -1.0 } });
  double edges = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    std::vector<vtkSmartPointer<vtkActor>> squares;
    if (i == 1)
    {
      squares.push_back(MakeTranslucentSquare({ { 0.0, 0.0, 0.1 } }, { { -0.8, 0.1, 0.6 } }, 0.9));
    }
    const auto stage = MakeStage(squares, sun);
    stage->AddSmoke({ { -0.3, 0.4, -0.35, 0.35, 0.1, 0.5 } }, 0.5 * EXTINCTION, 24);
    const std::string name = i == 0 ? "two volumes" : "two volumes, a square across";
    const double fraction = Compare(*stage, sun, name);
    check.Equal(stage->GetReport()->GetCount("Volumes"), 2, name + ": volumes");
    check.Equal(stage->GetReport()->GetCount("VolumesInSharedSlices"), 2,
      name + ": volumes in shared slices");
    check.Near(fraction, 0.0, i == 0 ? 0.08 : edges + 0.02,
      name + ": fraction of pixels with an error above 0.002", 1.0);
    edges = fraction;
  }
}

// Without volumes, VTK draws the squares, and the brightness of the floor behind them is exact.
void TestLight(Check& check)
{
  const auto sun = MakeSun({ { 0.0, 0.0, -1.0 } });
  for (const double opacity : { 0.25, 0.5, 1.0 })
  {
    for (int squares = 1; squares < 3; ++squares)
    {
      SceneStage stage(PIXELS, SIZE);
      stage.Add(
        MakeRectangle({ { -3.0, -3.0, -0.8 } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } }));
      for (int i = 0; i < squares; ++i)
      {
        vtkSmartPointer<vtkActor> square =
          MakeTranslucentSquare({ { 0.0, 0.0, 0.2 * i } }, { { 0.0, 0.0, 1.0 } }, 0.8, opacity);
        square->ForceTranslucentOn();
        square->GetProperty()->SetDiffuse(0.0);
        stage.Add(square);
      }
      stage.Stage.SetLights({ sun });
      const RgbaImage image = stage.Draw();
      const std::string name =
        std::to_string(squares) + " squares of opacity " + std::to_string(opacity);
      const double transmitted = std::pow(1.0 - opacity, squares);
      check.Near(
        stage.At(image, 0.0, 0.0), transmitted * transmitted, 1e-6, name + ": behind", 1.0);
      check.Near(stage.At(image, 0.6, 0.0), 1.0, 1e-6, name + ": next to the squares");
      check.Equal(stage.GetReport()->GetCount("LightLayers"), squares, name + ": light layers");
      check.Equal(stage.GetReport()->GetCount("CameraLayers"), 0, name + ": camera layers");
      check.Equal(stage.GetReport()->GetCount("LightLayerBytes"), 8LL * squares * 1024 * 1024,
        name + ": bytes");
    }
  }
}

// A clipping plane removes the left half of a square, both from the image and from its shadow.
// VTK's own shader code determines the coverage.
void TestMappers(Check& check)
{
  RgbaImage images[2];
  for (int i = 0; i < 2; ++i)
  {
    const auto sun = MakeSun({ { 0.5, 0.0, -1.0 } });
    vtkSmartPointer<vtkActor> square =
      MakeTranslucentSquare({ { 0.0, 0.0, 0.05 } }, { { 0.0, 0.0, 1.0 } }, 0.8);
    if (i == 0)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.0, 0.0);
      square->GetMapper()->AddClippingPlane(plane);
    }
    else
    {
      square = MakeRectangle({ { 0.0, -0.4, 0.05 } }, { { 0.4, 0.0, 0.0 } }, { { 0.0, 0.8, 0.0 } });
      square->GetProperty()->SetOpacity(0.5);
      square->GetProperty()->SetColor(0.9, 0.6, 0.2);
    }
    const auto stage = MakeStage({ square }, sun);
    images[i] = stage->Draw();
  }
  const ImageError clipped = CompareImages(images[0], images[1]);
  check.Near(clipped.Mean, 0.0, 1e-3, "a clipped square: mean difference from half a square", 1.0);

  // Opacity per point: the alpha component of the array increases from 0 to 1 along x.
  vtkNew<vtkPlaneSource> sheet;
  sheet->SetOrigin(-0.4, -0.4, 0.05);
  sheet->SetPoint1(0.4, -0.4, 0.05);
  sheet->SetPoint2(-0.4, 0.4, 0.05);
  sheet->Update();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(4);
  for (int i = 0; i < 4; ++i)
  {
    colors->InsertNextTuple4(0, 0, 0, i % 2 == 0 ? 0 : 255);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(sheet->GetOutput());
  mesh->GetPointData()->SetScalars(colors);
  vtkSmartPointer<vtkActor> actor = MakeActor(nullptr);
  vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(mesh);
  const auto stage = MakeStage({ actor }, MakeSun({ { 0.0, 0.0, -1.0 } }));
  stage->Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
  const RgbaImage image = stage->Draw();
  check.Equal(stage->GetReport()->GetCount("CameraLayers"), 1, "opacity per point: layers");
  double largest = 0.0;
  for (int i = 18; i < 46; ++i)
  {
    const double x = ((i + 0.5) / PIXELS - 0.5) * SIZE;
    const double transmitted = 0.5 - x / 0.8;
    const double expected = transmitted * transmitted * std::exp(-2.0 * EXTINCTION * 0.6);
    reference::KeepLargest(largest, std::abs(image.At(i, PIXELS / 2)[0] - expected));
  }
  check.Near(largest, 0.0, 2e-3, "opacity per point: the floor behind", 1.0);
}

// A warning names unsupported actors, and scenes without translucent actors require no additional
// work.
void TestCounters(Check& check)
{
  const auto sun = MakeSun({ { 0.5, 0.2, -1.0 } });
  {
    const auto stage = MakeStage({}, sun);
    stage->Draw();
    vtkInterlumeReport* report = stage->GetReport();
    check.Equal(report->GetCount("TranslucentActors") + report->GetCount("LightLayers") +
        report->GetCount("CameraLayers") + report->GetCount("SlicedSegments"),
      0, "no translucent actor: passes");
    check.Equal(report->GetCount("LightLayerBytes") + report->GetCount("CameraLayerBytes"), 0,
      "no translucent actor: bytes");
    check.That(stage->Mapper->GetReport()->GetText("Features").find("panes") == std::string::npos,
      "no translucent actor: features");
  }
  const auto square = MakeTranslucentSquare({ { 0.0, 0.0, 0.1 } }, { { 0.0, 0.0, 1.0 } }, 0.6);
  square->GetShaderProperty()->SetFragmentShaderCode("//VTK::System::Dec\n"
                                                     "//VTK::Output::Dec\n"
                                                     "void main()\n"
                                                     "{\n"
                                                     "  gl_FragData[0] = vec4(0.5);\n"
                                                     "}\n");
  const auto stage = MakeStage({ square }, sun);
  vtkNew<vtkTest::ErrorObserver> observer;
  stage->Pass->AddObserver(vtkCommand::WarningEvent, observer);
  stage->Draw();
  check.That(observer->GetWarning() &&
      observer->GetWarningMessage().find("is translucent") != std::string::npos,
    "a warning names an unsupported actor");
  check.Equal(
    stage->GetReport()->GetCount("TranslucentActors"), 0, "an unsupported actor is not counted");
  observer->Clear();
  stage->Draw();
  check.That(!observer->GetWarning(), "there is only one warning");
}

// The first image of a window, whose textures are not initialized yet, equals the second image.
void TestFirstImage(Check& check)
{
  const auto sun = MakeSun({ { 0.3, 0.2, -1.0 } });
  const auto stage =
    MakeStage({ MakeTranslucentSquare({ { 0.0, 0.0, 0.5 } }, { { 0.0, 0.0, 1.0 } }, 0.6) }, sun);
  stage->Stage.GetRenderer()->SetPass(stage->Pass);
  const auto draw = [&]()
  {
    vtkRenderWindow* window = stage->Stage.GetWindow();
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, PIXELS - 1, PIXELS - 1, 0, pixels);
    return std::vector<unsigned char>(pixels->Begin(), pixels->End());
  };
  const std::vector<unsigned char> first = draw();
  check.That(first == draw(), "the first image equals the second image");
  check.That(*std::max_element(first.begin(), first.end()) > 100, "the image is lit");
}

}

int TestTranslucentScene(int, char*[])
{
  Check check;
  TestFirstImage(check);
  TestPositions(check);
  TestTwoVolumes(check);
  TestLight(check);
  TestMappers(check);
  TestCounters(check);
  return check.Result();
}
