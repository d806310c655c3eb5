// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationBox.h"

#include "Common/FiniteNumbers.h"
#include "Common/NamedValue.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTerminationBox);

namespace
{
// Returns the coordinate axes along which u and v of a face run.
void GetAxesOfPart(int part, int axes[2])
{
  axes[0] = part < 2 ? 1 : 0;
  axes[1] = part < 4 ? 2 : 1;
}
}

std::string vtkTerminationBox::Update()
{
  if (!interlume::FiniteNumbers::AreFinite(this->Bounds, 6))
  {
    return "a bound of the box is not finite";
  }
  for (int i = 0; i < 3; ++i)
  {
    if (!(this->Bounds[2 * i] < this->Bounds[2 * i + 1]))
    {
      return std::string("the box's lower bound in ") + "xyz"[i] +
        " is not less than its upper bound";
    }
  }
  return {};
}

double vtkTerminationBox::EvaluateDistance(const double x[3]) const
{
  double outside[3];
  double nearest = -VTK_DOUBLE_MAX;
  for (int i = 0; i < 3; ++i)
  {
    const double distance = std::max(this->Bounds[2 * i] - x[i], x[i] - this->Bounds[2 * i + 1]);
    nearest = std::max(nearest, distance);
    outside[i] = std::max(distance, 0.0);
  }
  return nearest > 0.0 ? std::hypot(outside[0], outside[1], outside[2]) : nearest;
}

int vtkTerminationBox::EvaluatePart(const double x[3]) const
{
  double distances[6];
  for (int i = 0; i < 3; ++i)
  {
    distances[2 * i] = this->Bounds[2 * i] - x[i];
    distances[2 * i + 1] = x[i] - this->Bounds[2 * i + 1];
  }
  return static_cast<int>(std::max_element(distances, distances + 6) - distances);
}

void vtkTerminationBox::EvaluateParameters(const double x[3], double uv[2]) const
{
  int axes[2];
  GetAxesOfPart(this->EvaluatePart(x), axes);
  for (int i = 0; i < 2; ++i)
  {
    const double* range = &this->Bounds[2 * axes[i]];
    uv[i] = std::max(0.0, std::min((x[axes[i]] - range[0]) / (range[1] - range[0]), 1.0));
  }
}

void vtkTerminationBox::EvaluateNormal(const double x[3], double normal[3]) const
{
  const int part = this->EvaluatePart(x);
  std::fill_n(normal, 3, 0.0);
  normal[part / 2] = part % 2 == 0 ? -1.0 : 1.0;
}

bool vtkTerminationBox::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  if (!this->NormalizeParameters(part, uv, taken))
  {
    return false;
  }
  int axes[2];
  GetAxesOfPart(part, axes);
  x[part / 2] = this->Bounds[part];
  for (int i = 0; i < 2; ++i)
  {
    const double* range = &this->Bounds[2 * axes[i]];
    x[axes[i]] = (1.0 - taken[i]) * range[0] + taken[i] * range[1];
  }
  return true;
}

void vtkTerminationBox::GetBounds(double bounds[6]) const
{
  std::copy_n(this->Bounds, 6, bounds);
}

void vtkTerminationBox::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent, { { "Bounds", this->Bounds } });
}
