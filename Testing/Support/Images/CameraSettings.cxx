// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/CameraSettings.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace reference
{

vtkSmartPointer<vtkCamera> LookAt(vtkUnstructuredGrid* grid, const Point3& direction, bool parallel)
{
  Point3 center;
  grid->GetCenter(center.data());
  return LookAt(center, 0.5 * grid->GetLength(), direction, parallel);
}

vtkSmartPointer<vtkCamera> LookAt(
  const Point3& center, double radius, const Point3& direction, bool parallel)
{
  constexpr double distance = 4.0; // from the center to the camera, in radii
  const double length = vtkMath::Norm(direction.data());
  auto camera = vtkSmartPointer<vtkCamera>::New();
  double eye[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    eye[axis] = center[axis] - distance * radius * direction[axis] / length;
  }
  camera->SetPosition(eye);
  camera->SetFocalPoint(center.data());
  const bool alongY = std::abs(direction[1]) > 0.9 * length;
  camera->SetViewUp(0.0, alongY ? 0.0 : 1.0, alongY ? 1.0 : 0.0);
  camera->SetParallelProjection(parallel ? 1 : 0);
  camera->SetParallelScale(0.85 * radius);
  camera->SetViewAngle(24.0);
  camera->SetClippingRange(0.5 * distance * radius, 2.0 * distance * radius);
  return camera;
}

vtkSmartPointer<vtkVolumeProperty> MakeProperty(
  const std::vector<FunctionNode>& nodes, double unitDistance)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const FunctionNode& node : nodes)
  {
    color->AddRGBPoint(node.X, node.Color[0], node.Color[1], node.Color[2]);
    opacity->AddPoint(node.X, node.Opacity);
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
  return property;
}

vtkSmartPointer<vtkVolumeProperty> MakeRamp(double low, double high, double unitDistance)
{
  return MakeProperty(
    { { 0.0, { { 0.1, 0.2, 0.9 } }, low }, { 1.0, { { 1.0, 0.8, 0.1 } }, high } }, unitDistance);
}

}
