// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationTube.h"

#include "Common/FiniteNumbers.h"
#include "Common/NamedValue.h"
#include "Termination/DiscParameters.h"
#include "Termination/TubeAxis.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

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

void vtkTerminationTube::SetLine(vtkPolyData* line)
{
  if (this->Line != line)
  {
    this->Line = line;
    this->Modified();
  }
}

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
    return "the tube's radius is not finite and above 0";
  }
  if (!this->Line)
  {
    return this->Axis->Build(this->Points);
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
  std::vector<std::array<double, 3>> points(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    if (ids[i] < 0 || ids[i] >= this->Line->GetNumberOfPoints())
    {
      return "the tube's line has point " + std::to_string(ids[i]) + ", which is not there";
    }
    this->Line->GetPoint(ids[i], points[i].data());
  }
  return this->Axis->Build(points);
}

double vtkTerminationTube::EvaluateDistance(const double x[3]) const
{
  if (this->Axis->IsEmpty())
  {
    return VTK_DOUBLE_MAX;
  }
  const interlume::TubeAxis::Foot foot = this->Axis->GetFoot(x);
  return std::sqrt(vtkMath::Distance2BetweenPoints(x, foot.Nearest)) - this->Radius;
}

bool vtkTerminationTube::IsOn(const double x[3]) const
{
  return !this->Axis->IsEmpty() &&
    (this->Capped ||
      std::abs(this->Axis->GetFoot(x).Beyond) <= BorderTolerance * this->Axis->GetLength());
}

int vtkTerminationTube::EvaluatePart(const double x[3]) const
{
  const double beyond =
    this->Capped && !this->Axis->IsEmpty() ? this->Axis->GetFoot(x).Beyond : 0.0;
  return beyond < 0.0 ? CAP_1 : (beyond > 0.0 ? CAP_2 : TUBE);
}

void vtkTerminationTube::EvaluateParameters(const double x[3], double uv[2]) const
{
  std::fill_n(uv, 2, 0.0);
  const int part = this->EvaluatePart(x);
  if (part != TUBE)
  {
    const bool isLast = part == CAP_2;
    double p[3];
    this->Axis->GetEndFrame(isLast).GetComponents(x, this->Axis->GetEnd(isLast), p);
    const double across = std::hypot(p[0], p[1]);
    const double angle = std::atan2(across, std::abs(p[2]));
    const double scale = across > 0.0 ? 2.0 * angle / (vtkMath::Pi() * across) : 0.0;
    interlume::DiscParameters::FromPoint(scale * p[0], scale * p[1], uv);
  }
  else if (!this->Axis->IsEmpty())
  {
    this->Axis->GetParameters(x, uv);
  }
}

void vtkTerminationTube::EvaluateNormal(const double x[3], double normal[3]) const
{
  interlume::AxialFrame frame;
  std::copy_n(frame.X, 3, normal);
  if (this->Axis->IsEmpty())
  {
    return;
  }
  double outward[3];
  vtkMath::Subtract(x, this->Axis->GetFoot(x).Nearest, outward);
  if (vtkMath::Normalize(outward) > 0.0)
  {
    std::copy_n(outward, 3, normal);
  }
}

bool vtkTerminationTube::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  if (this->Axis->IsEmpty() || !this->TakeParameters(part, uv, taken))
  {
    return false;
  }
  if (part == TUBE)
  {
    this->Axis->GetPoint(taken, this->Radius, x);
    return true;
  }
  double a;
  double b;
  if (!interlume::DiscParameters::ToPoint(taken, a, b))
  {
    return false;
  }
  const bool isLast = part == CAP_2;
  const double angle = 0.5 * vtkMath::Pi() * std::hypot(a, b);
  const double scale = angle > 0.0 ? std::sin(angle) / std::hypot(a, b) : 0.0;
  this->Axis->GetEndFrame(isLast).GetPoint(this->Axis->GetEnd(isLast), this->Radius * scale * a,
    this->Radius * scale * b, this->Radius * (isLast ? 1.0 : -1.0) * std::cos(angle), x);
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
