// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TubeAxis.h"

#include "Common/FiniteNumbers.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
// The share of the line's size within which points are in the same place.
constexpr double SamePlace = 1e-12;
// The least distance from -1 of the cosine between segments that go on; below it the line turns
// back.
constexpr double TurnBack = 1e-8;

// Rotates v, which is across `from`, by the smallest rotation that takes `from` to `to`.
void Rotate(const double from[3], const double to[3], const double v[3], double rotated[3])
{
  const double scale = vtkMath::Dot(v, to) / (1.0 + vtkMath::Dot(from, to));
  for (int i = 0; i < 3; ++i)
  {
    rotated[i] = v[i] - scale * (from[i] + to[i]);
  }
  // Taking out the part along `to` keeps rounding from growing from segment to segment.
  const double along = vtkMath::Dot(rotated, to);
  for (int i = 0; i < 3; ++i)
  {
    rotated[i] -= along * to[i];
  }
  vtkMath::Normalize(rotated);
}
}

std::string TubeAxis::Build(const std::vector<Point>& points)
{
  this->Segments.clear();
  this->Tree.Build({});
  this->Closed = false;
  this->Length = 0.0;
  this->Twist = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!FiniteNumbers::AreFinite(points[i].data(), 3))
    {
      return "point " + std::to_string(i) + " of the tube's line is not finite";
    }
    size = std::max(
      size, std::sqrt(vtkMath::Distance2BetweenPoints(points[i].data(), points[0].data())));
  }
  const auto areSame = [size](const Point& a, const Point& b)
  { return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data())) <= SamePlace * size; };
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (kept.empty() || !areSame(points[i], points[kept.back()]))
    {
      kept.push_back(i);
    }
  }
  if (kept.size() < 2)
  {
    return "the tube's line has fewer than two points in different places";
  }
  this->Closed = kept.size() > 3 && areSame(points[kept.front()], points[kept.back()]);
  std::copy_n(points[kept.front()].data(), 3, this->FirstPoint);
  std::copy_n(points[kept.back()].data(), 3, this->LastPoint);

  std::vector<Segment> segments(kept.size() - 1);
  std::vector<BoxTree::Box> boxes(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    Segment& segment = segments[i];
    segment = {};
    const Point& start = points[kept[i]];
    const Point& end = points[kept[i + 1]];
    for (int axis = 0; axis < 3; ++axis)
    {
      segment.Start[axis] = start[axis];
      segment.Frame.Axis[axis] = end[axis] - start[axis];
      boxes[i].Lower[axis] = std::min(start[axis], end[axis]);
      boxes[i].Upper[axis] = std::max(start[axis], end[axis]);
    }
    segment.Length = vtkMath::Normalize(segment.Frame.Axis);
    segment.Distance = this->Length;
    this->Length += segment.Length;
  }
  segments[0].Frame.SetAxis(segments[0].Frame.Axis);
  const std::size_t bends = segments.size() - (this->Closed ? 0 : 1);
  for (std::size_t i = 0; i < bends; ++i)
  {
    Segment& before = segments[i];
    Segment& after = segments[(i + 1) % segments.size()];
    const double cosine = vtkMath::Dot(before.Frame.Axis, after.Frame.Axis);
    if (!(1.0 + cosine > TurnBack))
    {
      return "the tube's line turns back on itself at point " + std::to_string(kept[i + 1]);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      before.EndTilt[axis] = after.Frame.Axis[axis] / (1.0 + cosine);
      after.StartTilt[axis] = before.Frame.Axis[axis] / (1.0 + cosine);
    }
    double x[3];
    Rotate(before.Frame.Axis, after.Frame.Axis, before.Frame.X, x);
    if (i + 1 < segments.size())
    {
      after.Frame.SetAxis(after.Frame.Axis, x);
    }
    else
    {
      this->Twist =
        AxialFrame::GetTurn(vtkMath::Dot(x, after.Frame.X), vtkMath::Dot(x, after.Frame.Y));
      this->Twist -= std::round(this->Twist);
    }
  }
  this->Segments = std::move(segments);
  this->Tree.Build(boxes);
  return {};
}

int TubeAxis::FindNearest(const double x[3], double& along) const
{
  int nearest = 0;
  along = 0.0;
  this->Tree.VisitNear(x, std::numeric_limits<double>::infinity(),
    [this, x, &nearest, &along](int item, double& squaredLimit)
    {
      const Segment& segment = this->Segments[item];
      double p[3];
      vtkMath::Subtract(x, segment.Start, p);
      const double place = vtkMath::Dot(p, segment.Frame.Axis);
      const double clamped = std::max(0.0, std::min(place, segment.Length));
      for (int i = 0; i < 3; ++i)
      {
        p[i] -= clamped * segment.Frame.Axis[i];
      }
      const double squaredDistance = vtkMath::Dot(p, p);
      if (squaredDistance < squaredLimit)
      {
        squaredLimit = squaredDistance;
        nearest = item;
        along = place;
      }
    });
  return nearest;
}

TubeAxis::Foot TubeAxis::GetFoot(const double x[3]) const
{
  double along;
  const int nearest = this->FindNearest(x, along);
  const Segment& segment = this->Segments[nearest];
  Foot foot;
  const double clamped = std::max(0.0, std::min(along, segment.Length));
  segment.Frame.GetPoint(segment.Start, 0.0, 0.0, clamped, foot.Nearest);
  const bool isFirst = !this->Closed && nearest == 0;
  const bool isLast = !this->Closed && nearest + 1 == static_cast<int>(this->Segments.size());
  foot.Beyond = 0.0;
  if ((isFirst && along < 0.0) || (isLast && along > segment.Length))
  {
    foot.Beyond = along - clamped;
  }
  return foot;
}

void TubeAxis::GetPlanes(
  const Segment& segment, const double x[3], double across[3], double& start, double& end)
{
  segment.Frame.GetComponents(x, segment.Start, across);
  const double along = across[2];
  across[2] = 0.0;
  double w[3];
  const double zero[3] = { 0.0, 0.0, 0.0 };
  segment.Frame.GetPoint(zero, across[0], across[1], 0.0, w);
  start = along + vtkMath::Dot(w, segment.StartTilt);
  end = segment.Length - along - vtkMath::Dot(w, segment.EndTilt);
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

void TubeAxis::GetParameters(const double x[3], double uv[2]) const
{
  double along;
  int index = this->FindNearest(x, along);
  double across[3];
  double start;
  double end;
  GetPlanes(this->Segments[index], x, across, start, end);
  const int step = start < 0.0 ? -1 : (end < 0.0 ? 1 : 0);
  const int neighbor = this->GetNeighbor(index, step);
  if (neighbor != index)
  {
    index = neighbor;
    GetPlanes(this->Segments[index], x, across, start, end);
  }
  const Segment& segment = this->Segments[index];
  const double way = start + end;
  // Where a tube is thicker than its bend, the planes cross and the way is not above 0.
  const double part = way > 0.0 ? std::max(0.0, std::min(start / way, 1.0)) : 0.5;
  uv[1] = std::min(1.0, (segment.Distance + part * segment.Length) / this->Length);
  uv[1] = this->Closed && uv[1] == 1.0 ? 0.0 : uv[1];
  const double turn = AxialFrame::GetTurn(across[0], across[1]) + this->Twist * uv[1];
  uv[0] = turn - std::floor(turn);
  uv[0] = uv[0] < 1.0 ? uv[0] : 0.0;
}

void TubeAxis::GetPoint(const double uv[2], double radius, double x[3]) const
{
  const double distance = uv[1] * this->Length;
  auto next = std::upper_bound(this->Segments.begin(), this->Segments.end(), distance,
    [](double value, const Segment& segment) { return value < segment.Distance; });
  const Segment& segment = *(next == this->Segments.begin() ? next : next - 1);
  const double part = std::min(1.0, (distance - segment.Distance) / segment.Length);
  const double angle = 2.0 * vtkMath::Pi() * (uv[0] - this->Twist * uv[1]);
  const double zero[3] = { 0.0, 0.0, 0.0 };
  double across[3];
  segment.Frame.GetPoint(zero, std::cos(angle), std::sin(angle), 0.0, across);
  // At a distance rho across, the place is part * Length + rho * slope along.
  const double startTilt = vtkMath::Dot(across, segment.StartTilt);
  const double endTilt = vtkMath::Dot(across, segment.EndTilt);
  const double slope = part * (startTilt - endTilt) - startTilt;
  double rho = radius;
  double along = part * segment.Length + rho * slope;
  if (along < 0.0 || along > segment.Length)
  {
    // Around the outside of a bend the tube is a part of the sphere around the line's point.
    const double offset = part * segment.Length - (along < 0.0 ? 0.0 : segment.Length);
    const double square = 1.0 + slope * slope;
    const double root = std::sqrt(std::max(0.0, square * radius * radius - offset * offset));
    rho = (root - offset * slope) / square;
    along = part * segment.Length + rho * slope;
  }
  segment.Frame.GetPoint(segment.Start, rho * std::cos(angle), rho * std::sin(angle), along, x);
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
