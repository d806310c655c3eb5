// SPDX-License-Identifier: BSD-3-Clause
// Texture coordinates of stream surfaces: lengths along inflow contours compared with formulas, for
// closed, open and multiple contours, and across seams. No triangle spans the point where s wraps
// around. Also tests start points, scales and errors.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Flow/ReferenceContourSurfaces.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowVolume.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInflowMapping.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace
{

using namespace reference;

const double Pi = vtkMath::Pi();

// A pipeline from an Inflow formula to a stream surface with texture coordinates.
struct Pipeline
{
  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;
  vtkNew<vtkStreamSurfaceParameters> Parameters;

  Pipeline(vtkDataSet* data, const char* formula, const std::vector<double>& values,
    vtkTerminationSurface* surface = nullptr)
  {
    if (surface)
    {
      surface->SetId(0);
      this->Parameters->AddTerminationSurface(surface);
    }
    this->Mapping->SetInputData(data);
    this->Mapping->SetFormula(vtkInflowMapping::ALL, formula);
    this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Volume->SetStreamSurface(static_cast<int>(i), values[i]);
    }
    this->Volume->GenerateStreamSurfacesOn();
    this->Parameters->SetInputConnection(this->Volume->GetOutputPort(1));
    this->Parameters->SetMapping(this->Mapping);
  }

  vtkPolyData* Update()
  {
    this->Parameters->Update();
    return this->Parameters->GetOutput();
  }

  double GetLength(int contour)
  {
    vtkDataArray* lengths = this->Update()->GetFieldData()->GetArray("ContourLength");
    return lengths && contour < lengths->GetNumberOfTuples() ? lengths->GetComponent(contour, 0)
                                                             : -1.0;
  }
  int GetNumberOfContours()
  {
    vtkDataArray* lengths = this->Update()->GetFieldData()->GetArray("ContourLength");
    return lengths ? static_cast<int>(lengths->GetNumberOfTuples()) : -1;
  }
  int GetNumberOfClosedContours()
  {
    vtkDataArray* closed = this->Update()->GetFieldData()->GetArray("ContourClosed");
    int number = 0;
    for (vtkIdType i = 0; closed && i < closed->GetNumberOfTuples(); ++i)
    {
      number += closed->GetComponent(i, 0) != 0.0;
    }
    return number;
  }
};

vtkSmartPointer<vtkImageData> MakePlaneFlow(int points = 24)
{
  auto image = MakeFlowImage({ { 5, points, points } }, { { 0, 1, 0, 1, 0, 1 } });
  AddFlow(image, UniformFlow(0.5), { { { 0, 0, 0 } } });
  return image;
}

vtkSmartPointer<vtkImageData> MakeCylinderFlow(int points = 30)
{
  auto image = MakeFlowImage({ { points, points, 12 } }, { { -1, 1, -1, 1, 0, 1 } });
  AddFlow(image, CylinderFlow(0.4), { { { 0, 1, 0 } } });
  return image;
}

// A corner of a triangle with its texture coordinates, contour id, input point id and position.
struct Corner
{
  double S;
  double T;
  int Contour;
  vtkIdType Source;
  double X[3];
};

void ForEachTriangle(vtkPolyData* output, const std::function<void(const Corner*)>& visit)
{
  vtkPointData* data = output->GetPointData();
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, ids);
    Corner corners[3];
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType p = ids->GetId(c);
      corners[c].S = data->GetTCoords()->GetComponent(p, 0);
      corners[c].T = data->GetTCoords()->GetComponent(p, 1);
      corners[c].Contour = static_cast<int>(data->GetArray("ContourId")->GetComponent(p, 0));
      corners[c].Source =
        static_cast<vtkIdType>(data->GetArray("vtkOriginalPointIds")->GetComponent(p, 0));
      output->GetPoint(p, corners[c].X);
    }
    visit(corners);
  }
}

// Checks that the extent of triangles in s is at most \a longest, that their corners belong to one
// contour, that t is the advection time, and that the points of the input are unchanged.
void CheckTriangles(Pipeline& pipeline, double longest, Check& check)
{
  vtkPolyData* output = pipeline.Update();
  vtkUnstructuredGrid* input = pipeline.Volume->GetOutput(1);
  check.Equal(output->GetNumberOfCells(), input->GetNumberOfCells(), "triangles of the input");
  check.That(output->GetNumberOfCells() > 0, "there are triangles");
  check.That(output->GetPointData()->GetTCoords() &&
      output->GetPointData()->GetTCoords()->GetName() == std::string("StreamTexture"),
    "StreamTexture is active");
  ForEachTriangle(output,
    [&](const Corner* corners)
    {
      const auto ends = std::minmax({ corners[0].S, corners[1].S, corners[2].S });
      check.That(ends.second - ends.first <= longest,
        "a triangle is " + std::to_string(ends.second - ends.first) + " long");
      check.That(corners[0].Contour >= 0 && corners[0].Contour == corners[1].Contour &&
          corners[0].Contour == corners[2].Contour,
        "a triangle belongs to one contour");
      for (int c = 0; c < 3; ++c)
      {
        double x[3];
        input->GetPoint(corners[c].Source, x);
        check.That(std::equal(x, x + 3, corners[c].X), "points are unchanged");
        check.Near(corners[c].T,
          input->GetPointData()->GetArray("AdvectionTime")->GetComponent(corners[c].Source, 0), 0.0,
          "t", 1.0);
      }
    });
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    check.That(output->GetPointData()->GetArray("vtkOriginalPointIds")->GetComponent(p, 0) == p,
      "points keep their ids");
  }
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const double s = output->GetPointData()->GetTCoords()->GetComponent(p, 0);
    check.That(s >= 0.0, "s is not negative");
  }
}

// Checks s on a circular contour: s / radius minus the angle must be constant.
void CheckCircle(Pipeline& pipeline, double radius,
  const std::function<double(const double*)>& angle, double sign, double tolerance, Check& check)
{
  bool isFirst = true;
  double offset = 0.0;
  ForEachTriangle(pipeline.Update(),
    [&](const Corner* corners)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double difference = sign * corners[c].S / radius - angle(corners[c].X);
        offset = isFirst ? difference : offset;
        isFirst = false;
        const double rotations = (difference - offset) / (2.0 * Pi);
        check.Near(
          2.0 * Pi * (rotations - std::round(rotations)), 0.0, tolerance, "s along a circle", 1.0);
      }
    });
}

// Circumference of an ellipse with the semi-axes a and b, by Simpson's rule.
double GetEllipseLength(double a, double b)
{
  constexpr int steps = 2000;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double t = 2.0 * Pi * i / steps;
    const double speed = std::hypot(a * std::sin(t), b * std::cos(t));
    sum += speed * (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2);
  }
  return sum * 2.0 * Pi / steps / 3.0;
}

void CheckPlane(Check& check)
{
  vtkNew<Plane> plane;
  // On a rectangle twice as long as wide, a circle in parameter space is an ellipse.
  vtkNew<Plane> longPlane;
  longPlane->SetSize(2.0, 1.0);
  check.SetContext("circle");
  Pipeline circle(MakePlaneFlow(), "(u-0.5)^2+(v-0.5)^2", { 0.09 }, plane);
  check.Equal(circle.GetNumberOfContours(), 1, "contours");
  check.Equal(circle.GetNumberOfClosedContours(), 1, "closed contours");
  check.Near(circle.GetLength(0), 2.0 * Pi * 0.3, 1e-4, "length");
  CheckTriangles(circle, 0.15, check);
  // Values are higher outside the circle, which is to the left of a clockwise contour.
  const auto angle = [](const double* x) { return std::atan2(x[2] - 0.5, x[1] - 0.5); };
  CheckCircle(circle, 0.3, angle, -1.0, 2e-3, check);
  check.That(
    circle.Update()->GetNumberOfPoints() > circle.Volume->GetOutput(1)->GetNumberOfPoints(),
    "points at the start are copied");
  circle.Parameters->SetResolution(512);
  check.Near(circle.GetLength(0), 2.0 * Pi * 0.3, 1e-5, "length with higher resolution");
  circle.Parameters->SetResolution(256);

  check.SetContext("start point");
  circle.Parameters->AddStartPoint(0.0, 0.5, 3.0);
  CheckTriangles(circle, 0.15, check);
  ForEachTriangle(circle.Update(),
    [&](const Corner* corners)
    {
      for (int c = 0; c < 3; ++c)
      {
        // Clockwise rotations from the top. At duplicated start points, s is one rotation ahead.
        double rotations = 0.25 - angle(corners[c].X) / (2.0 * Pi);
        rotations -= std::floor(rotations);
        const double found = corners[c].S / circle.GetLength(0);
        check.Near(found - rotations, std::round(found - rotations), 5e-4, "s from the start", 1.0);
        check.That(found < 1.1, "s exceeds the length by at most a triangle");
      }
    });

  check.SetContext("scales");
  const double length = circle.GetLength(0);
  circle.Parameters->SetLengthScale(2.0 / length);
  circle.Parameters->SetTimeScale(3.0);
  const double most = circle.Update()->GetPointData()->GetTCoords()->GetRange(0)[1];
  check.That(most > 2.0 && most < 2.2, "two textures around");
  check.Near(circle.Update()->GetPointData()->GetTCoords()->GetRange(1)[1], 6.0, 1e-6, "t");
  check.Near(circle.GetLength(0), length, 1e-15, "lengths without scaling");

  check.SetContext("ellipse");
  Pipeline ellipse(MakePlaneFlow(), "(u-0.5)^2+(v-0.5)^2", { 0.09 }, longPlane);
  check.Near(ellipse.GetLength(0), GetEllipseLength(0.6, 0.3), 1e-4, "length");
  CheckTriangles(ellipse, 0.3, check);

  check.SetContext("open contours");
  Pipeline lines(MakePlaneFlow(), "u+0.5*v", { 0.3, 0.8, 1.2 }, plane);
  check.Equal(lines.GetNumberOfContours(), 3, "contours");
  check.Equal(lines.GetNumberOfClosedContours(), 0, "no contour is closed");
  check.Near(lines.GetLength(0), 0.3 * std::sqrt(5.0), 1e-9, "corner to corner");
  check.Near(lines.GetLength(1), std::sqrt(1.25), 1e-9, "side to side");
  check.Near(lines.GetLength(2), 0.3 * std::sqrt(5.0), 1e-9, "the other corner");
  CheckTriangles(lines, 0.15, check);
  for (double end : { 0.0, 1.0 })
  {
    lines.Parameters->RemoveAllStartPoints();
    lines.Parameters->AddStartPoint(0.0, 0.5, end);
    ForEachTriangle(lines.Update(),
      [&](const Corner* corners)
      {
        for (int c = 0; c < 3; ++c)
        {
          const double v = corners[c].X[2];
          // Contour 0 reaches only up to v = 0.6, and contour 2 only down to v = 0.4.
          const double first = corners[c].Contour == 0 ? 0.6 : 1.0;
          const double last = corners[c].Contour == 2 ? 0.4 : 0.0;
          check.Near(corners[c].S, std::sqrt(1.25) * (end == 0.0 ? v - last : first - v), 1e-6,
            "s of a straight line", 1.0);
        }
      });
  }
  check.SetContext("open curve");
  Pipeline parabola(MakePlaneFlow(), "v-u^2", { 0.0 }, plane);
  check.Near(
    parabola.GetLength(0), 0.5 * std::sqrt(5.0) + 0.25 * std::asinh(2.0), 1e-4, "parabola");

  check.SetContext("several contours of one value");
  Pipeline several(
    MakePlaneFlow(40), "min((u-0.27)^2+(v-0.27)^2,(u-0.72)^2+(v-0.7)^2)", { 0.04 }, plane);
  check.Equal(several.GetNumberOfClosedContours(), 2, "two circles");
  check.Near(several.GetLength(0), 2.0 * Pi * 0.2, 1e-4, "one");
  check.Near(several.GetLength(1), 2.0 * Pi * 0.2, 1e-4, "the other circle");
  CheckTriangles(several, 0.15, check);
  std::set<int> met;
  ForEachTriangle(several.Update(),
    [&](const Corner* corners)
    {
      met.insert(corners[0].Contour);
      const bool isFirst = corners[0].X[1] + corners[0].X[2] < 0.985;
      check.That((corners[0].Contour == 0) == isFirst, "the circle of the triangle");
    });
  check.Equal(static_cast<long long>(met.size()), 2, "both circles have triangles");

  // At the saddle, both branches of the contour cross the same cell of the contour grid.
  for (double value : { 0.0004, -0.0004 })
  {
    check.SetContext("saddle, " + std::to_string(value));
    Pipeline saddle(MakePlaneFlow(), "(u-0.5)*(v-0.5)", { value }, plane);
    saddle.Parameters->SetResolution(17);
    check.Equal(saddle.GetNumberOfContours(), 2, "two branches");
    check.Near(saddle.GetLength(0), saddle.GetLength(1), 1e-6, "equal lengths");
    // Ids of the contours at the arms of the saddle: right, top, left, bottom.
    std::array<std::set<int>, 4> arms;
    ForEachTriangle(saddle.Update(),
      [&](const Corner* corners)
      {
        const double y = corners[0].X[1] - 0.5;
        const double z = corners[0].X[2] - 0.5;
        if (std::max(std::abs(y), std::abs(z)) > 0.2)
        {
          const std::size_t arm = std::abs(y) > std::abs(z) ? (y > 0.0 ? 0 : 2) : z > 0.0 ? 1 : 3;
          arms[arm].insert(corners[0].Contour);
        }
      });
    const std::size_t first = value > 0.0 ? 0 : 1;
    check.That(arms[first].size() == 1 && arms[first] == arms[first + 1], "one branch");
    check.That(arms[first + 2].size() == 1 && arms[first + 2] == arms[(first + 3) % 4] &&
        arms[first + 2] != arms[first],
      "the other branch");
  }
}

void CheckCylinder(Check& check)
{
  vtkNew<Cylinder> cylinder;
  cylinder->SetRadius(0.4);
  check.SetContext("around a cylinder");
  Pipeline around(MakeCylinderFlow(), "v", { 0.37 }, cylinder);
  check.Equal(around.GetNumberOfContours(), 1, "contours");
  check.Equal(around.GetNumberOfClosedContours(), 1, "the contour is closed");
  check.Near(around.GetLength(0), 2.0 * Pi * 0.4, 1e-4, "length");
  CheckTriangles(around, 0.2, check);
  const auto angle = [](const double* x) { return std::atan2(x[1], x[0]); };
  CheckCircle(around, 0.4, angle, 1.0, 0.02, check);

  check.SetContext("a wave around a cylinder");
  // The wave is steepest at the seam.
  Pipeline wave(MakeCylinderFlow(), "v+0.1*sin(6.283185307179586*u)", { 0.5 }, cylinder);
  // Arc length of the wave as a function of the angle around the axis.
  std::vector<double> lengths{ 0.0 };
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i)
  {
    const double slope = 0.1 * std::cos(2.0 * Pi * (i + 0.5) / steps);
    lengths.push_back(lengths.back() + 2.0 * Pi / steps * std::hypot(0.4, slope));
  }
  check.Near(wave.GetLength(0), lengths.back(), 1e-4, "length");
  CheckTriangles(wave, 0.2, check);
  CheckCircle(
    wave, lengths.back() / (2.0 * Pi),
    [&](const double* x)
    {
      double rotations = std::atan2(x[1], x[0]) / (2.0 * Pi);
      rotations -= std::floor(rotations);
      return 2.0 * Pi * lengths[static_cast<std::size_t>(rotations * steps)] / lengths.back();
    },
    1.0, 0.02, check);

  check.SetContext("across the seam");
  Pipeline across(MakeCylinderFlow(40), "4*(1-cos(6.283185307179586*u))/39.4784176+(v-0.5)^2*0.7",
    { 0.01 }, cylinder);
  check.Equal(across.GetNumberOfClosedContours(), 1, "one closed contour");
  check.Equal(across.GetNumberOfContours(), 1, "no other contour");
  CheckTriangles(across, 0.3, check);
  // The same contour, rotated away from the seam.
  Pipeline away(MakeCylinderFlow(40),
    "4*(1-cos(6.283185307179586*(u-0.5)))/39.4784176+(v-0.5)^2*0.7", { 0.01 }, cylinder);
  check.Near(across.GetLength(0), away.GetLength(0), 1e-6,
    "the length equals the length at another seam position");

  check.SetContext("a spiral");
  Pipeline spiral(MakeCylinderFlow(), "u", { 0.25 }, cylinder);
  check.Equal(spiral.GetNumberOfContours(), 1, "an axial line");
  check.Near(spiral.GetLength(0), 1.0, 1e-9, "the length equals the height of the cylinder");
  CheckTriangles(spiral, 0.2, check);

  check.SetContext("gaps");
  cylinder->SetGap(0.25, 0.5);
  Pipeline gap(MakeCylinderFlow(), "v", { 0.37 }, cylinder);
  check.Equal(gap.GetNumberOfContours(), 1, "one arc remains");
  check.Equal(gap.GetNumberOfClosedContours(), 0, "the arc is open");
  check.Near(gap.GetLength(0), 1.5 * Pi * 0.4, 0.01, "length of the arc");
}

void CheckParts(Check& check)
{
  check.SetContext("several surfaces");
  auto image = MakeFlowImage({ { 20, 20, 20 } }, { { -1, 1, 0, 1, 0, 1 } });
  AddFlow(image,
    [](const double* x) -> FlowResult {
      return { 0, x[0] < 0.0 ? 4 : 9, x[1], x[2], std::abs(x[0]) };
    },
    { { { 4, 0, 0 } }, { { 9, 0, 0 } } });
  vtkNew<Plane> plane;
  vtkNew<Plane> large;
  large->SetSize(3.0, 3.0);
  Pipeline pipeline(image, "(u-0.5)^2+(v-0.5)^2", { 0.04, 0.09 });
  pipeline.Parameters->AddTerminationSurface(large, 4);
  pipeline.Parameters->AddTerminationSurface(plane, 9);
  check.Equal(pipeline.GetNumberOfContours(), 4, "contours");
  const double expected[4] = { 0.6, 0.9, 0.2, 0.3 };
  for (int i = 0; i < 4; ++i)
  {
    check.Near(pipeline.GetLength(i), 2.0 * Pi * expected[i], 1e-4, "length");
  }
  CheckTriangles(pipeline, 0.6, check);
  ForEachTriangle(pipeline.Update(),
    [&](const Corner* corners)
    { check.That((corners[0].Contour < 2) == (corners[0].X[0] < 0.0), "contour of the surface"); });
}

// Returns s, divided by the contour length, at points far from the contour. Each cell of \a mesh is
// a degenerate triangle whose corners are the same point.
std::vector<double> GetFar(vtkUnstructuredGrid* mesh, const FlowResultFunction& flow,
  const FlowSurface& periodic, const char* formula, double value, vtkTerminationSurface* surface,
  const std::array<double, 3>& start)
{
  AddFlow(mesh, flow, { periodic });
  vtkNew<vtkDoubleArray> values;
  values->SetName("Inflow");
  values->SetNumberOfValues(mesh->GetNumberOfCells());
  values->Fill(value);
  mesh->GetCellData()->AddArray(values);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetFormula(vtkInflowMapping::ALL, formula);
  vtkNew<vtkStreamSurfaceParameters> parameters;
  parameters->SetInputData(mesh);
  parameters->SetMapping(mapping);
  parameters->AddTerminationSurface(surface, 0);
  parameters->AddStartPoint(start[0], start[1], start[2]);
  parameters->Update();
  vtkPolyData* output = parameters->GetOutput();
  const double length = output->GetFieldData()->GetArray("ContourLength")->GetComponent(0, 0);
  std::vector<double> found;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    found.push_back(output->GetPointData()->GetTCoords()->GetComponent(i, 0) / length);
  }
  return found;
}

// Tests points far from a circular contour. The closest contour point has the same angle.
void CheckFar(Check& check)
{
  check.SetContext("far from the contour");
  vtkNew<Plane> plane;
  // Points on a spiral in parameter space.
  MeshBuilder builder;
  constexpr int number = 300;
  for (int i = 0; i < number; ++i)
  {
    const double r = 0.1 + 0.4 * i / number;
    const vtkIdType p = builder.AddPoint(0.0, 0.5 + r * std::cos(i), 0.5 + r * std::sin(i));
    builder.AddCell(VTK_TRIANGLE, { p, p, p });
  }
  auto mesh = builder.GetMesh();
  const std::vector<double> found = GetFar(mesh, UniformFlow(1.0), { { 0, 0, 0 } },
    "(u-0.5)^2+(v-0.5)^2", 0.09, plane, { { 0.0, 0.8, 0.5 } });
  for (int i = 0; i < number; ++i)
  {
    const double rotations = found[i] + i / (2.0 * Pi);
    check.Near(rotations, std::round(rotations), 2e-3, "s at the closest position", 1.0);
  }
}

// Compares s at points far from a wave around a cylinder, also across the seam, with s at the
// closest of many points sampled on the wave.
void CheckFarAround(Check& check)
{
  check.SetContext("far from a contour around a cylinder");
  vtkNew<Cylinder> cylinder;
  MeshBuilder builder;
  constexpr int number = 60;
  for (int i = 0; i < number; ++i)
  {
    const double rotations = 0.37 * i - std::floor(0.37 * i);
    const vtkIdType p = builder.AddPoint(
      std::cos(2.0 * Pi * rotations), std::sin(2.0 * Pi * rotations), 0.3 + 0.4 * i / number);
    builder.AddCell(VTK_TRIANGLE, { p, p, p });
  }
  auto mesh = builder.GetMesh();
  const std::vector<double> found = GetFar(mesh, CylinderFlow(0.999), { { 0, 1, 0 } },
    "v+0.1*sin(6.283185307179586*u)", 0.5, cylinder, { { 1.0, 0.0, 0.5 } });
  for (int i = 0; i < number; ++i)
  {
    const double* uv = mesh->GetPointData()->GetArray("TerminationUV")->GetTuple2(i);
    constexpr int steps = 20000;
    double length = 0.0;
    double nearest = 0.0;
    double least = 10.0;
    for (int step = 0; step < steps; ++step)
    {
      const double u = (step + 0.5) / steps;
      const double du = uv[0] - u - std::round(uv[0] - u);
      const double distance = std::hypot(du, uv[1] - 0.5 + 0.1 * std::sin(2.0 * Pi * u));
      length += 2.0 * Pi / steps * std::hypot(1.0, 0.1 * std::cos(2.0 * Pi * u));
      nearest = distance < least ? length : nearest;
      least = std::min(least, distance);
    }
    const double rotations = found[i] - nearest / length;
    check.Near(rotations, std::round(rotations), 3e-3, "s at the closest position", 1.0);
  }
}

void CheckRuns(Check& check)
{
  vtkNew<Cylinder> cylinder;
  cylinder->SetRadius(0.4);
  CheckThreads(
    "parameters",
    [&]()
    {
      Pipeline pipeline(
        MakeCylinderFlow(), "v+0.1*cos(6.283185307179586*u)", { 0.4, 0.5 }, cylinder);
      vtkPolyData* output = pipeline.Update();
      auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
      grid->SetPoints(output->GetPoints());
      grid->SetCells(VTK_TRIANGLE, output->GetPolys());
      grid->GetPointData()->ShallowCopy(output->GetPointData());
      return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ grid };
    },
    check);
}

void CheckErrors(Check& check)
{
  vtkNew<Plane> plane;
  struct
  {
    const char* Part;
    std::function<void(vtkStreamSurfaceParameters*, vtkUnstructuredGrid*)> Spoil;
  } const cases[] = {
    { "no mapping",
      [](vtkStreamSurfaceParameters* f, vtkUnstructuredGrid*) { f->SetMapping(nullptr); } },
    { "no termination surface with id 0",
      [](vtkStreamSurfaceParameters* f, vtkUnstructuredGrid*)
      { f->RemoveAllTerminationSurfaces(); } },
    { "sizes must be positive",
      [&](vtkStreamSurfaceParameters*, vtkUnstructuredGrid*) { plane->SetSize(0.0, 0.0); } },
    { "\"AdvectionTime\"",
      [](vtkStreamSurfaceParameters*, vtkUnstructuredGrid* d)
      { d->GetPointData()->RemoveArray("AdvectionTime"); } },
    { "\"TerminationUV\"",
      [](vtkStreamSurfaceParameters*, vtkUnstructuredGrid* d)
      { d->GetPointData()->RemoveArray("TerminationUV"); } },
    { "cell array \"Inflow\"",
      [](vtkStreamSurfaceParameters*, vtkUnstructuredGrid* d)
      { d->GetCellData()->RemoveArray("Inflow"); } },
    { "4 points",
      [](vtkStreamSurfaceParameters*, vtkUnstructuredGrid* d)
      {
        const vtkIdType ids[4] = { 0, 1, 2, 3 };
        d->InsertNextCell(VTK_TETRA, 4, ids);
        d->GetCellData()->GetArray("Inflow")->InsertNextTuple1(0.0);
        d->GetCellData()->GetArray("StreamSurfaceId")->InsertNextTuple1(0);
      } },
  };
  for (const auto& one : cases)
  {
    check.SetContext(one.Part);
    plane->SetSize(1.0, 1.0);
    Pipeline pipeline(MakePlaneFlow(8), "u", { 0.4 }, plane);
    pipeline.Volume->Update();
    vtkNew<vtkUnstructuredGrid> input;
    input->DeepCopy(pipeline.Volume->GetOutput(1));
    one.Spoil(pipeline.Parameters, input);
    pipeline.Parameters->SetInputData(input);
    const std::string message = UpdateAndGetErrors(pipeline.Parameters);
    check.Contains(message, one.Part);
    check.Equal(pipeline.Parameters->GetOutput()->GetNumberOfCells(), 0, "no output");
  }
  check.SetContext("settings");
  plane->SetSize(1.0, 1.0);
  Pipeline pipeline(MakePlaneFlow(8), "u", { 0.4 });
  pipeline.Parameters->AddTerminationSurface(nullptr);
  check.Equal(pipeline.Parameters->GetNumberOfTerminationSurfaces(), 0, "null is rejected");
  pipeline.Parameters->AddTerminationSurface(plane, 0);
  check.That(pipeline.Parameters->GetTerminationSurface(0) == plane.Get(), "GetTerminationSurface");
  check.That(pipeline.Parameters->GetTerminationSurface(1) == nullptr, "none");
  check.Near(pipeline.GetLength(0), 1.0, 1e-9, "length");
  plane->SetSize(1.0, 2.0);
  check.Near(pipeline.GetLength(0), 2.0, 1e-9, "a modified surface causes an execution");
  CheckPrinted(Print(pipeline.Parameters), { "Mapping: set", "Resolution: 256" }, check);
  ProgressWatch watch;
  ObserveProgress(pipeline.Parameters, watch);
  pipeline.Parameters->Modified();
  pipeline.Update();
  CheckMonotonicProgress(watch, 3, check);
  // A contour smaller than a cell of the contour grid is not found.
  check.SetContext("no contour");
  Pipeline small(MakePlaneFlow(41), "(u-0.525)^2+(v-0.525)^2", { 0.0002 }, plane);
  small.Parameters->SetResolution(4);
  check.Equal(small.GetNumberOfContours(), 0, "none");
  ForEachTriangle(small.Update(),
    [&](const Corner* corners) { check.Equal(corners[0].Contour, -1, "id without a contour"); });
}

}

int TestStreamSurfaceParameters(int, char*[])
{
  return RunChecks(
    { CheckPlane, CheckCylinder, CheckParts, CheckFar, CheckFarAround, CheckRuns, CheckErrors });
}
