// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalColorTransferFunction.h"

#include "Common/Error.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTemporalColorTransferFunction);

namespace
{
/// The range [0,1] of u, which the class comment defines, is divided into this many equal parts.
/// The color is linear in u within each part.
constexpr int PARTS = 4;

/// A node, with the arguments of AddRGBPoint.
struct Node
{
  double Time;
  double Red;
  double Green;
  double Blue;
};

/// Returns the node at u = part / PARTS (C. Zhang, dissertation, Ohio State 2006, figure 3.26).
Node GetNode(double time, double part)
{
  const auto clamp = [](double value) { return std::min(std::max(value, 0.0), 1.0); };
  return { time, clamp(part - 2.0), clamp(std::min(part, PARTS - part)), clamp(2.0 - part) };
}

/// Returns the nodes. Nodes are at the time steps, where the slope of u over time changes, and at
/// the ends of the parts of u, where the slope of the color over u changes. Node positions are
/// integers, so equal positions compare equal: consecutive time steps are `parts` units apart, and
/// the ends of parts are `slabs` units apart.
std::vector<Node> GetNodes(const std::vector<double>& times)
{
  const int slabs = static_cast<int>(times.size()) - 1;
  // With two time steps, u is in the second half of its range.
  const int first = slabs == 1 ? 2 : 0;
  const int parts = PARTS - first;
  std::set<int> positions;
  for (int step = 0; step <= slabs; ++step)
  {
    positions.insert(parts * step);
  }
  for (int part = 0; part <= parts; ++part)
  {
    positions.insert(slabs * part);
  }
  std::vector<Node> nodes;
  for (const int position : positions)
  {
    const auto step = static_cast<std::size_t>(position / parts);
    const double fraction = static_cast<double>(position % parts) / parts;
    const double next = step < times.size() - 1 ? times[step + 1] : times[step];
    nodes.push_back(GetNode((1.0 - fraction) * times[step] + fraction * next,
      first + static_cast<double>(position) / slabs));
  }
  return nodes;
}

interlume::Error FindError(const std::vector<double>& times, const std::vector<Node>& nodes)
{
  for (const double time : times)
  {
    if (!std::isfinite(time))
    {
      return "a time is not finite";
    }
  }
  const auto found = std::adjacent_find(
    nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return !(a.Time < b.Time); });
  if (found != nodes.end())
  {
    return "the time after " + std::to_string(found->Time) + " is not greater";
  }
  return {};
}
}

void vtkTemporalColorTransferFunction::SetTimes(int n, const double* times)
{
  if (n < 2 || !times)
  {
    vtkErrorMacro("SetTimes requires at least two times, but got " << (times ? n : 0) << ".");
    return;
  }
  const std::vector<double> steps(times, times + n);
  const std::vector<Node> nodes = GetNodes(steps);
  if (const interlume::Error error = FindError(steps, nodes))
  {
    vtkErrorMacro("SetTimes requires finite, increasing times, but " << error << ".");
    return;
  }
  this->RemoveAllPoints();
  for (const Node& node : nodes)
  {
    this->AddRGBPoint(node.Time, node.Red, node.Green, node.Blue);
  }
}

void vtkTemporalColorTransferFunction::SetTimes(double t1, double t2)
{
  const std::array<double, 2> times = { { t1, t2 } };
  this->SetTimes(static_cast<int>(times.size()), times.data());
}
