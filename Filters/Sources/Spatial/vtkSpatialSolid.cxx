// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialSolid.h"

#include <algorithm>
#include <cmath>

void vtkSpatialSolid::SetEdgeWidth(double width)
{
  if (!(width >= 0.0) || !std::isfinite(width))
  {
    vtkErrorMacro("The edge width " << width << " is not finite or below 0.");
    return;
  }
  if (this->EdgeWidth != width)
  {
    this->EdgeWidth = width;
    this->Modified();
  }
}

double vtkSpatialSolid::GetEdgeProfile(double distance) const
{
  const double half = 0.5 * this->EdgeWidth;
  if (distance <= -half)
  {
    return 1.0;
  }
  if (!(distance < half))
  {
    return 0.0;
  }
  const double e = 0.5 - distance / this->EdgeWidth;
  return e * e * (3.0 - 2.0 * e);
}

bool vtkSpatialSolid::EvaluateLocally(const double (*points)[3], int number, Sample* samples) const
{
  bool isAny = false;
  for (int i = 0; i < number; ++i)
  {
    samples[i].Density = this->GetDensity() * this->GetProfile(points[i]);
    std::copy_n(this->GetLeafColor(), 3, samples[i].Color);
    isAny = isAny || samples[i].Density > 0.0;
  }
  return isAny;
}

void vtkSpatialSolid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EdgeWidth: " << this->EdgeWidth << "\n";
}
