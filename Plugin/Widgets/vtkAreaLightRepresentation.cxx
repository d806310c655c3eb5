// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLightRepresentation.h"

#include "vtkAreaLight.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkBox.h"
#include "vtkCellArray.h"
#include "vtkInteractorObserver.h"
#include "vtkLineSource.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkAreaLightRepresentation);

namespace
{
constexpr double LightColor[3] = { 1.0, 0.85, 0.3 };
constexpr double ActiveColor[3] = { 1.0, 0.1, 0.1 };
constexpr double LineWidth = 2.0;
// Radius of a handle, and its distance from the edge of the emitter, in units of HandleSize.
constexpr double HandleRadius = 1.0;
constexpr double HandleDistance = 3.0;
// Maximum distance from the cursor to the center of a handle at which it is selected, in pixels.
constexpr double PickRadius = 12.0;
constexpr int EllipseSides = 64;

void SetAppearance(vtkActor* actor, const double color[3])
{
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLighting(false);
  actor->GetProperty()->SetLineWidth(LineWidth);
}
}

vtkAreaLightRepresentation::vtkAreaLightRepresentation()
{
  const int states[] = { MovingLight, MovingFocalPoint, ScalingWidth, ScalingHeight };
  for (std::size_t i = 0; i < this->Handles.size(); ++i)
  {
    Handle& handle = this->Handles[i];
    handle.State = states[i];
    handle.Sphere->SetThetaResolution(16);
    handle.Sphere->SetPhiResolution(16);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(handle.Sphere->GetOutputPort());
    handle.Actor->SetMapper(mapper);
    SetAppearance(handle.Actor, LightColor);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Outline);
  this->OutlineActor->SetMapper(mapper);
  SetAppearance(this->OutlineActor, LightColor);
  SetAppearance(this->LineActor, LightColor);
}

vtkAreaLightRepresentation::~vtkAreaLightRepresentation() = default;

void vtkAreaLightRepresentation::SetShape(int shape)
{
  this->Light->SetShape(shape);
  this->Modified();
}

int vtkAreaLightRepresentation::GetShape()
{
  return this->Light->GetShape();
}

void vtkAreaLightRepresentation::SetWidth(double width)
{
  this->Light->SetSize(width, this->GetHeight());
  this->Modified();
}

double vtkAreaLightRepresentation::GetWidth()
{
  return this->Light->GetSize()[0];
}

void vtkAreaLightRepresentation::SetHeight(double height)
{
  this->Light->SetSize(this->GetWidth(), height);
  this->Modified();
}

double vtkAreaLightRepresentation::GetHeight()
{
  return this->Light->GetSize()[1];
}

void vtkAreaLightRepresentation::SetViewUp(double x, double y, double z)
{
  this->Light->SetViewUp(x, y, z);
  this->Modified();
}

double* vtkAreaLightRepresentation::GetViewUp()
{
  return this->Light->GetViewUp();
}

void vtkAreaLightRepresentation::UpdateLight()
{
  this->Light->SetPosition(this->LightPosition);
  this->Light->SetFocalPoint(this->FocalPoint);
}

void vtkAreaLightRepresentation::GetHandlePosition(int handle, double position[3])
{
  std::copy_n(handle == MovingFocalPoint ? this->FocalPoint : this->LightPosition, 3, position);
  this->UpdateLight();
  vtkNew<vtkMatrix4x4> frame;
  const bool isAtEdge = handle == ScalingWidth || handle == ScalingHeight;
  if (!isAtEdge || !this->Light->GetEmitterMatrix(frame))
  {
    return;
  }
  const int axis = handle == ScalingWidth ? 0 : 1;
  const double radius = this->Renderer ? this->SizeHandlesInPixels(HandleDistance, position) : 0.0;
  for (int i = 0; i < 3; ++i)
  {
    position[i] += (0.5 * this->Light->GetSize()[axis] + radius) * frame->GetElement(i, axis);
  }
}

void vtkAreaLightRepresentation::BuildOutline()
{
  this->UpdateLight();
  this->Outline->Initialize();
  vtkNew<vtkMatrix4x4> frame;
  if (!this->Light->GetEmitterMatrix(frame))
  {
    return;
  }
  // Build both shapes as regular polygons, scaled by width and height. The rectangle is a scaled
  // square.
  const bool isRound = this->GetShape() == vtkAreaLight::ROUND;
  const int sides = isRound ? EllipseSides : 4;
  const double radius = isRound ? 0.5 : std::sqrt(0.5);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(sides + 1);
  for (int side = 0; side < sides; ++side)
  {
    const double angle = 2.0 * vtkMath::Pi() * (side + 0.5) / sides;
    const double position[4] = { radius * this->GetWidth() * std::cos(angle),
      radius * this->GetHeight() * std::sin(angle), 0.0, 1.0 };
    double point[4];
    frame->MultiplyPoint(position, point);
    lines->InsertCellPoint(points->InsertNextPoint(point));
  }
  lines->InsertCellPoint(0);
  this->Outline->SetPoints(points);
  this->Outline->SetLines(lines);
}

void vtkAreaLightRepresentation::BuildRepresentation()
{
  this->Superclass::BuildRepresentation();
  this->BuildOutline();
  for (Handle& handle : this->Handles)
  {
    double position[3];
    this->GetHandlePosition(handle.State, position);
    handle.Sphere->SetCenter(position);
    handle.Sphere->SetRadius(
      this->Renderer ? this->SizeHandlesInPixels(HandleRadius, position) : 0.0);
    const double* color = handle.State == this->InteractionState ? ActiveColor : LightColor;
    handle.Actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  }
}

int vtkAreaLightRepresentation::ComputeInteractionState(int x, int y, int)
{
  this->InteractionState = Outside;
  if (!this->Renderer || !this->Renderer->IsInViewport(x, y))
  {
    return this->InteractionState;
  }
  double nearest = PickRadius * PickRadius;
  for (const Handle& handle : this->Handles)
  {
    double position[3];
    double display[3];
    this->GetHandlePosition(handle.State, position);
    vtkInteractorObserver::ComputeWorldToDisplay(
      this->Renderer, position[0], position[1], position[2], display);
    const double distance =
      (display[0] - x) * (display[0] - x) + (display[1] - y) * (display[1] - y);
    if (distance < nearest)
    {
      nearest = distance;
      this->InteractionState = handle.State;
    }
  }
  return this->InteractionState;
}

void vtkAreaLightRepresentation::GetDraggedPoint(const double eventPosition[2], double point[3])
{
  double display[3];
  double world[4];
  vtkInteractorObserver::ComputeWorldToDisplay(
    this->Renderer, this->StartHandle[0], this->StartHandle[1], this->StartHandle[2], display);
  vtkInteractorObserver::ComputeDisplayToWorld(
    this->Renderer, eventPosition[0], eventPosition[1], display[2], world);
  std::copy_n(world, 3, point);
}

void vtkAreaLightRepresentation::StartWidgetInteraction(double eventPosition[2])
{
  this->Superclass::StartWidgetInteraction(eventPosition);
  this->GetHandlePosition(this->InteractionState, this->StartHandle);
  this->GetDraggedPoint(eventPosition, this->StartPoint);
  std::copy_n(this->Light->GetSize(), 2, this->StartSize);
}

void vtkAreaLightRepresentation::WidgetInteraction(double eventPosition[2])
{
  double motion[3];
  this->GetDraggedPoint(eventPosition, motion);
  vtkMath::Subtract(motion, this->StartPoint, motion);
  double position[3];
  vtkMath::Add(this->StartHandle, motion, position);
  vtkNew<vtkMatrix4x4> frame;
  if (this->InteractionState == MovingLight)
  {
    this->SetLightPosition(position);
  }
  else if (this->InteractionState == MovingFocalPoint)
  {
    this->SetFocalPoint(position);
  }
  else if (this->Light->GetEmitterMatrix(frame))
  {
    const int axis = this->InteractionState == ScalingWidth ? 0 : 1;
    const double direction[3] = { frame->GetElement(0, axis), frame->GetElement(1, axis),
      frame->GetElement(2, axis) };
    const double size =
      std::max(0.0, this->StartSize[axis] + 2.0 * vtkMath::Dot(motion, direction));
    axis == 0 ? this->SetWidth(size) : this->SetHeight(size);
  }
}

double* vtkAreaLightRepresentation::GetBounds()
{
  this->BuildRepresentation();
  vtkBoundingBox box(this->OutlineActor->GetBounds());
  box.AddPoint(this->LightPosition);
  box.AddPoint(this->FocalPoint);
  double bounds[6];
  box.GetBounds(bounds);
  this->BoundingBox->SetBounds(bounds);
  return this->BoundingBox->GetBounds();
}

void vtkAreaLightRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->OutlineActor->ReleaseGraphicsResources(window);
  for (Handle& handle : this->Handles)
  {
    handle.Actor->ReleaseGraphicsResources(window);
  }
}

int vtkAreaLightRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->BuildRepresentation();
  int count = this->LineActor->RenderOpaqueGeometry(viewport);
  count += this->OutlineActor->RenderOpaqueGeometry(viewport);
  for (Handle& handle : this->Handles)
  {
    count += handle.Actor->RenderOpaqueGeometry(viewport);
  }
  return count;
}

int vtkAreaLightRepresentation::RenderTranslucentPolygonalGeometry(vtkViewport*)
{
  return 0;
}

void vtkAreaLightRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Light:\n";
  this->Light->PrintSelf(os, indent.GetNextIndent());
}
