// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TransferNodes.h"

#include "Volume/TransferMath.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace interlume
{

namespace
{
using Value = TransferNodes::Value;
using TransferMath::GetDistance;
using TransferMath::Mix;
using Node = TransferNodes::Node;

/// Maximum number of bisections of a curve.
constexpr int MaximumCurveDepth = 16;
constexpr double NodeTolerance = 1e-5;
/// Distance from the ends of a curve at which its one-sided limits are evaluated, as a fraction of
/// the curve's width.
constexpr double AtEnd = 1e-9;

double GetSize(const Value& value)
{
  return GetDistance(value, Value{});
}

/// Returns a position outside the points of a function: below the first point \a x if \a sign is
/// -1, or above the last point \a x if \a sign is 1.
double GetPositionOutside(double x, double sign)
{
  return x + sign * std::max(std::abs(x), 1.0);
}

/// Returns the value at \a x, just before the midpoint, of a rise from 0 to 1 with a sharpness of
/// 1. The value is 0 in VTK versions in which the rise is a step, and positive in versions in which
/// it is a steep curve.
double GetValueBeforeStep(vtkPiecewiseFunction* rise, double x)
{
  rise->AddPoint(0.0, 0.0, 0.5, 1.0);
  rise->AddPoint(1.0, 1.0, 0.5, 1.0);
  return rise->GetValue(x);
}

double GetValueBeforeStep(vtkColorTransferFunction* rise, double x)
{
  rise->AddRGBPoint(0.0, 0.0, 0.0, 0.0, 0.5, 1.0);
  rise->AddRGBPoint(1.0, 1.0, 1.0, 1.0, 0.5, 1.0);
  return rise->GetRedValue(x);
}

/// Returns true if a sharpness of 1 is a step in this VTK version, for functions of type Transfer.
template <typename Transfer>
bool MakesSteps()
{
  static const bool steps = []()
  {
    vtkNew<Transfer> rise;
    return GetValueBeforeStep(rise, 0.49) == 0.0;
  }();
  return steps;
}
}

void TransferNodes::Add(double x, const Value& y)
{
  if (this->Nodes.empty() || this->Nodes.back().X != x || this->Nodes.back().Y != y)
  {
    this->Nodes.push_back({ x, y });
  }
}

template <typename Function>
void TransferNodes::AddCurve(
  const Function& function, const Node& a, const Node& b, double scale, int depth)
{
  const auto isStraight = [&](double fraction)
  {
    return GetDistance(function(a.X + fraction * (b.X - a.X)), Mix(a.Y, b.Y, fraction)) <=
      NodeTolerance * scale;
  };
  const double center = a.X + 0.5 * (b.X - a.X);
  if (depth == 0 || !(center > a.X && center < b.X) ||
    (isStraight(0.5) && isStraight(0.25) && isStraight(0.75) && isStraight(0.03) &&
      isStraight(0.97)))
  {
    this->Add(b.X, b.Y);
    return;
  }
  const Node half{ center, function(center) };
  this->AddCurve(function, a, half, scale, depth - 1);
  this->AddCurve(function, half, b, scale, depth - 1);
}

template <typename Function>
void TransferNodes::AddSegment(const Function& function, const Node& a, const Node& b,
  double midpoint, double sharpness, bool steps, Curve curve)
{
  // VTK's transfer functions use these thresholds.
  constexpr double minimumMidpoint = 0.00001;
  constexpr double straight = 0.01;
  constexpr double step = 0.99;
  const double fraction = std::clamp(midpoint, minimumMidpoint, 1.0 - minimumMidpoint);
  const double center = curve == LOGARITHMIC && a.X > 0.0 ? a.X * std::pow(b.X / a.X, fraction)
                                                          : a.X + fraction * (b.X - a.X);
  if (steps && sharpness > step)
  {
    this->Add(center, a.Y);
    this->Add(center, b.Y);
  }
  else if (b.X > a.X && (curve != STRAIGHT || sharpness >= straight))
  {
    const double scale = std::max(GetSize(a.Y), GetSize(b.Y));
    const Node first{ a.X, function(a.X + AtEnd * (b.X - a.X)) };
    const Node bend{ center, function(center) };
    const Node last{ b.X, function(b.X - AtEnd * (b.X - a.X)) };
    const auto snap = [&](const Node& limit, const Node& node)
    { return GetDistance(limit.Y, node.Y) <= NodeTolerance * scale ? node : limit; };
    const Node from = snap(first, a);
    this->Add(from.X, from.Y);
    this->AddCurve(function, from, bend, scale, MaximumCurveDepth);
    this->AddCurve(function, bend, snap(last, b), scale, MaximumCurveDepth);
  }
  else if (fraction != 0.5)
  {
    this->Add(center, Mix(a.Y, b.Y, 0.5));
  }
  this->Add(b.X, b.Y);
}

template <std::size_t Channels, typename Transfer, typename Function>
void TransferNodes::AddFunction(Transfer* transfer, const Function& function, Curve curve)
{
  // A point of a VTK function: position, channels, midpoint and sharpness.
  std::array<double, Channels + 3> point{};
  const auto get = [&](int i)
  {
    transfer->GetNodeValue(i, point.data());
    return Node{ point[0], { { point[1], point[(Channels + 1) / 2], point[Channels] } } };
  };
  Node node = get(0);
  this->Add(node.X, function(GetPositionOutside(node.X, -1.0)));
  this->Add(node.X, node.Y);
  for (int i = 1; i < transfer->GetSize(); ++i)
  {
    const double midpoint = point[Channels + 1];
    const double sharpness = point[Channels + 2];
    const Node next = get(i);
    this->AddSegment(function, node, next, midpoint, sharpness, MakesSteps<Transfer>(), curve);
    node = next;
  }
  this->Add(node.X, function(GetPositionOutside(node.X, 1.0)));
  this->FindLargest();
}

TransferNodes::TransferNodes(vtkPiecewiseFunction* function)
{
  const auto evaluate = [function](double x)
  {
    const double value = function->GetValue(x);
    return Value{ { value, value, value } };
  };
  this->AddFunction<1>(function, evaluate, function->GetUseLogScale() ? LOGARITHMIC : STRAIGHT);
}

TransferNodes::TransferNodes(vtkColorTransferFunction* function)
{
  const auto evaluate = [function](double x)
  {
    Value value{};
    function->GetColor(x, value.data());
    return value;
  };
  this->AddFunction<3>(function, evaluate,
    function->GetScale() != VTK_CTF_LINEAR       ? LOGARITHMIC
      : function->GetColorSpace() != VTK_CTF_RGB ? CURVED
                                                 : STRAIGHT);
}

TransferNodes::TransferNodes(const Range& range, double first, double last)
{
  this->Nodes = { { range[0], { { first, first, first } } },
    { range[1], { { last, last, last } } } };
  this->FindLargest();
}

void TransferNodes::FindLargest()
{
  std::vector<double> largest;
  for (const Node& node : this->Nodes)
  {
    largest.push_back(node.Y[0]);
  }
  for (std::size_t width = 1; !largest.empty(); width *= 2)
  {
    std::vector<double> wider(largest.size() > width ? largest.size() - width : 0);
    for (std::size_t i = 0; i < wider.size(); ++i)
    {
      wider[i] = std::max(largest[i], largest[i + width]);
    }
    this->Largest.push_back(std::move(largest));
    largest = std::move(wider);
  }
}

TransferNodes::Range TransferNodes::ClipRange(const Range& range) const
{
  const Node& first = this->Nodes.front();
  const Node& last = this->Nodes.back();
  const double width = last.X > first.X ? last.X - first.X : range[1] - range[0];
  const auto isStep = [](const Node& a, const Node& b) { return a.X == b.X; };
  const bool hasPieces = this->Nodes.size() > 1;
  constexpr double margin = 1.0 / 64.0;
  const double lower =
    first.X - (hasPieces && isStep(first, this->Nodes[1]) ? margin * width : 0.0);
  const double upper =
    last.X + (hasPieces && isStep(*(this->Nodes.end() - 2), last) ? margin * width : 0.0);
  const Range part{ { std::max(range[0], lower), std::min(range[1], upper) } };
  // If the part were narrower than this, the scale factor from texels to columns would overflow
  // single precision.
  constexpr double least = 1e-33;
  const double size = std::max(std::abs(range[0]), std::abs(range[1]));
  return part[1] - part[0] > least * size && std::isfinite(part[1] - part[0]) ? part : range;
}

bool TransferNodes::IsStepwise(const Range& range, double width) const
{
  const auto isRamp = [&](const Node& a, const Node& b)
  { return a.Y[0] != b.Y[0] && std::min(b.X, range[1]) - std::max(a.X, range[0]) > width; };
  return std::adjacent_find(this->Nodes.begin(), this->Nodes.end(), isRamp) == this->Nodes.end();
}

double TransferNodes::GetSmallestAboveZero(const Range& range) const
{
  double smallest = 0.0;
  const auto add = [&](double value)
  { smallest = value > 0.0 && (smallest == 0.0 || value < smallest) ? value : smallest; };
  add(this->Evaluate(range[0])[0]);
  add(this->Evaluate(range[1])[0]);
  for (const Node& node : this->Nodes)
  {
    if (node.X >= range[0] && node.X <= range[1])
    {
      add(node.Y[0]);
    }
  }
  return smallest;
}

TransferNodes::Value TransferNodes::Evaluate(double x) const
{
  const auto right = std::upper_bound(this->Nodes.begin(), this->Nodes.end(), x,
    [](double position, const Node& node) { return position < node.X; });
  if (right == this->Nodes.begin())
  {
    return right->Y;
  }
  const Node& left = *(right - 1);
  return right == this->Nodes.end() ? left.Y
                                    : Mix(left.Y, right->Y, (x - left.X) / (right->X - left.X));
}

double TransferNodes::GetLargest(const Range& range, const Range& near) const
{
  const auto begin = std::lower_bound(this->Nodes.begin(), this->Nodes.end(), range[0] - near[0],
    [](const Node& node, double position) { return node.X < position; });
  const auto end = std::upper_bound(begin, this->Nodes.end(), range[1] + near[1],
    [](double position, const Node& node) { return position < node.X; });
  double largest = 0.0;
  if (begin < end)
  {
    const auto first = static_cast<std::size_t>(begin - this->Nodes.begin());
    const auto count = static_cast<std::size_t>(end - begin);
    std::size_t level = 0;
    while ((std::size_t(2) << level) <= count)
    {
      ++level;
    }
    largest = std::max(
      this->Largest[level][first], this->Largest[level][first + count - (std::size_t(1) << level)]);
  }
  if (begin == end || begin->X > range[0] + near[0])
  {
    largest = std::max(largest, this->Evaluate(range[0])[0]);
  }
  if (begin == end || (end - 1)->X < range[1] - near[1])
  {
    largest = std::max(largest, this->Evaluate(range[1])[0]);
  }
  return largest;
}

}
