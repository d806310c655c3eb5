// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PiecewiseLinearTransferFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
using Value = std::array<double, 4>;
/// Maximum depth of recursive bisection. The narrowest piece is 2^-24 of a control point interval.
constexpr int DEPTH = 24;

// The color and opacity functions.
class Functions
{
public:
  Functions(vtkVolumeProperty* property, int component, double unit)
    : Unit(unit)
    , Opacity(property->GetScalarOpacity(component))
  {
    if (property->GetColorChannels(component) == 3)
    {
      this->Color = property->GetRGBTransferFunction(component);
    }
    else
    {
      this->Gray = property->GetGrayTransferFunction(component);
    }
  }

  Value Evaluate(double x) const
  {
    Value value;
    if (this->Color)
    {
      this->Color->GetColor(x, value.data());
    }
    else
    {
      value[0] = value[1] = value[2] = this->Gray ? this->Gray->GetValue(x) : 1.0;
    }
    value[3] = this->Opacity->GetValue(x) * this->Unit;
    return value;
  }

  // Returns the ends of the range and the control points inside it, in ascending order.
  std::vector<double> GetNodes(const double range[2]) const
  {
    std::vector<double> nodes = { range[0], range[1] };
    const auto add = [&nodes, range](double x)
    {
      if (x > range[0] && x < range[1])
      {
        nodes.push_back(x);
      }
    };
    double node[6];
    const int colors = this->Color ? this->Color->GetSize() : 0;
    for (int i = 0; i < colors; ++i)
    {
      this->Color->GetNodeValue(i, node);
      add(node[0]);
    }
    for (vtkPiecewiseFunction* function : { this->Gray, this->Opacity })
    {
      for (int i = 0; function && i < function->GetSize(); ++i)
      {
        function->GetNodeValue(i, node);
        add(node[0]);
      }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

private:
  double Unit;
  vtkColorTransferFunction* Color = nullptr;
  vtkPiecewiseFunction* Gray = nullptr;
  vtkPiecewiseFunction* Opacity;
};

Value Mix(const Value& a, const Value& b, double t)
{
  Value mixed;
  for (int i = 0; i < 4; ++i)
  {
    mixed[i] = a[i] + t * (b[i] - a[i]);
  }
  return mixed;
}

bool IsClose(const Value& value, const Value& straight, double tolerance)
{
  for (int i = 0; i < 3; ++i)
  {
    if (std::abs(value[i] - straight[i]) > tolerance)
    {
      return false;
    }
  }
  return std::abs(value[3] - straight[3]) <=
    tolerance * std::max(std::abs(value[3]), std::abs(straight[3]));
}
}

void PiecewiseLinearTransferFunction::Build(
  vtkVolumeProperty* property, int component, const double range[2], double unit, double tolerance)
{
  const Functions functions(property, component, unit);
  std::vector<Node> nodes;
  // Appends nodes for the curve from a to b, excluding a and including b.
  const auto append = [&](const auto& self, const Node& a, const Node& b, int depth) -> void
  {
    const auto isStraight = [&](double t) {
      return IsClose(
        functions.Evaluate(a.X + t * (b.X - a.X)), Mix(a.Value, b.Value, t), tolerance);
    };
    const double midpoint = 0.5 * (a.X + b.X);
    if (depth == DEPTH || !(midpoint > a.X && midpoint < b.X) ||
      (isStraight(0.25) && isStraight(0.5) && isStraight(0.75) && isStraight(0.03) &&
        isStraight(0.97)))
    {
      nodes.push_back(b);
      return;
    }
    const Node half = { midpoint, functions.Evaluate(midpoint) };
    self(self, a, half, depth + 1);
    self(self, half, b, depth + 1);
  };
  const std::vector<double> breakpoints = functions.GetNodes(range);
  nodes.push_back({ breakpoints[0], functions.Evaluate(breakpoints[0]) });
  for (std::size_t i = 1; i < breakpoints.size(); ++i)
  {
    append(append, nodes.back(), { breakpoints[i], functions.Evaluate(breakpoints[i]) }, 0);
  }

  // Remove nodes that lie on the line from the last retained node to a later node.
  std::vector<Node> retained = { nodes[0] };
  std::size_t from = 0;
  for (std::size_t to = 2; to < nodes.size(); ++to)
  {
    const Node& a = nodes[from];
    const Node& b = nodes[to];
    for (std::size_t i = from + 1; i < to; ++i)
    {
      if (!IsClose(
            nodes[i].Value, Mix(a.Value, b.Value, (nodes[i].X - a.X) / (b.X - a.X)), tolerance))
      {
        from = to - 1;
        retained.push_back(nodes[from]);
        break;
      }
    }
  }
  if (nodes.size() > 1)
  {
    retained.push_back(nodes.back());
  }
  const double width = range[1] - range[0];
  for (Node& node : retained)
  {
    node.X = width > 0.0 ? (node.X - range[0]) / width : 0.0;
  }
  this->SetNodes(retained);
}

void PiecewiseLinearTransferFunction::SetNodes(const std::vector<Node>& nodes)
{
  this->Pieces.clear();
  this->Starts.clear();
  this->Extinctions.clear();
  this->ExtinctionSlopes.clear();
  for (std::size_t i = 0; i + 1 < std::max<std::size_t>(nodes.size(), 2); ++i)
  {
    Piece piece = {};
    // Two nodes may coincide after rounding. The function then has a jump there.
    const double width = i + 1 < nodes.size() ? nodes[i + 1].X - nodes[i].X : 0.0;
    for (int c = 0; c < 4; ++c)
    {
      piece.Value[c] = static_cast<float>(nodes[i].Value[c]);
      if (width > 0.0)
      {
        piece.Slope[c] = static_cast<float>((nodes[i + 1].Value[c] - nodes[i].Value[c]) / width);
      }
    }
    this->Pieces.push_back(piece);
    this->Starts.push_back(static_cast<float>(nodes[i].X));
    this->Extinctions.push_back(piece.Value[3]);
    this->ExtinctionSlopes.push_back(piece.Slope[3]);
  }
  this->Starts.push_back(2.0f);
  this->First.resize(BUCKETS + 1);
  int piece = 0;
  for (int bucket = 0; bucket <= BUCKETS; ++bucket)
  {
    while (static_cast<float>(bucket) / BUCKETS >= this->Starts[piece + 1])
    {
      ++piece;
    }
    this->First[bucket] = piece;
  }
}

bool PiecewiseLinearTransferFunction::HasConstantColor() const
{
  const Sample& first = this->Pieces[0].Value;
  for (const Piece& piece : this->Pieces)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (piece.Value[i] != first[i] || piece.Slope[i] != 0.0f)
      {
        return false;
      }
    }
  }
  return true;
}

}
