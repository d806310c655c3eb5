// SPDX-License-Identifier: BSD-3-Clause
// Tests extreme two-dimensional cells: degenerate, self-intersecting and invalid polygons, lines,
// extreme values, and coordinates that are huge, tiny or NaN.
#include "StabilityChecks.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace reference;

constexpr double AreaBound = 1e-12;
const LinearFunction Function = { 0.1, { 0.3, 0.5, 0.7 } };
const std::vector<Interval> Halves = { { -9, 0.5 }, { 0.5, 9 } };

double SumAreas(vtkUnstructuredGrid* triangles)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    vtkIdList* ids = triangles->GetCell(cell)->GetPointIds();
    double x[3][3];
    for (int v = 0; v < 3; ++v)
    {
      triangles->GetPoint(ids->GetId(v), x[v]);
    }
    sum += vtkTriangle::TriangleArea(x[0], x[1], x[2]);
  }
  return sum;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeCell(
  int type, const std::vector<std::array<double, 2>>& points, const std::vector<vtkIdType>& ids)
{
  MeshBuilder builder;
  for (const auto& point : points)
  {
    builder.AddPoint(point[0], point[1], 0);
  }
  builder.AddCell(type, ids);
  auto mesh = builder.GetMesh();
  AddLinearField(mesh, Function);
  return mesh;
}

void TestDegenerate(StabilityCatalogue& catalogue)
{
  const std::vector<std::array<double, 2>> square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  struct
  {
    const char* Name;
    int Type;
    std::vector<vtkIdType> Ids;
    double Area;
  } const cases[] = { { "triangle-point-twice", VTK_TRIANGLE, { 0, 1, 1 }, 0 },
    { "triangle-one-point", VTK_TRIANGLE, { 2, 2, 2 }, 0 },
    { "quad-point-twice", VTK_QUAD, { 0, 1, 2, 2 }, 0.5 },
    { "quad-two-points", VTK_QUAD, { 0, 1, 0, 1 }, 0 },
    { "quad-one-point", VTK_QUAD, { 3, 3, 3, 3 }, 0 },
    { "pixel-point-twice", VTK_PIXEL, { 0, 1, 3, 3 }, 0.5 },
    { "polygon-point-twice", VTK_POLYGON, { 0, 1, 2, 2, 3 }, 1 },
    { "strip-point-twice", VTK_TRIANGLE_STRIP, { 0, 1, 3, 3, 2 }, 0.5 } };
  for (const auto& one : cases)
  {
    auto mesh = MakeCell(one.Type, square, one.Ids);
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(mesh);
    filter->WarnOnEmptyOutputOff();
    filter->SetInterval(0, Halves[0][0], Halves[0][1]);
    filter->SetInterval(1, Halves[1][0], Halves[1][1]);
    stability::UpdateFilter(filter);
    catalogue.Measure(one.Name, "a polygon with repeated point ids", "error of its area",
      SumAreas(filter->GetOutput()) - one.Area, AreaBound);
  }
  // All points on a line.
  auto flat =
    MakeCell(VTK_POLYGON, { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 4, 0 } }, { 0, 1, 2, 3, 4 });
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(flat);
  filter->WarnOnEmptyOutputOff();
  filter->SetInterval(0, -9, 9);
  const auto messages = stability::UpdateFilter(filter);
  catalogue.Check("polygon-flat", "a polygon whose points are all on a line", "no error, no area",
    messages.Errors.empty() ? "no error" : messages.Errors,
    messages.Errors.empty() && SumAreas(filter->GetOutput()) < AreaBound);
}

void TestLines(StabilityCatalogue& catalogue)
{
  vtkNew<vtkImageData> plane;
  plane->SetDimensions(4, 1, 3);
  plane->SetSpacing(0.1, 0.3, 0.7);
  AddLinearField(plane, Function);
  catalogue.Measure("one-layer-image", "an image with one layer of points", "error of its area",
    SumAreas(ExtractIntervals(plane, Halves).Volume) - 0.3 * 1.4, AreaBound);
  vtkNew<vtkImageData> pixel;
  pixel->SetDimensions(1, 2, 2);
  AddLinearField(pixel, Function);
  catalogue.Measure("one-pixel", "an image of one pixel", "error of its area",
    SumAreas(ExtractIntervals(pixel, Halves).Volume) - 1, AreaBound);
}

void TestValues(StabilityCatalogue& catalogue)
{
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double scale : { huge, tiny })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 1);
    vtkNew<vtkDoubleArray> values;
    values->SetName("f");
    for (int i = 0; i < 9; ++i)
    {
      values->InsertNextValue(i % 2 ? scale : -scale);
    }
    image->GetPointData()->SetScalars(values);
    catalogue.Measure(scale > 1 ? "surface-values-huge" : "surface-values-tiny",
      "values of the largest or smallest magnitude", "error of the area of two intervals",
      SumAreas(ExtractIntervals(image, { { -scale, 0 }, { 0, scale } }).Volume) - 4, AreaBound);
  }
}

void TestCoordinates(StabilityCatalogue& catalogue)
{
  for (const int exponent : { -100, 100 })
  {
    const double scale = std::ldexp(1.0, exponent);
    auto mesh = MakeCell(
      VTK_QUAD, { { 0, 0 }, { scale, 0 }, { scale, scale }, { 0, scale } }, { 0, 1, 2, 3 });
    AddRandomField(mesh, 2);
    catalogue.Measure("surface-coordinates-2^" + std::to_string(exponent),
      "tiny or huge coordinates", "relative error of the area",
      SumAreas(ExtractIntervals(mesh, { { -1, 0.5 }, { 0.5, 2 } }).Volume) / (scale * scale) - 1,
      AreaBound);
  }
  for (const double bad : { stability::NaN, stability::Infinity })
  {
    auto mesh = MakeCell(
      VTK_POLYGON, { { 0, 0 }, { 1, 0 }, { bad, 1 }, { 0, 2 }, { -1, 1 } }, { 0, 1, 2, 3, 4 });
    AddRandomField(mesh, 3);
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(mesh);
    filter->SetInterval(0, -1, 2);
    const auto messages = stability::UpdateFilter(filter);
    const double area = SumAreas(filter->GetOutput());
    catalogue.Check(std::string("polygon-") + (std::isnan(bad) ? "nan" : "infinite"),
      "a coordinate of a polygon is not finite", "a warning, finite output",
      std::to_string(area) + ": " + ToSingleLine(messages.Warnings),
      std::isfinite(area) && messages.Errors.empty() &&
        messages.Warnings.find("has a NaN or infinite coordinate") != std::string::npos);
  }
}

void TestInvalid(StabilityCatalogue& catalogue)
{
  auto bowtie = MakeCell(VTK_QUAD, { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } }, { 0, 1, 2, 3 });
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(bowtie);
  filter->SetInterval(0, -9, 9);
  const auto messages = stability::UpdateFilter(filter);
  catalogue.Check("quad-self-intersecting", "a quadrilateral that intersects itself",
    "no error, finite output", ToSingleLine(messages.Warnings),
    messages.Errors.empty() && std::isfinite(SumAreas(filter->GetOutput())));

  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(3), std::numeric_limits<vtkIdType>::max() })
  {
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    vtkNew<vtkCellArray> polygons;
    const vtkIdType ids[] = { 0, 1, 2 };
    polygons->InsertNextCell(3, ids);
    surface->SetPolys(polygons);
    AddLinearField(surface, Function);
    const vtkIdType wrong[] = { 0, 1, id };
    polygons->ReplaceCellAtId(0, 3, wrong);
    vtkNew<vtkIntervalVolume> invalid;
    invalid->SetInputData(surface);
    invalid->SetInterval(0, -9, 9);
    stability::ReportRejection(catalogue, invalid, "polygon-point-id-" + std::to_string(id),
      "a polygon with a point id out of range", { "vtkPolygon", "has the point" },
      [&]
      {
        polygons->ReplaceCellAtId(0, 3, ids);
        surface->Modified();
      });
  }
}

}

int TestStabilitySurfaces(int argc, char* argv[])
{
  return stability::RunCases(__func__, "vtkIntervalVolume", argc, argv,
    { TestDegenerate, TestLines, TestValues, TestCoordinates, TestInvalid });
}
