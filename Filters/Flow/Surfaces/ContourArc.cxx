// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/ContourArc.h"

#include "Common/Vectors.h"

#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace interlume
{

namespace
{
using Parameters = LevelContours::Parameters;

// Points of a contour: their parameters, their world positions, and whether the surface has a point
// at these parameters.
struct Line
{
  std::vector<Parameters> Points;
  std::vector<glm::dvec3> Positions;
  std::vector<bool> AreThere;
};

// Location on a line: a segment, and the fraction along it.
struct Location
{
  std::size_t Segment = 0;
  double Along = 0.0;
};

Line Locate(std::vector<Parameters> points, const vtkTerminationSurface& surface, int part,
  const std::array<bool, 2>& isPeriodic)
{
  Line line;
  for (const Parameters& point : points)
  {
    Parameters inside = point;
    for (int direction = 0; direction < 2; ++direction)
    {
      inside[direction] -= isPeriodic[direction] ? std::floor(inside[direction]) : 0.0;
    }
    glm::dvec3 position(0.0);
    line.AreThere.push_back(surface.EvaluatePoint(part, inside.data(), glm::value_ptr(position)));
    line.Positions.push_back(position);
  }
  line.Points = std::move(points);
  return line;
}

// Rotates a closed line to begin at another of its points. The last point remains a copy of the
// first.
void Rotate(Line& line, std::size_t first)
{
  const std::size_t segments = line.Points.size() - 1;
  Line rotated;
  for (std::size_t i = 0; i <= segments; ++i)
  {
    const std::size_t from = (first + i) % segments;
    Parameters point = line.Points[from];
    for (int direction = 0; direction < 2 && first + i >= segments; ++direction)
    {
      point[direction] += line.Points.back()[direction] - line.Points.front()[direction];
    }
    rotated.Points.push_back(point);
    rotated.Positions.push_back(line.Positions[from]);
    rotated.AreThere.push_back(line.AreThere[from]);
  }
  line = std::move(rotated);
}

// Finds the location nearest to any of the positions. All points of the line must have positions.
Location FindNearest(const Line& line, const std::vector<glm::dvec3>& positions)
{
  Location nearest;
  double smallest = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& position : positions)
  {
    for (std::size_t s = 0; s + 1 < line.Positions.size(); ++s)
    {
      const glm::dvec3 step = line.Positions[s + 1] - line.Positions[s];
      const glm::dvec3 offset = position - line.Positions[s];
      const double length2 = glm::dot(step, step);
      double along = length2 > 0.0 ? glm::dot(offset, step) / length2 : 0.0;
      along = std::max(0.0, std::min(along, 1.0));
      const glm::dvec3 difference = offset - along * step;
      const double distance2 = glm::dot(difference, difference);
      if (distance2 < smallest)
      {
        smallest = distance2;
        nearest = { s, along };
      }
    }
  }
  return nearest;
}

// Rotates a closed line to begin at a location, inserting a point there.
void StartAt(Line& line, const Location& location)
{
  Rotate(line, location.Segment);
  Parameters point;
  for (int direction = 0; direction < 2; ++direction)
  {
    point[direction] = line.Points[0][direction] +
      location.Along * (line.Points[1][direction] - line.Points[0][direction]);
  }
  const glm::dvec3 position =
    line.Positions[0] + location.Along * (line.Positions[1] - line.Positions[0]);
  Parameters end = point;
  for (int direction = 0; direction < 2; ++direction)
  {
    end[direction] += line.Points.back()[direction] - line.Points.front()[direction];
  }
  line.Points.front() = point;
  line.Positions.front() = position;
  line.Points.push_back(end);
  line.Positions.push_back(position);
}

ContourArc MakeArc(Line line, bool isClosed)
{
  ContourArc arc;
  arc.IsClosed = isClosed;
  double length = 0.0;
  for (std::size_t i = 0; i < line.Points.size(); ++i)
  {
    length += i == 0 ? 0.0 : glm::distance(line.Positions[i - 1], line.Positions[i]);
    arc.Curve.Lengths.push_back(length);
  }
  arc.Curve.Points = std::move(line.Points);
  return arc;
}

// Creates an open arc from a line. The arc begins at the end of the line that is closer, along the
// line, to the location nearest to the start points.
ContourArc MakeOpenArc(Line line, const std::vector<glm::dvec3>& startPoints)
{
  if (!startPoints.empty())
  {
    const ContourArc arc = MakeArc(line, false);
    const Location location = FindNearest(line, startPoints);
    const std::vector<double>& lengths = arc.Curve.Lengths;
    const double at = lengths[location.Segment] +
      location.Along * (lengths[location.Segment + 1] - lengths[location.Segment]);
    if (at > 0.5 * arc.GetLength())
    {
      std::reverse(line.Points.begin(), line.Points.end());
      std::reverse(line.Positions.begin(), line.Positions.end());
    }
  }
  return MakeArc(std::move(line), false);
}
}

std::vector<ContourArc> ContourArc::Measure(LevelContours::Contour contour,
  const vtkTerminationSurface& surface, int part, const std::array<bool, 2>& isPeriodic,
  const std::vector<glm::dvec3>& startPoints)
{
  Line line = Locate(std::move(contour.Points), surface, part, isPeriodic);
  const auto gap = std::find(line.AreThere.begin(), line.AreThere.end(), false);
  if (contour.IsClosed && gap == line.AreThere.end())
  {
    if (!startPoints.empty())
    {
      StartAt(line, FindNearest(line, startPoints));
    }
    return { MakeArc(std::move(line), true) };
  }
  if (contour.IsClosed)
  {
    Rotate(line, (gap - line.AreThere.begin()) % (line.Points.size() - 1));
  }
  std::vector<ContourArc> arcs;
  Line run;
  for (std::size_t i = 0; i <= line.Points.size(); ++i)
  {
    if (i < line.Points.size() && line.AreThere[i])
    {
      run.Points.push_back(line.Points[i]);
      run.Positions.push_back(line.Positions[i]);
      continue;
    }
    if (run.Points.size() > 1)
    {
      arcs.push_back(MakeOpenArc(run, startPoints));
    }
    run = Line();
  }
  return arcs;
}

}
