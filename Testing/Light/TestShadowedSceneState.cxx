// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowedScenePass in combination with other parts of VTK: several lights, viewports,
// multisampling, kinds of shading, clipping, selection, other passes, released resources, and
// unsupported actors.
#include "Support/Checks/LargestError.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkElevationFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProperty.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTranslucentPass.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace reference;

// Creates a box and a sphere on a floor, with black smoke in between.
std::unique_ptr<SceneStage> MakeStage()
{
  auto stage = std::make_unique<SceneStage>(96);
  stage->Add(MakeRectangle({ { -2.0, -2.0, -0.5 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }));
  stage->Add(MakeBox({ { 0.2, 0.5, -0.6, 0.1, -0.5, 0.4 } }));
  stage->Add(MakeSphereActor({ { -0.3, 0.2, 0.0 } }, 0.25, 32));
  stage->AddSmoke({ { -0.4, 0.4, -0.4, 0.4, -0.3, 0.3 } }, 1.5, 16);
  stage->Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
  stage->Stage.SetLights({ MakeSun({ { 0.5, 0.3, -1.0 } }) });
  stage->LookAlong({ { 0.1, 0.7, -1.0 } });
  return stage;
}

void TestLights(Check& check)
{
  const vtkSmartPointer<vtkLight> suns[3] = { MakeSun({ { 0.5, 0.3, -1.0 } }),
    MakePointLight({ { -0.8, -0.5, 2.0 } }, { { 0.0, 0.0, 0.0 } }),
    MakeSun({ { -1.0, 0.2, -0.3 } }) };
  RgbaImage images[3];
  for (int i = 0; i < 3; ++i)
  {
    auto stage = MakeStage();
    stage->Stage.SetLights({ suns[i] });
    images[i] = stage->Draw();
  }
  auto stage = MakeStage();
  stage->Stage.SetLights({ suns[0], suns[1], suns[2] });
  const RgbaImage all = stage->Draw();
  check.Equal(stage->GetReport()->GetCount("DepthMaps"), 3, "shadow maps of three lights");
  double mean = 0.0;
  for (std::size_t i = 0; i < all.Values.size(); i += 4)
  {
    const double sum = images[0].Values[i] + images[1].Values[i] + images[2].Values[i];
    mean += std::abs(all.Values[i] - sum) / (all.Values.size() / 4);
  }
  // Slices for three lights differ from slices for one light, so only the mean is compared.
  check.Near(mean, 0.0, 1e-3, "three lights are the sum of single lights", 1.0);

  // The received light is linear in the shadow attenuation.
  RgbaImage parts[2];
  for (int i = 0; i < 2; ++i)
  {
    suns[0]->SetShadowAttenuation(0.5F - 0.25F * static_cast<float>(i));
    stage->Stage.SetLights({ suns[0] });
    parts[i] = stage->Draw();
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < all.Values.size(); i += 4)
  {
    const double half = parts[0].Values[i];
    const double expected = half + 0.5 * (half - images[0].Values[i]);
    reference::KeepLargest(largest, std::abs(parts[1].Values[i] - expected));
  }
  check.Near(largest, 0.0, 1e-4, "a quarter of the attenuation", 1.0);
  suns[0]->SetShadowAttenuation(1.0F);

  // With a headlight, smoke casts shadows but actors do not.
  vtkSmartPointer<vtkLight> head = MakeSun({ { 0.0, 0.0, -1.0 } });
  head->SetLightTypeToHeadlight();
  stage->Stage.SetLights({ head });
  stage->Draw();
  check.Equal(stage->GetReport()->GetCount("DepthMaps"), 0, "shadow maps of a headlight");
  check.That(stage->GetReport()->GetNumber("ReceiverPasses") > 0, "smoke shadows of a headlight");
  // A point light between the actors has shadow maps in all directions.
  stage->Stage.SetLights({ MakePointLight({ { 0.0, 0.0, 0.45 } }, { { 0.0, 0.0, 0.0 } }) });
  stage->Draw();
  check.Equal(stage->GetReport()->GetCount("DepthMaps"), 6,
    "shadow maps of a point light between the actors");
  stage->Pass->SetMaximumNumberOfShadowLights(0);
  const RgbaImage off = stage->Draw();
  check.Equal(stage->GetReport()->GetCount("DepthMaps"), 0, "no shadow maps without shadow lights");
  stage->Pass->SetMaximumNumberOfShadowLights(16);
  stage->Pass->ShadowsOff();
  check.Near(CompareImages(off, stage->Draw()).Max, 0.0, 0.0, "shadows off", 1.0);
}

void TestPasses(Check& check)
{
  auto stage = MakeStage();
  const RgbaImage expected = stage->Draw();
  vtkNew<vtkRenderStepsPass> steps;
  stage->Pass->SetDelegatePass(steps);
  check.Near(CompareImages(stage->Draw(), expected).Max, 0.0, 0.0,
    "a vtkRenderStepsPass as the delegate", 1.0);

  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(vtkNew<vtkTranslucentPass>());
  passes->AddItem(vtkNew<vtkVolumetricPass>());
  passes->AddItem(vtkNew<vtkOverlayPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  stage->Pass->SetDelegatePass(sequence);
  vtkNew<vtkRenderPassCollection> outer;
  outer->AddItem(stage->Pass);
  vtkNew<vtkSequencePass> all;
  all->SetPasses(outer);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(all);
  stage->Stage.SetPass(camera);
  check.Near(CompareImages(stage->Stage.Capture(), expected).Max, 0.0, 0.0,
    "inside a sequence, with a sequence as the delegate", 1.0);
  stage->Pass->SetDelegatePass(nullptr);

  stage->Pass->ReleaseGraphicsResources(stage->Stage.GetWindow());
  check.Near(
    CompareImages(stage->Draw(), expected).Max, 0.0, 0.0, "after resources were released", 1.0);
  // Shadow maps do not depend on the camera.
  const RgbaImage before = stage->Draw();
  stage->LookAlong({ { -0.5, 0.7, -1.0 } });
  stage->Draw();
  check.Equal(
    stage->GetReport()->GetCount("DepthMapsDrawn"), 0, "no shadow maps are drawn for another view");
  stage->LookAlong({ { 0.1, 0.7, -1.0 } });
  check.Near(CompareImages(stage->Draw(), before).Max, 0.0, 0.0, "the first view again", 1.0);
  // Actors are drawn with the correct lights even if their shader programs have just drawn shadow
  // maps.
  vtkSmartPointer<vtkActor> sphere = MakeSphereActor({ { -0.6, -0.5, 0.0 } }, 0.2, 32);
  stage->Add(sphere);
  sphere->SetPosition(0.1, 0.0, 0.0);
  stage->Draw();
  sphere->SetPosition(0.0, 0.0, 0.0);
  stage->Stage.GetWindow()->Render();
  check.Equal(
    stage->GetReport()->GetCount("DepthMapsDrawn"), 1, "shadow maps drawn for a moved actor");
  auto fresh = MakeStage();
  fresh->Add(MakeSphereActor({ { -0.6, -0.5, 0.0 } }, 0.2, 32));
  check.Near(CompareImages(stage->Draw(), fresh->Draw()).Max, 0.0, 0.0, "an actor moved back", 1.0);
}

void TestViewports(Check& check)
{
  // A renderer draws the same image next to another renderer as in a separate window.
  auto single = MakeStage();
  single->Stage.GetRenderer()->SetPass(single->Pass);
  single->Stage.GetRenderer()->SetBackgroundAlpha(1.0);
  const RgbaImage expected = single->Stage.CaptureBytes();

  auto stage = MakeStage();
  vtkRenderWindow* window = stage->Stage.GetWindow();
  vtkRenderer* right = stage->Stage.GetRenderer();
  right->SetBackgroundAlpha(1.0);
  right->SetPass(stage->Pass);
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  left->SetActiveCamera(right->GetActiveCamera());
  left->AutomaticLightCreationOff();
  left->AddLight(MakeSun({ { 0.5, 0.3, -1.0 } }));
  left->AddActor(MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.5, 32));
  vtkNew<vtkShadowedScenePass> pass;
  left->SetPass(pass);
  window->AddRenderer(left);
  window->SetSize(192, 96);
  ReadWindow(window);
  const RgbaImage both = ReadWindow(window);
  double largest = 0.0;
  for (int j = 0; j < 96; ++j)
  {
    for (int i = 0; i < 96; ++i)
    {
      reference::KeepLargest(largest, std::abs(both.At(96 + i, j)[0] - expected.At(i, j)[0]));
    }
  }
  check.Near(largest, 0.0, 0.0, "the right viewport", 1.0);
  check.That(both.At(48, 48)[0] > 0.5, "a sphere in the left viewport");
  left->SetPass(nullptr);
  pass->ReleaseGraphicsResources(window);
  right->SetPass(nullptr);
  single->Stage.GetRenderer()->SetPass(nullptr);
}

// Returns the largest deviation of pixels with 8 samples from the range of neighboring pixels with
// one sample.
double MeasureExcess(bool hasPass)
{
  RgbaImage images[2];
  for (int i = 0; i < 2; ++i)
  {
    auto stage = MakeStage();
    stage->Stage.GetWindow()->SetMultiSamples(8 * i);
    stage->Stage.GetRenderer()->SetPass(hasPass ? stage->Pass.Get() : nullptr);
    images[i] = stage->Stage.CaptureBytes();
    stage->Stage.GetRenderer()->SetPass(nullptr);
  }
  double excess = 0.0;
  for (int j = 1; j < 95; ++j)
  {
    for (int i = 1; i < 95; ++i)
    {
      double minimum = 1.0;
      double maximum = 0.0;
      for (int k = 0; k < 9; ++k)
      {
        const double value = images[0].At(i + k % 3 - 1, j + k / 3 - 1)[0];
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
      }
      const double value = images[1].At(i, j)[0];
      excess = std::max({ excess, minimum - value, value - maximum });
    }
  }
  return excess;
}

void TestSamples(Check& check)
{
  const double with = MeasureExcess(true);
  const double without = MeasureExcess(false);
  std::cout << "8 samples per pixel: deviation " << with
            << " from neighboring pixels, without the pass " << without << std::endl;
  // At edges, VTK shades a surface at the pixel's center, which may be behind another surface.
  check.Near(with, 0.0, 0.15, "edges with 8 samples per pixel", 1.0);
}

void TestShading(Check& check)
{
  // An unshadowed sphere looks the same with and without the pass.
  for (int kind = 0; kind < 6; ++kind)
  {
    SceneStage stage(64);
    vtkNew<vtkSphereSource> source;
    source->SetRadius(0.7);
    source->SetThetaResolution(64);
    source->SetPhiResolution(32);
    vtkNew<vtkElevationFilter> elevation;
    elevation->SetInputConnection(source->GetOutputPort());
    vtkSmartPointer<vtkActor> sphere =
      MakeActor(kind == 2 ? elevation->GetOutputPort() : source->GetOutputPort());
    vtkProperty* property = sphere->GetProperty();
    property->SetSpecular(0.4);
    property->SetSpecularPower(20.0);
    property->SetAmbient(0.1);
    vtkNew<vtkGlyph3DMapper> glyphs;
    vtkNew<vtkSphereSource> point;
    point->SetRadius(0.0);
    switch (kind)
    {
      case 0:
        property->SetInterpolationToFlat();
        break;
      case 1:
        property->SetInterpolationToPBR();
        property->SetRoughness(0.4);
        property->SetMetallic(0.3);
        break;
      case 3:
        property->LightingOff();
        break;
      case 4:
        property->SetRepresentationToWireframe();
        property->SetLineWidth(3.0F);
        break;
      case 5:
        glyphs->SetInputConnection(point->GetOutputPort());
        glyphs->SetSourceConnection(source->GetOutputPort());
        glyphs->ScalingOff();
        sphere->SetMapper(glyphs);
        break;
      default:
        break;
    }
    stage.Add(sphere);
    // The light comes from the front, so the sphere casts no visible shadow on itself.
    stage.Stage.SetLights({ MakeSun({ { 0.1, 0.1, -1.0 } }) });
    const RgbaImage with = stage.Draw();
    const RgbaImage without = stage.Draw(false);
    double mean = 0.0;
    double brightness = 0.0;
    for (std::size_t i = 0; i < with.Values.size(); ++i)
    {
      mean += std::abs(with.Values[i] - without.Values[i]) / with.Values.size();
      brightness = std::max(brightness, without.Values[i]);
    }
    // Wireframe lines are as wide as texels of the shadow map, so that neighboring lines can shadow
    // each other.
    check.Near(mean, 0.0, kind == 4 ? 0.02 : 5e-4, "kind of shading " + std::to_string(kind), 1.0);
    check.That(brightness > 0.3, "the sphere is lit, kind of shading " + std::to_string(kind));
  }
}

void TestClipping(Check& check)
{
  // A plate above a floor is clipped at x = 0. Only its right half casts a shadow.
  SceneStage stage;
  stage.Add(MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
  vtkSmartPointer<vtkActor> plate =
    MakeRectangle({ { -0.4, -0.4, 0.3 } }, { { 0.8, 0.0, 0.0 } }, { { 0.0, 0.8, 0.0 } });
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  plate->GetMapper()->AddClippingPlane(plane);
  stage.Add(plate);
  stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -1.0 } }) });
  const RgbaImage image = stage.Draw();
  const double lit = std::sqrt(0.5);
  check.Near(stage.At(image, -0.2, 0.0), lit, 1e-4, "the floor below the clipped half");
  check.Near(stage.At(image, 0.55, 0.0), 0.0, 0.0, "the shadow of the remaining half", 1.0);
  check.Near(stage.At(image, 0.1, 0.6), lit, 1e-4, "the floor outside the shadow");
}

void TestSelection(Check& check)
{
  auto stage = MakeStage();
  vtkSmartPointer<vtkActor> sphere = MakeSphereActor({ { 0.0, 0.0, 0.8 } }, 0.2, 16);
  stage->Add(sphere);
  stage->LookAlong({ { 0.0, 0.0, -1.0 } });
  vtkRenderer* renderer = stage->Stage.GetRenderer();
  renderer->SetPass(stage->Pass);
  stage->Stage.GetWindow()->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, 95, 95);
  check.That(selector->CaptureBuffers(), "the selection succeeds");
  const unsigned int center[2] = { 48, 48 };
  check.That(selector->GetPixelInformation(center, 0).Prop == sphere, "the sphere is selected");
  check.Equal(stage->GetReport()->GetCount("DepthMaps"), 0, "no shadow maps for a selection");
  renderer->SetPass(nullptr);
}

void TestForeign(Check& check)
{
  // A custom shader that uses VTK's light uniforms, but not its lighting code.
  auto stage = MakeStage();
  vtkSmartPointer<vtkActor> sphere = MakeSphereActor({ { 0.0, 0.0, 0.8 } }, 0.2, 16);
  sphere->GetShaderProperty()->SetFragmentShaderCode("//VTK::System::Dec\n"
                                                     "//VTK::Output::Dec\n"
                                                     "uniform vec3 lightColor0;\n"
                                                     "void main()\n"
                                                     "{\n"
                                                     "  gl_FragData[0] = vec4(lightColor0, 1.0);\n"
                                                     "}\n");
  stage->Add(sphere);
  vtkNew<vtkTest::ErrorObserver> observer;
  stage->Pass->AddObserver(vtkCommand::WarningEvent, observer);
  stage->Draw();
  check.That(observer->GetWarning() &&
      observer->GetWarningMessage().find("vtkOpenGLActor") != std::string::npos,
    "a warning names an unsupported actor");
  observer->Clear();
  stage->Draw();
  check.That(!observer->GetWarning(), "there is only one warning");
}

}

int TestShadowedSceneState(int, char*[])
{
  Check check;
  TestLights(check);
  TestPasses(check);
  TestViewports(check);
  TestSamples(check);
  TestShading(check);
  TestClipping(check);
  TestSelection(check);
  TestForeign(check);
  return check.Result();
}
