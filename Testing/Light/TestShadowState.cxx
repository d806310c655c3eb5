// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowedSliceMapper in windows: several viewports and windows, 8-bit and floating-point
// targets, stereo, backgrounds, props that are drawn later, and changes between frames.
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr double Byte = 1.0 / 255.0;

ShadowScene SphereScene()
{
  auto scene = MakeScene(MakeImage(16, MakeSphere(0.15, 0.45)), MakeTranslucentProperty(0.6, true));
  scene.Size = { { 51, 40 } };
  return scene;
}

/// Returns \a width columns of an image, starting at \a left.
RgbaImage Crop(const RgbaImage& image, int left, int width)
{
  RgbaImage part(width, image.Height);
  for (int j = 0; j < image.Height; ++j)
  {
    std::copy_n(image.At(left, j), 4 * static_cast<std::size_t>(width), part.At(0, j));
  }
  return part;
}

/// Composites an image over an opaque background.
RgbaImage Over(const RgbaImage& image, const Double3& background)
{
  RgbaImage result = image;
  for (int j = 0; j < image.Height; ++j)
  {
    for (int i = 0; i < image.Width; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        result.At(i, j)[k] += (1.0 - image.At(i, j)[3]) * background[k];
      }
      result.At(i, j)[3] = 1.0;
    }
  }
  return result;
}

void ExpectSame(Check& check, const std::string& name, const RgbaImage& found,
  const RgbaImage& expected, double bound = 0.0)
{
  check.Near(CompareImages(found, expected).Max, 0.0, bound, name, 1.0);
}

void AddSceneTo(vtkRenderer* renderer, vtkShadowedSliceMapper* mapper, const ShadowScene& scene)
{
  Configure(mapper, scene);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(scene.Property);
  renderer->AddVolume(volume);
  renderer->SetActiveCamera(scene.Camera);
  renderer->AutomaticLightCreationOff();
  for (vtkLight* light : scene.Lights)
  {
    renderer->AddLight(light);
  }
}

vtkSmartPointer<vtkActor> MakeSphereActor(const Double3& center, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.5, 0.2);
  return actor;
}

/// Tests that 8-bit targets show the same image as floating-point targets, over an unchanged
/// background.
void TestTargets(Check& check)
{
  const auto scene = SphereScene();
  vtkNew<vtkShadowedSliceMapper> mapper;
  const RgbaImage floats = DrawByMapper(mapper, scene);
  check.That(LargestAlpha(floats) > 0.5, "the image is not empty");
  for (const Double3& background : { Double3{ { 0.0, 0.0, 0.0 } }, Double3{ { 0.2, 0.6, 0.4 } } })
  {
    VolumeStage stage(scene.Size);
    SetScene(stage, mapper, scene);
    stage.GetRenderer()->SetBackground(background[0], background[1], background[2]);
    const RgbaImage bytes = stage.CaptureBytes();
    // The image, the background and the blending each add one rounding error.
    ExpectSame(check, "8-bit target", bytes, Over(floats, background), 1.25 * Byte);
    for (int k = 0; k < 3; ++k)
    {
      check.Near(bytes.At(0, 0)[k], background[k], 0.5 * Byte, "background in the corner", 1.0);
    }
  }
}

/// Two viewports of a window with different content do not affect each other.
void TestViewports(Check& check)
{
  const auto left = SphereScene();
  auto right = SphereScene();
  right.Camera = LookAt(right.Image, { { 1.0, 0.2, 0.3 } }, true);
  right.Lights = { MakeDirectionalLight({ { -1.0, -1.0, 0.2 } }) };
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(102, 40);
  const ShadowScene* const scenes[2] = { &left, &right };
  vtkNew<vtkShadowedSliceMapper> mappers[2];
  for (int side = 0; side < 2; ++side)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(0.5 * side, 0.0, 0.5 + 0.5 * side, 1.0);
    AddSceneTo(renderer, mappers[side], *scenes[side]);
    window->AddRenderer(renderer);
  }
  for (int frame = 0; frame < 2; ++frame)
  {
    const RgbaImage both = ReadWindow(window);
    for (int side = 0; side < 2; ++side)
    {
      vtkNew<vtkShadowedSliceMapper> single;
      const RgbaImage expected = Over(DrawByMapper(single, *scenes[side]), { { 0.0, 0.0, 0.0 } });
      ExpectSame(check, side == 0 ? "left viewport" : "right viewport", Crop(both, 51 * side, 51),
        expected, 1.1 * Byte);
    }
  }
}

/// Tests one volume in two viewports.
void TestSharedVolume(Check& check)
{
  const auto scene = SphereScene();
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(102, 40);
  vtkNew<vtkShadowedSliceMapper> mapper;
  for (int side = 0; side < 2; ++side)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(0.5 * side, 0.0, 0.5 + 0.5 * side, 1.0);
    AddSceneTo(renderer, mapper, scene);
    window->AddRenderer(renderer);
  }
  const RgbaImage both = ReadWindow(window);
  vtkNew<vtkShadowedSliceMapper> single;
  const RgbaImage expected = Over(DrawByMapper(single, scene), { { 0.0, 0.0, 0.0 } });
  for (int side = 0; side < 2; ++side)
  {
    ExpectSame(
      check, "one mapper in two viewports", Crop(both, 51 * side, 51), expected, 1.1 * Byte);
  }
}

/// Tests that the volume does not change surfaces in a viewport that is drawn later.
void TestAfter(Check& check)
{
  RgbaImage images[2];
  for (int with = 0; with < 2; ++with)
  {
    const auto scene = SphereScene();
    vtkNew<vtkRenderWindow> window;
    window->OffScreenRenderingOn();
    window->SetMultiSamples(0);
    window->SetSize(102, 40);
    vtkNew<vtkRenderer> left;
    left->SetViewport(0.0, 0.0, 0.5, 1.0);
    vtkNew<vtkShadowedSliceMapper> mapper;
    if (with == 1)
    {
      AddSceneTo(left, mapper, scene);
    }
    window->AddRenderer(left);
    vtkNew<vtkRenderer> right;
    right->SetViewport(0.5, 0.0, 1.0, 1.0);
    right->SetBackground(0.3, 0.2, 0.1);
    right->AddActor(MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.4));
    const auto translucent = MakeSphereActor({ { 0.2, 0.0, 0.3 } }, 0.2);
    translucent->GetProperty()->SetOpacity(0.5);
    right->AddActor(translucent);
    right->SetActiveCamera(scene.Camera);
    window->AddRenderer(right);
    ReadWindow(window);
    images[with] = Crop(ReadWindow(window), 51, 51);
  }
  ExpectSame(check, "surfaces in a later viewport", images[1], images[0]);
}

Double3 GetCentroid(const RgbaImage& image)
{
  Double3 sum{};
  for (int j = 0; j < image.Height; ++j)
  {
    for (int i = 0; i < image.Width; ++i)
    {
      const double weight = image.At(i, j)[0] + image.At(i, j)[1] + image.At(i, j)[2];
      sum[0] += weight * i;
      sum[1] += weight * j;
      sum[2] += weight;
    }
  }
  return { { sum[0] / sum[2], sum[1] / sum[2], sum[2] } };
}

/// For each eye, the volume appears at the same position as a polygonal sphere with the same
/// center.
void TestStereo(Check& check)
{
  auto scene = SphereScene();
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, false);
  scene.Camera->SetFocalPoint(0.0, 0.0, -1.0);
  scene.Camera->SetEyeAngle(8.0);
  scene.Lights = { MakeDirectionalLight({ { 0.0, 0.0, -1.0 } }) };
  double centers[2] = { 0.0, 0.0 };
  const int types[2] = { VTK_STEREO_LEFT, VTK_STEREO_RIGHT };
  RgbaImage views[2];
  for (int side = 0; side < 2; ++side)
  {
    vtkNew<vtkShadowedSliceMapper> mapper;
    VolumeStage stage(scene.Size);
    SetScene(stage, mapper, scene);
    stage.GetWindow()->SetStereoType(types[side]);
    stage.GetWindow()->StereoRenderOn();
    views[side] = stage.CaptureBytes();
    const Double3 volume = GetCentroid(views[side]);
    check.That(volume[2] > 10.0, "the volume is visible");
    stage.GetVolume()->VisibilityOff();
    const auto actor = MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.35);
    actor->GetProperty()->LightingOff();
    stage.AddActor(actor);
    const Double3 surface = GetCentroid(stage.CaptureBytes());
    check.Near(volume[0], surface[0], 0.3, "the horizontal position of the volume", 1.0);
    check.Near(volume[1], surface[1], 0.3, "the vertical position of the volume", 1.0);
    centers[side] = volume[0];
  }
  check.That(std::abs(centers[0] - centers[1]) > 1.0, "both eyes have different positions");
  vtkNew<vtkShadowedSliceMapper> mapper;
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  stage.GetWindow()->SetStereoTypeToAnaglyph();
  stage.GetWindow()->SetAnaglyphColorSaturation(0.0F);
  stage.GetWindow()->StereoRenderOn();
  const RgbaImage anaglyph = stage.CaptureBytes();
  double red = 0.0;
  double cyan = 0.0;
  double sums[2] = { 0.0, 0.0 };
  for (int j = 0; j < anaglyph.Height; ++j)
  {
    for (int i = 0; i < anaglyph.Width; ++i)
    {
      red += i * anaglyph.At(i, j)[0];
      sums[0] += anaglyph.At(i, j)[0];
      cyan += i * anaglyph.At(i, j)[2];
      sums[1] += anaglyph.At(i, j)[2];
    }
  }
  check.Near(red / sums[0], centers[0], 0.5, "red of an anaglyph is the left view", 1.0);
  check.Near(cyan / sums[1], centers[1], 0.5, "cyan of an anaglyph is the right view", 1.0);
}

/// After each change, the image equals the image of a new mapper.
void TestChanges(Check& check)
{
  auto scene = SphereScene();
  vtkNew<vtkShadowedSliceMapper> mapper;
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  RgbaImage before = stage.Capture();
  const auto change = [&](const std::string& name, const std::function<void()>& what)
  {
    what();
    const RgbaImage found = stage.Capture();
    check.That(CompareImages(found, before).Max > 1e-3, name + " changes the image");
    vtkNew<vtkShadowedSliceMapper> fresh;
    fresh->SetSliceSpacing(mapper->GetSliceSpacing());
    fresh->SetShadows(mapper->GetShadows());
    ShadowScene now = scene;
    now.Shadows = mapper->GetShadows();
    now.TransmissionColor = mapper->GetTransmissionColor();
    ExpectSame(check, name + ", same as by a new mapper", found, DrawByMapper(fresh, now));
    before = found;
  };
  change("opacity", [&] { scene.Property->GetScalarOpacity()->AddPoint(0.5, 0.6); });
  change("color", [&] { scene.Property->GetRGBTransferFunction()->AddRGBPoint(0.5, 1, 0, 0); });
  change("shade", [&] { scene.Property->ShadeOff(); });
  change("diffuse", [&] { scene.Property->SetDiffuse(0.5); });
  change("unit distance", [&] { scene.Property->SetScalarOpacityUnitDistance(0.3); });
  change("light position", [&] { scene.Lights[0]->SetPosition(1.0, 1.0, -0.3); });
  change("light color", [&] { scene.Lights[0]->SetDiffuseColor(0.2, 0.6, 1.0); });
  change("light shadow", [&] { scene.Lights[0]->SetShadowAttenuation(0.3); });
  change("camera", [&] { scene.Camera->Azimuth(30.0); });
  change("projection", [&] { scene.Camera->ParallelProjectionOn(); });
  change("values",
    [&]
    {
      vtkDataArray* values = scene.Image->GetPointData()->GetScalars();
      for (vtkIdType id = 0; id < values->GetNumberOfTuples() / 2; ++id)
      {
        values->SetComponent(id, 0, 0.0);
      }
      values->Modified();
      scene.Image->Modified();
    });
  change("image spacing", [&] { scene.Image->SetSpacing(0.06, 0.05, 0.04); });
  change("no shadows", [&] { mapper->ShadowsOff(); });
  change("shadows", [&] { mapper->ShadowsOn(); });
  change("transmission",
    [&]
    {
      vtkNew<vtkColorTransferFunction> function;
      function->AddRGBPoint(0.0, 1.0, 0.2, 0.0);
      mapper->SetTransmissionColor(function);
    });
  change("transmission points", [&] { mapper->GetTransmissionColor()->AddRGBPoint(1.0, 0, 1, 1); });
  change("values of another type",
    [&]
    {
      vtkDataArray* doubles = scene.Image->GetPointData()->GetScalars();
      vtkNew<vtkUnsignedCharArray> bytes;
      for (vtkIdType id = 0; id < doubles->GetNumberOfTuples(); ++id)
      {
        bytes->InsertNextValue(doubles->GetComponent(id, 0) > 0.3 ? 1 : 0);
      }
      scene.Image->GetPointData()->SetScalars(bytes);
    });
  change("two-component values",
    [&]
    {
      mapper->SetTransmissionColor(nullptr);
      vtkNew<vtkUnsignedCharArray> bytes;
      bytes->SetNumberOfComponents(2);
      for (vtkIdType id = 0; id < scene.Image->GetNumberOfPoints(); ++id)
      {
        bytes->InsertNextTuple2(0.0, id % 50 < 25 ? 1.0 : 0.0);
      }
      scene.Image->GetPointData()->SetScalars(bytes);
      scene.Property->IndependentComponentsOff();
    });
}

/// Several vtkImageData, with different dimensions and positions, share one array as point or cell
/// data. The array has a later modification time than the vtkImageData.
void TestSharedArrays(Check& check)
{
  constexpr vtkIdType values = 576;
  vtkNew<vtkDoubleArray> array;
  array->SetName("f");
  for (vtkIdType id = 0; id < values; ++id)
  {
    array->InsertNextValue(std::fmod(0.37 * static_cast<double>(id), 1.0));
  }
  const std::vector<std::array<int, 3>> sizes = { { { 6, 8, 12 } }, { { 12, 8, 6 } },
    { { 24, 6, 4 } }, { { 8, 8, 9 } }, { { 9, 8, 8 } }, { { 6, 8, 12 } } };
  std::vector<ShadowScene> scenes;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    for (const bool isOfCells : { false, true })
    {
      auto scene = SphereScene();
      const std::array<int, 3>& size = sizes[i];
      const int more = isOfCells ? 1 : 0;
      const int first = 5 * static_cast<int>(i);
      scene.Image = vtkSmartPointer<vtkImageData>::New();
      scene.Image->SetExtent(first, first + size[0] - 1 + more, 0, size[1] - 1 + more, -first,
        size[2] - 1 + more - first);
      scene.Image->SetSpacing(0.1, i % 2 == 0 ? 0.1 : -0.08, 0.09);
      if (i % 3 == 2)
      {
        scene.Image->SetDirectionMatrix(0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0);
      }
      scene.Array.OfCells = isOfCells;
      vtkDataSetAttributes* data = scene.Image->GetPointData();
      if (isOfCells)
      {
        data = scene.Image->GetCellData();
      }
      data->SetScalars(array);
      scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, false);
      scenes.push_back(scene);
    }
  }
  for (const int scattering :
    { vtkShadowedSliceMapper::NO_SCATTERING, vtkShadowedSliceMapper::FULL_SCATTERING })
  {
    std::vector<RgbaImage> expected;
    for (const ShadowScene& scene : scenes)
    {
      vtkNew<vtkShadowedSliceMapper> fresh;
      fresh->SetScatteringMode(scattering);
      expected.push_back(DrawByMapper(fresh, scene));
      check.That(LargestAlpha(expected.back()) > 0.3, "the image of the shared array is not empty");
    }
    array->Modified();
    vtkNew<vtkShadowedSliceMapper> mapper;
    mapper->SetScatteringMode(scattering);
    VolumeStage stage(scenes[0].Size);
    Random random(5);
    for (int change = 0; change < 24; ++change)
    {
      const auto which =
        static_cast<std::size_t>(random.Get(0.0, static_cast<double>(scenes.size()) - 1e-6));
      SetScene(stage, mapper, scenes[which]);
      ExpectSame(check, "image " + std::to_string(which) + " of a shared array", stage.Capture(),
        expected[which]);
    }
  }
}

/// Tests that textures are created again after they are released, and for each window.
void TestWindows(Check& check)
{
  const auto scene = SphereScene();
  vtkNew<vtkShadowedSliceMapper> mapper;
  VolumeStage first(scene.Size);
  SetScene(first, mapper, scene);
  const RgbaImage image = first.Capture();
  mapper->ReleaseGraphicsResources(first.GetWindow());
  ExpectSame(check, "after release", first.Capture(), image);
  check.That(LargestAlpha(image) > 0.5, "the image is not empty");
  {
    VolumeStage second(scene.Size);
    SetScene(second, mapper, scene);
    ExpectSame(check, "in another window", second.Capture(), image);
    ExpectSame(check, "in the first window again", first.Capture(), image);
    ExpectSame(check, "in the other window again", second.Capture(), image);
  }
  ExpectSame(check, "after deletion of the other window", first.Capture(), image);
  first.GetWindow()->SetSize(80, 60);
  const RgbaImage large = first.Capture();
  auto resized = scene;
  resized.Size = { { 80, 60 } };
  vtkNew<vtkShadowedSliceMapper> fresh;
  ExpectSame(check, "after a change of size", large, DrawByMapper(fresh, resized));
}

}

int TestShadowState(int, char*[])
{
  Check check;
  TestTargets(check);
  TestViewports(check);
  TestSharedVolume(check);
  TestAfter(check);
  TestStereo(check);
  TestChanges(check);
  TestSharedArrays(check);
  TestWindows(check);
  return check.Result();
}
