// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationSurface.h"

#include "Common/NamedValue.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

std::string vtkTerminationSurface::InitializeFromField(vtkDataSet*, vtkDataArray*, bool)
{
  return {};
}

bool vtkTerminationSurface::IsOn(const double*) const
{
  return true;
}

bool vtkTerminationSurface::ProjectsOntoSurface(const double x[3]) const
{
  const double distance = this->EvaluateDistance(x);
  double foot[3];
  this->EvaluateNormal(x, foot);
  for (int i = 0; i < 3; ++i)
  {
    foot[i] = x[i] - distance * foot[i];
  }
  return this->IsOn(foot);
}

int vtkTerminationSurface::EvaluatePart(const double*) const
{
  return 0;
}

bool vtkTerminationSurface::IsPeriodic(int, int) const
{
  return false;
}

double vtkTerminationSurface::EvaluateGap(const double x[3]) const
{
  double uv[2];
  double nearest[3];
  this->EvaluateParameters(x, uv);
  return this->EvaluatePoint(this->EvaluatePart(x), uv, nearest)
    ? interlume::Vectors::SafeLength(interlume::Vectors::Difference(x, nearest))
    : std::abs(this->EvaluateDistance(x));
}

bool vtkTerminationSurface::NormalizeParameters(int part, const double uv[2], double taken[2]) const
{
  if (part < 0 || part >= this->GetNumberOfParts())
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    taken[i] =
      this->IsPeriodic(i, part) ? uv[i] - std::floor(uv[i]) : std::max(0.0, std::min(uv[i], 1.0));
    // The negated condition rejects NaN and infinity.
    if (!(std::isfinite(uv[i]) &&
          (this->IsPeriodic(i, part) || std::abs(taken[i] - uv[i]) <= BorderTolerance)))
    {
      return false;
    }
  }
  return true;
}

void vtkTerminationSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(
    os, indent, { { "Id", this->Id }, { "NumberOfParts", this->GetNumberOfParts() } });
}
