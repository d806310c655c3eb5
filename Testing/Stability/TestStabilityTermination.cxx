// SPDX-License-Identifier: BSD-3-Clause
// Tests distances and meshes of termination surfaces of any size, close to the origin and far away,
// and settings that are out of range.
#include "StabilityChecks.h"
#include "StabilityShapes.h"

#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTerminationInflow.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationSurfaceSource.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;
using namespace stability;

/// Returns the total area of the triangles in units of \a size squared.
double MeasureTriangles(vtkPolyData* data, double size)
{
  double sum = data->GetNumberOfPolys() > 0 ? 0.0 : NaN;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    data->GetCellPoints(i, ids);
    double corners[3][3];
    for (int c = 0; c < 3; ++c)
    {
      data->GetPoint(ids->GetId(c), corners[c]);
      for (int axis = 0; axis < 3 && c > 0; ++axis)
      {
        corners[c][axis] = (corners[c][axis] - corners[0][axis]) / size;
      }
    }
    double cross[3];
    vtkMath::Cross(corners[1], corners[2], cross);
    sum += 0.5 * vtkMath::Norm(cross);
  }
  return sum;
}

void TestShapes(StabilityCatalogue& catalogue)
{
  for (const Shape& shape : MakeShapes())
  {
    for (const double size : { 1e-160, 1e-100, 1e-30, 1e-6, 1e6, 1e30, 1e100, 1e160 })
    {
      for (const double offset : { 0.0, 1e6 })
      {
        const auto surface = shape.Make(size, offset * size);
        catalogue.SetClass(surface->GetClassName());
        const std::string name = "size-" + FormatShort(size) + (offset > 0.0 ? "-far" : "");
        const std::string extreme = "a surface of size " + FormatShort(size) +
          (offset > 0.0 ? ", a million times its size from the origin" : "");
        const std::string error = surface->Update();
        vtkNew<vtkTerminationSurfaceSource> source;
        source->SetSurface(surface);
        source->SetResolutionU(48);
        source->SetResolutionV(48);
        source->Update();
        const double rounding = offset > 0.0 ? 1e-9 : 1e-12;
        catalogue.Measure(name + "-area", extreme, "relative error of the mesh area" + error,
          error.empty() ? MeasureTriangles(source->GetOutput(), size) / shape.Area - 1.0 : NaN,
          std::max(shape.AreaBound, rounding));
        const double x[3] = { (shape.Position[0] + offset) * size, shape.Position[1] * size,
          shape.Position[2] * size };
        catalogue.Measure(name + "-distance", extreme, "relative error of the distance of a point",
          std::abs(surface->EvaluateDistance(x)) / size / shape.Distance - 1.0, rounding);
      }
    }
  }
}

/// Tests a mesh of one polygon, which VTK triangulates.
void TestPolygons(StabilityCatalogue& catalogue)
{
  for (const double size : { 1e-160, 1e-100, 1e-30, 1e30, 1e100, 1e160 })
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> texture;
    texture->SetNumberOfComponents(2);
    const double corners[5][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0.4, 0.3 }, { 0, 1 } };
    for (const double* corner : corners)
    {
      points->InsertNextPoint(corner[0] * size, corner[1] * size, 0.0);
      texture->InsertNextTuple(corner);
    }
    vtkNew<vtkCellArray> polygon;
    polygon->InsertNextCell({ 0, 1, 2, 3, 4 });
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(polygon);
    data->GetPointData()->SetTCoords(texture);
    vtkNew<vtkTerminationMesh> mesh;
    mesh->SetMesh(data);
    catalogue.SetClass(mesh->GetClassName());
    const std::string error = mesh->Update();
    const double x[3] = { 0.7 * size, 0.2 * size, 2.0 * size };
    catalogue.Measure("polygon-" + FormatShort(size),
      "a concave polygon of size " + FormatShort(size),
      "relative error of the distance of a point" + error,
      std::abs(mesh->EvaluateDistance(x)) / size / 2.0 - 1.0, 1e-12);
  }
}

void TestResolutions(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkTerminationSurfaceSource");
  vtkNew<vtkTerminationSphere> sphere;
  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(sphere);
  for (const int resolution : { -1, 1, 1000 })
  {
    source->SetResolutionU(resolution);
    source->SetResolutionV(resolution);
    source->Update();
    const double n = std::max(1, resolution);
    catalogue.Measure("resolution-" + std::to_string(resolution),
      "a sphere on a grid of " + FormatShort(n) + " squares per axis",
      "difference from the number of nondegenerate triangles",
      static_cast<double>(source->GetOutput()->GetNumberOfCells()) - 2.0 * n * (n - 1.0), 0.0);
  }
}

/// Tests the inflow rectangle in uniform fields of various sizes and speeds.
void TestInflow(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkTerminationInflow");
  const auto initialize = [](double size, double speed, vtkTerminationInflow* surface)
  {
    auto image = MakeFlowImage({ { 9, 9, 9 } }, { { 0.0, size, 0.0, size, 0.0, size } });
    SetVelocity(image, [speed](const FlowVector&) { return FlowVector{ { speed, 0.0, 0.0 } }; });
    return surface->InitializeFromField(image, image->GetPointData()->GetVectors(), true);
  };
  for (const double size :
    { 1e-300, 1e-200, 1e-150, 1e-100, 1e-60, 1e-6, 1e6, 1e60, 1e100, 1e150, 1e200, 1e300 })
  {
    for (const double speed : { 1e-300, 1e-200, 1e-150, 1e-100, 1e-6, 1e6, 1e100, 1e150, 1e200 })
    {
      vtkNew<vtkTerminationInflow> surface;
      const std::string error = initialize(size, speed, surface);
      double bounds[6] = { NaN, NaN, NaN, NaN, NaN, NaN };
      if (error.empty())
      {
        surface->GetBounds(bounds);
      }
      // The rectangle is at the center of the first of 32 slabs and covers the cross section of the
      // field.
      catalogue.Measure("size-" + FormatShort(size) + "-speed-" + FormatShort(speed),
        "a box of " + FormatShort(size) + " with a speed of " + FormatShort(speed),
        "error of the rectangle's bounds, relative to the size" + error,
        std::abs(bounds[0] / size - 1.0 / 64.0) + std::abs(bounds[1] / size - 1.0 / 64.0) +
          std::abs(bounds[2] / size) + std::abs(bounds[3] / size - 1.0),
        1e-9);
    }
  }
  for (const double speed : { 0.0, NaN, Infinity })
  {
    vtkNew<vtkTerminationInflow> surface;
    const std::string error = initialize(1.0, speed, surface);
    catalogue.Check("speed-" + FormatShort(speed), "a speed of " + FormatShort(speed),
      "an error that reports no flow", error, error.find("flow") != std::string::npos);
  }
}

}

int TestStabilityTermination(int argc, char* argv[])
{
  return RunCases(
    __func__, "", argc, argv, { TestShapes, TestPolygons, TestResolutions, TestInflow });
}
