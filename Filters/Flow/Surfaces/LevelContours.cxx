// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/LevelContours.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace interlume
{

LevelContours::LevelContours(Function function, int resolution, std::array<bool, 2> isPeriodic)
  : Evaluate(std::move(function))
  , Resolution(resolution)
  , IsPeriodic(isPeriodic)
{
  this->Values.reserve(static_cast<std::size_t>(resolution + 1) * (resolution + 1));
  for (int j = 0; j <= resolution; ++j)
  {
    for (int i = 0; i <= resolution; ++i)
    {
      this->Values.push_back(
        this->Evaluate(static_cast<double>(i) / resolution, static_cast<double>(j) / resolution));
    }
  }
}

double LevelContours::GetValue(int i, int j) const
{
  // The nodes on both sides of a seam are the same.
  i = this->IsPeriodic[0] && i == this->Resolution ? 0 : i;
  j = this->IsPeriodic[1] && j == this->Resolution ? 0 : j;
  return this->Values[static_cast<std::size_t>(j) * (this->Resolution + 1) + i];
}

int LevelContours::GetIndex(Edge edge) const
{
  edge.I = this->IsPeriodic[0] && edge.I == this->Resolution ? 0 : edge.I;
  edge.J = this->IsPeriodic[1] && edge.J == this->Resolution ? 0 : edge.J;
  return 2 * (edge.J * (this->Resolution + 1) + edge.I) + edge.Direction;
}

LevelContours::Edge LevelContours::GetEdge(int index) const
{
  const int node = index / 2;
  return { node % (this->Resolution + 1), node / (this->Resolution + 1), index % 2 };
}

LevelContours::Parameters LevelContours::GetCrossing(Edge edge, double level) const
{
  const auto getPosition = [&](double along)
  {
    Parameters position{ { static_cast<double>(edge.I), static_cast<double>(edge.J) } };
    position[edge.Direction] += along;
    return Parameters{ { position[0] / this->Resolution, position[1] / this->Resolution } };
  };
  const auto getValue = [&](double along)
  {
    const Parameters position = getPosition(along);
    return this->Evaluate(position[0], position[1]) - level;
  };
  double lower = 0.0;
  double upper = 1.0;
  double atLower = this->GetValue(edge.I, edge.J) - level;
  double atUpper =
    this->GetValue(edge.I + (edge.Direction == 0), edge.J + (edge.Direction == 1)) - level;
  // Illinois variant of regula falsi: if a bound is retained twice in a row, the value there is
  // halved.
  constexpr int maximumNumberOfSteps = 60;
  constexpr double tolerance = 1e-13;
  double along = atLower / (atLower - atUpper);
  int retained = 0;
  for (int step = 0; step < maximumNumberOfSteps && upper - lower > tolerance; ++step)
  {
    const double value = getValue(along);
    if (value == 0.0 || !std::isfinite(value))
    {
      break;
    }
    if ((value > 0.0) == (atLower > 0.0))
    {
      atUpper *= retained == 1 ? 0.5 : 1.0;
      lower = along;
      atLower = value;
      retained = 1;
    }
    else
    {
      atLower *= retained == -1 ? 0.5 : 1.0;
      upper = along;
      atUpper = value;
      retained = -1;
    }
    const double before = along;
    along = (lower * atUpper - upper * atLower) / (atUpper - atLower);
    if (std::abs(along - before) < tolerance)
    {
      break;
    }
  }
  return getPosition(along);
}

void LevelContours::LinkSquareEdges(int i, int j, double level, std::vector<int>& next) const
{
  // Corners and the edges between them, counterclockwise.
  const double corners[4] = { this->GetValue(i, j), this->GetValue(i + 1, j),
    this->GetValue(i + 1, j + 1), this->GetValue(i, j + 1) };
  const Edge edges[4] = { { i, j, 0 }, { i + 1, j, 1 }, { i, j + 1, 0 }, { i, j, 1 } };
  if (!std::all_of(corners, corners + 4, [](double value) { return std::isfinite(value); }))
  {
    return;
  }
  bool isInside[4];
  std::transform(corners, corners + 4, isInside, [level](double value) { return value >= level; });
  // Inside corners have values at or above the level. Contours have the inside on their left.
  // Therefore they enter the square through edges from an inside corner to an outside corner, in
  // counterclockwise order.
  int starts[2];
  int number = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    if (isInside[corner] && !isInside[(corner + 1) % 4])
    {
      starts[number++] = corner;
    }
  }
  bool isCenterInside = true;
  if (number == 2)
  {
    isCenterInside =
      this->Evaluate((i + 0.5) / this->Resolution, (j + 0.5) / this->Resolution) >= level;
  }
  for (int s = 0; s < number; ++s)
  {
    // If the center is inside, contours separate the outside corners from each other; otherwise
    // they separate the inside corners.
    int end = starts[s];
    do
    {
      end = (end + (isCenterInside ? 1 : 3)) % 4;
    } while (isInside[end] || !isInside[(end + 1) % 4]);
    next[this->GetIndex(edges[starts[s]])] = this->GetIndex(edges[end]);
  }
}

std::vector<int> LevelContours::FindNext(double level) const
{
  std::vector<int> next(2 * this->Values.size(), -1);
  for (int j = 0; j < this->Resolution; ++j)
  {
    for (int i = 0; i < this->Resolution; ++i)
    {
      this->LinkSquareEdges(i, j, level, next);
    }
  }
  return next;
}

std::vector<LevelContours::Contour> LevelContours::Follow(double level) const
{
  std::vector<int> next = this->FindNext(level);
  std::vector<bool> hasPrevious(next.size(), false);
  for (const int edge : next)
  {
    if (edge >= 0)
    {
      hasPrevious[edge] = true;
    }
  }
  std::vector<Contour> contours;
  for (const bool isOpen : { true, false })
  {
    for (int start = 0; start < static_cast<int>(next.size()); ++start)
    {
      if (next[start] < 0 || (isOpen && hasPrevious[start]))
      {
        continue;
      }
      Contour contour;
      contour.IsClosed = !isOpen;
      for (int edge = start; edge >= 0;)
      {
        Parameters position = this->GetCrossing(this->GetEdge(edge), level);
        for (int direction = 0; direction < 2 && !contour.Points.empty(); ++direction)
        {
          const double step = position[direction] - contour.Points.back()[direction];
          position[direction] -= this->IsPeriodic[direction] ? std::round(step) : 0.0;
        }
        contour.Points.push_back(position);
        const bool isEnd = edge == start && contour.Points.size() > 1;
        edge = isEnd ? -1 : std::exchange(next[edge], -1);
      }
      contours.push_back(std::move(contour));
    }
  }
  return contours;
}

}
