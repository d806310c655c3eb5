// SPDX-License-Identifier: BSD-3-Clause
#include "Support/AnalyticFlows/ReferenceFlowResults.h"

#include "Support/Arrays/ReferenceVector.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace reference
{

namespace
{

using Vector = std::array<double, 3>;

double GetTurns(double x, double y)
{
  const double turns = std::atan2(y, x) / (2.0 * vtkMath::Pi());
  return turns < 0.0 ? turns + 1.0 : turns;
}

// Calls visit with the corners of each cell whose value in the cell array is \a value, or of every
// cell if \a array is null.
template <typename Visitor>
void ForEachSimplex(vtkUnstructuredGrid* grid, const char* array, int value, Visitor&& visit)
{
  vtkDataArray* values = array ? grid->GetCellData()->GetArray(array) : nullptr;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (array && static_cast<int>(values->GetComponent(cell, 0)) != value)
    {
      continue;
    }
    grid->GetCellPoints(cell, ids);
    Vector corners[4] = {};
    for (vtkIdType c = 0; c < ids->GetNumberOfIds(); ++c)
    {
      grid->GetPoint(ids->GetId(c), corners[c].data());
    }
    visit(corners);
  }
}

// Returns the normal of the first three corners, with the area of their triangle as its length.
Vector GetAreaVector(const Vector corners[4])
{
  return 0.5 * Cross(corners[1] - corners[0], corners[2] - corners[0]);
}

}

void AddFlow(
  vtkDataSet* data, const FlowResultFunction& function, const std::vector<FlowSurface>& surfaces)
{
  const vtkIdType number = data->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> statuses;
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkDoubleArray> parameters;
  vtkNew<vtkDoubleArray> times;
  parameters->SetNumberOfComponents(2);
  for (vtkIdType p = 0; p < number; ++p)
  {
    double x[3];
    data->GetPoint(p, x);
    const FlowResult result = function(x);
    const bool isReached = result.Status == vtkFlowStatus::REACHED_SURFACE;
    statuses->InsertNextValue(static_cast<unsigned char>(result.Status));
    ids->InsertNextValue(isReached ? result.Id : -1);
    parameters->InsertNextTuple2(isReached ? result.U : 0.0, isReached ? result.V : 0.0);
    times->InsertNextValue(result.Time);
  }
  statuses->SetName("FlowStatus");
  ids->SetName("TerminationId");
  parameters->SetName("TerminationUV");
  times->SetName("AdvectionTime");
  data->GetPointData()->AddArray(statuses);
  data->GetPointData()->AddArray(ids);
  data->GetPointData()->AddArray(parameters);
  data->GetPointData()->AddArray(times);
  vtkNew<vtkIntArray> used;
  used->SetName("TerminationSurfaces");
  used->SetNumberOfComponents(3);
  for (const FlowSurface& surface : surfaces)
  {
    used->InsertNextTypedTuple(surface.data());
  }
  data->GetFieldData()->AddArray(used);
}

vtkSmartPointer<vtkImageData> MakeFlowImage(
  const std::array<int, 3>& points, const std::array<double, 6>& bounds)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points[0], points[1], points[2]);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  image->SetSpacing((bounds[1] - bounds[0]) / (points[0] - 1),
    (bounds[3] - bounds[2]) / (points[1] - 1), (bounds[5] - bounds[4]) / (points[2] - 1));
  return image;
}

FlowResultFunction UniformFlow(double speed)
{
  return [speed](const double* x) -> FlowResult {
    return { x[0] < 0.0 ? 1 : 0, 0, x[1], x[2], x[0] < 0.0 ? 0.0 : x[0] / speed };
  };
}

FlowResultFunction CylinderFlow(double radius)
{
  return [radius](const double* x) -> FlowResult
  {
    const double distance = std::hypot(x[0], x[1]) - radius;
    return { distance < 0.0 ? 1 : 0, 0, GetTurns(x[0], x[1]), x[2],
      distance < 0.0 ? 0.0 : distance };
  };
}

FlowResultFunction SphereFlow(double radius)
{
  return [radius](const double* x) -> FlowResult
  {
    const double flat = std::hypot(x[0], x[1]);
    const double distance = std::hypot(flat, x[2]) - radius;
    return { distance < 0.0 ? 1 : 0, 0, GetTurns(x[0], x[1]),
      std::atan2(flat, x[2]) / vtkMath::Pi(), distance < 0.0 ? 0.0 : distance };
  };
}

FlowResultFunction SaddleFlow()
{
  return [](const double* x) -> FlowResult
  {
    if (x[1] == 0.0)
    {
      return { 2, -1, 0.0, 0.0, 1e9 };
    }
    const double height = std::abs(x[1]);
    return { 0, x[1] > 0.0 ? 0 : 1, x[0] * height, x[2], -std::log(height) };
  };
}

FlowResultFunction RotationFlow()
{
  return [](const double* x) -> FlowResult {
    return { 0, 0, std::hypot(x[0], x[1]), x[2], 2.0 * vtkMath::Pi() * GetTurns(x[0], x[1]) };
  };
}

double MeasureArea(vtkUnstructuredGrid* triangles, const char* array, int value)
{
  double sum = 0.0;
  ForEachSimplex(triangles, array, value,
    [&](const Vector* corners) { sum += GetNorm(GetAreaVector(corners)); });
  return sum;
}

double MeasureVolume(vtkUnstructuredGrid* tetrahedra, const char* array, int value)
{
  double sum = 0.0;
  ForEachSimplex(tetrahedra, array, value,
    [&](const Vector* corners)
    { sum += Dot(GetAreaVector(corners), corners[3] - corners[0]) / 3.0; });
  return sum;
}

double MeasureFlux(vtkUnstructuredGrid* triangles,
  const std::function<std::array<double, 3>(const double* x)>& field, const char* array, int value)
{
  double sum = 0.0;
  ForEachSimplex(triangles, array, value,
    [&](const Vector* corners)
    {
      const Vector area = GetAreaVector(corners);
      for (int edge = 0; edge < 3; ++edge)
      {
        const Vector midpoint = 0.5 * (corners[edge] + corners[(edge + 1) % 3]);
        sum += Dot(area, field(midpoint.data())) / 3.0;
      }
    });
  return sum;
}

}
