// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TubeAxis.h"

#include "Cells/MultilinearCell.h"
#include "Common/Vectors.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
// Two points coincide if their distance is at most this fraction of the line's size.
constexpr double CoincidenceTolerance = 1e-12;
// Minimum of 1 plus the cosine of the angle between the directions of consecutive segments. Below
// it, the line turns back on itself.
constexpr double ReversalTolerance = 1e-8;

// Rotates v, which is perpendicular to `from`, by the smallest rotation from `from` to `to`.
glm::dvec3 Rotate(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& v)
{
  const glm::dvec3 rotated = v - glm::dot(v, to) / (1.0 + glm::dot(from, to)) * (from + to);
  // Orthogonalize so that rounding errors do not accumulate along the line.
  const glm::dvec3 across = rotated - glm::dot(rotated, to) * to;
  return across / glm::length(across);
}
}

Error TubeAxis::Build(const std::vector<glm::dvec3>& points)
{
  this->Segments.clear();
  this->Tree.Build({});
  this->Closed = false;
  this->Length = 0.0;
  this->Twist = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!Vectors::IsFinite(points[i]))
    {
      return "point " + std::to_string(i) + " of the tube's line is not finite";
    }
    size = std::max(size, Vectors::SafeLength(points[i] - points[0]));
  }
  const auto areSame = [size](const glm::dvec3& a, const glm::dvec3& b)
  { return Vectors::SafeLength(a - b) <= CoincidenceTolerance * size; };
  std::vector<std::size_t> retained;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (retained.empty() || !areSame(points[i], points[retained.back()]))
    {
      retained.push_back(i);
    }
  }
  if (retained.size() < 2)
  {
    return "the tube's line has fewer than two distinct points";
  }
  this->Closed = retained.size() > 3 && areSame(points[retained.front()], points[retained.back()]);
  this->FirstPoint = points[retained.front()];
  this->LastPoint = points[retained.back()];
  this->Scale = MultilinearCell::GetScale(size);

  std::vector<Segment> segments(retained.size() - 1);
  std::vector<BoxTree::Box> boxes(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    Segment& segment = segments[i];
    segment = {};
    const glm::dvec3& end = points[retained[i + 1]];
    segment.Start = points[retained[i]];
    for (int axis = 0; axis < 3; ++axis)
    {
      boxes[i].Lower[axis] = this->Scale * std::min(segment.Start[axis], end[axis]);
      boxes[i].Upper[axis] = this->Scale * std::max(segment.Start[axis], end[axis]);
    }
    segment.Length = Vectors::SafeLength(end - segment.Start);
    segment.Frame.Axis = (end - segment.Start) / segment.Length;
    segment.Distance = this->Length;
    this->Length += segment.Length;
  }
  segments[0].Frame.SetAxis(segments[0].Frame.Axis);
  const std::size_t bends = segments.size() - (this->Closed ? 0 : 1);
  for (std::size_t i = 0; i < bends; ++i)
  {
    Segment& before = segments[i];
    Segment& after = segments[(i + 1) % segments.size()];
    const double cosine = glm::dot(before.Frame.Axis, after.Frame.Axis);
    if (!(1.0 + cosine > ReversalTolerance))
    {
      return "the tube's line turns back on itself at point " + std::to_string(retained[i + 1]);
    }
    before.EndTilt = after.Frame.Axis / (1.0 + cosine);
    after.StartTilt = before.Frame.Axis / (1.0 + cosine);
    const glm::dvec3 x = Rotate(before.Frame.Axis, after.Frame.Axis, before.Frame.X);
    if (i + 1 < segments.size())
    {
      after.Frame.SetAxis(after.Frame.Axis, x);
    }
    else
    {
      this->Twist =
        AxialFrame::GetAngleInTurns(glm::dot(x, after.Frame.X), glm::dot(x, after.Frame.Y));
      this->Twist -= std::round(this->Twist);
    }
  }
  this->Segments = std::move(segments);
  this->Tree.Build(boxes);
  return {};
}

int TubeAxis::FindNearest(const glm::dvec3& x, double& along) const
{
  int nearest = 0;
  along = 0.0;
  const glm::dvec3 scaled = this->Scale * x;
  this->Tree.VisitNear(glm::value_ptr(scaled), std::numeric_limits<double>::infinity(),
    [this, &x, &nearest, &along](int item, double& squaredLimit)
    {
      const Segment& segment = this->Segments[item];
      const glm::dvec3 p = x - segment.Start;
      const double position = glm::dot(p, segment.Frame.Axis);
      const double clamped = std::max(0.0, std::min(position, segment.Length));
      const glm::dvec3 difference = this->Scale * (p - clamped * segment.Frame.Axis);
      const double squaredDistance = glm::dot(difference, difference);
      if (squaredDistance < squaredLimit)
      {
        squaredLimit = squaredDistance;
        nearest = item;
        along = position;
      }
    });
  return nearest;
}

TubeAxis::Foot TubeAxis::GetFoot(const glm::dvec3& x) const
{
  double along;
  const int nearest = this->FindNearest(x, along);
  const Segment& segment = this->Segments[nearest];
  Foot foot;
  const double clamped = std::max(0.0, std::min(along, segment.Length));
  foot.Nearest = segment.Start + clamped * segment.Frame.Axis;
  const bool isFirst = !this->Closed && nearest == 0;
  const bool isLast = !this->Closed && nearest + 1 == static_cast<int>(this->Segments.size());
  foot.DistancePastEnd = 0.0;
  if ((isFirst && along < 0.0) || (isLast && along > segment.Length))
  {
    foot.DistancePastEnd = along - clamped;
  }
  return foot;
}

void TubeAxis::GetPlanes(
  const Segment& segment, const glm::dvec3& x, glm::dvec3& components, double& start, double& end)
{
  components = segment.Frame.GetComponents(x, segment.Start);
  const glm::dvec3 across = segment.Frame.GetVector(components.x, components.y, 0.0);
  start = components.z + glm::dot(across, segment.StartTilt);
  end = segment.Length - components.z - glm::dot(across, segment.EndTilt);
}

int TubeAxis::GetNeighbor(int segment, int step) const
{
  const int number = static_cast<int>(this->Segments.size());
  const int neighbor = segment + step;
  if (this->Closed)
  {
    return (neighbor + number) % number;
  }
  return neighbor < 0 || neighbor >= number ? segment : neighbor;
}

void TubeAxis::GetParameters(const glm::dvec3& x, double uv[2]) const
{
  double along;
  int index = this->FindNearest(x, along);
  glm::dvec3 components;
  double start;
  double end;
  GetPlanes(this->Segments[index], x, components, start, end);
  const int step = start < 0.0 ? -1 : (end < 0.0 ? 1 : 0);
  const int neighbor = this->GetNeighbor(index, step);
  if (neighbor != index)
  {
    index = neighbor;
    GetPlanes(this->Segments[index], x, components, start, end);
  }
  const Segment& segment = this->Segments[index];
  const double distanceBetween = start + end;
  // Where the tube's radius exceeds the bend's radius, the bisecting planes intersect inside the
  // tube, and the distance between them can be 0 or negative.
  const double part =
    distanceBetween > 0.0 ? std::max(0.0, std::min(start / distanceBetween, 1.0)) : 0.5;
  uv[1] = std::min(1.0, (segment.Distance + part * segment.Length) / this->Length);
  uv[1] = this->Closed && uv[1] == 1.0 ? 0.0 : uv[1];
  const double turn = AxialFrame::GetAngleInTurns(components.x, components.y) + this->Twist * uv[1];
  uv[0] = turn - std::floor(turn);
  uv[0] = uv[0] < 1.0 ? uv[0] : 0.0;
}

glm::dvec3 TubeAxis::GetPoint(const double uv[2], double radius) const
{
  const double distance = uv[1] * this->Length;
  auto next = std::upper_bound(this->Segments.begin(), this->Segments.end(), distance,
    [](double value, const Segment& segment) { return value < segment.Distance; });
  const Segment& segment = *(next == this->Segments.begin() ? next : next - 1);
  const double part = std::min(1.0, (distance - segment.Distance) / segment.Length);
  const double angle = 2.0 * vtkMath::Pi() * (uv[0] - this->Twist * uv[1]);
  const glm::dvec3 across = segment.Frame.GetVector(std::cos(angle), std::sin(angle), 0.0);
  // At distance rho from the line, the position along the segment is part * Length + rho * slope.
  const double startTilt = glm::dot(across, segment.StartTilt);
  const double endTilt = glm::dot(across, segment.EndTilt);
  const double slope = part * (startTilt - endTilt) - startTilt;
  double rho = radius;
  double along = part * segment.Length + rho * slope;
  if (along < 0.0 || along > segment.Length)
  {
    // On the outside of a bend, the tube is part of a sphere around the line's vertex there.
    const double offset =
      this->Scale * (part * segment.Length - (along < 0.0 ? 0.0 : segment.Length));
    const double size = this->Scale * radius;
    const double square = 1.0 + slope * slope;
    const double root = std::sqrt(std::max(0.0, square * size * size - offset * offset));
    rho = (root - offset * slope) / square / this->Scale;
    along = part * segment.Length + rho * slope;
  }
  return segment.Start +
    segment.Frame.GetVector(rho * std::cos(angle), rho * std::sin(angle), along);
}

const AxialFrame& TubeAxis::GetEndFrame(bool isLast) const
{
  return isLast ? this->Segments.back().Frame : this->Segments.front().Frame;
}

void TubeAxis::GetBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  for (int i = 0; i < 3 && !this->Segments.empty(); ++i)
  {
    bounds[2 * i] = bounds[2 * i + 1] = this->LastPoint[i];
    for (const Segment& segment : this->Segments)
    {
      bounds[2 * i] = std::min(bounds[2 * i], segment.Start[i]);
      bounds[2 * i + 1] = std::max(bounds[2 * i + 1], segment.Start[i]);
    }
  }
}

}
