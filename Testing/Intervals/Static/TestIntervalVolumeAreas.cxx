// SPDX-License-Identifier: BSD-3-Clause
// Areas of the output of two-dimensional cells. For linear fields they equal the areas of clipped
// polygons, for polygons of any type, in any plane, and for structured grids with any flat axis.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkClipPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <string>

namespace
{

using namespace reference;
using Point = std::array<double, 3>;
using Polygon = std::vector<Point>;

constexpr double Tolerance = 1e-13;

/// The area vectors of the triangles of each interval, and the sums of their lengths.
struct Areas
{
  std::vector<Point> Vectors;
  std::vector<double> Sums;
};

Point Subtract(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Point AreaVector(const Polygon& polygon)
{
  Point sum{};
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const Point a = Subtract(polygon[i - 1], polygon[0]);
    const Point b = Subtract(polygon[i], polygon[0]);
    Point cross;
    vtkMath::Cross(a.data(), b.data(), cross.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += cross[axis] / 2;
    }
  }
  return sum;
}

Areas Measure(vtkUnstructuredGrid* output, std::size_t intervals, Check& check)
{
  Areas areas{ std::vector<Point>(intervals), std::vector<double>(intervals) };
  vtkDataArray* ids = output->GetCellData()->GetArray("IntervalId");
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    check.Equal(output->GetCellType(cell), VTK_TRIANGLE, "type of a cell");
    output->GetCellPoints(cell, points);
    Polygon triangle(3);
    for (int v = 0; v < 3; ++v)
    {
      output->GetPoint(points->GetId(v), triangle[v].data());
    }
    const Point area = AreaVector(triangle);
    const int interval = static_cast<int>(ids->GetComponent(cell, 0));
    vtkMath::Add(areas.Vectors[interval].data(), area.data(), areas.Vectors[interval].data());
    areas.Sums[interval] += vtkMath::Norm(area.data());
  }
  return areas;
}

/// Clips a polygon by Sutherland and Hodgman's algorithm to where function >= value, or <= value.
/// The result may contain edges of no width, which do not change its signed area.
Polygon Clip(const Polygon& polygon, const LinearFunction& function, double value, double sign)
{
  Polygon clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double fa = sign * (function(a.data()) - value);
    const double fb = sign * (function(b.data()) - value);
    if (fa >= 0)
    {
      clipped.push_back(a);
    }
    if ((fa >= 0) != (fb >= 0))
    {
      const double t = fa / (fa - fb);
      clipped.push_back(
        { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) });
    }
  }
  return clipped;
}

std::vector<Interval> Bands(const std::vector<double>& bounds)
{
  std::vector<Interval> bands;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
  {
    bands.push_back({ bounds[i], bounds[i + 1] });
  }
  return bands;
}

/// Compares the output of a dataset that covers \a polygon with the clipped polygon. All triangles
/// must have the orientation of the polygon. The bounds are fractions of the range of the values.
void CheckBands(vtkDataSet* data, const Polygon& polygon, const LinearFunction& function,
  bool isOriented, Check& check)
{
  double range[2] = { function(polygon[0].data()), function(polygon[0].data()) };
  for (const Point& x : polygon)
  {
    range[0] = std::min(range[0], function(x.data()));
    range[1] = std::max(range[1], function(x.data()));
  }
  std::vector<double> bounds;
  for (const double fraction : { -1.0, 0.1, 0.11, 0.5, 0.8, 2.0 })
  {
    bounds.push_back(range[0] + fraction * (range[1] - range[0]));
  }
  const std::vector<Interval> bands = Bands(bounds);
  const Extraction extraction = ExtractIntervals(data, bands);
  const Areas areas = Measure(extraction.Volume, bands.size(), check);
  const Point all = AreaVector(polygon);
  const double total = vtkMath::Norm(all.data());
  Point sum{};
  for (std::size_t i = 0; i < bands.size(); ++i)
  {
    const Point area =
      AreaVector(Clip(Clip(polygon, function, bands[i][0], 1), function, bands[i][1], -1));
    for (int axis = 0; axis < 3; ++axis)
    {
      check.Near(areas.Vectors[i][axis], area[axis], Tolerance,
        "area of band " + std::to_string(i) + " along axis " + std::to_string(axis), total);
      sum[axis] += areas.Vectors[i][axis];
    }
    if (isOriented)
    {
      check.Near(areas.Sums[i], vtkMath::Norm(areas.Vectors[i].data()), Tolerance,
        "orientation of band " + std::to_string(i), total);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    check.Near(sum[axis], all[axis], Tolerance, "sum of the areas", total);
  }
  // The boundary consists of lines on which the field equals a bound.
  vtkUnstructuredGrid* lines = extraction.Surface;
  vtkDataArray* sides = lines->GetCellData()->GetArray("BoundarySide");
  vtkDataArray* intervals = lines->GetCellData()->GetArray("IntervalId");
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    const double bound = bands[static_cast<std::size_t>(intervals->GetComponent(line, 0))]
                              [static_cast<std::size_t>(sides->GetComponent(line, 0))];
    check.Equal(lines->GetCellType(line), VTK_LINE, "type of a boundary cell");
    for (int end = 0; end < 2; ++end)
    {
      check.Near(function(lines->GetPoint(lines->GetCell(line)->GetPointId(end))), bound, Tolerance,
        "value on a boundary", range[1] - range[0]);
    }
  }
  check.That(lines->GetNumberOfCells() > 0, "there is a boundary");
}

/// Maps the plane z = 0 to an inclined plane.
Point Incline(double x, double y)
{
  return { 0.3 + 0.8 * x - 0.2 * y, 0.1 * x + 0.9 * y - 1, 0.5 * x + 0.4 * y + 2 };
}

void CheckCellTypes(Check& check)
{
  const LinearFunction function{ 0.2, { 0.7, -0.4, 0.3 } };
  struct
  {
    const char* Name;
    int Type;
    std::vector<std::array<double, 2>> Points;
    /// The number of corners, if there are other points.
    std::size_t Corners;
    /// The order of the points along the border. Empty if it is the order of the points.
    std::vector<int> Border;
  } const cases[] = { { "triangle", VTK_TRIANGLE, { { 0, 0 }, { 2, 0.3 }, { 0.4, 1 } }, 0, {} },
    { "clockwise triangle", VTK_TRIANGLE, { { 0, 0 }, { 0.4, 1 }, { 2, 0.3 } }, 0, {} },
    { "quadrilateral", VTK_QUAD, { { 0, 0 }, { 2, 0.3 }, { 1.8, 1.5 }, { 0.4, 1 } }, 0, {} },
    { "pixel", VTK_PIXEL, { { 0, 0 }, { 2, 0 }, { 0, 1 }, { 2, 1 } }, 0, { 0, 1, 3, 2 } },
    { "concave quadrilateral", VTK_QUAD, { { 0, 0 }, { 2, 0 }, { 0.5, 0.4 }, { 0.1, 2 } }, 0, {} },
    { "concave quadrilateral, at its last point", VTK_QUAD,
      { { 0.1, 2 }, { 0, 0 }, { 2, 0 }, { 0.5, 0.4 } }, 0, {} },
    { "degenerate quadrilateral", VTK_QUAD, { { 0, 0 }, { 2, 0 }, { 2, 0 }, { 0.1, 2 } }, 0, {} },
    { "hexagon", VTK_POLYGON,
      { { 1, 0 }, { 0.5, 0.9 }, { -0.5, 0.8 }, { -1, 0 }, { -0.5, -0.7 }, { 0.5, -0.8 } }, 0, {} },
    { "polygon with three points", VTK_POLYGON, { { 0, 0 }, { 2, 0.3 }, { 0.4, 1 } }, 0, {} },
    { "concave polygon", VTK_POLYGON,
      { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 2 }, { 2.5, 2 }, { 2.5, 3 }, { 0, 3 } }, 0,
      {} },
    { "polygon with points on edges", VTK_POLYGON,
      { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 2, 2 }, { 0, 2 } }, 0, {} },
    { "strip", VTK_TRIANGLE_STRIP, { { 0, 0 }, { 0, 1 }, { 1, 0 }, { 1.2, 1.1 }, { 2, 0.1 } }, 0,
      { 0, 1, 3, 4, 2 } },
    { "quadratic triangle", VTK_QUADRATIC_TRIANGLE,
      { { 0, 0 }, { 2, 0.3 }, { 0.4, 1 }, { 1, 0.1 }, { 1, 1 }, { 0, 0 } }, 3, {} },
    { "quadratic quadrilateral", VTK_QUADRATIC_QUAD,
      { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 }, { 1, 0 }, { 2, 0 }, { 1, 1 }, { 0, 0 } }, 4, {} },
    { "quadratic polygon", VTK_QUADRATIC_POLYGON,
      { { 1, 0 }, { 0, 1 }, { -1, 0 }, { -1, -1 }, { 0, -1 }, { 0, 0 }, { 0, 0 }, { 0, 0 },
        { 0, 0 }, { 0, 0 } },
      5, {} } };
  for (const auto& one : cases)
  {
    check.SetContext(one.Name);
    MeshBuilder builder;
    std::vector<vtkIdType> ids;
    Polygon points;
    for (const auto& at : one.Points)
    {
      points.push_back(Incline(at[0], at[1]));
      ids.push_back(builder.AddPoint(points.back()[0], points.back()[1], points.back()[2]));
    }
    builder.AddCell(one.Type, ids);
    auto mesh = builder.GetMesh();
    AddLinearField(mesh, function);
    Polygon border;
    for (const int v : one.Border)
    {
      border.push_back(points[v]);
    }
    if (border.empty())
    {
      border = points;
      border.resize(one.Corners > 0 ? one.Corners : points.size());
    }
    if (one.Corners == 0)
    {
      CheckBands(mesh, border, function, true, check);
      check.Near(Measure(ExtractIntervals(mesh, { { -10, 10 } }).Volume, 1, check).Sums[0],
        vtkMath::Norm(AreaVector(border).data()), Tolerance, "area without overlaps");
      continue;
    }
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(mesh);
    filter->SetInterval(0, -10, 10);
    check.Contains(WarningsOf(filter), "1 quadratic or higher-order cells are treated as linear");
    check.Near(Measure(filter->GetOutput(), 1, check).Sums[0],
      vtkMath::Norm(AreaVector(border).data()), Tolerance, "area");
    check.Equal(filter->GetReport()->GetCount("LinearizedCells"), 1, "linearized cells");
  }
}

/// The corners of a structured grid with one flat axis, in the orientation of its cells.
Polygon GetCorners(vtkDataSet* grid, const int dimensions[3])
{
  std::vector<vtkIdType> sizes;
  std::copy_if(dimensions, dimensions + 3, std::back_inserter(sizes), [](int n) { return n > 1; });
  const vtkIdType ids[] = { 0, sizes[0] - 1, sizes[0] * sizes[1] - 1, sizes[0] * (sizes[1] - 1) };
  Polygon corners(4);
  for (int v = 0; v < 4; ++v)
  {
    grid->GetPoint(ids[v], corners[v].data());
  }
  return corners;
}

void CheckStructuredGrids(Check& check)
{
  const LinearFunction function{ 0.2, { 0.7, -0.4, 0.3 } };
  const double spacings[][3] = { { 0.1, 0.3, 0.7 }, { -0.1, 0.3, 0.7 }, { 0.1, -0.3, -0.7 } };
  for (int flat = 0; flat < 3; ++flat)
  {
    int dimensions[3] = { 5, 4, 7 };
    dimensions[flat] = 1;
    for (const double* spacing : { spacings[0], spacings[1], spacings[2] })
    {
      for (const bool isRotated : { false, true })
      {
        check.SetContext("flat axis " + std::to_string(flat) + ", spacing " +
          std::to_string(spacing[0]) + (isRotated ? ", rotated" : ""));
        vtkNew<vtkImageData> image;
        image->SetExtent(2, 1 + dimensions[0], -1, dimensions[1] - 2, 0, dimensions[2] - 1);
        image->SetSpacing(spacing);
        image->SetOrigin(0.3, -2, 5);
        if (isRotated)
        {
          image->SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
        }
        AddLinearField(image, function);
        const Polygon corners = GetCorners(image, dimensions);
        CheckBands(image, corners, function, true, check);
        vtkNew<vtkStructuredGrid> curvilinear;
        vtkNew<vtkPoints> points;
        points->SetDataTypeToDouble();
        for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
        {
          points->InsertNextPoint(image->GetPoint(p));
        }
        curvilinear->SetDimensions(dimensions);
        curvilinear->SetPoints(points);
        AddLinearField(curvilinear, function);
        CheckBands(curvilinear, corners, function, true, check);
      }
    }
    check.SetContext("rectilinear grid, flat axis " + std::to_string(flat));
    vtkNew<vtkRectilinearGrid> rectilinear;
    rectilinear->SetDimensions(dimensions);
    vtkNew<vtkDoubleArray> axes[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < dimensions[axis]; ++i)
      {
        axes[axis]->InsertNextValue(axis == 1 ? 3 - 0.1 * i * i : 0.2 * i + 0.05 * i * i);
      }
    }
    rectilinear->SetXCoordinates(axes[0]);
    rectilinear->SetYCoordinates(axes[1]);
    rectilinear->SetZCoordinates(axes[2]);
    AddLinearField(rectilinear, function);
    CheckBands(rectilinear, GetCorners(rectilinear, dimensions), function, true, check);
  }
}

double SurfaceArea(vtkPolyData* surface)
{
  double area = 0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdList* ids = surface->GetCell(cell)->GetPointIds();
    Polygon polygon(ids->GetNumberOfIds());
    for (vtkIdType v = 0; v < ids->GetNumberOfIds(); ++v)
    {
      surface->GetPoint(ids->GetId(v), polygon[v].data());
    }
    area += vtkMath::Norm(AreaVector(polygon).data());
  }
  return area;
}

/// Returns the area where the active scalars are at least \a value, as clipped by VTK.
double ClippedArea(vtkPolyData* surface, double value)
{
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(surface);
  clip->SetValue(value);
  clip->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clip->Update();
  return SurfaceArea(clip->GetOutput());
}

/// Compares random values on a triangulated sphere with VTK's clips, which are exact on triangles
/// except that they round scalars to float.
void CheckClips(Check& check)
{
  check.SetContext("clips of a sphere");
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  vtkPolyData* surface = sphere->GetOutput();
  AddRandomField(surface, 3);
  const std::vector<Interval> bands = Bands({ -1, 0.2, 0.21, 0.5, 0.9, 2 });
  const Areas areas = Measure(ExtractIntervals(surface, bands).Volume, bands.size(), check);
  const double total = SurfaceArea(surface);
  double sum = 0;
  for (std::size_t i = 0; i < bands.size(); ++i)
  {
    check.Near(areas.Sums[i], ClippedArea(surface, bands[i][0]) - ClippedArea(surface, bands[i][1]),
      1e-8, "band " + std::to_string(i), total);
    sum += areas.Sums[i];
  }
  check.Near(sum, total, 1e-12, "sum of the bands");
}

struct Band
{
  LinearFunction Function;
  double Lower;
  double Upper;
};

/// Checks the areas of the union and the difference of a region of the rectangle and two criteria.
void CheckOperations(vtkIntervalVolume* filter, const std::array<Band, 3>& bands, Check& check)
{
  // The area where all bands of a set overlap.
  const auto area = [&bands](std::initializer_list<int> set)
  {
    Polygon polygon = { { 0, 0, 0 }, { 0.7, 0, 0 }, { 0.7, 1, 0 }, { 0, 1, 0 } };
    for (int i : set)
    {
      const Band& band = bands[i];
      polygon = Clip(Clip(polygon, band.Function, band.Lower, 1), band.Function, band.Upper, -1);
    }
    return AreaVector(polygon)[2];
  };
  const double difference = area({ 0 }) - area({ 0, 1 }) - area({ 0, 2 }) + area({ 0, 1, 2 });
  const double criteria = area({ 1 }) + area({ 2 }) - area({ 1, 2 });
  for (int operation : { vtkIntervalVolume::UNION, vtkIntervalVolume::DIFFERENCE })
  {
    vtkNew<vtkIntervalVolume> changed;
    changed->SetInputData(filter->GetInput());
    changed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    changed->SetInterval(0, bands[0].Lower, bands[0].Upper);
    changed->AddCriterion("g", bands[1].Lower, bands[1].Upper);
    changed->AddCriterion("h", bands[2].Lower, bands[2].Upper);
    changed->SetCriteriaOperation(operation);
    changed->Update();
    changed->GetOutput()->GetCellData()->GetArray("IntervalId")->Fill(0);
    const Areas areas = Measure(changed->GetOutput(), 1, check);
    const double expected =
      operation == vtkIntervalVolume::UNION ? difference + criteria : difference;
    check.Near(areas.Vectors[0][2], expected, 1e-13, "area of an operation", 1);
    check.Near(areas.Sums[0], expected, 1e-13, "orientation of an operation", 1);
  }
}

/// Cuts a rectangle by two criteria. The boundary consists of lines of the intervals and criteria.
void CheckCriteria(Check& check)
{
  check.SetContext("criteria");
  const LinearFunction f{ 0, { 1, 0.2, 0 } };
  const LinearFunction g{ 0, { -0.3, 1, 0 } };
  const LinearFunction h{ 0, { 0.5, 0.5, 0 } };
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 6, 1);
  image->SetSpacing(0.1, 0.2, 1);
  AddLinearField(image, g, "g");
  AddLinearField(image, h, "h");
  AddLinearField(image, f, "f");
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(image);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->GenerateBoundariesOn();
  filter->SetInterval(0, 0.11, 0.43);
  filter->SetInterval(1, 0.43, 0.62);
  filter->AddCriterion("g", 0.17, 0.71);
  filter->AddCriterion("h", 0.2, 0.55);
  filter->Update();
  const Areas areas = Measure(filter->GetOutput(), 2, check);
  CheckOperations(filter, { { { f, 0.11, 0.62 }, { g, 0.17, 0.71 }, { h, 0.2, 0.55 } } }, check);
  const Polygon all = { { 0, 0, 0 }, { 0.7, 0, 0 }, { 0.7, 1, 0 }, { 0, 1, 0 } };
  const Polygon region =
    Clip(Clip(Clip(Clip(all, g, 0.17, 1), g, 0.71, -1), h, 0.2, 1), h, 0.55, -1);
  double lengths[2][6] = {};
  vtkUnstructuredGrid* lines = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    double x[2][3];
    lines->GetPoint(lines->GetCell(line)->GetPointId(0), x[0]);
    lines->GetPoint(lines->GetCell(line)->GetPointId(1), x[1]);
    const auto id = [&](const char* name)
    { return static_cast<int>(lines->GetCellData()->GetArray(name)->GetComponent(line, 0)); };
    lengths[id("IntervalId")][id("BoundarySide")] +=
      std::sqrt(vtkMath::Distance2BetweenPoints(x[0], x[1]));
  }
  const double bounds[] = { 0.11, 0.43, 0.62 };
  for (int i = 0; i < 2; ++i)
  {
    const Polygon band = Clip(Clip(region, f, bounds[i], 1), f, bounds[i + 1], -1);
    check.Near(areas.Vectors[i][2], AreaVector(band)[2], 1e-13, "area", 1);
    check.Near(areas.Sums[i], areas.Vectors[i][2], 1e-13, "orientation", 1);
    const std::pair<LinearFunction, double> sides[] = { { f, bounds[i] }, { f, bounds[i + 1] },
      { g, 0.17 }, { g, 0.71 }, { h, 0.2 }, { h, 0.55 } };
    for (int side = 0; side < 6; ++side)
    {
      double length = 0;
      for (std::size_t v = 0; v < band.size(); ++v)
      {
        const Point& a = band[v];
        const Point& b = band[(v + 1) % band.size()];
        const double middle[] = { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 0 };
        if (std::abs(sides[side].first(middle) - sides[side].second) < 1e-9)
        {
          length += std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
        }
      }
      check.Near(lengths[i][side], length, 1e-12, "length of the boundary", 1);
      check.That(side > 1 || length > 0.1, "the boundary is not short");
    }
  }
}

/// A self-intersecting polygon is counted, and its signed area is preserved.
void CheckFolded(Check& check)
{
  check.SetContext("self-intersecting polygon");
  const LinearFunction function{ 0, { 1, 0, 0 } };
  MeshBuilder builder;
  Polygon star;
  std::vector<vtkIdType> ids;
  for (int v = 0; v < 5; ++v)
  {
    const double angle = 0.8 * v * vtkMath::Pi();
    star.push_back({ std::cos(angle), std::sin(angle), 0 });
    ids.push_back(builder.AddPoint(star[v][0], star[v][1], 0));
  }
  builder.AddCell(VTK_POLYGON, ids);
  auto mesh = builder.GetMesh();
  AddLinearField(mesh, function);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(mesh);
  filter->SetInterval(0, -10, 10);
  check.Contains(WarningsOf(filter), "1 cells are folded or intersect themselves");
  check.Near(Measure(filter->GetOutput(), 1, check).Vectors[0][2], AreaVector(star)[2], Tolerance,
    "signed area");
}

/// Tiny and huge values and coordinates.
void CheckScales(Check& check)
{
  for (const double scale : { 1e-150, 1e150 })
  {
    check.SetContext("scale " + std::to_string(std::log10(scale)));
    const LinearFunction function{ 0, { scale, scale / 3, 0 } };
    vtkNew<vtkImageData> image;
    image->SetDimensions(4, 4, 1);
    AddLinearField(image, function);
    const std::vector<Interval> bands = Bands({ -scale, 0.7 * scale, 1.2 * scale, 9 * scale });
    const Areas areas = Measure(ExtractIntervals(image, bands).Volume, 3, check);
    const Polygon all = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 } };
    for (int i = 0; i < 3; ++i)
    {
      check.Near(areas.Vectors[i][2],
        AreaVector(Clip(Clip(all, function, bands[i][0], 1), function, bands[i][1], -1))[2], 1e-13,
        "area", 9);
    }
  }
}

}

int TestIntervalVolumeAreas(int, char*[])
{
  return RunChecks(
    { CheckCellTypes, CheckStructuredGrids, CheckClips, CheckCriteria, CheckFolded, CheckScales });
}
