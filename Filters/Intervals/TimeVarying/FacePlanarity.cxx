// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/FacePlanarity.h"

#include "vtkMath.h"
#include "vtkStructuredGrid.h"

#include <cmath>

namespace interlume
{

FacePlanarity::FacePlanarity(const TimeStep& first, const TimeStep& second)
  : Grid(first.GetGrid())
  , Static(first.HasSamePoints(second))
  , Flat(!vtkPointSet::SafeDownCast(first.GetGrid()))
{
}

unsigned FacePlanarity::GetPlanarFaces(
  const TimeVaryingCell& cell, const SpaceTimeSlots& slots) const
{
  if (this->Flat)
  {
    return (1u << SpaceTimeSlots::MaximumNumberOfFaces) - 1;
  }
  unsigned planar = 0;
  for (int f = 0; f < SpaceTimeSlots::MaximumNumberOfFaces; ++f)
  {
    planar |= this->IsPlanar(cell, slots.GetFace(f)) ? 1u << f : 0u;
  }
  return planar;
}

bool FacePlanarity::IsPlanar(const TimeVaryingCell& cell, unsigned corners) const
{
  double x[4][3];
  int number = 0;
  for (int v = 0; v < cell.NumberOfCorners; ++v)
  {
    if ((corners >> v) & 1)
    {
      this->Grid->GetPoint(cell.Ids[v], x[number++]);
    }
  }
  if (number < 4)
  {
    return true;
  }
  for (int k = 1; k < 4; ++k)
  {
    vtkMath::Subtract(x[k], x[0], x[k]);
  }
  // Maximum relative volume that rounding alone may cause.
  constexpr double small = 1e-13;
  const double size = vtkMath::Norm(x[1]) * vtkMath::Norm(x[2]) * vtkMath::Norm(x[3]);
  return std::abs(vtkMath::Determinant3x3(x[1], x[2], x[3])) <= small * size;
}

}
