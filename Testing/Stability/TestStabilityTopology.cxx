// SPDX-License-Identifier: BSD-3-Clause
// Tests critical points and vortex axes: extreme lengths and speeds, nearly singular Jacobians,
// zero or non-finite cells, and fields without critical points or axes.
#include "StabilityChecks.h"

#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Checks/LargestError.h"
#include "Support/Flow/ReferenceCriticalPoints.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFlowBoundary.h"
#include "vtkImageData.h"
#include "vtkInterlumeReport.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVortexAxis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using namespace reference;
using namespace stability;

vtkSmartPointer<vtkImageData> MakeCube(int cells, double size = 1.0, double midpoint = 0.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(midpoint - size, midpoint - size, midpoint - size);
  image->SetSpacing(2.0 * size / cells, 2.0 * size / cells, 2.0 * size / cells);
  return image;
}

/// Returns a point without a cell.
vtkSmartPointer<vtkUnstructuredGrid> MakeBarePoint()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  SetVelocity(grid, [](const FlowVector&) { return FlowVector{ { 1.0, 0.0, 0.0 } }; });
  return grid;
}

/// Returns the distance between the critical point and its exact position, or NaN if not exactly
/// one critical point is found.
double ErrorOfPoint(vtkDataSet* data, const FlowMatrix& matrix, const FlowVector& center)
{
  SetVelocity(data, LinearField(matrix, center));
  const CriticalPoints result(data);
  return result.GetNumber() == 1 ? Distance(result.GetPosition(0).data(), center.data()) : NaN;
}

void TestPointScales(StabilityCatalogue& catalogue)
{
  for (const double length : { 1e-200, 1e-150, 1e-100, 1e-12, 1.0, 1e12, 1e100, 1e150, 1e200 })
  {
    for (const double speed : { 1e-200, 1e-12, 1e12, 1e200 })
    {
      if (!std::isnormal(speed / length))
      {
        continue;
      }
      FlowMatrix matrix = GenericMatrix;
      for (double& entry : matrix)
      {
        entry *= speed / length;
      }
      const FlowVector center = { { 0.13 * length, -0.37 * length, 0.71 * length } };
      catalogue.Measure("length-" + FormatShort(length) + "-speed-" + FormatShort(speed),
        "a box of " + FormatShort(length) + " with speeds of " + FormatShort(speed),
        "distance of the critical point from the exact one, relative to the length",
        ErrorOfPoint(MakeCube(4, length), matrix, center) / length, 1e-11);
    }
  }
  const FlowVector far = { { 1e6 + 0.13, 1e6 - 0.37, 1e6 + 0.71 } };
  catalogue.Measure("far-1e+6", "a box of size 1 at a distance of 1.7e6",
    "distance of the critical point from the exact one",
    ErrorOfPoint(MakeCube(4, 1.0, 1e6), GenericMatrix, far), 1e-8);
  for (const double perturbation : { 1e-6, 1e-8, 1e-10 })
  {
    FlowMatrix flat = GenericMatrix;
    for (int j = 0; j < 3; ++j)
    {
      flat[6 + j] = flat[j] - 2.0 * flat[3 + j] + perturbation * flat[6 + j];
    }
    double largest = 0.0;
    for (const MeshKind kind : ZeroMeshKinds)
    {
      for (const FlowVector& position : ZeroPositions)
      {
        const double error = ErrorOfPoint(MakeMesh(kind, { 3, 4, 2 }), flat, position);
        reference::KeepLargest(largest, error);
      }
    }
    catalogue.Measure("singular-" + FormatShort(perturbation),
      "a singular Jacobian perturbed by " + FormatShort(perturbation) +
        ", 14 positions in 7 kinds of cells",
      "largest distance of the critical point from the exact one", largest, 1e-14 / perturbation);
  }
}

/// Tests the critical point in a box of 4 x 4 x 4 cells with several side lengths and aspect
/// ratios.
void TestCellLengths(StabilityCatalogue& catalogue)
{
  for (const double length : { 1e-250, 1e-200, 1e-100, 1e-12, 1.0, 1e12, 1e100, 1e200, 1e250 })
  {
    for (const double thin : { 1.0, 1e-40, 1e40 })
    {
      const FlowVector size = { { length, length, length * thin } };
      auto image = vtkSmartPointer<vtkImageData>::New();
      image->SetDimensions(5, 5, 5);
      image->SetOrigin(-size[0], -size[1], -size[2]);
      image->SetSpacing(0.5 * size[0], 0.5 * size[1], 0.5 * size[2]);
      const FlowFunction field = LinearField(GenericMatrix, { { 0.13, -0.37, 0.71 } });
      SetVelocity(image,
        [&](const FlowVector& x) {
          return field({ { x[0] / size[0], x[1] / size[1], x[2] / size[2] } });
        });
      const CriticalPoints result(image);
      const std::string name = "cell-" + FormatShort(length) + "-thick-" + FormatShort(thin);
      const std::string extreme =
        "cells of " + FormatShort(length) + ", " + FormatShort(thin) + " times as thick as wide";
      const bool isOne = result.GetNumber() == 1;
      catalogue.Measure(name, extreme,
        "distance of the critical point from the exact one, relative to the sides",
        isOne
          ? std::hypot(result.GetPosition(0)[0] / size[0] - 0.13,
              result.GetPosition(0)[1] / size[1] + 0.37, result.GetPosition(0)[2] / size[2] - 0.71)
          : NaN,
        1e-11);
      // CellLength is the cube root of the cell volume. The volume itself may overflow or
      // underflow.
      catalogue.Measure(name + "-length", extreme, "relative error of the cell's length",
        isOne ? result.GetArray("CellLength")->GetTuple1(0) / (0.5 * length * std::cbrt(thin)) - 1.0
              : NaN,
        1e-12);
    }
  }
}

void TestPointCells(StabilityCatalogue& catalogue)
{
  vtkNew<vtkFlowCriticalPoints> filter;
  auto still = MakeCube(4);
  SetVelocity(still, [](const FlowVector&) { return FlowVector{ { 0.0, 0.0, 0.0 } }; });
  filter->SetInputData(still);
  ReportEmpty(catalogue, filter, "zero-field", "vectors 0 everywhere", "0 throughout 64 cells");
  auto rotating = MakeCube(4);
  SetVelocity(rotating, [](const FlowVector& x) { return FlowVector{ { -x[1], x[0], 0.0 } }; });
  filter->SetInputData(rotating);
  ReportEmpty(catalogue, filter, "line-of-zeros", "a rotation, which is 0 along its axis",
    "0 along lines or surfaces in 16");
  auto broken = MakeCube(4);
  SetVelocity(broken, [](const FlowVector&) { return FlowVector{ { NaN, NaN, NaN } }; });
  filter->SetInputData(broken);
  ReportEmpty(catalogue, filter, "nan-field", "vectors NaN everywhere", "not finite in 64");
  // The vector at a point that eight cells share is NaN.
  auto corner = MakeCube(4);
  SetVelocity(corner, LinearField(GenericMatrix, { { 0.6, 0.6, 0.6 } }));
  corner->GetPointData()->GetVectors()->SetComponent(31, 1, NaN);
  const CriticalPoints result(corner);
  catalogue.Measure("nan-corner", "NaN at a point of eight cells next to the critical point",
    "errors of the numbers of critical points and of non-finite cells",
    std::abs(result.GetNumber() - 1.0) +
      std::abs(result.Filter->GetReport()->GetNumber("NonFiniteCells") - 8.0),
    0.0);
  filter->SetInputData(MakeBarePoint());
  ReportRejection(catalogue, filter, "no-cells", "a point without cells", "no cells",
    [&]() { filter->SetInputData(corner); });
}

/// Returns a vortex about the axis x = 0.31, y = 0.17. The axis is scaled by \a size, and the
/// velocity by \a speed.
FlowFunction MakeVortex(double size, double speed)
{
  return [=](const FlowVector& x)
  {
    const double d[2] = { x[0] / size - 0.31, x[1] / size - 0.17 };
    return FlowVector{ { -speed * d[1], speed * d[0], 0.5 * speed } };
  };
}

/// Returns the largest distance of an output point from the exact axis, relative to \a size, or NaN
/// if the number of output points is not \a points.
double ErrorOfAxis(vtkVortexAxis* filter, double size, vtkIdType points)
{
  const Messages messages = UpdateFilter(filter);
  vtkPolyData* output = filter->GetOutput();
  double largest = output->GetNumberOfPoints() == points && messages.Errors.empty() ? 0.0 : NaN;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const double distance = std::hypot(x[0] / size - 0.31, x[1] / size - 0.17);
    reference::KeepLargest(largest, distance);
  }
  return largest;
}

/// Tests that the axis has one point on each grid layer along it, even if layers are very close.
void TestLayers(StabilityCatalogue& catalogue)
{
  for (const double size : { 1e-250, 1e-200, 1e-100, 1.0, 1e100, 1e200, 1e250 })
  {
    const std::array<double, 6> layers = { { 0.0, 1e-9, 1e-6, 1e-3, 0.5, 1.0 } };
    vtkNew<vtkDoubleArray> across;
    for (const double position : { -1.0, 0.0, 1.0 })
    {
      across->InsertNextValue(size * position);
    }
    vtkNew<vtkDoubleArray> along;
    for (const double position : layers)
    {
      along->InsertNextValue(size * position);
    }
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetDimensions(3, 3, static_cast<int>(layers.size()));
    grid->SetXCoordinates(across);
    grid->SetYCoordinates(across);
    grid->SetZCoordinates(along);
    SetVelocity(grid, MakeVortex(size, 1.0));
    vtkNew<vtkVortexAxis> filter;
    filter->SetInputData(grid);
    const double error = ErrorOfAxis(filter, size, static_cast<vtkIdType>(layers.size()));
    double largest = error;
    for (std::size_t i = 0; std::isfinite(error) && i < layers.size(); ++i)
    {
      const double position = filter->GetOutput()->GetPoint(static_cast<vtkIdType>(i))[2] / size;
      // Relative to the layer's distance from the first layer, which is as small as 1e-9.
      reference::KeepLargest(largest, std::abs(position - layers[i]) / std::max(layers[i], 1e-9));
    }
    catalogue.Measure("layers-" + FormatShort(size),
      "layers from 1e-9 to 0.5 apart in a grid of " + FormatShort(size),
      "largest distance of 6 points from the axis and from their layers", largest, 1e-6);
  }
}

void TestAxes(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkVortexAxis");
  for (const double size : { 1e-200, 1e-150, 1e-100, 1e-12, 1.0, 1e12, 1e100, 1e150, 1e200 })
  {
    for (const double speed : { 1e-200, 1e-150, 1e-100, 1e-12, 1e12, 1e100, 1e150, 1e200 })
    {
      const bool isFar = std::abs(std::log10(speed)) > 151 && std::abs(std::log10(size)) > 13;
      if (!std::isnormal(speed / size) || isFar)
      {
        continue;
      }
      auto image = MakeCube(6, size);
      SetVelocity(image, MakeVortex(size, speed));
      vtkNew<vtkVortexAxis> filter;
      filter->SetInputData(image);
      const std::string name = "length-" + FormatShort(size) + "-speed-" + FormatShort(speed);
      const std::string extreme =
        "a box of " + FormatShort(size) + " with speeds of " + FormatShort(speed);
      catalogue.Measure(name, extreme, "largest distance of 7 points from the axis",
        ErrorOfAxis(filter, size, 7), 1e-12);
      vtkDataArray* swirl = filter->GetOutput()->GetPointData()->GetArray("SwirlStrength");
      catalogue.Measure(name + "-swirl", extreme, "relative error of the swirl",
        swirl && swirl->GetNumberOfTuples() > 0 ? swirl->GetComponent(0, 0) / (speed / size) - 1.0
                                                : NaN,
        1e-12);
    }
  }
  auto image = MakeCube(2);
  SetVelocity(image, MakeVortex(1.0, 1.0));
  vtkNew<vtkVortexAxis> filter;
  filter->SetInputData(image);
  filter->SetNumberOfPlanes(100000);
  catalogue.Measure("planes-100000", "100,000 planes through eight cells",
    "largest distance of 100,000 points from the axis", ErrorOfAxis(filter, 1.0, 100000), 1e-12);
  filter->SetNumberOfPlanes(0);
  filter->SetAxis(0.0, 0.0, -1e-300);
  catalogue.Measure("axis-1e-300", "an axis of length 1e-300",
    "largest distance of 3 points from the axis", ErrorOfAxis(filter, 1.0, 3), 1e-12);
  filter->SetAxis(0.0, 0.0, 1.0);
  filter->SetInputData(MakeBarePoint());
  ReportRejection(catalogue, filter, "no-cells", "a point without cells", "no cells",
    [&]() { filter->SetInputData(image); });
  filter->SetFrameVelocity(1e300, 0.0, 0.0);
  ReportEmpty(catalogue, filter, "frame-1e300", "a frame that moves at 1e300", "0 points");
  filter->SetFrameVelocity(0.0, 0.0, 0.0);
  filter->SetMinimumSwirlStrength(1e300);
  ReportEmpty(catalogue, filter, "swirl-1e300", "a minimum swirl strength of 1e300", "3 points");
  filter->SetMinimumSwirlStrength(0.0);
  SetVelocity(image, [](const FlowVector& x) { return FlowVector{ { x[0], x[1], 1.0 } }; });
  ReportEmpty(catalogue, filter, "no-vortex", "a field without rotation", "3 points");
}

void TestBoundaries(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkFlowBoundary");
  const auto getInflow = [](vtkFlowBoundary* filter)
  { return filter->GetReport()->GetNumber("InflowRate"); };
  vtkNew<vtkFlowBoundary> filter;
  for (const double size : { 1e-150, 1e-100, 1e-12, 1e12, 1e100, 1e150 })
  {
    for (const double speed : { 1e-150, 1e-100, 1e-12, 1e12, 1e100, 1e150 })
    {
      auto image = MakeCube(3, size);
      SetVelocity(image, [speed](const FlowVector&) { return FlowVector{ { speed, 0.0, 0.0 } }; });
      filter->SetInputData(image);
      filter->Update();
      const std::string name = "length-" + FormatShort(size) + "-speed-" + FormatShort(speed);
      const std::string extreme =
        "a box of " + FormatShort(size) + " with speeds of " + FormatShort(speed);
      const double expected = 4.0 * size * speed * size;
      catalogue.Measure(name + "-regions", extreme, "regions beyond one inflow and one outflow",
        filter->GetReport()->GetNumber("InflowRegions") +
          filter->GetReport()->GetNumber("OutflowRegions") - 2.0,
        0.0);
      if (std::isnormal(expected))
      {
        catalogue.Measure(
          name, extreme, "relative error of the inflow", getInflow(filter) / expected - 1.0, 1e-12);
      }
    }
  }
  auto image = MakeCube(3);
  SetVelocity(image, [](const FlowVector&) { return FlowVector{ { 0.0, 0.0, 0.0 } }; });
  filter->SetInputData(image);
  filter->SetRegion(0);
  ReportRejection(catalogue, filter, "no-flow", "a region of a field without flow", "has 0 regions",
    [&]() { filter->SetRegion(vtkFlowBoundary::ALL); });
  SetVelocity(image, [](const FlowVector& x) { return x; });
  filter->SetInputData(MakeBarePoint());
  ReportRejection(catalogue, filter, "no-cells", "a point without cells", "no cells",
    [&]() { filter->SetInputData(image); });
}

}

int TestStabilityTopology(int argc, char* argv[])
{
  return RunCases(__func__, "vtkFlowCriticalPoints", argc, argv,
    { TestPointScales, TestCellLengths, TestPointCells, TestAxes, TestBoundaries, TestLayers });
}
