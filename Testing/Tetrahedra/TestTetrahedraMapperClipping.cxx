// SPDX-License-Identifier: BSD-3-Clause
// Tests clipping planes at any angle against formulas for the clipped segment of each pixel, in
// every blend mode, with all kinds of values, boundaries and selection. Also tests planes through
// points, and sequences that add, move and remove planes.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Tetrahedra/MapperImage.h"
#include "Tetrahedra/PixelSegments.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkGeometryFilter.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace
{

using namespace reference;
using Mapper = vtkTimeWeightedTetrahedraMapper;
using Color = std::array<double, 4>;

constexpr std::array<double, 6> Box = { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } };
constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
/// Extinctions that are passed to MakeRamp(), for the scalar values 0 and 1.
constexpr double LowExtinction = 0.3;
constexpr double HighExtinction = 6.0;

struct PlaneCase
{
  Point3 Normal;
  Point3 Origin;
};

struct Planes
{
  std::string Name;
  std::vector<PlaneCase> Sides;
};

const std::vector<Planes>& AllPlanes()
{
  static const std::vector<Planes> planes = {
    { "one plane", { { { { 0.3, 0.8, -0.2 } }, { { 0.5, 0.45, 0.55 } } } } },
    { "two planes",
      { { { { 2.0, 1.0, 0.1 } }, { { 0.3, 0.3, 0.3 } } },
        { { { -1.0, 0.2, -0.4 } }, { { 0.7, 0.6, 0.8 } } } } },
    { "six planes",
      { { { { 1.0, 0.1, 0.0 } }, { { 0.1, 0.1, 0.1 } } },
        { { { -1.0, 0.0, 0.2 } }, { { 0.9, 0.9, 0.9 } } },
        { { { 0.0, 1.0, 0.3 } }, { { 0.2, 0.1, 0.1 } } },
        { { { 0.2, -1.0, 0.0 } }, { { 0.8, 0.9, 0.7 } } },
        { { { 0.1, 0.2, 1.0 } }, { { 0.1, 0.1, 0.2 } } },
        { { { 0.0, -0.3, -1.0 } }, { { 0.5, 0.5, 0.9 } } } } },
    { "planes through points",
      { { { { 1.0, 0.0, 0.0 } }, { { 1.0 / 3.0, 0.0, 0.0 } } },
        { { { 0.0, -1.0, 0.0 } }, { { 0.0, 1.0, 0.0 } } },
        { { { 0.0, 1.0, -1.0 } }, { { 0.0, 0.0, 0.0 } } } } },
    { "a plane along the view", { { { { 0.4, 0.3, 0.0 } }, { { 0.5, 0.5, 0.5 } } } } },
  };
  return planes;
}

void SetPlanes(Mapper* mapper, const Planes& planes)
{
  mapper->RemoveAllClippingPlanes();
  for (const PlaneCase& side : planes.Sides)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(side.Normal.data());
    plane->SetOrigin(side.Origin.data());
    mapper->AddClippingPlane(plane);
  }
}

PixelSegment Clip(PixelSegment segment, const Planes& planes, vtkVolume* volume)
{
  segment.ClipToBox(Box, volume);
  for (const PlaneCase& side : planes.Sides)
  {
    segment.Clip(side.Normal, side.Origin);
  }
  return segment;
}

/// A window that shows the unit cube as a volume.
class Scene
{
public:
  explicit Scene(bool parallel)
    : Grid(MakeBox({ { 3, 2, 4 } }))
    , Stage(std::array<int, 2>{ { 72, 64 } })
    , Camera(LookAt(this->Grid, Slanted, parallel))
  {
    this->Stage.SetCamera(this->Camera);
    this->Property = MakeRamp(LowExtinction, HighExtinction);
  }

  void SetMapper(Mapper* mapper)
  {
    mapper->SetInputData(static_cast<vtkDataSet*>(this->Grid));
    mapper->AutoAdjustLevelOfDetailOff();
    this->Stage.SetVolume(mapper, this->Property);
  }

  vtkVolume* GetVolume() { return this->Stage.GetVolume(); }

  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  VolumeStage Stage;
  vtkSmartPointer<vtkCamera> Camera;
  vtkSmartPointer<vtkVolumeProperty> Property;
};

/// Compares every pixel with the result of \a formula for the pixel's clipped segment.
void Compare(Check& check, Scene& scene, const Planes& planes, double tolerance,
  const std::string& name, const std::function<Color(const PixelSegment&)>& formula)
{
  const RgbaImage image = scene.Stage.Capture();
  const PixelSegments segments(scene.Stage.GetRenderer());
  double largest = 0.0;
  int seen = 0;
  for (const auto& [j, i] : AllIndices(image.Height, image.Width))
  {
    const PixelSegment segment = Clip(segments.Get(i, j), planes, scene.GetVolume());
    const Color expected = segment.IsEmpty() ? Color{ { 0.0, 0.0, 0.0, 0.0 } } : formula(segment);
    seen += expected[3] > 0.05 ? 1 : 0;
    for (int c = 0; c < 4; ++c)
    {
      const double error = std::abs(image.At(i, j)[c] - expected[c]);
      largest = std::isfinite(error) ? std::max(largest, error) : 1e9;
    }
  }
  check.That(seen > 100, name + ": " + std::to_string(seen) + " pixels show the volume");
  check.Near(largest, 0.0, tolerance, name, 1.0);
}

/// Returns the scalar of MakeBox() at a point in world coordinates.
double GetScalar(const Point3& point, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(volume->GetMatrix(), inverse);
  double x[4] = { point[0], point[1], point[2], 1.0 };
  inverse->MultiplyPoint(x, x);
  return 0.1 + 0.5 * x[0] + 0.3 * x[1] + 0.1 * x[2];
}

double GetExtinction(double scalar)
{
  return LowExtinction + (HighExtinction - LowExtinction) * scalar;
}

/// Returns a color from blue at 0 to yellow at 1, as in MakeRamp().
Point3 GetColor(double scalar)
{
  return { { 0.1 + 0.9 * scalar, 0.2 + 0.6 * scalar, 0.9 - 0.8 * scalar } };
}

/// Composites the linear color and extinction along a segment in many small steps.
Color Composite(const PixelSegment& segment, vtkVolume* volume)
{
  constexpr int steps = 200;
  const double front = GetScalar(segment.GetFront(), volume);
  const double back = GetScalar(segment.GetBack(), volume);
  const double length = segment.GetLength() / steps;
  Color sum = { { 0.0, 0.0, 0.0, 0.0 } };
  for (int step = 0; step < steps; ++step)
  {
    const double scalar = front + (back - front) * (step + 0.5) / steps;
    const double alpha = -std::expm1(-GetExtinction(scalar) * length) * (1.0 - sum[3]);
    const Point3 color = GetColor(scalar);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += alpha * color[c];
    }
    sum[3] += alpha;
  }
  return sum;
}

double GetOpticalDepth(const PixelSegment& segment, vtkVolume* volume)
{
  const double front = GetExtinction(GetScalar(segment.GetFront(), volume));
  const double back = GetExtinction(GetScalar(segment.GetBack(), volume));
  return 0.5 * (front + back) * segment.GetLength();
}

/// A render path and a shader, with the maximum error of their images.
struct Path
{
  int RenderPath;
  int Shader;
  double Tolerance;
  std::string Name;
};

const std::vector<Path>& AllPaths()
{
  static const std::vector<Path> paths = {
    { Mapper::SOFTWARE_PATH, Mapper::AUTOMATIC_SHADER, 5e-5, "software" },
    { Mapper::OPENGL_PATH, Mapper::GEOMETRY_SHADER, 1e-3, "geometry shader" },
    { Mapper::OPENGL_PATH, Mapper::VERTEX_SHADER, 1e-3, "vertex shader" },
  };
  return paths;
}

vtkSmartPointer<Mapper> NewMapper(const Path& path)
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetRenderPath(path.RenderPath);
  mapper->SetSilhouetteShader(path.Shader);
  return mapper;
}

/// Tests composite and maximum blending of scalars. Moving the prop must not move the planes.
void TestScalars(Check& check, const Path& path, const Planes& planes, bool parallel)
{
  for (bool isMoved : { false, true })
  {
    Scene scene(parallel);
    if (isMoved)
    {
      scene.GetVolume()->SetPosition(0.1, -0.05, 0.1);
      scene.GetVolume()->SetScale(0.9, 1.2, 0.8);
      scene.GetVolume()->RotateZ(12.0);
    }
    auto mapper = NewMapper(path);
    scene.SetMapper(mapper);
    SetPlanes(mapper, planes);
    vtkVolume* volume = scene.GetVolume();
    const std::string name = isMoved ? ", moved" : "";
    mapper->SetBlendModeToComposite();
    Compare(check, scene, planes, 10.0 * path.Tolerance, "composite" + name,
      [volume](const PixelSegment& segment) { return Composite(segment, volume); });
    mapper->SetBlendMode(Mapper::MAXIMUM_INTENSITY_BLEND);
    Compare(check, scene, planes, 1e-2, "maximum" + name,
      [volume](const PixelSegment& segment)
      {
        const double scalar =
          std::max(GetScalar(segment.GetFront(), volume), GetScalar(segment.GetBack(), volume));
        const double alpha = std::min(GetExtinction(scalar), 1.0);
        const Point3 color = GetColor(scalar);
        return Color{ { alpha * color[0], alpha * color[1], alpha * color[2], alpha } };
      });
  }
}

/// Tests a volume in a single color with linear extinction, without and with an extent in time.
void TestDepth(Check& check, const Path& path, const Planes& planes, bool parallel)
{
  Scene scene(parallel);
  const Point3 white = { { 1.0, 1.0, 1.0 } };
  scene.Property = MakeProperty({ { 0.0, white, LowExtinction }, { 1.0, white, HighExtinction } });
  AddLinearArray(scene.Grid, "DeltaT", 1.0, { { -0.8, 0.5, 0.3 } });
  auto mapper = NewMapper(path);
  scene.SetMapper(mapper);
  SetPlanes(mapper, planes);
  vtkVolume* volume = scene.GetVolume();
  for (int blend :
    { static_cast<int>(Mapper::COMPOSITE_BLEND), static_cast<int>(Mapper::OPTICAL_DEPTH_BLEND) })
  {
    mapper->SetBlendMode(blend);
    mapper->SetDeltaTArrayName("");
    Compare(check, scene, planes, path.Tolerance, "depth",
      [volume](const PixelSegment& segment)
      {
        const double alpha = -std::expm1(-GetOpticalDepth(segment, volume));
        return Color{ { alpha, alpha, alpha, alpha } };
      });
    mapper->SetDeltaTArrayName("DeltaT");
    Compare(check, scene, planes, path.Tolerance, "depth in time",
      [volume](const PixelSegment& segment)
      {
        const auto time = [](const Point3& x)
        { return 1.0 - 0.8 * x[0] + 0.5 * x[1] + 0.3 * x[2]; };
        const double t[2] = { GetExtinction(GetScalar(segment.GetFront(), volume)),
          GetExtinction(GetScalar(segment.GetBack(), volume)) };
        const double d[2] = { time(segment.GetFront()), time(segment.GetBack()) };
        const double mean =
          (2.0 * t[0] * d[0] + t[0] * d[1] + t[1] * d[0] + 2.0 * t[1] * d[1]) / 6.0;
        const double alpha = -std::expm1(-mean * segment.GetLength());
        return Color{ { alpha, alpha, alpha, alpha } };
      });
  }
}

/// Tests colors that are constant in each cell, and point colors, which are linear along a segment.
void TestColors(Check& check, const Path& path, const Planes& planes, bool parallel)
{
  Scene scene(parallel);
  AddSlabIndices(scene.Grid, "slab", 0, 3);
  const double extinctions[3] = { 2.0, 0.7, 4.0 };
  const Point3 colors[3] = { { { 1.0, 0.1, 0.0 } }, { { 0.0, 0.9, 0.3 } }, { { 0.2, 0.0, 1.0 } } };
  scene.Property = MakeProperty({ { 0.0, colors[0], extinctions[0] },
    { 1.0, colors[1], extinctions[1] }, { 2.0, colors[2], extinctions[2] } });
  auto mapper = NewMapper(path);
  scene.SetMapper(mapper);
  mapper->SetScalarMode(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SelectScalarArray("slab");
  SetPlanes(mapper, planes);
  vtkVolume* volume = scene.GetVolume();
  mapper->SetBlendModeToComposite();
  // The camera looks toward higher x, so the slabs are in front-to-back order.
  Compare(check, scene, planes, path.Tolerance, "slabs",
    [&](const PixelSegment& segment)
    {
      Color sum = { { 0.0, 0.0, 0.0, 0.0 } };
      for (int slab = 0; slab < 3; ++slab)
      {
        PixelSegment part = segment;
        part.ClipToBox({ { slab / 3.0, (slab + 1) / 3.0, 0.0, 1.0, 0.0, 1.0 } }, volume);
        const double alpha = -std::expm1(-extinctions[slab] * part.GetLength()) * (1.0 - sum[3]);
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += alpha * colors[slab][c];
        }
        sum[3] += alpha;
      }
      return sum;
    });

  vtkNew<vtkFloatArray> pointColors;
  pointColors->SetName("colors");
  pointColors->SetNumberOfComponents(4);
  for (vtkIdType p = 0; p < scene.Grid->GetNumberOfPoints(); ++p)
  {
    const double* x = scene.Grid->GetPoint(p);
    pointColors->InsertNextTuple4(x[0], x[1], x[2], 0.5 * (x[0] + x[1]));
  }
  scene.Grid->GetPointData()->AddArray(pointColors);
  scene.Property = MakeRamp(0.0, 1.0);
  scene.Property->IndependentComponentsOff();
  scene.SetMapper(mapper);
  mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray("colors");
  mapper->SetBlendMode(Mapper::OPTICAL_DEPTH_BLEND);
  Compare(check, scene, planes, path.Tolerance, "colors of points",
    [&](const PixelSegment& segment)
    {
      // The mean color, weighted by the extinction, where both are linear along the segment.
      const auto at = [](const Point3& x) {
        return Color{ { x[0], x[1], x[2], 0.5 * (x[0] + x[1]) } };
      };
      const Color a = at(segment.GetFront());
      const Color b = at(segment.GetBack());
      const double extinction = 0.5 * (a[3] + b[3]);
      const double alpha = -std::expm1(-extinction * segment.GetLength());
      Color sum;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] = (2.0 * a[c] * a[3] + a[c] * b[3] + b[c] * a[3] + 2.0 * b[c] * b[3]) / 6.0 * alpha /
          extinction;
      }
      sum[3] = alpha;
      return sum;
    });
}

/// Tests that boundary triangles are visible where a pixel's segment enters and leaves the cube,
/// unless a plane removes them.
void TestBoundary(Check& check, const Path& path, const Planes& planes, bool parallel)
{
  Scene scene(parallel);
  scene.Property = MakeProperty({ { 0.0, { { 0.0, 0.0, 0.0 } }, 0.0 } });
  vtkNew<vtkGeometryFilter> boundary;
  boundary->SetInputData(scene.Grid);
  vtkNew<vtkProperty> property;
  property->SetColor(0.0, 1.0, 0.0);
  property->SetOpacity(0.3);
  property->LightingOff();
  property->SetAmbient(1.0);
  auto mapper = NewMapper(path);
  scene.SetMapper(mapper);
  mapper->SetBlendModeToComposite();
  mapper->SetBoundaryConnection(boundary->GetOutputPort());
  mapper->SetBoundaryProperty(property);
  SetPlanes(mapper, planes);
  const RgbaImage image = scene.Stage.Capture();
  const PixelSegments segments(scene.Stage.GetRenderer());
  int different = 0;
  int counts[3] = { 0, 0, 0 };
  for (const auto& [j, i] : AllIndices(image.Height, image.Width))
  {
    PixelSegment unclipped = segments.Get(i, j);
    unclipped.ClipToBox(Box, scene.GetVolume());
    const PixelSegment segment = Clip(segments.Get(i, j), planes, scene.GetVolume());
    int faces = 0;
    if (!segment.IsEmpty())
    {
      faces += segment.GetFrom() == unclipped.GetFrom() ? 1 : 0;
      faces += segment.GetTo() == unclipped.GetTo() ? 1 : 0;
    }
    ++counts[faces];
    const double expected = faces == 0 ? 0.0 : faces == 1 ? 0.3 : 0.51;
    different +=
      std::abs(image.At(i, j)[3] - expected) > 1e-3 || std::abs(image.At(i, j)[1] - expected) > 1e-3
      ? 1
      : 0;
  }
  check.That(counts[1] + counts[2] > 100,
    "boundary: " + std::to_string(counts[1] + counts[2]) + " pixels with faces");
  // At edges cut by planes, OpenGL may be off by a pixel.
  check.That(different <= (path.RenderPath == Mapper::SOFTWARE_PATH ? 0 : 4),
    "boundary: " + std::to_string(different) + " pixels differ");
}

/// Tests that parts of cells that the planes remove cannot be selected.
void TestSelection(Check& check, const Path& path, const Planes& planes, bool parallel)
{
  Scene scene(parallel);
  auto mapper = NewMapper(path);
  scene.SetMapper(mapper);
  SetPlanes(mapper, planes);
  scene.Stage.Render();
  const int found = CheckSelection(
    check, scene.Stage.GetRenderer(), scene.GetVolume(), scene.Grid,
    [&](PixelSegment& segment) { segment = Clip(segment, planes, scene.GetVolume()); },
    [&](const Point3& point) { return GetExtinction(GetScalar(point, scene.GetVolume())); });
  check.That(found > 30, "selection: " + std::to_string(found) + " pixels");
}

/// Tests a convex region with more planes than shader uniforms or bit masks could hold.
void TestManyPlanes(Check& check, const Path& path)
{
  Planes planes;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 70; ++i)
  {
    Point3 n = { { normal(random), normal(random), normal(random) } };
    vtkMath::Normalize(n.data());
    planes.Sides.push_back({ n, { { 0.5 - 0.45 * n[0], 0.5 - 0.45 * n[1], 0.5 - 0.45 * n[2] } } });
  }
  TestDepth(check, path, planes, false);
}

/// Tests a sequence of changes to the planes and the camera. Each image must equal the image of a
/// new mapper.
void TestSequence(Check& check, const Path& path)
{
  Scene scene(false);
  auto mapper = NewMapper(path);
  scene.SetMapper(mapper);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto capture = [&](Mapper* renderedMapper)
  {
    scene.SetMapper(renderedMapper);
    return scene.Stage.Capture();
  };
  RgbaImage last = capture(mapper);
  for (int step = 0; step < 14; ++step)
  {
    bool isView = false;
    switch (step % 7)
    {
      case 0:
      case 1:
      case 4:
        SetPlanes(mapper,
          { "",
            { { { { number(random), number(random), number(random) } },
              { { 0.5, 0.5, 0.5 } } } } });
        break;
      case 2:
      case 3:
        scene.Camera->Azimuth(20.0);
        isView = true;
        break;
      case 5:
        mapper->GetClippingPlanes()->GetItem(0)->SetOrigin(0.4, 0.6, 0.55);
        break;
      default:
        mapper->RemoveAllClippingPlanes();
    }
    const std::string name = "step " + std::to_string(step);
    last = capture(mapper);
    const auto report = CopyReport(mapper->GetReport());
    check.That((report->GetNumber("TetrahedraClipped") > 0) == (step % 7 != 6),
      name + ": tetrahedra are clipped");
    if (isView && path.RenderPath == Mapper::OPENGL_PATH)
    {
      check.Equal(report->GetCount("UploadedStaticBytes"), 0,
        name + ": a camera move uploads only the order");
    }
    auto fresh = NewMapper(path);
    fresh->SetClippingPlanes(mapper->GetClippingPlanes());
    check.That(
      capture(fresh).Values == last.Values, name + ": the image equals that of a new mapper");
    check.That(LargestAlpha(last) > 0.1, name + ": the volume is visible");
  }
}

/// Tests planes that remove the whole volume, and invalid planes.
void TestEmptyAndInvalid(Check& check, const Path& path)
{
  for (int blend :
    { static_cast<int>(Mapper::COMPOSITE_BLEND), static_cast<int>(Mapper::MAXIMUM_INTENSITY_BLEND),
      static_cast<int>(Mapper::OPTICAL_DEPTH_BLEND) })
  {
    Scene scene(false);
    auto mapper = NewMapper(path);
    scene.SetMapper(mapper);
    mapper->SetBlendMode(blend);
    check.That(LargestAlpha(scene.Stage.Capture()) > 0.1, "the unclipped volume is visible");
    SetPlanes(mapper, { "", { { { { 1.0, 0.0, 0.0 } }, { { 1.5, 0.0, 0.0 } } } } });
    check.Near(LargestAlpha(scene.Stage.Capture()), 0.0, 0.0, "alpha if all is clipped");
    check.Equal(
      mapper->GetReport()->GetCount("TetrahedraDrawn"), 0, "tetrahedra drawn if all is clipped");
  }
  Scene scene(false);
  auto mapper = NewMapper(path);
  scene.SetMapper(mapper);
  const auto draw = [&]() { scene.Stage.Capture(); };
  SetPlanes(mapper, { "", { { { { 0.0, 0.0, 1.0 } }, { { 0.0, 0.0, 0.5 } } } } });
  mapper->GetClippingPlanes()->GetItem(0)->SetNormal(0.0, 0.0, 0.0);
  check.Contains(CaptureErrors(mapper, draw), "clipping plane 0");
  mapper->GetClippingPlanes()->GetItem(0)->SetNormal(0.0, 0.0, 1.0);
  mapper->GetClippingPlanes()->GetItem(0)->SetOrigin(
    0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  mapper->Modified();
  check.Contains(CaptureErrors(mapper, draw), "clipping plane 0");
}

}

int TestTetrahedraMapperClipping(int, char*[])
{
  Check check;
  for (const Path& path : AllPaths())
  {
    for (const Planes& planes : AllPlanes())
    {
      // The shaders do not depend on the planes, so one case is enough for the vertex shader.
      if (path.Shader == Mapper::VERTEX_SHADER && &planes != &AllPlanes()[1])
      {
        continue;
      }
      for (bool parallel : { false, true })
      {
        check.SetContext(
          path.Name + ", " + planes.Name + (parallel ? ", parallel" : ", perspective"));
        TestScalars(check, path, planes, parallel);
        TestDepth(check, path, planes, parallel);
        TestColors(check, path, planes, parallel);
        TestBoundary(check, path, planes, parallel);
        TestSelection(check, path, planes, parallel);
      }
    }
    check.SetContext(path.Name);
    TestManyPlanes(check, path);
    TestSequence(check, path);
    TestEmptyAndInvalid(check, path);
  }
  return check.Result();
}
