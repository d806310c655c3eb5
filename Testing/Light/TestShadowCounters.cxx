// SPDX-License-Identifier: BSD-3-Clause
// The report of vtkShadowedSliceMapper: no shadow work if no light casts shadows, one buffer per
// light, the sweeps that the light positions require, skipped empty regions, and a single upload of
// the data.
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
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
  auto scene = MakeScene(MakeImage(20, MakeSphere(0.15, 0.45)), MakeTranslucentProperty(0.5, true));
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
  check.Equal(report->GetCount("ShadowedLights"), 0, what + ": lights with shadows");
  check.Equal(report->GetCount("LightPasses"), 0, what + ": light passes");
  check.Equal(report->GetCount("LightBuffers"), 0, what + ": light buffers");
  check.Equal(report->GetCount("LightBufferBytes"), 0, what + ": bytes of light buffers");
  check.That(report->GetText("Features").find("hadow") == std::string::npos,
    what + ": no shader code for shadows");
  check.Equal(report->GetCount("Sweeps"), 1, what + ": sweeps");
  check.That(report->GetNumber("ImagePasses") > 0, what + ": the volume is drawn");
}

void TestNoShadows(Check& check)
{
  for (bool shade : { true, false })
  {
    auto scene = SphereScene();
    scene.Property->SetShade(shade ? 1 : 0);
    scene.Lights.push_back(MakePositionalLight({ { -0.2, 0.4, -1.5 } }));
    const ReportCopy with = GetReport(scene);
    check.Equal(
      with->GetCount("Lights"), shade || with->GetCount("ShadowedLights") > 0 ? 2 : 0, "lights");
    check.Equal(with->GetCount("ShadowedLights"), 2, "lights with shadows");
    check.That(with->GetNumber("LightPasses") > 0, "light passes");
    check.That(
      with->GetText("Features").find("hadow") != std::string::npos, "shader code for shadows");

    scene.Shadows = false;
    vtkNew<vtkShadowedSliceMapper> off;
    const RgbaImage image = DrawByMapper(off, scene);
    ExpectNoShadows(check, off->GetReport(), "shadows off");
    scene.Shadows = true;
    for (vtkLight* light : scene.Lights)
    {
      light->SetShadowAttenuation(0.0);
    }
    vtkNew<vtkShadowedSliceMapper> none;
    const ImageError error = CompareImages(DrawByMapper(none, scene), image);
    check.Near(error.Max, 0.0, 0.0, "equal image without shadow attenuation");
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
    check.Equal(dark->GetCount("Lights"), 0, "no lights: lights");
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
      check.Equal(report->GetCount("ShadowedLights"), lights, name + ": shadows");
      check.Equal(report->GetCount("LightBuffers"), lights, name + ": buffers");
      check.Equal(report->GetCount("LightBufferSize"), 64, name + ": size");
      check.Equal(report->GetCount("LightChannels"), channels, name + ": channels");
      // Each texel has four bytes of transmittance per channel, and two bytes of depth for opaque
      // regions.
      check.Equal(report->GetCount("LightBufferBytes"), lights * 64 * 64 * (4 * channels + 2),
        name + ": bytes");
    }
    const ReportCopy automatic = GetReport(scene);
    check.That(automatic->GetNumber("LightBufferSize") >= 20 &&
        automatic->GetNumber("LightBufferSize") <= 64,
      "the default size is about the number of voxels across");
    check.That(automatic->GetNumber("LightBufferBytes") <= 4 * (4 * channels + 2) *
          automatic->GetNumber("LightBufferSize") * automatic->GetNumber("LightBufferSize"),
      "the bytes match the reported size");
  }
}

void TestSweeps(Check& check)
{
  auto scene = SphereScene();
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
  const auto sweeps = [&](const std::string& name, int all, int fromFront)
  {
    const ReportCopy report = GetReport(scene);
    check.Equal(report->GetCount("Sweeps"), all, name + ": sweeps");
    check.Equal(
      report->GetCount("FrontToBackSweeps"), fromFront, name + ": sweeps from front to back");
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

/// A light inside the volume splits one sweep into two: no slice is drawn twice, and the light
/// buffer is drawn once for each nonempty slice.
void TestInside(Check& check)
{
  auto scene = SphereScene();
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
  scene.Lights = { MakePositionalLight({ { 0.05, 0.1, 0.07 } }) };
  scene.Shadows = false;
  const ReportCopy without = GetReport(scene);
  scene.Shadows = true;
  const ReportCopy with = GetReport(scene);
  check.Equal(with->GetCount("Sweeps"), 2, "light inside: sweeps");
  check.That(with->GetNumber("Slices") <= without->GetNumber("Slices") + 1,
    "light inside: " + std::to_string(with->GetNumber("Slices")) + " slices for " +
      std::to_string(without->GetNumber("Slices")));
  check.That(with->GetNumber("ImagePasses") <= without->GetNumber("ImagePasses") + 1,
    "light inside: " + std::to_string(with->GetNumber("ImagePasses")) + " image passes for " +
      std::to_string(without->GetNumber("ImagePasses")));
  check.That(
    with->GetNumber("LightPasses") <= with->GetNumber("ImagePasses"), "light inside: light passes");
  check.Equal(with->GetCount("ImageBuffers"), without->GetCount("ImageBuffers"),
    "light inside: image buffers");

  // Most blocks on one side of the light are empty.
  const auto layer = [](const Double3& x) { return x[2] < 0.2 ? 1.0 : 0.0; };
  scene.Image = MakeImage(64, layer);
  scene.Lights = { MakePositionalLight({ { 0.0, 0.0, 0.1 } }) };
  const ReportCopy half = GetReport(scene);
  check.That(half->GetNumber("SlicesDrawn") < 0.5 * half->GetNumber("Slices"),
    "light inside: empty slices are skipped");
  check.That(half->GetNumber("LightPasses") <= half->GetNumber("SlicesDrawn"),
    "light inside: light passes of empty slices are skipped");
}

void TestBlocks(Check& check)
{
  // Two spheres in opposite corners, with empty space between them.
  const auto spheres = [](const Double3& x)
  {
    const double a = vtkMath::Norm(Double3{ { x[0] - 0.1, x[1] - 0.1, x[2] - 0.1 } }.data());
    const double b = vtkMath::Norm(Double3{ { x[0] - 0.9, x[1] - 0.9, x[2] - 0.9 } }.data());
    return std::max(0.0, 1.0 - std::min(a, b) / 0.08);
  };
  auto scene = MakeScene(MakeImage(64, spheres), MakeTranslucentProperty(0.9, true));
  scene.Lights = { MakeDirectionalLight({ { -0.4, -0.3, -1.0 } }) };
  const ReportCopy some = GetReport(scene);
  check.Equal(some->GetCount("Blocks"), 64, "blocks of 16 cells");
  check.Equal(some->GetCount("BlocksDrawn"), 2, "visible blocks");
  check.That(some->GetNumber("SlicesDrawn") > 0 &&
      some->GetNumber("SlicesDrawn") < some->GetNumber("Slices"),
    "empty slices between the spheres are skipped");
  // Only software OpenGL draws empty regions first, in an additional pass.
  VolumeStage stage(scene.Size);
  stage.Render();
  const bool isSoftware = interlume::SoftwareOpenGL::IsUsed(
    vtkOpenGLRenderWindow::SafeDownCast(stage.GetRenderer()->GetRenderWindow()));
  const auto isEmptyFirst = [](vtkInterlumeReport* report)
  { return report->GetText("Features").find("empty-first") != std::string::npos; };
  check.That(isEmptyFirst(some) == isSoftware, "sparse medium: empty regions are drawn first");
  auto full = MakeScene(
    MakeImage(20, [](const Double3&) { return 1.0; }), MakeTranslucentProperty(0.5, true));
  check.That(!isEmptyFirst(GetReport(full)), "dense medium: no pass over empty regions");
  scene.Shadows = false;
  scene.Property->ShadeOff();
  check.That(!isEmptyFirst(GetReport(scene)), "no light: no pass over empty regions");
  scene.Shadows = true;

  scene.Image->GetPointData()->GetScalars()->Fill(0.0);
  scene.Image->GetPointData()->GetScalars()->Modified();
  vtkNew<vtkShadowedSliceMapper> mapper;
  const RgbaImage image = DrawByMapper(mapper, scene);
  vtkInterlumeReport* none = mapper->GetReport();
  check.Equal(none->GetCount("BlocksDrawn"), 0, "empty volume: blocks");
  check.Equal(none->GetCount("SlicesDrawn"), 0, "empty volume: slices");
  check.Equal(none->GetCount("LightPasses"), 0, "empty volume: light passes");
  check.Near(LargestAlpha(image), 0.0, 0.0, "empty volume: image");
}

void TestUploads(Check& check)
{
  auto scene = SphereScene();
  vtkNew<vtkShadowedSliceMapper> mapper;
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  stage.Render();
  const ReportCopy first = CopyReport(mapper->GetReport());
  check.That(first->GetNumber("UploadedBytes") > 21 * 21 * 21, "the volume is uploaded");
  check.That(first->GetNumber("TextureBytes") > 21 * 21 * 21, "the uploaded textures are retained");
  // Drawing the same frame again uploads nothing. After changing the view or a light, slices are
  // uploaded, but textures are not.
  const auto expectNothing = [&](const std::string& name, bool isSame = true)
  {
    stage.Render();
    const vtkIdType uploaded = mapper->GetReport()->GetNumber("UploadedBytes");
    check.That(isSame ? uploaded == 0 : uploaded < first->GetNumber("TextureBytes") / 10,
      name + ": " + std::to_string(uploaded) + " bytes are uploaded");
    check.Equal(mapper->GetReport()->GetCount("TextureBytes"), first->GetCount("TextureBytes"),
      name + ": retained textures");
  };
  expectNothing("drawing again");
  scene.Camera->Azimuth(20.0);
  expectNothing("another camera", false);
  scene.Lights[0]->SetPosition(1.0, 1.0, -1.0);
  expectNothing("another light", false);
  scene.Property->GetRGBTransferFunction()->AddRGBPoint(0.5, 0.0, 1.0, 0.0);
  stage.Render();
  const vtkIdType colors = mapper->GetReport()->GetNumber("UploadedBytes");
  check.That(colors > 0 && colors < first->GetNumber("UploadedBytes"),
    "other colors: only the functions are uploaded");
  expectNothing("other colors, drawn again");
  scene.Image->GetPointData()->GetScalars()->SetComponent(0, 0, 0.5);
  scene.Image->GetPointData()->GetScalars()->Modified();
  scene.Image->Modified();
  stage.Render();
  check.That(
    mapper->GetReport()->GetNumber("UploadedBytes") > 21 * 21 * 21, "other values are uploaded");
  expectNothing("other values, drawn again");
}

/// Tests a light kit of five lights, of which only the brightest casts shadows.
void TestLightKit(Check& check)
{
  auto scene = SphereScene();
  scene.Lights.clear();
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetMaximumNumberOfShadowLights(1);
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(stage.GetRenderer());
  stage.Render();
  check.Equal(mapper->GetReport()->GetCount("Lights"),
    stage.GetRenderer()->GetLights()->GetNumberOfItems(), "lights of the kit");
  check.Equal(mapper->GetReport()->GetCount("LightBuffers"), 1, "light buffers of the kit");
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
