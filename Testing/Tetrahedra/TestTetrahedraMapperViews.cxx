// SPDX-License-Identifier: BSD-3-Clause
// Tests one mapper in several windows and renderers, with resizing and releasing resources, depth
// peeling and multisampling. Images are compared with those of new mappers.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/LargestError.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/TestWindow.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "Loader/OpenGLFunctions.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;

constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
constexpr Point3 Sideways = { { 1.0, 0.2, 0.3 } };
constexpr double Byte = 1.0 / 255.0;
constexpr double StillRate = 1e-4;

/// Renders the window and returns its pixels.
RgbaImage Draw(vtkRenderWindow* window)
{
  window->Render();
  const int* size = window->GetSize();
  RgbaImage image(size[0], size[1]);
  vtkNew<vtkFloatArray> pixels;
  window->GetRGBAPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  for (std::size_t i = 0; i < image.Values.size(); ++i)
  {
    image.Values[i] = pixels->GetValue(static_cast<vtkIdType>(i));
  }
  return image;
}

/// A mesh with its rendering settings.
struct Scene
{
  /// Uses composite blending if \a isSorted is true, otherwise optical depth blending.
  Scene(int path, bool isSorted)
    : Path(path)
    , Blend(isSorted ? static_cast<int>(Mapper::COMPOSITE_BLEND)
                     : static_cast<int>(Mapper::OPTICAL_DEPTH_BLEND))
    , Name(GetPathName(path) + (isSorted ? ", sorted, " : ", without order, "))
  {
  }

  vtkSmartPointer<vtkVolume> MakeVolume() const
  {
    vtkNew<Mapper> mapper;
    mapper->SetRenderPath(this->Path);
    mapper->SetBlendMode(this->Blend);
    mapper->SetInputData(static_cast<vtkDataSet*>(this->Grid));
    mapper->AutoAdjustLevelOfDetailOff();
    auto volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(mapper);
    // Use a copy: a volume modifies its property, which would make other volumes render again.
    vtkNew<vtkVolumeProperty> property;
    property->DeepCopy(this->Property);
    volume->SetProperty(property);
    return volume;
  }

  int Path;
  int Blend;
  std::string Name;
  vtkSmartPointer<vtkUnstructuredGrid> Grid = MakeCube(4);
  vtkSmartPointer<vtkVolumeProperty> Property = MakeRamp(0.1, 1.0, 0.25);
};

/// A window with one renderer.
struct View
{
  View(const Scene& scene, vtkVolume* volume, const Point3& direction,
    const std::array<int, 2>& size = { { 80, 64 } }, int samples = 0)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(samples);
    this->Window->SetSize(size[0], size[1]);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.2, 0.1, 0.3);
    this->Renderer->AddVolume(volume);
    this->Renderer->SetActiveCamera(LookAt(scene.Grid, direction, false));
  }

  RgbaImage Draw() { return ::Draw(this->Window); }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/// Renders with a new mapper.
RgbaImage DrawFresh(
  const Scene& scene, const Point3& direction, const std::array<int, 2>& size = { { 80, 64 } })
{
  return View(scene, scene.MakeVolume(), direction, size).Draw();
}

/// Expects equal images that show the volume.
void ExpectSame(
  Check& check, const RgbaImage& found, const RgbaImage& expected, const std::string& what)
{
  check.Near(CompareImages(found, expected).Max, 0.0, 1e-9, what, 1.0);
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.Values.size(); i += 4)
  {
    reference::KeepLargest(largest, std::abs(expected.Values[i] - 0.2));
  }
  check.That(largest > 0.1, what + ": the volume is visible");
}

void TestTwoWindows(Check& check, const Scene& scene)
{
  const RgbaImage first = DrawFresh(scene, Slanted);
  const RgbaImage second = DrawFresh(scene, Sideways, { { 48, 72 } });
  auto volume = scene.MakeVolume();
  View a(scene, volume, Slanted);
  View b(scene, volume, Sideways, { { 48, 72 } });
  for (int frame = 0; frame < 3; ++frame)
  {
    const std::string name = scene.Name + "two windows, turn " + std::to_string(frame);
    ExpectSame(check, a.Draw(), first, name + ", first");
    ExpectSame(check, b.Draw(), second, name + ", second");
  }
  // A change of the property affects both windows.
  Scene other = scene;
  other.Property = MakeRamp(1.0, 0.2, 0.5);
  volume->SetProperty(other.Property);
  ExpectSame(check, a.Draw(), DrawFresh(other, Slanted), scene.Name + "other colors, first");
  ExpectSame(check, b.Draw(), DrawFresh(other, Sideways, { { 48, 72 } }),
    scene.Name + "other colors, second");
}

void TestTwoRenderers(Check& check, const Scene& scene)
{
  const RgbaImage left = DrawFresh(scene, Slanted, { { 40, 64 } });
  const RgbaImage right = DrawFresh(scene, Sideways, { { 40, 64 } });
  auto volume = scene.MakeVolume();
  View view(scene, volume, Slanted);
  view.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetBackground(0.2, 0.1, 0.3);
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->AddVolume(volume);
  other->SetActiveCamera(LookAt(scene.Grid, Sideways, false));
  view.Window->AddRenderer(other);
  for (int frame = 0; frame < 2; ++frame)
  {
    const RgbaImage both = view.Draw();
    RgbaImage halves[2] = { RgbaImage(40, 64), RgbaImage(40, 64) };
    for (const auto& [j, i] : AllIndices(64, 80))
    {
      std::copy_n(both.At(i, j), 4, halves[i / 40].At(i % 40, j));
    }
    ExpectSame(check, halves[0], left, scene.Name + "two renderers, left");
    ExpectSame(check, halves[1], right, scene.Name + "two renderers, right");
  }
}

void TestResize(Check& check, const Scene& scene)
{
  View view(scene, scene.MakeVolume(), Slanted);
  view.Draw();
  for (const std::array<int, 2>& size :
    { std::array<int, 2>{ { 33, 57 } }, { { 120, 90 } }, { { 80, 64 } } })
  {
    view.Window->SetSize(size[0], size[1]);
    ExpectSame(check, view.Draw(), DrawFresh(scene, Slanted, size),
      scene.Name + "resized to " + std::to_string(size[0]));
  }
}

void TestRelease(Check& check, const Scene& scene)
{
  auto volume = scene.MakeVolume();
  View view(scene, volume, Slanted);
  const RgbaImage expected = view.Draw();
  volume->GetMapper()->ReleaseGraphicsResources(view.Window);
  ExpectSame(check, view.Draw(), expected, scene.Name + "released");
  volume->GetMapper()->ReleaseGraphicsResources(view.Window);
  volume->GetMapper()->ReleaseGraphicsResources(view.Window);
  ExpectSame(check, view.Draw(), expected, scene.Name + "released twice");
  view.Window->Finalize();
  ExpectSame(check, view.Draw(), expected, scene.Name + "window finalized");
  {
    View other(scene, volume, Slanted);
    ExpectSame(check, other.Draw(), expected, scene.Name + "another window");
  }
  ExpectSame(check, view.Draw(), expected, scene.Name + "the other window is destroyed");
}

/// Returns a translucent plane over the left half of the image, in front of the volume.
vtkSmartPointer<vtkActor> MakePlane(const Scene& scene)
{
  auto camera = LookAt(scene.Grid, Slanted, false);
  double position[3];
  double focalPoint[3];
  camera->GetPosition(position);
  camera->GetFocalPoint(focalPoint);
  double right[3];
  double up[3] = { 0.0, 1.0, 0.0 };
  double view[3];
  camera->GetDirectionOfProjection(view);
  vtkMath::Cross(view, up, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, view, up);
  double corners[3][3];
  for (int k = 0; k < 3; ++k)
  {
    const double center = 0.5 * (position[k] + focalPoint[k]);
    corners[0][k] = center - 2.0 * right[k] - 2.0 * up[k];
    corners[1][k] = center - 2.0 * up[k];
    corners[2][k] = center - 2.0 * right[k] + 2.0 * up[k];
  }
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(corners[0]);
  plane->SetPoint1(corners[1]);
  plane->SetPoint2(corners[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.1, 0.9, 0.2);
  actor->GetProperty()->SetOpacity(0.5);
  return actor;
}

/// Returns the largest color difference in the columns [first, last).
double CompareColumns(const RgbaImage& a, const RgbaImage& b, int first, int last)
{
  double largest = 0.0;
  for (int j = 0; j < a.Height; ++j)
  {
    for (int i = first; i < last; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        reference::KeepLargest(largest, std::abs(a.At(i, j)[k] - b.At(i, j)[k]));
      }
    }
  }
  return largest;
}

void TestPeeling(Check& check, const Scene& scene, int samples, bool isPeeled)
{
  const std::string name = scene.Name + std::to_string(samples) + " samples, " +
    (isPeeled ? "depth peeling" : "no depth peeling");
  View view(scene, scene.MakeVolume(), Slanted, { { 80, 64 } }, samples);
  AllowMultisampledDepthPeeling(view.Window);
  view.Window->SetAlphaBitPlanes(1);
  view.Renderer->SetUseDepthPeeling(isPeeled);
  view.Renderer->SetMaximumNumberOfPeels(8);
  view.Renderer->AddActor(MakePlane(scene));
  const RgbaImage plain = DrawFresh(scene, Slanted);
  for (int frame = 0; frame < 2; ++frame)
  {
    const RgbaImage found = view.Draw();
    check.Near(CompareColumns(found, plain, 42, 80), 0.0, 2.0 * Byte, name + ": the volume", 1.0);
    check.That(CompareColumns(found, plain, 25, 38) > 0.1, name + ": the actor covers the volume");
    // Outside the volume the plane is blended with the background.
    const double* corner = found.At(1, 1);
    check.Near(corner[0], 0.5 * (0.2 + 0.1), 2.0 * Byte, name + ": the actor's red", 1.0);
    check.Near(corner[1], 0.5 * (0.1 + 0.9), 2.0 * Byte, name + ": the actor's green", 1.0);
    check.Near(corner[2], 0.5 * (0.3 + 0.2), 2.0 * Byte, name + ": the actor's blue", 1.0);
  }
}

/// Tests that the time that controls the level of detail includes rendering, although OpenGL
/// renders asynchronously.
void TestLevelOfDetailTime(Check& check)
{
  Scene scene(Mapper::OPENGL_PATH, false);
  scene.Grid = MakeCube(1);
  auto volume = scene.MakeVolume();
  auto* mapper = Mapper::SafeDownCast(volume->GetMapper());
  mapper->AutoAdjustLevelOfDetailOn();
  View view(scene, volume, Slanted, { { 1000, 800 } });
  view.Window->SetDesiredUpdateRate(StillRate);
  double left = 0.0;
  vtkNew<vtkCallbackCommand> wait;
  wait->SetClientData(&left);
  wait->SetCallback(
    [](vtkObject*, unsigned long, void* seconds, void*)
    {
      const auto start = std::chrono::steady_clock::now();
      glFinish();
      *static_cast<double*>(seconds) =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    });
  view.Renderer->AddObserver(vtkCommand::EndEvent, wait);
  // Fraction of the rendering time that the report does not include. The minimum over several
  // frames excludes delays on a busy machine.
  double fraction = 1.0;
  for (int frame = 0; frame < 3; ++frame)
  {
    view.Window->Render();
    fraction = std::min(fraction, left / (left + mapper->GetReport()->GetNumber("Seconds")));
  }
  check.That(fraction < 0.01,
    scene.Name +
      "level of detail: fraction of the time that is not measured: " + std::to_string(fraction));
}
}

int TestTetrahedraMapperViews(int, char*[])
{
  Check check;
  for (int path : AllRenderPaths())
  {
    for (bool isSorted : { true, false })
    {
      const Scene scene(path, isSorted);
      TestTwoWindows(check, scene);
      TestTwoRenderers(check, scene);
      TestResize(check, scene);
      TestRelease(check, scene);
    }
    const Scene scene(path, true);
    for (int samples : { 0, 4 })
    {
      TestPeeling(check, scene, samples, false);
      TestPeeling(check, scene, samples, true);
    }
  }
  TestLevelOfDetailTime(check);
  return check.Result();
}
