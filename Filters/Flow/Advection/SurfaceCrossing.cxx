// SPDX-License-Identifier: BSD-3-Clause
#include "Advection/SurfaceCrossing.h"

#include <cfloat>

namespace interlume
{

int SurfaceCrossing::Begin(const double x[3], double size)
{
  this->Evaluations = 0;
  this->Size = size;
  int on = -1;
  for (std::size_t i = 0; i < this->States.size(); ++i)
  {
    State& state = this->States[i];
    state.SetDistance(this->Evaluate(i, x));
    const bool isClose = std::abs(state.Distance) <= this->GetTolerance(x);
    state.Side = isClose ? 0 : (state.Distance < 0.0 ? -1 : 1);
    if (on < 0 && isClose && this->Surfaces[i].Shape->IsOn(x))
    {
      on = static_cast<int>(i);
    }
  }
  return on;
}

int SurfaceCrossing::FindNear(
  const double x[3], double tolerance, const double faceNormal[3], const double direction[3]) const
{
  int nearest = -1;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->States.size(); ++i)
  {
    const vtkTerminationSurface* shape = this->Surfaces[i].Shape;
    // The points of a mesh may have single precision, which can be less accurate than the
    // tolerance.
    if (this->States[i].Clearance > tolerance + FLT_EPSILON * this->GetSize(x))
    {
      continue;
    }
    const double gap = shape->EvaluateGap(x);
    double normal[3];
    shape->EvaluateNormal(x, normal);
    const double weight = 2.0 *
      std::max(
        std::abs(Vectors::Dot(normal, faceNormal)), std::abs(Vectors::Dot(normal, direction)));
    if (gap < minimum && gap <= std::min(1.0, weight) * tolerance)
    {
      minimum = gap;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

void SurfaceCrossing::GetResult(int surface, const double x[3], AdvectionEnd& result) const
{
  const AdvectionOptions::Surface& found = this->Surfaces[static_cast<std::size_t>(surface)];
  result.Id = found.Id + found.Shape->EvaluatePart(x);
  found.Shape->EvaluateParameters(x, result.Parameters);
}

double SurfaceCrossing::GetMinimumDistance(const double x[3])
{
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Surfaces.size(); ++i)
  {
    minimum = std::min(minimum, std::abs(this->Evaluate(i, x)));
  }
  return minimum;
}

void SurfaceCrossing::Save(std::vector<double>& numbers) const
{
  numbers.push_back(this->Size);
  numbers.push_back(this->Evaluations);
  for (const State& state : this->States)
  {
    numbers.insert(numbers.end(),
      { state.Distance, state.Clearance, static_cast<double>(state.Side),
        state.IsFresh ? 1.0 : 0.0 });
  }
}

const double* SurfaceCrossing::Restore(const double* numbers)
{
  this->Size = *numbers++;
  this->Evaluations = static_cast<int>(*numbers++);
  for (State& state : this->States)
  {
    state.Distance = *numbers++;
    state.Clearance = *numbers++;
    state.Side = static_cast<int>(*numbers++);
    state.IsFresh = *numbers++ != 0.0;
  }
  return numbers;
}

}
