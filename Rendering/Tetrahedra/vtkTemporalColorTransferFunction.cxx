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
/// The number of equal parts within which the map over u in [0,1] is straight.
constexpr int PARTS = 4;

/// Nodes as the superclass takes them.
struct Node
{
  double Time;
  double Red;
  double Green;
  double Blue;
};

/// Returns the node of C. Zhang, dissertation, Ohio State 2006, figure 3.26, at u = part / PARTS.
Node GetNode(double time, double part)
{
  const auto clamp = [](double value) { return std::min(std::max(value, 0.0), 1.0); };
  return { time, clamp(part - 2.0), clamp(std::min(part, PARTS - part)), clamp(2.0 - part) };
}

/// Returns the nodes. They are at the steps, where u has a kink in time, and at the parts' ends,
/// where colour has one in u. Places are counted from the first step, as many to a slab as there
/// are parts.
std::vector<Node> GetNodes(const std::vector<double>& times)
{
  const int slabs = static_cast<int>(times.size()) - 1;
  // Two steps have the map from the middle to the end of that of more.
  const int first = slabs == 1 ? 2 : 0;
  const int parts = PARTS - first;
  std::set<int> places;
  for (int step = 0; step <= slabs; ++step)
  {
    places.insert(parts * step);
  }
  for (int part = 0; part <= parts; ++part)
  {
    places.insert(slabs * part);
  }
  std::vector<Node> nodes;
  for (const int place : places)
  {
    const auto step = static_cast<std::size_t>(place / parts);
    const double share = static_cast<double>(place % parts) / parts;
    const double next = step < times.size() - 1 ? times[step + 1] : times[step];
    nodes.push_back(GetNode(
      (1.0 - share) * times[step] + share * next, first + static_cast<double>(place) / slabs));
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
    return "times do not increase at " + std::to_string(found->Time);
  }
  return {};
}
}

void vtkTemporalColorTransferFunction::SetTimes(int n, const double* times)
{
  if (n < 2 || !times)
  {
    vtkErrorMacro("Colours need two times or more, not " << (times ? n : 0) << ".");
    return;
  }
  const std::vector<double> steps(times, times + n);
  const std::vector<Node> nodes = GetNodes(steps);
  if (const interlume::Error error = FindError(steps, nodes))
  {
    vtkErrorMacro("Colours need finite times that increase: " << error << ".");
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
