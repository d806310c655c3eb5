// SPDX-License-Identifier: BSD-3-Clause
// No interpolation across discontinuities of an implicit flow field: across a separatrix, between
// samples with and without a result, and across seams where the mapping is discontinuous. At seams
// where the mapping is continuous, volumes are complete and parameters are unwrapped.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFlowVolume.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInflowMapping.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;

const double TwoPi = 2.0 * vtkMath::Pi();

void Connect(vtkInflowMapping* mapping, vtkFlowVolume* volume, vtkDataSet* data)
{
  mapping->SetInputData(data);
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->GenerateStreamSurfacesOn();
  volume->GenerateTimeSurfacesOn();
  volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
}

// If \a points is even, no sample lies on the separatrix. If it is odd, a row of samples lies on
// the separatrix and has no result.
void CheckSaddle(int points, Check& check)
{
  check.SetContext("saddle, " + std::to_string(points) + " points");
  auto image = MakeFlowImage({ { points, points, 4 } }, { { -1, 1, -1, 1, 0, 1 } });
  const double spacing = 2.0 / (points - 1);
  AddFlow(image, SaddleFlow(), { { { 0, 0, 0 } }, { { 1, 0, 0 } } });
  vtkNew<vtkInflowMapping> mapping;
  vtkNew<vtkFlowVolume> volume;
  Connect(mapping, volume, image);
  // The values of the two sides are far apart. Any value in between indicates interpolation across
  // the separatrix.
  mapping->SetFormula(0, "u");
  mapping->SetFormula(1, "5+u");
  volume->SetInterval(0, -0.25, 0.25);
  volume->SetInterval(1, 0.25, 4.75);
  volume->SetInterval(2, 4.75, 5.25);
  volume->SetStreamSurface(0, 2.5);
  volume->Update();
  vtkUnstructuredGrid* mesh = volume->GetOutput();
  vtkDataArray* inflow = mesh->GetPointData()->GetArray("Inflow");
  vtkDataArray* ids = mesh->GetPointData()->GetArray("TerminationId");
  const double gap = points % 2 == 0 ? 0.5 * spacing : spacing;
  double closest = 1.0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    const double expected = x[0] * std::abs(x[1]) + (x[1] > 0.0 ? 0.0 : 5.0);
    // The product x y is linear along grid edges.
    check.Near(inflow->GetComponent(p, 0), expected, 1e-12, "Inflow of a point", 1.0);
    check.Equal(static_cast<int>(ids->GetComponent(p, 0)), x[1] > 0.0 ? 0 : 1, "id of a point");
    check.That(std::abs(x[1]) >= gap - 1e-12, "no point between the two sides");
    closest = std::min(closest, std::abs(x[1]));
  }
  check.Near(closest, gap, 1e-12, "the distance to the separatrix is one cell");
  // Every cell lies inside the exact stream volume.
  for (const Tetrahedron& tetrahedron : TetrahedraOf(mesh, 0))
  {
    for (const vtkIdType p : tetrahedron)
    {
      double x[3];
      mesh->GetPoint(p, x);
      check.That(std::abs(x[0] * x[1]) <= 0.25 + 1e-12, "the point is in the stream volume");
    }
  }
  // Area of |x y| < 1/4 above the gap.
  const double half = 0.5 * (1.0 + std::log(4.0)) - 2.0 * gap;
  check.Near(MeasureVolume(mesh, "IntervalId", 0), half, 0.02, "one side");
  check.Near(MeasureVolume(mesh, "IntervalId", 2), half, 0.02, "the other side");
  check.Near(
    MeasureArea(volume->GetOutput(1), "StreamSurfaceId", 2), 0.0, 1e-9, "no stream surface", 1.0);
  const vtkIdType row = (points - 1) * 3;
  vtkInterlumeReport* report = volume->GetReport();
  check.Equal(report->GetCount("Cells"), row * (points - 1), "cells");
  check.Equal(
    report->GetCount("CellsBetweenSurfaces"), points % 2 == 0 ? row : 0, "cells between surfaces");
  check.Equal(
    report->GetCount("CellsWithoutResult"), points % 2 == 0 ? 0 : 2 * row, "cells without result");
  check.Equal(
    report->GetCount("CellsOnSeams") + report->GetCount("CellsAcrossSeams"), 0, "no seams");
}

// Returns the maximum range of an array component within a tetrahedron.
double GetLargestSpread(vtkUnstructuredGrid* mesh, const char* name, int component)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  vtkNew<vtkIdList> ids;
  double largest = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double lowest = VTK_DOUBLE_MAX;
    double highest = -VTK_DOUBLE_MAX;
    for (int c = 0; c < 4; ++c)
    {
      const double value = array->GetComponent(ids->GetId(c), component);
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    reference::KeepLargest(largest, highest - lowest);
  }
  return largest;
}

// Returns the maximum difference between u and the angle of a point, in full rotations.
double GetLargestAngleError(vtkUnstructuredGrid* mesh)
{
  vtkDataArray* parameters = mesh->GetPointData()->GetArray("TerminationUV");
  double largest = 0.0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    const double difference = parameters->GetComponent(p, 0) - std::atan2(x[1], x[0]) / TwoPi;
    reference::KeepLargest(largest, std::abs(difference - std::round(difference)));
  }
  return largest;
}

// Returns the number of image cells whose points all have a result, and how many of them the
// half-plane y = 0, x > 0 crosses.
std::array<vtkIdType, 2> CountCylinderCells(int points, double radius)
{
  const auto at = [&](int i) { return -1.0 + 2.0 * i / (points - 1); };
  std::array<vtkIdType, 2> counts{ { 0, 0 } };
  for (int j = 0; j + 1 < points; ++j)
  {
    for (int i = 0; i + 1 < points; ++i)
    {
      bool isReached = true;
      for (int corner = 0; corner < 4; ++corner)
      {
        isReached = isReached && std::hypot(at(i + corner % 2), at(j + corner / 2)) >= radius;
      }
      counts[0] += isReached;
      counts[1] += isReached && at(j) < 0.0 && at(j + 1) >= 0.0 && at(i) > 0.0;
    }
  }
  return counts;
}

void CheckCylinder(Check& check)
{
  constexpr int points = 30;
  constexpr int layers = 6;
  constexpr double radius = 0.3;
  const auto makeImage = [&](int isPeriodic)
  {
    auto image = MakeFlowImage({ { points, points, layers } }, { { -1, 1, -1, 1, 0, 1 } });
    AddFlow(image, CylinderFlow(radius), { { { 0, isPeriodic, 0 } } });
    return image;
  };
  const auto counts = CountCylinderCells(points, radius);
  vtkNew<vtkInflowMapping> mapping;
  vtkNew<vtkFlowVolume> volume;
  Connect(mapping, volume, makeImage(1));
  mapping->SetFormula(0, "v");
  volume->SetInterval(0, 0.23, 0.77);
  volume->SetTimeRange(0.1, 0.6);
  volume->SetTimeSurface(0, 0.3);
  volume->SetStreamSurface(0, 0.5);
  // The mapping does not depend on u, so the geometry must equal the geometry without a seam.
  vtkNew<vtkInflowMapping> plainMapping;
  vtkNew<vtkFlowVolume> plain;
  Connect(plainMapping, plain, makeImage(0));
  plainMapping->SetFormula(0, "v");
  plain->SetInterval(0, 0.23, 0.77);
  plain->SetStreamSurface(0, 0.5);
  for (bool isClipped : { true, false })
  {
    check.SetContext(std::string("cylinder, closed tube") + (isClipped ? "" : ", all times"));
    for (vtkFlowVolume* one : { volume.Get(), plain.Get() })
    {
      one->SetTimeRange(isClipped ? 0.1 : 0.0, isClipped ? 0.6 : VTK_DOUBLE_MAX);
      one->SetNumberOfTimeSurfaces(0);
      if (isClipped)
      {
        one->SetTimeSurface(0, 0.3);
      }
      one->Update();
    }
    const char* const arrays[3] = { "TimeIntervalId", "StreamSurfaceId", "TimeSurfaceId" };
    for (int port = 0; port < (isClipped ? 3 : 2); ++port)
    {
      const auto expected = GeometricSet(plain->GetOutput(port), { arrays[port] });
      check.That(!expected.empty(), "the output is not empty");
      check.That(GeometricSet(volume->GetOutput(port), { arrays[port] }) == expected,
        "port " + std::to_string(port) + " has no gap and no overlap");
    }
    check.That(GetLargestSpread(plain->GetOutput(), "TerminationUV", 0) > 0.5,
      "without the seam, parameters jump");
    check.That(
      GetLargestSpread(volume->GetOutput(), "TerminationUV", 0) < 0.3, "parameters are unwrapped");
    check.That(GetLargestAngleError(volume->GetOutput()) < 0.002, "u at every point");
    vtkInterlumeReport* report = volume->GetReport();
    check.Equal(
      report->GetCount("CellsAcrossSeams"), counts[1] * (layers - 1), "cells across the seam");
    check.Equal(report->GetCount("CellsOnSeams") + report->GetCount("CellsAroundPoles"), 0,
      "no other cells at seams");
    check.Equal(report->GetCount("Cells") - report->GetCount("CellsWithoutResult"),
      counts[0] * (layers - 1), "answers");
    if (!isClipped)
    {
      check.Near(volume->GetOutput()->GetNumberOfPoints(),
        plain->GetOutput()->GetNumberOfPoints() + report->GetNumber("PointsOnSeams"), 0.0,
        "points are added at seams");
    }
  }
  // Without a mapping, the seam has no effect on the geometry.
  check.SetContext("cylinder, time volume");
  vtkNew<vtkFlowVolume> times;
  times->SetInputData(makeImage(1));
  times->SetTimeRange(0.1, 0.6);
  times->Update();
  check.Near(MeasureVolume(times->GetOutput()), 0.5 * TwoPi * (0.81 - 0.16), 0.01, "volume");
  check.That(GetLargestSpread(times->GetOutput(), "TerminationUV", 0) < 0.3, "unwrapped");
  check.That(GetLargestAngleError(times->GetOutput()) < 0.002, "u at every point");

  // A wedge around the seam, whose sides lie inside the cells that cross the seam, and a wedge on
  // the opposite side.
  check.SetContext("cylinder, wedge");
  vtkNew<vtkInflowMapping> wave;
  vtkNew<vtkFlowVolume> wedge;
  Connect(wave, wedge, makeImage(1));
  wave->SetFormula(0, "sin(6.283185307179586*u)");
  wedge->SetInterval(0, -0.02, 0.02);
  wedge->Update();
  check.Near(
    MeasureVolume(wedge->GetOutput()), 2.0 * 0.02 * (1.0 - radius * radius), 0.1, "volume");
  check.That(GetLargestAngleError(wedge->GetOutput()) < 1e-4, "u at every point");
  const double* range = wedge->GetOutput()->GetPointData()->GetArray("TerminationUV")->GetRange(0);
  check.Near(range[0], 0.5 - 0.02 / TwoPi, 1e-4, "u of the opposite wedge");
  check.Near(range[1], 1.0 + 0.02 / TwoPi, 1e-4, "u after the seam");

  // With a discontinuous mapping, cells across the seam are omitted.
  check.SetContext("cylinder, discontinuous mapping");
  mapping->SetFormula(0, "u");
  volume->SetTimeRange(0.0, VTK_DOUBLE_MAX);
  volume->SetNumberOfTimeSurfaces(0);
  volume->SetInterval(0, 0.0, 0.5);
  volume->SetInterval(1, 0.5, 1.0);
  volume->Update();
  check.Equal(
    volume->GetReport()->GetCount("CellsOnSeams"), counts[1] * (layers - 1), "cells on the seam");
  check.Equal(volume->GetReport()->GetCount("CellsAcrossSeams"), 0, "no cells across the seam");
  vtkUnstructuredGrid* sheet = volume->GetOutput(1);
  for (const Triangle& triangle : TrianglesOf(sheet))
  {
    for (const vtkIdType p : triangle)
    {
      double x[3];
      sheet->GetPoint(p, x);
      check.That(x[0] < 0.0 && std::abs(x[1]) < 1e-12, "the only sheet is at half a rotation");
    }
  }
  const double area = MeasureArea(sheet, "StreamSurfaceId", 1);
  check.That(area > 0.6 && area <= 0.7 + 1e-12, "the area of one sheet, " + std::to_string(area));
  check.That(
    GetLargestSpread(volume->GetOutput(), "Inflow", 0) < 0.3, "no cell spans the discontinuity");
}

// Both u and v are periodic. Some cells lie across the seam of u, some across the seam of v, and
// some across both.
void CheckTorus(Check& check)
{
  check.SetContext("torus");
  auto image = MakeFlowImage({ { 4, 17, 15 } }, { { 0, 1, 0, 1.9, 0, 1.9 } });
  const auto flow = [](const double* x) -> FlowResult {
    return { 0, 0, x[1] - std::floor(x[1]), x[2] - std::floor(x[2]), x[0] };
  };
  AddFlow(image, flow, { { { 0, 1, 1 } } });
  for (bool byTime : { false, true })
  {
    vtkNew<vtkInflowMapping> mapping;
    vtkNew<vtkFlowVolume> volume;
    Connect(mapping, volume, image);
    mapping->SetFormula(0, "cos(6.283185307179586*u)+sin(6.283185307179586*v)");
    volume->SetInterval(0, -10.0, 10.0);
    if (byTime)
    {
      volume->SetTimeRange(0.3, 0.8);
    }
    volume->Update();
    vtkUnstructuredGrid* mesh = volume->GetOutput();
    check.Near(MeasureVolume(mesh), byTime ? 0.5 * 3.61 : 3.61, 1e-12, "full volume");
    vtkDataArray* parameters = mesh->GetPointData()->GetArray("TerminationUV");
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      double x[3];
      mesh->GetPoint(p, x);
      for (int direction = 0; direction < 2; ++direction)
      {
        const double difference = parameters->GetComponent(p, direction) - x[direction + 1];
        check.Near(difference, std::round(difference), 1e-12, "range of a parameter", 1.0);
        check.That(std::abs(parameters->GetComponent(p, direction) - 0.75) <= 0.75 + 1e-12,
          "parameters are between 0 and 3/2");
      }
    }
    check.That(GetLargestSpread(mesh, "TerminationUV", 0) < 0.2, "u is unwrapped");
    check.That(GetLargestSpread(mesh, "TerminationUV", 1) < 0.2, "v is unwrapped");
    // Each parameter crosses 1 in one layer of cells.
    check.Equal(
      volume->GetReport()->GetCount("CellsAcrossSeams"), 3 * (14 + 16 - 1), "cells across seams");
    check.That(volume->GetReport()->GetNumber("PointsOnSeams") > 0, "points are added");
  }
}

// A cell lies across a seam if its corners' parameters differ by more than half a period.
void CheckThreshold(Check& check)
{
  for (double step : { 0.45, 0.49, 0.51, 0.55 })
  {
    check.SetContext("parameters that differ by " + std::to_string(step));
    auto image = MakeFlowImage({ { 2, 2, 2 } }, { { 0, 1, 0, 1, 0, 1 } });
    AddFlow(image,
      [step](const double* x) -> FlowResult {
        return { 0, 0, 0.2, 0.3 + step * x[1], x[0] };
      },
      { { { 0, 1, 1 } } });
    vtkNew<vtkFlowVolume> volume;
    volume->SetInputData(image);
    volume->Update();
    check.Near(volume->GetReport()->GetNumber("CellsAcrossSeams"), step > 0.5, 0.0, "cells across");
    const double* range =
      volume->GetOutput()->GetPointData()->GetArray("TerminationUV")->GetRange(1);
    check.Near(range[0], step > 0.5 ? 0.3 + step : 0.3, 1e-12, "lowest");
    check.Near(range[1], step > 0.5 ? 1.3 : 0.3 + step, 1e-12, "highest");
  }
}

// Polyhedra on seams are omitted with any mapping. Other polyhedra are handled like other cells.
void CheckPolyhedra(Check& check)
{
  check.SetContext("polyhedra");
  auto mesh = MakeMesh(MeshKind::Boxes, { { 4, 4, 4 } });
  AddFlow(mesh,
    [](const double* x) -> FlowResult
    {
      const double u = 0.2 * x[1] + 0.5;
      return { 0, 0, u - std::floor(u), x[2], x[0] };
    },
    { { { 0, 1, 0 } } });
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputData(mesh);
  volume->SetTimeRange(0.5, 3.0);
  volume->Update();
  check.Equal(volume->GetReport()->GetCount("CellsOnSeams"), 16, "a layer of cells");
  check.Near(
    MeasureVolume(volume->GetOutput()), 2.5 * 3.0 * 4.0, 1e-12, "volume of the remaining cells");
  check.That(
    GetLargestSpread(volume->GetOutput(), "TerminationUV", 0) < 0.21, "no jump of parameters");
}

// Ghost cells of the input are skipped, and the output has no ghost array.
void CheckGhosts(Check& check)
{
  check.SetContext("ghosts");
  auto image = MakeFlowImage({ { 6, 6, 6 } }, { { -0.2, 0.8, 0, 1, 0, 1 } });
  AddFlow(image, UniformFlow(1.0), { { { 0, 0, 0 } } });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(125);
  ghosts->Fill(0);
  // One ghost cell lies in a layer that is omitted anyway, two lie elsewhere.
  ghosts->SetValue(0, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(1, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(124, vtkDataSetAttributes::HIDDENCELL);
  image->GetCellData()->AddArray(ghosts);
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext("ghosts, " + form.Name);
    AddFlow(form.Data, UniformFlow(1.0), { { { 0, 0, 0 } } });
    vtkNew<vtkFlowVolume> volume;
    volume->SetInputData(form.Data);
    volume->Update();
    check.Near(MeasureVolume(volume->GetOutput()), (100.0 - 2.0) / 125.0, 1e-6, "volume");
    check.Equal(
      volume->GetReport()->GetCount("CellsWithoutResult"), 24, "cells that are not ghosts");
    check.That(
      !volume->GetOutput()->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()),
      "no ghost array");
  }
  check.Equal(ghosts->GetValue(5), 0, "the ghost array of the input is unchanged");
}

}

int TestFlowVolumeSeams(int, char*[])
{
  Check check;
  CheckSaddle(40, check);
  CheckSaddle(41, check);
  CheckCylinder(check);
  CheckTorus(check);
  CheckThreshold(check);
  CheckPolyhedra(check);
  CheckGhosts(check);
  return check.Result();
}
