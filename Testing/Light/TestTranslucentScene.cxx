// SPDX-License-Identifier: BSD-3-Clause
// Translucent surfaces in order with sliced smoke by vtkShadowedScenePass, and the light that they
// take, against the double-precision reference of mixed scenes.
#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/ReferenceMixedPicture.h"
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

// Compares the picture with the reference and returns the share of pixels that are off by more than
// 0.002: these lie at edges, of surfaces, of smoke and of shadows.
double Compare(SceneStage& stage, vtkLight* light, const std::string& name)
{
  const RgbaPicture found = stage.Draw();
  const RgbaPicture expected = MakeMixedPicture(MakeMixed(stage, light));
  std::vector<double> errors;
  for (std::size_t i = 0; i < found.Values.size(); i += 4)
  {
    double largest = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      largest = std::max(largest, std::abs(found.Values[i + k] - expected.Values[i + k]));
    }
    errors.push_back(largest);
  }
  const double off = static_cast<double>(std::count_if(
                       errors.begin(), errors.end(), [](double error) { return error > 0.002; })) /
    (PIXELS * PIXELS);
  std::sort(errors.begin(), errors.end());
  vtkInterlumeReport* report = stage.GetReport();
  std::cout << name << ": 90 % " << errors[errors.size() * 9 / 10] << ", largest " << errors.back()
            << ", above 0.002: " << off << " of the pixels, layers "
            << report->GetNumber("CameraLayers") << " " << report->GetNumber("LightLayers")
            << ", sweeps " << stage.Mapper->GetReport()->GetNumber("Sweeps") << " "
            << stage.Mapper->GetReport()->GetNumber("FrontToBackSweeps") << std::endl;
  return off;
}

void TestPlaces(Check& check)
{
  const vtkSmartPointer<vtkLight> lights[3] = { MakeSun({ { 0.5, 0.2, -1.0 } }),
    MakeSun({ { 0.6, 0.1, 0.8 } }), MakeLamp({ { -1.0, 0.2, 2.0 } }, { { 0.0, 0.0, 0.0 } }) };
  const char* names[3] = { "sun", "sun from below", "lamp" };
  const Vector up{ { 0.0, 0.0, 1.0 } };
  const Vector tilted{ { -0.8, 0.1, 0.6 } };
  const Vector other{ { 0.6, 0.2, 0.7 } };
  struct Case
  {
    const char* Name;
    std::vector<vtkSmartPointer<vtkActor>> Panes;
  };
  for (int i = 0; i < 3; ++i)
  {
    const std::vector<Case> cases{ { "without panes", {} },
      { "a pane before", { MakePane({ { 0.05, 0.0, 0.5 } }, up, 0.6) } },
      { "a pane inside", { MakePane({ { 0.05, 0.0, 0.1 } }, up, 0.6) } },
      { "a pane behind", { MakePane({ { 0.05, 0.0, -0.5 } }, up, 0.6) } },
      { "a pane across", { MakePane({ { 0.0, 0.0, 0.05 } }, tilted, 0.9) } },
      { "two panes through each other",
        { MakePane({ { 0.0, 0.0, 0.05 } }, tilted, 0.9),
          MakePane({ { 0.1, 0.0, 0.0 } }, other, 0.7, 0.3) } } };
    double edges = 0.0;
    for (const Case& one : cases)
    {
      // A floor would keep light from below out.
      const auto stage = MakeStage(one.Panes, lights[i], i != 1);
      const std::string name = std::string(names[i]) + ", " + one.Name;
      const double off = Compare(*stage, lights[i], name);
      // Those at edges of smoke are there without panes; an edge of a pane adds a row of pixels.
      edges = one.Panes.empty() ? off : edges;
      check.Near(off, 0.0, edges + 0.02, name + ": share of pixels off by 0.002", 1.0);
      check.Near(stage->GetReport()->GetNumber("CameraLayers"), static_cast<int>(one.Panes.size()),
        0.0, name + ": layers of the eye");
      check.Near(stage->GetReport()->GetNumber("LightLayers"), static_cast<int>(one.Panes.size()),
        0.0, name + ": layers of the light");
    }
    check.Near(edges, 0.0, 0.08, std::string(names[i]) + ": edges of smoke", 1.0);
  }
}

// Two volumes in one set of slices, which overlap, with a pane across both.
void TestTwoVolumes(Check& check)
{
  const auto sun = MakeSun({ { 0.5, 0.2, -1.0 } });
  double edges = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    std::vector<vtkSmartPointer<vtkActor>> panes;
    if (i == 1)
    {
      panes.push_back(MakePane({ { 0.0, 0.0, 0.1 } }, { { -0.8, 0.1, 0.6 } }, 0.9));
    }
    const auto stage = MakeStage(panes, sun);
    stage->AddSmoke({ { -0.3, 0.4, -0.35, 0.35, 0.1, 0.5 } }, 0.5 * EXTINCTION, 24);
    const std::string name = i == 0 ? "two volumes" : "two volumes, a pane across";
    const double off = Compare(*stage, sun, name);
    check.Near(stage->GetReport()->GetNumber("Volumes"), 2, 0.0, name + ": volumes");
    check.Near(
      stage->GetReport()->GetNumber("VolumesInSharedSlices"), 2, 0.0, name + ": volumes together");
    check.Near(
      off, 0.0, i == 0 ? 0.08 : edges + 0.02, name + ": share of pixels off by 0.002", 1.0);
    edges = off;
  }
}

// Without volumes: the floor behind panes has the light that they leave, exactly, and VTK draws
// them.
void TestLight(Check& check)
{
  const auto sun = MakeSun({ { 0.0, 0.0, -1.0 } });
  for (const double opacity : { 0.25, 0.5, 1.0 })
  {
    for (int panes = 1; panes < 3; ++panes)
    {
      SceneStage stage(PIXELS, SIZE);
      stage.Add(
        MakeRectangle({ { -3.0, -3.0, -0.8 } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } }));
      for (int i = 0; i < panes; ++i)
      {
        vtkSmartPointer<vtkActor> pane =
          MakePane({ { 0.0, 0.0, 0.2 * i } }, { { 0.0, 0.0, 1.0 } }, 0.8, opacity);
        pane->ForceTranslucentOn();
        pane->GetProperty()->SetDiffuse(0.0);
        stage.Add(pane);
      }
      stage.Stage.SetLights({ sun });
      const RgbaPicture picture = stage.Draw();
      const std::string name =
        std::to_string(panes) + " panes of opacity " + std::to_string(opacity);
      const double through = std::pow(1.0 - opacity, panes);
      check.Near(stage.At(picture, 0.0, 0.0), through * through, 1e-6, name + ": behind", 1.0);
      check.Near(stage.At(picture, 0.6, 0.0), 1.0, 1e-6, name + ": beside");
      check.Near(
        stage.GetReport()->GetNumber("LightLayers"), panes, 0.0, name + ": layers of the light");
      check.Near(
        stage.GetReport()->GetNumber("CameraLayers"), 0, 0.0, name + ": layers of the eye");
      check.Near(stage.GetReport()->GetNumber("LightLayerBytes"), 8LL * panes * 1024 * 1024, 0.0,
        name + ": bytes");
    }
  }
}

// A sheet of colours by points, of which a clipping plane leaves the right half: both show in the
// picture and in the shadow, since VTK's own shader decides.
void TestMappers(Check& check)
{
  RgbaPicture pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    const auto sun = MakeSun({ { 0.5, 0.0, -1.0 } });
    vtkSmartPointer<vtkActor> pane = MakePane({ { 0.0, 0.0, 0.05 } }, { { 0.0, 0.0, 1.0 } }, 0.8);
    if (i == 0)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.0, 0.0);
      pane->GetMapper()->AddClippingPlane(plane);
    }
    else
    {
      pane = MakeRectangle({ { 0.0, -0.4, 0.05 } }, { { 0.4, 0.0, 0.0 } }, { { 0.0, 0.8, 0.0 } });
      pane->GetProperty()->SetOpacity(0.5);
      pane->GetProperty()->SetColor(0.9, 0.6, 0.2);
    }
    const auto stage = MakeStage({ pane }, sun);
    pictures[i] = stage->Draw();
  }
  const PictureError clipped = ComparePictures(pictures[0], pictures[1]);
  check.Near(clipped.Mean, 0.0, 1e-3, "a pane that is cut: mean difference from half a pane", 1.0);

  // Opacity by points: the array's alpha, which goes from 0 to 1 along x.
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
  const RgbaPicture picture = stage->Draw();
  check.Near(stage->GetReport()->GetNumber("CameraLayers"), 1, 0.0, "opacity by points: layers");
  double largest = 0.0;
  for (int i = 18; i < 46; ++i)
  {
    const double x = ((i + 0.5) / PIXELS - 0.5) * SIZE;
    const double through = 0.5 - x / 0.8;
    const double expected = through * through * std::exp(-2.0 * EXTINCTION * 0.6);
    largest = std::max(largest, std::abs(picture.At(i, PIXELS / 2)[0] - expected));
  }
  check.Near(largest, 0.0, 2e-3, "opacity by points: the floor behind", 1.0);
}

// What takes no part, and what no part costs.
void TestCounters(Check& check)
{
  const auto sun = MakeSun({ { 0.5, 0.2, -1.0 } });
  {
    const auto stage = MakeStage({}, sun);
    stage->Draw();
    vtkInterlumeReport* report = stage->GetReport();
    check.Near(report->GetNumber("TranslucentActors") + report->GetNumber("LightLayers") +
        report->GetNumber("CameraLayers") + report->GetNumber("SlicedSegments"),
      0, 0.0, "no translucent actor: passes");
    check.Near(report->GetNumber("LightLayerBytes") + report->GetNumber("CameraLayerBytes"), 0, 0.0,
      "no translucent actor: bytes");
    check.That(stage->Mapper->GetReport()->GetText("Features").find("panes") == std::string::npos,
      "no translucent actor: features");
  }
  const auto pane = MakePane({ { 0.0, 0.0, 0.1 } }, { { 0.0, 0.0, 1.0 } }, 0.6);
  pane->GetShaderProperty()->SetFragmentShaderCode("//VTK::System::Dec\n"
                                                   "//VTK::Output::Dec\n"
                                                   "void main()\n"
                                                   "{\n"
                                                   "  gl_FragData[0] = vec4(0.5);\n"
                                                   "}\n");
  const auto stage = MakeStage({ pane }, sun);
  vtkNew<vtkTest::ErrorObserver> observer;
  stage->Pass->AddObserver(vtkCommand::WarningEvent, observer);
  stage->Draw();
  check.That(observer->GetWarning() &&
      observer->GetWarningMessage().find("is translucent") != std::string::npos,
    "an actor that cannot take part is named");
  check.Near(
    stage->GetReport()->GetNumber("TranslucentActors"), 0, 0.0, "an actor that cannot take part");
  observer->Clear();
  stage->Draw();
  check.That(!observer->GetWarning(), "it is named once");
}

// The first picture of a window, whose textures have no values yet, is as the second one.
void TestFirstPicture(Check& check)
{
  const auto sun = MakeSun({ { 0.3, 0.2, -1.0 } });
  const auto stage =
    MakeStage({ MakePane({ { 0.0, 0.0, 0.5 } }, { { 0.0, 0.0, 1.0 } }, 0.6) }, sun);
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
  check.That(first == draw(), "the first picture is as the second");
  check.That(*std::max_element(first.begin(), first.end()) > 100, "there is light in it");
}

}

int TestTranslucentScene(int, char*[])
{
  Check check;
  TestFirstPicture(check);
  TestPlaces(check);
  TestTwoVolumes(check);
  TestLight(check);
  TestMappers(check);
  TestCounters(check);
  return check.Result();
}
