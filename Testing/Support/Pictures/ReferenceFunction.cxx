// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Pictures/ReferenceFunction.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <stdexcept>

namespace reference
{

namespace
{

void ExpectStraight(bool straight)
{
  if (!straight)
  {
    throw std::invalid_argument("a transfer function whose pieces are not straight");
  }
}

}

StraightFunction::StraightFunction(vtkColorTransferFunction* function)
  : Clamping(function->GetClamping() != 0)
{
  ExpectStraight(
    function->GetColorSpace() == VTK_CTF_RGB && function->GetScale() == VTK_CTF_LINEAR);
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    ExpectStraight(node[4] == 0.5 && node[5] == 0.0);
    this->Nodes.push_back({ node[0], { node[1], node[2], node[3] } });
  }
}

StraightFunction::StraightFunction(vtkPiecewiseFunction* function)
  : Clamping(function->GetClamping() != 0)
{
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    ExpectStraight(node[2] == 0.5 && node[3] == 0.0);
    this->Nodes.push_back({ node[0], { node[1], node[1], node[1] } });
  }
}

void StraightFunction::AppendNodes(double begin, double end, std::vector<double>& places) const
{
  for (const Node& node : this->Nodes)
  {
    const double place = (node.X - begin) / (end - begin);
    if (place > 0.0 && place < 1.0)
    {
      places.push_back(place);
    }
  }
}

StraightFunction::Value StraightFunction::Evaluate(double x, double inside) const
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
  const double share = (x - left.X) / (right->X - left.X);
  Value value;
  for (int k = 0; k < 3; ++k)
  {
    value[k] = left.Y[k] + share * (right->Y[k] - left.Y[k]);
  }
  return value;
}

}
