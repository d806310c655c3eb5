// SPDX-License-Identifier: BSD-3-Clause
// What vtkShadowedSliceMapper reports of its work: nothing for shadows that nobody casts, one
// buffer a light, sweeps by where lights are, nothing drawn of what is empty, nothing sent twice.
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
#include "Support/Pictures/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightKit.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "Loader/SoftwareOpenGL.h"
#include "vtkVolumeProperty.h"

namespace
{

using namespace reference;

ShadowScene SphereScene()
{
  auto scene = MakeScene(MakeImage(20, MakeSphere(0.15, 0.45)), MakeSoftProperty(0.5, true));
  scene.Size = { { 32, 32 } };
  return scene;
}

ReportCopy GetReport(const ShadowScene& scene)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  DrawByMapper(mapper, scene);
  return CopyReport(mapper->GetReport());
}

void ExpectNoShadows(Check& check, vtkInterlumeReport* report, const std::string& what)
{
  check.Near(report->GetNumber("ShadowedLights"), 0, 0.0, what + ": lights with shadows");
  check.Near(report->GetNumber("LightPasses"), 0, 0.0, what + ": light passes");
  check.Near(report->GetNumber("LightBuffers"), 0, 0.0, what + ": light buffers");
  check.Near(report->GetNumber("LightBufferBytes"), 0, 0.0, what + ": bytes of light buffers");
  check.That(report->GetText("Features").find("hadow") == std::string::npos,
    what + ": no shader of shadows");
  check.Near(report->GetNumber("Sweeps"), 1, 0.0, what + ": sweeps");
  check.That(report->GetNumber("ImagePasses") > 0, what + ": drawn");
}

void TestNoShadows(Check& check)
{
  for (bool shade : { true, false })
  {
    auto scene = SphereScene();
    scene.Property->SetShade(shade ? 1 : 0);
    scene.Lights.push_back(MakePositionalLight({ { -0.2, 0.4, -1.5 } }));
    const ReportCopy with = GetReport(scene);
    check.Near(with->GetNumber("Lights"), shade || with->GetNumber("ShadowedLights") > 0 ? 2 : 0,
      0.0, "lights");
    check.Near(with->GetNumber("ShadowedLights"), 2, 0.0, "lights with shadows");
    check.That(with->GetNumber("LightPasses") > 0, "light passes");
    check.That(with->GetText("Features").find("hadow") != std::string::npos, "shader of shadows");

    scene.Shadows = false;
    vtkNew<vtkShadowedSliceMapper> off;
    const RgbaPicture picture = DrawByMapper(off, scene);
    ExpectNoShadows(check, off->GetReport(), "shadows off");
    scene.Shadows = true;
    for (vtkLight* light : scene.Lights)
    {
      light->SetShadowAttenuation(0.0);
    }
    vtkNew<vtkShadowedSliceMapper> none;
    const PictureError error = ComparePictures(DrawByMapper(none, scene), picture);
    check.Near(error.Max, 0.0, 0.0, "the same without shadow attenuation");
    ExpectNoShadows(check, none->GetReport(), "no shadow attenuation");
    for (vtkLight* light : scene.Lights)
    {
      light->SetShadowAttenuation(1.0);
      light->SetSwitch(0);
    }
    ExpectNoShadows(check, GetReport(scene), "lights off");
    scene.Lights.clear();
    const ReportCopy dark = GetReport(scene);
    ExpectNoShadows(check, dark, "no lights");
    check.Near(dark->GetNumber("Lights"), 0, 0.0, "no lights: lights");
  }
}

void TestBuffers(Check& check)
{
  for (bool colored : { false, true })
  {
    auto scene = SphereScene();
    if (colored)
    {
      scene.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
      scene.TransmissionColor->AddRGBPoint(0.0, 1.0, 0.5, 0.2);
    }
    scene.Lights.clear();
    const int channels = colored ? 3 : 1;
    for (int lights = 1; lights <= 4; ++lights)
    {
      scene.Lights.push_back(MakeDirectionalLight({ { 0.3 * lights - 0.8, 0.4, -1.0 } }));
      vtkNew<vtkShadowedSliceMapper> mapper;
      mapper->SetLightBufferSize(64);
      DrawByMapper(mapper, scene);
      vtkInterlumeReport* report = mapper->GetReport();
      const std::string name =
        std::to_string(lights) + " lights, " + std::to_string(channels) + " channels";
      check.Near(report->GetNumber("ShadowedLights"), lights, 0.0, name + ": shadows");
      check.Near(report->GetNumber("LightBuffers"), lights, 0.0, name + ": buffers");
      check.Near(report->GetNumber("LightBufferSize"), 64, 0.0, name + ": size");
      check.Near(report->GetNumber("LightChannels"), channels, 0.0, name + ": channels");
      // Floats of transmittance, and two bytes of depth for what is opaque.
      check.Near(report->GetNumber("LightBufferBytes"), lights * 64 * 64 * (4 * channels + 2), 0.0,
        name + ": bytes");
    }
    const ReportCopy automatic = GetReport(scene);
    check.That(automatic->GetNumber("LightBufferSize") >= 20 &&
        automatic->GetNumber("LightBufferSize") <= 64,
      "as many samples as voxels are across");
    check.That(automatic->GetNumber("LightBufferBytes") <= 4 * (4 * channels + 2) *
          automatic->GetNumber("LightBufferSize") * automatic->GetNumber("LightBufferSize"),
      "bytes of buffers of the size that is reported");
  }
}

void TestSweeps(Check& check)
{
  auto scene = SphereScene();
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
  const auto sweeps = [&](const std::string& name, int all, int fromFront)
  {
    const ReportCopy report = GetReport(scene);
    check.Near(report->GetNumber("Sweeps"), all, 0.0, name + ": sweeps");
    check.Near(
      report->GetNumber("FrontToBackSweeps"), fromFront, 0.0, name + ": sweeps from front to back");
  };
  const auto front = MakeDirectionalLight({ { 0.3, -0.3, -1.0 } });
  const auto back = MakeDirectionalLight({ { 0.3, -0.3, 1.0 } });
  scene.Lights = { front };
  sweeps("light in front", 1, 1);
  scene.Lights = { back };
  sweeps("light behind", 1, 0);
  scene.Lights = { front, MakePositionalLight({ { -0.5, 0.4, 2.0 } }) };
  sweeps("two lights in front", 1, 1);
  scene.Lights = { front, back };
  sweeps("lights on both sides", 2, 1);
  scene.Lights = { MakePositionalLight({ { 0.05, 0.1, 0.0 } }) };
  sweeps("light inside", 2, 1);
}

/// A light inside the volume has halves of one sweep: no slice is drawn twice, and the light's
/// buffer is drawn once for each that has matter for the light.
void TestInside(Check& check)
{
  auto scene = SphereScene();
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
  scene.Lights = { MakePositionalLight({ { 0.05, 0.1, 0.07 } }) };
  scene.Shadows = false;
  const ReportCopy without = GetReport(scene);
  scene.Shadows = true;
  const ReportCopy with = GetReport(scene);
  check.Near(with->GetNumber("Sweeps"), 2, 0.0, "light inside: sweeps");
  check.That(with->GetNumber("Slices") <= without->GetNumber("Slices") + 1,
    "light inside: " + std::to_string(with->GetNumber("Slices")) + " slices for " +
      std::to_string(without->GetNumber("Slices")));
  check.That(with->GetNumber("ImagePasses") <= without->GetNumber("ImagePasses") + 1,
    "light inside: " + std::to_string(with->GetNumber("ImagePasses")) +
      " passes over the picture for " + std::to_string(without->GetNumber("ImagePasses")));
  check.That(with->GetNumber("LightPasses") <= with->GetNumber("ImagePasses"),
    "light inside: passes over the light's buffer");
  check.Near(with->GetNumber("ImageBuffers"), without->GetNumber("ImageBuffers"), 0.0,
    "light inside: buffers of the picture");

  // Beside the light's half the blocks are empty.
  const auto layer = [](const Double3& x) { return x[2] < 0.2 ? 1.0 : 0.0; };
  scene.Image = MakeImage(64, layer);
  scene.Lights = { MakePositionalLight({ { 0.0, 0.0, 0.1 } }) };
  const ReportCopy half = GetReport(scene);
  check.That(half->GetNumber("SlicesDrawn") < 0.5 * half->GetNumber("Slices"),
    "light inside: empty slices are left out");
  check.That(half->GetNumber("LightPasses") <= half->GetNumber("SlicesDrawn"),
    "light inside: and those of its buffer");
}

void TestBlocks(Check& check)
{
  // Two balls in opposite corners, with nothing between.
  const auto balls = [](const Double3& x)
  {
    const double a = vtkMath::Norm(Double3{ { x[0] - 0.1, x[1] - 0.1, x[2] - 0.1 } }.data());
    const double b = vtkMath::Norm(Double3{ { x[0] - 0.9, x[1] - 0.9, x[2] - 0.9 } }.data());
    return std::max(0.0, 1.0 - std::min(a, b) / 0.08);
  };
  auto scene = MakeScene(MakeImage(64, balls), MakeSoftProperty(0.9, true));
  scene.Lights = { MakeDirectionalLight({ { -0.4, -0.3, -1.0 } }) };
  const ReportCopy some = GetReport(scene);
  check.Near(some->GetNumber("Blocks"), 64, 0.0, "blocks of 16 cells");
  check.Near(some->GetNumber("BlocksDrawn"), 2, 0.0, "blocks with something to see");
  check.That(some->GetNumber("SlicesDrawn") > 0 &&
      some->GetNumber("SlicesDrawn") < some->GetNumber("Slices"),
    "slices between are left out");
  // A card drops fragments by itself.
  VolumeStage stage(scene.Size);
  stage.Render();
  const bool isSoftware = interlume::SoftwareOpenGL::IsUsed(
    vtkOpenGLRenderWindow::SafeDownCast(stage.GetRenderer()->GetRenderWindow()));
  const auto isEmptyFirst = [](vtkInterlumeReport* report)
  { return report->GetText("Features").find("empty-first") != std::string::npos; };
  check.That(isEmptyFirst(some) == isSoftware, "little matter: what is empty is drawn first");
  auto full =
    MakeScene(MakeImage(20, [](const Double3&) { return 1.0; }), MakeSoftProperty(0.5, true));
  check.That(!isEmptyFirst(GetReport(full)), "all is matter: no pass over what is empty");
  scene.Shadows = false;
  scene.Property->ShadeOff();
  check.That(!isEmptyFirst(GetReport(scene)), "no light: no pass over what is empty");
  scene.Shadows = true;

  scene.Image->GetPointData()->GetScalars()->Fill(0.0);
  scene.Image->GetPointData()->GetScalars()->Modified();
  vtkNew<vtkShadowedSliceMapper> mapper;
  const RgbaPicture picture = DrawByMapper(mapper, scene);
  vtkInterlumeReport* none = mapper->GetReport();
  check.Near(none->GetNumber("BlocksDrawn"), 0, 0.0, "nothing to see: blocks");
  check.Near(none->GetNumber("SlicesDrawn"), 0, 0.0, "nothing to see: slices");
  check.Near(none->GetNumber("LightPasses"), 0, 0.0, "nothing to see: light passes");
  check.Near(LargestAlpha(picture), 0.0, 0.0, "nothing to see: picture");
}

void TestUploads(Check& check)
{
  auto scene = SphereScene();
  vtkNew<vtkShadowedSliceMapper> mapper;
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  stage.Render();
  const ReportCopy first = CopyReport(mapper->GetReport());
  check.That(first->GetNumber("UploadedBytes") > 21 * 21 * 21, "the volume is sent");
  check.That(first->GetNumber("TextureBytes") > 21 * 21 * 21, "what is sent is kept");
  // Slices are sent for each view and light, textures are not.
  const auto expectNothing = [&](const std::string& name, bool isSame = true)
  {
    stage.Render();
    const vtkIdType sent = mapper->GetReport()->GetNumber("UploadedBytes");
    check.That(isSame ? sent == 0 : sent < first->GetNumber("TextureBytes") / 10,
      name + ": " + std::to_string(sent) + " bytes are sent");
    check.Near(mapper->GetReport()->GetNumber("TextureBytes"), first->GetNumber("TextureBytes"),
      0.0, name + ": kept");
  };
  expectNothing("the same again");
  scene.Camera->Azimuth(20.0);
  expectNothing("another camera", false);
  scene.Lights[0]->SetPosition(1.0, 1.0, -1.0);
  expectNothing("another light", false);
  scene.Property->GetRGBTransferFunction()->AddRGBPoint(0.5, 0.0, 1.0, 0.0);
  stage.Render();
  const vtkIdType colors = mapper->GetReport()->GetNumber("UploadedBytes");
  check.That(
    colors > 0 && colors < first->GetNumber("UploadedBytes"), "other colours: the functions alone");
  expectNothing("other colours, again");
  scene.Image->GetPointData()->GetScalars()->SetComponent(0, 0, 0.5);
  scene.Image->GetPointData()->GetScalars()->Modified();
  scene.Image->Modified();
  stage.Render();
  check.That(
    mapper->GetReport()->GetNumber("UploadedBytes") > 21 * 21 * 21, "other values are sent");
  expectNothing("other values, again");
}

/// Five lights, of which the brightest casts shadows.
void TestLightKit(Check& check)
{
  auto scene = SphereScene();
  scene.Lights.clear();
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetMaximumNumberOfShadows(1);
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(stage.GetRenderer());
  stage.Render();
  check.Near(mapper->GetReport()->GetNumber("Lights"),
    stage.GetRenderer()->GetLights()->GetNumberOfItems(), 0.0, "lights of a kit");
  check.Near(mapper->GetReport()->GetNumber("LightBuffers"), 1, 0.0, "buffers of a kit");
}

}

int TestShadowCounters(int, char*[])
{
  Check check;
  TestNoShadows(check);
  TestBuffers(check);
  TestSweeps(check);
  TestInside(check);
  TestBlocks(check);
  TestUploads(check);
  TestLightKit(check);
  return check.Result();
}
