// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationTube.h"

#include "Common/FiniteNumbers.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Termination/DiskParameters.h"
#include "Termination/TubeAxis.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>

vtkStandardNewMacro(vtkTerminationTube);

vtkTerminationTube::vtkTerminationTube()
  : Axis(new interlume::TubeAxis)
{
}

vtkTerminationTube::~vtkTerminationTube() = default;

void vtkTerminationTube::AddPoint(double x, double y, double z)
{
  this->Points.push_back({ { x, y, z } });
  this->Modified();
}

void vtkTerminationTube::RemoveAllPoints()
{
  if (!this->Points.empty())
  {
    this->Points.clear();
    this->Modified();
  }
}

void vtkTerminationTube::GetPoint(int i, double x[3]) const
{
  if (i >= 0 && i < this->GetNumberOfPoints())
  {
    std::copy_n(this->Points[i].data(), 3, x);
  }
}

vtkCxxSetSmartPointerMacro(vtkTerminationTube, Line, vtkPolyData);

vtkPolyData* vtkTerminationTube::GetLine() const
{
  return this->Line;
}

vtkMTimeType vtkTerminationTube::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Line ? std::max(own, this->Line->GetMTime()) : own;
}

int vtkTerminationTube::GetNumberOfParts() const
{
  return this->Capped && !this->Axis->IsClosed() ? 3 : 1;
}

std::string vtkTerminationTube::Update()
{
  if (!interlume::FiniteNumbers::IsSize(this->Radius))
  {
    return "the tube's radius must be finite and greater than 0";
  }
  if (!this->Line)
  {
    std::vector<glm::dvec3> points;
    std::transform(this->Points.begin(), this->Points.end(), std::back_inserter(points),
      [](const auto& point) { return glm::make_vec3(point.data()); });
    return this->Axis->Build(points).GetMessage();
  }
  const vtkIdType lines = this->Line->GetNumberOfLines();
  if (lines != 1)
  {
    return "the tube's dataset has " + std::to_string(lines) + " lines, not one";
  }
  vtkIdType number;
  const vtkIdType* ids;
  vtkCellArray* cells = this->Line->GetLines();
  cells->GetCellAtId(0, number, ids);
  std::vector<glm::dvec3> points(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    if (ids[i] < 0 || ids[i] >= this->Line->GetNumberOfPoints())
    {
      return "the tube's line refers to point " + std::to_string(ids[i]) + ", which does not exist";
    }
    this->Line->GetPoint(ids[i], glm::value_ptr(points[i]));
  }
  return this->Axis->Build(points).GetMessage();
}

double vtkTerminationTube::EvaluateDistance(const double x[3]) const
{
  if (this->Axis->IsEmpty())
  {
    return VTK_DOUBLE_MAX;
  }
  const glm::dvec3 position = glm::make_vec3(x);
  return interlume::Vectors::SafeLength(position - this->Axis->GetFoot(position).Nearest) -
    this->Radius;
}

bool vtkTerminationTube::IsOn(const double x[3]) const
{
  return !this->Axis->IsEmpty() &&
    (this->Capped ||
      std::abs(this->Axis->GetFoot(glm::make_vec3(x)).DistancePastEnd) <=
        BorderTolerance * this->Axis->GetLength());
}

int vtkTerminationTube::EvaluatePart(const double x[3]) const
{
  const double beyond = this->Capped && !this->Axis->IsEmpty()
    ? this->Axis->GetFoot(glm::make_vec3(x)).DistancePastEnd
    : 0.0;
  return beyond < 0.0 ? CAP_1 : (beyond > 0.0 ? CAP_2 : TUBE);
}

void vtkTerminationTube::EvaluateParameters(const double x[3], double uv[2]) const
{
  std::fill_n(uv, 2, 0.0);
  const int part = this->EvaluatePart(x);
  if (part != TUBE)
  {
    const bool isLast = part == CAP_2;
    const glm::dvec3 p =
      this->Axis->GetEndFrame(isLast).GetComponents(glm::make_vec3(x), this->Axis->GetEnd(isLast));
    const double across = std::hypot(p[0], p[1]);
    const double angle = std::atan2(across, std::abs(p[2]));
    const double scale = across > 0.0 ? 2.0 * angle / (vtkMath::Pi() * across) : 0.0;
    interlume::DiskParameters::FromPoint(scale * p[0], scale * p[1], uv);
  }
  else if (!this->Axis->IsEmpty())
  {
    this->Axis->GetParameters(glm::make_vec3(x), uv);
  }
}

void vtkTerminationTube::EvaluateNormal(const double x[3], double normal[3]) const
{
  glm::dvec3 outward = interlume::AxialFrame().X;
  if (!this->Axis->IsEmpty())
  {
    const glm::dvec3 position = glm::make_vec3(x);
    const glm::dvec3 away = position - this->Axis->GetFoot(position).Nearest;
    const double length = interlume::Vectors::SafeLength(away);
    outward = length > 0.0 ? away / length : outward;
  }
  std::copy_n(glm::value_ptr(outward), 3, normal);
}

bool vtkTerminationTube::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  if (this->Axis->IsEmpty() || !this->NormalizeParameters(part, uv, taken))
  {
    return false;
  }
  if (part == TUBE)
  {
    std::copy_n(glm::value_ptr(this->Axis->GetPoint(taken, this->Radius)), 3, x);
    return true;
  }
  double a;
  double b;
  if (!interlume::DiskParameters::ToPoint(taken, a, b))
  {
    return false;
  }
  const bool isLast = part == CAP_2;
  const double angle = 0.5 * vtkMath::Pi() * std::hypot(a, b);
  const double scale = angle > 0.0 ? std::sin(angle) / std::hypot(a, b) : 0.0;
  const glm::dvec3 point = this->Axis->GetEnd(isLast) +
    this->Axis->GetEndFrame(isLast).GetVector(this->Radius * scale * a, this->Radius * scale * b,
      this->Radius * (isLast ? 1.0 : -1.0) * std::cos(angle));
  std::copy_n(glm::value_ptr(point), 3, x);
  return true;
}

bool vtkTerminationTube::IsPeriodic(int direction, int part) const
{
  return part == TUBE && (direction == 0 || this->Axis->IsClosed());
}

void vtkTerminationTube::GetBounds(double bounds[6]) const
{
  this->Axis->GetBounds(bounds);
  for (int i = 0; i < 6 && !this->Axis->IsEmpty(); ++i)
  {
    bounds[i] += i % 2 == 0 ? -this->Radius : this->Radius;
  }
}

void vtkTerminationTube::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Points", this->Points.size() }, { "Line", this->Line.GetPointer() },
      { "Radius", this->Radius }, { "Capped", this->Capped } });
}
