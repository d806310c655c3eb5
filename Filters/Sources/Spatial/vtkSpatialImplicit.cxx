// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialImplicit.h"

#include "Common/NamedValue.h"
#include "Sampling/PartPrinter.h"

#include "vtkImplicitFunction.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSpatialImplicit);

vtkSpatialImplicit::vtkSpatialImplicit()
{
  for (int side = 0; side < 6; ++side)
  {
    this->Limits[side] = side % 2 == 0 ? vtkMath::NegInf() : vtkMath::Inf();
  }
}

vtkSpatialImplicit::~vtkSpatialImplicit() = default;

void vtkSpatialImplicit::SetFunction(vtkImplicitFunction* function)
{
  if (this->Function != function)
  {
    this->Function = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkSpatialImplicit::GetFunction() const
{
  return this->Function;
}

void vtkSpatialImplicit::SetLimits(const double limits[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(limits[2 * axis] <= limits[2 * axis + 1]))
    {
      vtkErrorMacro("The limits " << limits[2 * axis] << " and " << limits[2 * axis + 1]
                                  << " of axis " << axis << " are not in order.");
      return;
    }
  }
  if (!std::equal(limits, limits + 6, this->Limits))
  {
    std::copy_n(limits, 6, this->Limits);
    this->Modified();
  }
}

vtkMTimeType vtkSpatialImplicit::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Function ? std::max(own, this->Function->GetMTime()) : own;
}

std::string vtkSpatialImplicit::Prepare(double bounds[6])
{
  std::copy_n(this->Limits, 6, bounds);
  return this->Function ? "" : "A spatial object of an implicit function has no function.";
}

double vtkSpatialImplicit::GetProfile(const double x[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (x[axis] < this->Limits[2 * axis] || x[axis] > this->Limits[2 * axis + 1])
    {
      return 0.0;
    }
  }
  const double value = this->Function->FunctionValue(x);
  if (this->GetEdgeWidth() == 0.0)
  {
    return this->GetEdgeProfile(value);
  }
  double gradient[3];
  double position[3] = { x[0], x[1], x[2] };
  this->Function->FunctionGradient(position, gradient);
  const double steepness = vtkMath::Norm(gradient);
  // Where there is no gradient only the sign is known.
  return this->GetEdgeProfile(
    steepness > 0.0 ? value / steepness : std::copysign(this->GetEdgeWidth(), value));
}

void vtkSpatialImplicit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent, { { "Limits", this->Limits } });
  interlume::PartPrinter::Print(os, indent, "Function", this->Function);
}
