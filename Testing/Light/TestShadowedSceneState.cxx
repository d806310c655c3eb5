// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowedScenePass among VTK's other parts: several lights, viewports, samples a pixel, kinds
// of shading, clipping, selection, other passes, resources given back, actors that cannot take
// part.
#include "Support/Drawing/ShadowPicture.h"
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

// A box and a ball on a floor, with black smoke in between.
std::unique_ptr<SceneStage> MakeStage()
{
  auto stage = std::make_unique<SceneStage>(96);
  stage->Add(MakeRectangle({ { -2.0, -2.0, -0.5 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }));
  stage->Add(MakeBox({ { 0.2, 0.5, -0.6, 0.1, -0.5, 0.4 } }));
  stage->Add(MakeBall({ { -0.3, 0.2, 0.0 } }, 0.25, 32));
  stage->AddSmoke({ { -0.4, 0.4, -0.4, 0.4, -0.3, 0.3 } }, 1.5, 16);
  stage->Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
  stage->Stage.SetLights({ MakeSun({ { 0.5, 0.3, -1.0 } }) });
  stage->LookAlong({ { 0.1, 0.7, -1.0 } });
  return stage;
}

void TestLights(Check& check)
{
  const vtkSmartPointer<vtkLight> suns[3] = { MakeSun({ { 0.5, 0.3, -1.0 } }),
    MakeLamp({ { -0.8, -0.5, 2.0 } }, { { 0.0, 0.0, 0.0 } }), MakeSun({ { -1.0, 0.2, -0.3 } }) };
  RgbaPicture pictures[3];
  for (int i = 0; i < 3; ++i)
  {
    auto stage = MakeStage();
    stage->Stage.SetLights({ suns[i] });
    pictures[i] = stage->Draw();
  }
  auto stage = MakeStage();
  stage->Stage.SetLights({ suns[0], suns[1], suns[2] });
  const RgbaPicture all = stage->Draw();
  check.Near(stage->GetReport()->GetNumber("DepthMaps"), 3, 0.0, "maps of three lights");
  double mean = 0.0;
  for (std::size_t i = 0; i < all.Values.size(); i += 4)
  {
    const double sum = pictures[0].Values[i] + pictures[1].Values[i] + pictures[2].Values[i];
    mean += std::abs(all.Values[i] - sum) / (all.Values.size() / 4);
  }
  // Slices for three lights are others than for one.
  check.Near(mean, 0.0, 1e-3, "three lights are the sum of each", 1.0);

  // What comes through is linear in the attenuation.
  RgbaPicture parts[2];
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
    const double expected = half + 0.5 * (half - pictures[0].Values[i]);
    largest = std::max(largest, std::abs(parts[1].Values[i] - expected));
  }
  check.Near(largest, 0.0, 1e-4, "a quarter of the attenuation", 1.0);
  suns[0]->SetShadowAttenuation(1.0F);

  // With a light at the eye actors cast none, and smoke does.
  vtkSmartPointer<vtkLight> head = MakeSun({ { 0.0, 0.0, -1.0 } });
  head->SetLightTypeToHeadlight();
  stage->Stage.SetLights({ head });
  stage->Draw();
  check.Near(stage->GetReport()->GetNumber("DepthMaps"), 0, 0.0, "maps of a headlight");
  check.That(stage->GetReport()->GetNumber("ReceiverPasses") > 0, "a headlight's smoke");
  // A lamp amid the actors looks to all sides.
  stage->Stage.SetLights({ MakeLamp({ { 0.0, 0.0, 0.45 } }, { { 0.0, 0.0, 0.0 } }) });
  stage->Draw();
  check.Near(stage->GetReport()->GetNumber("DepthMaps"), 6, 0.0, "maps of a lamp amid the actors");
  stage->Pass->SetMaximumNumberOfShadows(0);
  const RgbaPicture off = stage->Draw();
  check.Near(stage->GetReport()->GetNumber("DepthMaps"), 0, 0.0, "no light may cast shadows");
  stage->Pass->SetMaximumNumberOfShadows(16);
  stage->Pass->ShadowsOff();
  check.Near(ComparePictures(off, stage->Draw()).Max, 0.0, 0.0, "shadows off", 1.0);
}

void TestPasses(Check& check)
{
  auto stage = MakeStage();
  const RgbaPicture expected = stage->Draw();
  vtkNew<vtkRenderStepsPass> steps;
  stage->Pass->SetDelegatePass(steps);
  check.Near(ComparePictures(stage->Draw(), expected).Max, 0.0, 0.0, "steps as the delegate", 1.0);

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
  check.Near(ComparePictures(stage->Stage.Capture(), expected).Max, 0.0, 0.0,
    "in a sequence, with a sequence", 1.0);
  stage->Pass->SetDelegatePass(nullptr);

  stage->Pass->ReleaseGraphicsResources(stage->Stage.GetWindow());
  check.Near(
    ComparePictures(stage->Draw(), expected).Max, 0.0, 0.0, "after resources were freed", 1.0);
  // A map that is drawn again after the eye's camera was changed is that of before.
  const RgbaPicture before = stage->Draw();
  stage->LookAlong({ { -0.5, 0.7, -1.0 } });
  stage->Draw();
  check.Near(stage->GetReport()->GetNumber("DepthMapsDrawn"), 0, 0.0, "maps drawn for another eye");
  stage->LookAlong({ { 0.1, 0.7, -1.0 } });
  check.Near(ComparePictures(stage->Draw(), before).Max, 0.0, 0.0, "the eye back again", 1.0);
  // Programs that have just drawn maps draw the picture with the eye's lights.
  vtkSmartPointer<vtkActor> ball = MakeBall({ { -0.6, -0.5, 0.0 } }, 0.2, 32);
  stage->Add(ball);
  ball->SetPosition(0.1, 0.0, 0.0);
  stage->Draw();
  ball->SetPosition(0.0, 0.0, 0.0);
  stage->Stage.GetWindow()->Render();
  check.Near(
    stage->GetReport()->GetNumber("DepthMapsDrawn"), 1, 0.0, "maps drawn for an actor that moved");
  auto fresh = MakeStage();
  fresh->Add(MakeBall({ { -0.6, -0.5, 0.0 } }, 0.2, 32));
  check.Near(
    ComparePictures(stage->Draw(), fresh->Draw()).Max, 0.0, 0.0, "an actor back again", 1.0);
}

void TestViewports(Check& check)
{
  // Two renderers side by side, each as in a window of its own.
  auto alone = MakeStage();
  alone->Stage.GetRenderer()->SetPass(alone->Pass);
  alone->Stage.GetRenderer()->SetBackgroundAlpha(1.0);
  const RgbaPicture expected = ReadWindow(alone->Stage.GetWindow());

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
  left->AddActor(MakeBall({ { 0.0, 0.0, 0.0 } }, 0.5, 32));
  vtkNew<vtkShadowedScenePass> pass;
  left->SetPass(pass);
  window->AddRenderer(left);
  window->SetSize(192, 96);
  ReadWindow(window);
  const RgbaPicture both = ReadWindow(window);
  double largest = 0.0;
  for (int j = 0; j < 96; ++j)
  {
    for (int i = 0; i < 96; ++i)
    {
      largest = std::max(largest, std::abs(both.At(96 + i, j)[0] - expected.At(i, j)[0]));
    }
  }
  check.Near(largest, 0.0, 0.0, "the right one of two viewports", 1.0);
  check.That(both.At(48, 48)[0] > 0.5, "a ball in the left one");
  left->SetPass(nullptr);
  pass->ReleaseGraphicsResources(window);
  right->SetPass(nullptr);
  alone->Stage.GetRenderer()->SetPass(nullptr);
}

// How far pixels of eight samples lie beyond all of those around with one.
double MeasureBeyond(bool hasPass)
{
  RgbaPicture pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    auto stage = MakeStage();
    stage->Stage.GetWindow()->SetMultiSamples(8 * i);
    stage->Stage.GetRenderer()->SetPass(hasPass ? stage->Pass.Get() : nullptr);
    pictures[i] = ReadWindow(stage->Stage.GetWindow());
    stage->Stage.GetRenderer()->SetPass(nullptr);
  }
  double beyond = 0.0;
  for (int j = 1; j < 95; ++j)
  {
    for (int i = 1; i < 95; ++i)
    {
      double least = 1.0;
      double most = 0.0;
      for (int k = 0; k < 9; ++k)
      {
        const double value = pictures[0].At(i + k % 3 - 1, j + k / 3 - 1)[0];
        least = std::min(least, value);
        most = std::max(most, value);
      }
      const double value = pictures[1].At(i, j)[0];
      beyond = std::max({ beyond, least - value, value - most });
    }
  }
  return beyond;
}

void TestSamples(Check& check)
{
  const double with = MeasureBeyond(true);
  const double without = MeasureBeyond(false);
  std::cout << "eight samples a pixel: " << with << " beyond the pixels around, without the pass "
            << without << std::endl;
  // At an edge VTK shades a surface in the middle of the pixel, where it may lie under another one.
  check.Near(with, 0.0, 0.15, "edges of eight samples a pixel", 1.0);
}

void TestShading(Check& check)
{
  // A ball that no shadow falls on keeps its look.
  for (int kind = 0; kind < 6; ++kind)
  {
    SceneStage stage(64);
    vtkNew<vtkSphereSource> source;
    source->SetRadius(0.7);
    source->SetThetaResolution(64);
    source->SetPhiResolution(32);
    vtkNew<vtkElevationFilter> elevation;
    elevation->SetInputConnection(source->GetOutputPort());
    vtkSmartPointer<vtkActor> ball =
      MakeActor(kind == 2 ? elevation->GetOutputPort() : source->GetOutputPort());
    vtkProperty* property = ball->GetProperty();
    property->SetSpecular(0.4);
    property->SetSpecularPower(20.0);
    property->SetAmbient(0.1);
    vtkNew<vtkGlyph3DMapper> glyphs;
    vtkNew<vtkSphereSource> place;
    place->SetRadius(0.0);
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
        glyphs->SetInputConnection(place->GetOutputPort());
        glyphs->SetSourceConnection(source->GetOutputPort());
        glyphs->ScalingOff();
        ball->SetMapper(glyphs);
        break;
      default:
        break;
    }
    stage.Add(ball);
    // Something that falls out of the light's way, so that the map is not the ball's alone.
    stage.Stage.SetLights({ MakeSun({ { 0.1, 0.1, -1.0 } }) });
    const RgbaPicture with = stage.Draw();
    const RgbaPicture without = stage.Draw(false);
    double mean = 0.0;
    double brightness = 0.0;
    for (std::size_t i = 0; i < with.Values.size(); ++i)
    {
      mean += std::abs(with.Values[i] - without.Values[i]) / with.Values.size();
      brightness = std::max(brightness, without.Values[i]);
    }
    // Lines are as wide as texels in the map, which the next line of a mesh can hide.
    check.Near(mean, 0.0, kind == 4 ? 0.02 : 5e-4, "kind of shading " + std::to_string(kind), 1.0);
    check.That(brightness > 0.3, "lit, kind of shading " + std::to_string(kind));
  }
}

void TestClipping(Check& check)
{
  // A plate above a floor, cut at x = 0: its right half alone casts a shadow.
  SceneStage stage;
  stage.Add(MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
  vtkSmartPointer<vtkActor> plate =
    MakeRectangle({ { -0.4, -0.4, 0.3 } }, { { 0.8, 0.0, 0.0 } }, { { 0.0, 0.8, 0.0 } });
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  plate->GetMapper()->AddClippingPlane(plane);
  stage.Add(plate);
  stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -1.0 } }) });
  const RgbaPicture picture = stage.Draw();
  const double lit = std::sqrt(0.5);
  check.Near(stage.At(picture, -0.2, 0.0), lit, 1e-4, "the floor where the plate is cut");
  check.Near(stage.At(picture, 0.55, 0.0), 0.0, 0.0, "the shadow of what is left", 1.0);
  check.Near(stage.At(picture, 0.1, 0.6), lit, 1e-4, "beside the shadow");
}

void TestSelection(Check& check)
{
  auto stage = MakeStage();
  vtkSmartPointer<vtkActor> ball = MakeBall({ { 0.0, 0.0, 0.8 } }, 0.2, 16);
  stage->Add(ball);
  stage->LookAlong({ { 0.0, 0.0, -1.0 } });
  vtkRenderer* renderer = stage->Stage.GetRenderer();
  renderer->SetPass(stage->Pass);
  stage->Stage.GetWindow()->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(0, 0, 95, 95);
  check.That(selector->CaptureBuffers(), "a selection");
  const unsigned int middle[2] = { 48, 48 };
  check.That(selector->GetPixelInformation(middle, 0).Prop == ball, "the ball is selected");
  check.Near(stage->GetReport()->GetNumber("DepthMaps"), 0, 0.0, "maps for a selection");
  renderer->SetPass(nullptr);
}

void TestForeign(Check& check)
{
  // A shader of the actor's own, with light and without VTK's parts.
  auto stage = MakeStage();
  vtkSmartPointer<vtkActor> ball = MakeBall({ { 0.0, 0.0, 0.8 } }, 0.2, 16);
  ball->GetShaderProperty()->SetFragmentShaderCode("//VTK::System::Dec\n"
                                                   "//VTK::Output::Dec\n"
                                                   "uniform vec3 lightColor0;\n"
                                                   "void main()\n"
                                                   "{\n"
                                                   "  gl_FragData[0] = vec4(lightColor0, 1.0);\n"
                                                   "}\n");
  stage->Add(ball);
  vtkNew<vtkTest::ErrorObserver> observer;
  stage->Pass->AddObserver(vtkCommand::WarningEvent, observer);
  stage->Draw();
  check.That(observer->GetWarning() &&
      observer->GetWarningMessage().find("vtkOpenGLActor") != std::string::npos,
    "an actor that cannot take part is named");
  observer->Clear();
  stage->Draw();
  check.That(!observer->GetWarning(), "it is named once");
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
