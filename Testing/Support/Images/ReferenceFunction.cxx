// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <stdexcept>

namespace reference
{

namespace
{

void RequireLinear(bool isLinear)
{
  if (!isLinear)
  {
    throw std::invalid_argument("the transfer function is not piecewise linear in RGB");
  }
}

}

PiecewiseLinearFunction::PiecewiseLinearFunction(vtkColorTransferFunction* function)
  : Clamping(function->GetClamping() != 0)
{
  RequireLinear(function->GetColorSpace() == VTK_CTF_RGB && function->GetScale() == VTK_CTF_LINEAR);
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    RequireLinear(node[4] == 0.5 && node[5] == 0.0);
    this->Nodes.push_back({ node[0], { node[1], node[2], node[3] } });
  }
}

PiecewiseLinearFunction::PiecewiseLinearFunction(vtkPiecewiseFunction* function)
  : Clamping(function->GetClamping() != 0)
{
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    RequireLinear(node[2] == 0.5 && node[3] == 0.0);
    this->Nodes.push_back({ node[0], { node[1], node[1], node[1] } });
  }
}

void PiecewiseLinearFunction::AppendNodes(
  double begin, double end, std::vector<double>& positions) const
{
  for (const Node& node : this->Nodes)
  {
    const double location = (node.X - begin) / (end - begin);
    if (location > 0.0 && location < 1.0)
    {
      positions.push_back(location);
    }
  }
}

PiecewiseLinearFunction::Value PiecewiseLinearFunction::Evaluate(double x, double inside) const
{
  if (this->Nodes.empty())
  {
    return { 0.0, 0.0, 0.0 };
  }
  const auto right = std::upper_bound(this->Nodes.begin(), this->Nodes.end(), inside,
    [](double position, const Node& node) { return position < node.X; });
  if (right == this->Nodes.begin() || right == this->Nodes.end())
  {
    const Node& nearest = right == this->Nodes.end() ? this->Nodes.back() : this->Nodes.front();
    return this->Clamping || inside == nearest.X ? nearest.Y : Value{ 0.0, 0.0, 0.0 };
  }
  const Node& left = *(right - 1);
  const double fraction = (x - left.X) / (right->X - left.X);
  Value value;
  for (int k = 0; k < 3; ++k)
  {
    value[k] = left.Y[k] + fraction * (right->Y[k] - left.Y[k]);
  }
  return value;
}

}
