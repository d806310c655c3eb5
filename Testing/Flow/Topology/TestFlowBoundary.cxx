// SPDX-License-Identifier: BSD-3-Clause
// vtkFlowBoundary: flow rates by formula and by the divergence theorem, regions, outward polygons,
// seams, hidden cells, parameters, regions as termination surfaces, pieces, extreme scales, threads
// and messages.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowBoundary.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkInterlumeReport.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

double GetCellValue(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetComponent(cell, 0);
}

std::vector<double> GetRates(vtkFlowBoundary* filter)
{
  vtkDataArray* rates = filter->GetOutput()->GetFieldData()->GetArray("RegionFlowRate");
  std::vector<double> values;
  for (vtkIdType i = 0; i < rates->GetNumberOfTuples(); ++i)
  {
    values.push_back(rates->GetComponent(i, 0));
  }
  return values;
}

/// Uniform flow enters the cube through two sides and leaves through two.
void TestUniform(Check& check)
{
  for (const auto& grid : MakeFlowGrids())
  {
    check.SetContext(grid.first);
    AddVectors(
      grid.second,
      [](const Vector&) -> Vector {
        return { { 1.0, 0.5, 0.0 } };
      },
      VTK_FLOAT);
    vtkNew<vtkFlowBoundary> filter;
    filter->SetInputDataObject(grid.second);
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    vtkPolyData* output = filter->GetOutput();
    const std::vector<double> rates = GetRates(filter);
    const double expected[4] = { -16.0, 16.0, -8.0, 8.0 };
    check.Equal(static_cast<long long>(rates.size()), 4, "regions");
    for (std::size_t i = 0; i < rates.size() && i < 4; ++i)
    {
      check.Near(rates[i], expected[i], 1e-12, "flow rate");
      check.Near(
        output->GetFieldData()->GetArray("RegionArea")->GetComponent(i, 0), 16.0, 1e-12, "area");
    }
    check.Near(filter->GetReport()->GetNumber("InflowRate"), 24.0, 1e-12, "inflow");
    check.Near(filter->GetReport()->GetNumber("OutflowRate"), 24.0, 1e-12, "outflow");
    check.Equal(filter->GetReport()->GetCount("InflowRegions"), 2, "inflow regions");
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      double normal[3];
      double center[3] = { 0.0, 0.0, 0.0 };
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      output->GetCellPoints(cell, size, points);
      double corners[3][3];
      for (vtkIdType i = 0; i < size; ++i)
      {
        double x[3];
        output->GetPoint(points[i], x);
        for (int axis = 0; axis < 3; ++axis)
        {
          center[axis] += x[axis] / static_cast<double>(size);
          corners[i < 3 ? i : 2][axis] = x[axis];
        }
      }
      vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], normal);
      double outward = 0.0;
      int axis = 0;
      for (int i = 0; i < 3; ++i)
      {
        outward += normal[i] * (center[i] - 2.0);
        axis = std::abs(normal[i]) > 0.5 ? i : axis;
      }
      check.Near(outward, 2.0, 1e-12, "the polygon faces outward");
      const auto direction = static_cast<int>(GetCellValue(output, "FlowDirection", cell));
      const auto region = static_cast<int>(GetCellValue(output, "RegionId", cell));
      const int side = center[axis] > 2.0 ? 1 : -1;
      check.Equal(direction, axis == 2 ? 0 : side, "direction");
      check.Equal(region, axis == 2 ? -1 : 2 * axis + (side > 0 ? 1 : 0), "region");
      for (vtkIdType i = 0; i < size; ++i)
      {
        const double* uv = output->GetPointData()->GetTCoords()->GetTuple2(points[i]);
        double x[3];
        output->GetPoint(points[i], x);
        check.Near(uv[0], axis == 2 ? 0.0 : x[axis == 0 ? 1 : 0] / 4.0, 1e-12, "u", 1.0);
        check.Near(uv[1], axis == 2 ? 0.0 : x[2] / 4.0, 1e-12, "v", 1.0);
      }
    }
  }
  check.SetContext("");
}

/// Rates of a linear field add up to its divergence times the volume.
void TestDivergence(Check& check)
{
  for (const auto& grid : MakeFlowGrids())
  {
    check.SetContext(grid.first);
    AddVectors(grid.second, GetLinearVector);
    vtkNew<vtkFlowBoundary> filter;
    filter->SetInputDataObject(grid.second);
    filter->SetMinimumNormalSpeed(0.0);
    filter->Update();
    vtkInterlumeReport* report = filter->GetReport();
    check.Near(report->GetNumber("OutflowRate") - report->GetNumber("InflowRate"), 64.0 * 1.25,
      1e-12, "divergence theorem");
    double sum = 0.0;
    for (vtkIdType cell = 0; cell < filter->GetOutput()->GetNumberOfCells(); ++cell)
    {
      sum += GetCellValue(filter->GetOutput(), "FlowRate", cell);
    }
    check.Near(sum, 64.0 * 1.25, 1e-12, "sum over faces");
    check.That(report->GetNumber("InflowRate") > 10.0, "there is inflow");
  }
  check.SetContext("");
}

/// If flow both enters and leaves through a side, the side consists of two regions.
void TestHalves(Check& check)
{
  auto image = MakeFlowImage(5, [](const Vector& x) -> Vector { return { { x[1] - 2.0, 0, 0 } }; });
  vtkNew<vtkFlowBoundary> filter;
  filter->SetInputData(image);
  filter->Update();
  const std::vector<double> rates = GetRates(filter);
  check.Equal(static_cast<long long>(rates.size()), 4, "halves");
  for (const double rate : rates)
  {
    check.Near(std::abs(rate), 8.0, 1e-12, "rate of a half");
  }
  check.That(rates[0] < 0.0 && rates[1] < 0.0 && rates[2] > 0.0, "inflow first at equal rates");
  filter->SetMinimumNormalSpeed(0.5);
  filter->Update();
  check.Near(filter->GetReport()->GetNumber("InflowRate"), 12.0, 1e-12, "only the faster faces");
  filter->SetRegion(1);
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 4, "cells of one region");
  check.Equal(filter->GetOutput()->GetNumberOfPoints(), 10, "points of one region");
  filter->SetMinimumNormalSpeed(1.0);
  filter->SetRegion(vtkFlowBoundary::ALL);
  AllowWarnings(filter);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("InflowRegions"), 0, "no region");
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 6 * 16, "all faces are in the output");
}

/// The seam of a closed ring and faces next to hidden cells.
void TestSeamsAndHoles(Check& check)
{
  const auto ring = MakeRing({ { 3, 24, 2 } });
  AddVectors(ring, [](const Vector& x) -> Vector { return { { -x[1], x[0], 0.0 } }; });
  vtkNew<vtkFlowBoundary> filter;
  filter->SetInputData(ring);
  AllowWarnings(filter);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("InflowRegions"), 0, "no inflow at the seam");
  const int* size = ring->GetDimensions();
  check.Equal(filter->GetOutput()->GetNumberOfCells(),
    2 * (size[1] - 1) * (size[0] - 1 + size[2] - 1), "faces at the seam");

  auto image = MakeFlowImage(7, [](const Vector&) -> Vector { return { { 0.0, 0.0, 3.0 } }; });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(image->GetNumberOfCells());
  ghosts->FillValue(0);
  // A cell in the middle.
  ghosts->SetValue(2 + 6 * (2 + 6 * 2), vtkDataSetAttributes::HIDDENCELL);
  image->GetCellData()->AddArray(ghosts);
  filter->SetInputData(image);
  filter->Update();
  const double face = 4.0 / 6.0 * 4.0 / 6.0;
  check.Near(filter->GetReport()->GetNumber("InflowRate"), 3.0 * (16.0 + face), 1e-12, "hole");
  check.Equal(filter->GetReport()->GetCount("InflowRegions"), 2, "the hole has its own region");
  check.Near(GetRates(filter)[2], -3.0 * face, 1e-12, "inflow from the hole");
}

/// The inflow region as a termination surface results in the same field as a plane.
void TestTermination(Check& check)
{
  auto image = MakeFlowImage(6,
    [](const Vector& x) -> Vector {
      return { { 1.0, 0.1 * x[2], 0.0 } };
    });
  vtkNew<vtkFlowBoundary> boundary;
  boundary->SetInputData(image);
  boundary->SetRegion(0);
  boundary->Update();
  check.Near(GetRates(boundary)[0], -16.0, 1e-12, "the largest region");
  vtkNew<vtkTerminationMesh> mesh;
  mesh->SetMesh(boundary->GetOutput());
  vtkSmartPointer<vtkDataSet> results[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkImplicitFlowField> field;
    field->SetInputData(image);
    field->AddTerminationSurface(
      i == 0 ? static_cast<vtkTerminationSurface*>(mesh) : MakeFlowPlane(0.0).Get());
    check.That(UpdateAndGetErrors(field).empty(), "no messages");
    results[i] = vtkDataSet::SafeDownCast(field->GetOutputDataObject(0));
  }
  int reached = 0;
  for (vtkIdType p = 0; p < results[0]->GetNumberOfPoints(); ++p)
  {
    for (const char* name : { "FlowStatus", "AdvectionTime", "TerminationUV" })
    {
      for (int c = 0; c < (std::string(name) == "TerminationUV" ? 2 : 1); ++c)
      {
        check.Near(results[0]->GetPointData()->GetArray(name)->GetComponent(p, c),
          results[1]->GetPointData()->GetArray(name)->GetComponent(p, c), 1e-9, name, 1.0);
      }
    }
    reached += results[0]->GetPointData()->GetArray("FlowStatus")->GetComponent(p, 0) == 0.0;
  }
  check.That(reached > 150, "many samples reach the region");
}

/// Integers, unnamed and cell vectors, mirrored grids, extreme lengths and speeds.
void TestOdd(Check& check)
{
  for (const double length : { 1e-150, 1.0, 1e150 })
  {
    for (const double speed : { 1e-150, 1e150 })
    {
      auto image = MakeFlowImage(4,
        [speed](const Vector&) -> Vector {
          return { { speed, 0, 0 } };
        });
      image->SetSpacing(length, 2.0 * length, length);
      image->SetOrigin(-length, 7.0 * length, 0.0);
      vtkNew<vtkFlowBoundary> filter;
      filter->SetInputData(image);
      check.That(UpdateAndGetErrors(filter).empty(), "no messages");
      check.Equal(filter->GetReport()->GetCount("InflowRegions"), 1, "regions at extreme scales");
    }
  }
  for (const int type : { VTK_SHORT, VTK_UNSIGNED_CHAR, VTK_DOUBLE })
  {
    auto image = MakeFlowImage(5, [](const Vector&) -> Vector { return { { 3.0, 0.0, 0.0 } }; });
    AddVectors(
      image,
      [](const Vector&) -> Vector {
        return { { 3.0, 0.0, 0.0 } };
      },
      type)
      ->SetName(nullptr);
    vtkNew<vtkDoubleArray> cells;
    cells->SetNumberOfComponents(3);
    cells->SetNumberOfTuples(image->GetNumberOfCells());
    cells->SetName("cells");
    for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
    {
      cells->SetTuple3(cell, 0.0, 0.0, -2.0);
    }
    image->GetCellData()->AddArray(cells);
    image->SetSpacing(-1.0, 1.0, 1.0);
    vtkNew<vtkFlowBoundary> filter;
    filter->SetInputData(image);
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    check.Near(filter->GetReport()->GetNumber("InflowRate"), 48.0, 1e-12, "unnamed vectors");
    for (vtkIdType cell = 0; cell < filter->GetOutput()->GetNumberOfCells(); ++cell)
    {
      double b[6];
      filter->GetOutput()->GetCellBounds(cell, b);
      const double expected = b[0] == b[1] ? (b[0] < -2.0 ? -3.0 : 3.0) : 0.0;
      check.Near(GetCellValue(filter->GetOutput(), "FlowRate", cell), expected, 1e-12,
        "negative spacing", 1.0);
    }
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "cells");
    filter->Update();
    check.Near(filter->GetReport()->GetNumber("OutflowRate"), 32.0, 1e-12, "cell vectors");
    check.That(filter->GetReport()->GetText("ConvertedCellArrays") == "cells", "converted array");
  }
}

/// Cells without volume, at the boundary and inside, and collapsed faces.
void TestDegenerate(Check& check)
{
  for (const std::vector<double>& positions : std::vector<std::vector<double>>{
         { 0.0, 1.0, 1.0 }, { 0.0, 1.0, 1.0, 2.0 }, { 0.0, 0.0, 2.0 } })
  {
    vtkNew<vtkRectilinearGrid> grid;
    vtkNew<vtkDoubleArray> x;
    for (const double position : positions)
    {
      x->InsertNextValue(position);
    }
    vtkNew<vtkDoubleArray> others;
    others->InsertNextValue(0.0);
    others->InsertNextValue(2.0);
    grid->SetDimensions(static_cast<int>(positions.size()), 2, 2);
    grid->SetXCoordinates(x);
    grid->SetYCoordinates(others);
    grid->SetZCoordinates(others);
    AddVectors(grid, [](const Vector&) -> Vector { return { { 1.0, 0.0, 0.0 } }; });
    vtkNew<vtkFlowBoundary> filter;
    filter->SetInputData(grid);
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    check.That(GetRates(filter) == std::vector<double>({ -4.0, 4.0 }), "rates with a flat cell");
  }
  // A hexahedron with an edge that is collapsed to a point, as at the pole of a sphere.
  vtkNew<vtkUnstructuredGrid> wedge;
  vtkNew<vtkPoints> points;
  for (const auto& position : { std::array<double, 3>{ { 0, 0, 0 } }, { { 1, 0, 0 } },
         { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 0, 1, 1 } } })
  {
    points->InsertNextPoint(position.data());
  }
  wedge->SetPoints(points);
  const vtkIdType corners[8] = { 0, 1, 2, 2, 3, 4, 5, 5 };
  wedge->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  AddVectors(wedge, [](const Vector&) -> Vector { return { { 0.0, 0.0, 3.0 } }; });
  vtkNew<vtkFlowBoundary> filter;
  filter->SetInputData(wedge);
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 5, "faces of a collapsed hexahedron");
  check.Near(GetRates(filter)[0], -1.5, 1e-12, "inflow of a collapsed hexahedron");
  for (vtkIdType cell = 0; cell < 5; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    filter->GetOutput()->GetCellPoints(cell, size, ids);
    check.Equal(static_cast<long long>(std::set<vtkIdType>(ids, ids + size).size()), size,
      "no repeated points");
  }
  // A hexahedron next to tetrahedra.
  const vtkIdType hexahedron = points->GetNumberOfPoints();
  for (int i = 0; i < 12; ++i)
  {
    points->InsertNextPoint(5.0 + i / 4, (i + 1) / 2 % 2, i / 2 % 2);
  }
  points->Modified();
  vtkNew<vtkUnstructuredGrid> mixed;
  mixed->SetPoints(points);
  const vtkIdType first[8] = { hexahedron, hexahedron + 1, hexahedron + 2, hexahedron + 3,
    hexahedron + 4, hexahedron + 5, hexahedron + 6, hexahedron + 7 };
  mixed->InsertNextCell(VTK_HEXAHEDRON, 8, first);
  const vtkIdType tetrahedron[4] = { hexahedron + 4, hexahedron + 5, hexahedron + 6,
    hexahedron + 8 };
  mixed->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  AddVectors(mixed, [](const Vector&) -> Vector { return { { 1.0, 0.0, 0.0 } }; });
  filter->SetInputData(mixed);
  check.Contains(WarningsOf(filter), "nonconforming at");
}

void TestPieces(Check& check)
{
  auto image = MakeFlowImage(6, GetLinearVector);
  vtkNew<vtkFlowBoundary> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkNew<vtkPolyData> entire;
  entire->DeepCopy(filter->GetOutput());
  filter->Modified();
  filter->UpdatePiece(1, 3, 1);
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "the second piece is empty");
  filter->UpdatePiece(0, 3, 0);
  check.Equal(
    filter->GetOutput()->GetNumberOfCells(), entire->GetNumberOfCells(), "the first piece is all");
}

void TestMessages(Check& check)
{
  auto image = MakeFlowImage(5, [](const Vector&) -> Vector { return { { 1.0, 0.0, 0.0 } }; });
  vtkNew<vtkFlowBoundary> filter;
  filter->SetInputData(image);
  filter->SetRegion(2);
  check.Contains(UpdateAndGetErrors(filter), "Region 2 does not exist: the boundary has 2 regions");
  check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "empty output after an error");
  filter->SetRegion(-5);
  check.Equal(filter->GetRegion(), vtkFlowBoundary::ALL, "clamped");
  for (const double odd : { NaN, 1e20, HUGE_VAL })
  {
    image->GetPointData()->GetVectors()->SetTuple3(0, odd, odd, odd);
    image->GetPointData()->GetVectors()->Modified();
    check.Contains(WarningsOf(filter), "3 faces count as faces without flow");
    check.Equal(filter->GetReport()->GetCount("SkippedFaces"), 3, "skipped faces");
    check.Near(filter->GetReport()->GetNumber("InflowRate"), 15.0, 1e-12, "inflow without one");
  }
  image->GetPointData()->SetActiveVectors(nullptr);
  check.Contains(UpdateAndGetErrors(filter), "active vectors");
  auto flat = MakeFlowImage(5, GetLinearVector);
  flat->SetDimensions(5, 25, 1);
  filter->SetInputData(flat);
  check.Contains(UpdateAndGetErrors(filter), "three-dimensional");
  vtkNew<vtkUnstructuredGrid> empty;
  filter->SetInputData(empty);
  check.That(UpdateAndGetErrors(filter).empty(), "an empty input is not an error");
}

}

int TestFlowBoundary(int, char*[])
{
  Check check;
  TestUniform(check);
  TestDivergence(check);
  TestHalves(check);
  TestSeamsAndHoles(check);
  TestTermination(check);
  TestOdd(check);
  TestDegenerate(check);
  TestPieces(check);
  TestMessages(check);
  return check.Result();
}
