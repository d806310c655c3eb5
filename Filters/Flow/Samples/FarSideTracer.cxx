// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/FarSideTracer.h"

#include "Common/Vectors.h"

#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace interlume
{

namespace
{
// Maximum number of steps to the surface near a sample. Crossing a cell needs only a few.
constexpr int MaximumSteps = 100;
// Maximum distance from a sample to the point where its streamline reaches the surface, in units of
// the cell's diagonal.
constexpr double MaximumDistance = 4.0;
// Distance behind the surface at which the streamline continues, in the same units.
constexpr double StartBehind = 1e-4;

/// Adds the path to the far side to the result \a on of the streamline that starts there. The path
/// consists of \a to, which ends at the surface, and a short step of length \a way through the
/// surface. It takes the time \a before.
void Append(const AdvectionResult& to, double way, double before, AdvectionResult& on)
{
  const double after = on.Time;
  const auto average = [&](double first, double second)
  { return (before * first + after * second) / (before + after); };
  on.Time = before + after;
  on.MaximumSpeed = std::max(to.MaximumSpeed, on.MaximumSpeed);
  on.ArcLength += to.ArcLength + way;
  on.MeanVorticity = average(to.MeanVorticity, on.MeanVorticity);
  for (std::size_t i = 0; i < on.Means.size(); ++i)
  {
    on.Means[i] = average(to.Means[i], on.Means[i]);
  }
}
}

bool FarSideTracer::Find(const Corners& corners, std::vector<SampleResult>& sampleResults)
{
  sampleResults.resize(corners.size());
  const std::vector<Streamlines::Velocity> velocities = this->Context.Field.GetVelocities(
    static_cast<vtkIdType>(corners.size()),
    [&](vtkIdType i, double x[3])
    { this->Samples->GetPoint(corners[static_cast<std::size_t>(i)].Sample, x); },
    false);
  Rows back;
  Rows on;
  for (std::size_t row = 0; row < corners.size(); ++row)
  {
    this->Describe(corners, row, velocities[row], sampleResults[row], back, on);
  }
  std::vector<AdvectionResult> results(corners.size());
  if (!this->FollowTo(corners, back, true, results) || !this->FollowTo(corners, on, false, results))
  {
    return false;
  }
  for (const std::size_t row : back)
  {
    AdvectionResult& farSide = sampleResults[row].FarSide;
    farSide = results[row];
    farSide.Status = this->ReachesSurfaceNearby(farSide, corners[row])
      ? farSide.Status
      : static_cast<int>(vtkFlowStatus::OUTSIDE);
    farSide.Time = -farSide.Time;
    farSide.ArcLength = -farSide.ArcLength;
  }
  if (!this->TraceBeyondSurface(corners, on, results, sampleResults))
  {
    return false;
  }
  for (SampleResult& sampleResult : sampleResults)
  {
    if (sampleResult.FarSide.Status != vtkFlowStatus::REACHED_SURFACE)
    {
      sampleResult.FarSide.Id = -1;
    }
  }
  return true;
}

bool FarSideTracer::OrientVelocity(Streamlines::Velocity& velocity) const
{
  for (double& component : velocity.V)
  {
    component = this->Options.IsBackward() ? -component : component;
  }
  const double speed = Vectors::SafeLength(glm::make_vec3(velocity.V));
  return velocity.IsInField && std::isfinite(speed) && speed > this->Options.MinimumSpeed;
}

void FarSideTracer::Describe(const Corners& corners, std::size_t row,
  Streamlines::Velocity velocity, SampleResult& sampleResult, Rows& back, Rows& on) const
{
  const FarSideCorners::Corner& corner = corners[row];
  sampleResult.FarSide.Means.assign(this->Options.MeanNumbers.size(), 0.0);
  double x[3];
  this->Samples->GetPoint(corner.Sample, x);
  this->Options.Surfaces[static_cast<std::size_t>(corner.Surface)].Shape->EvaluateNormal(
    x, sampleResult.Normal);
  const bool isMoving = this->OrientVelocity(velocity);
  sampleResult.IsStagnant = !isMoving && corner.Distance == 0.0;
  // A streamline parallel to the surface counts as AWAY, as in TerminationSide.
  const double speed = vtkMath::Dot(sampleResult.Normal, velocity.V);
  const bool isAway =
    (corner.Distance >= 0.0 && speed >= 0.0) || (corner.Distance <= 0.0 && speed <= 0.0);
  const int side = corner.Distance == 0.0 ? 0 : (corner.Distance < 0.0 ? -1 : 1);
  sampleResult.Side =
    static_cast<signed char>(side * (isAway ? vtkFlowStatus::AWAY : vtkFlowStatus::TOWARD));
  if (isMoving && side != 0 && isAway)
  {
    back.push_back(row);
  }
  else if (isMoving && corner.IsOtherReached)
  {
    on.push_back(row);
  }
}

bool FarSideTracer::ReachesSurfaceNearby(
  const AdvectionResult& result, const FarSideCorners::Corner& corner) const
{
  double x[3];
  this->Samples->GetPoint(corner.Sample, x);
  return result.Status == vtkFlowStatus::REACHED_SURFACE &&
    Vectors::SafeLength(Vectors::Difference(result.Position, x)) <= MaximumDistance * corner.Length;
}

bool FarSideTracer::FollowTo(
  const Corners& corners, const Rows& rows, bool isBack, std::vector<AdvectionResult>& results)
{
  AdvectionOptions options = this->Options;
  options.DomainFaces = false;
  options.MaximumTime = VTK_DOUBLE_MAX;
  options.MaximumNumberOfSteps = MaximumSteps;
  options.SetBackward(this->Options.IsBackward() != isBack);
  bool isActive = true;
  for (std::size_t surface = 0; isActive && surface < this->Options.Surfaces.size(); ++surface)
  {
    Rows own;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
      [&](std::size_t row) { return corners[row].Surface == static_cast<int>(surface); });
    options.Surfaces = { this->Options.Surfaces[surface] };
    isActive = this->Context.Field.Follow(
      options, static_cast<vtkIdType>(own.size()),
      [&](vtkIdType i, double x[3])
      { this->Samples->GetPoint(corners[own[static_cast<std::size_t>(i)]].Sample, x); },
      [&](vtkIdType i, const AdvectionResult& result)
      { results[own[static_cast<std::size_t>(i)]] = result; },
      this->Context.Progress, this->Context.Progress);
  }
  return isActive;
}

bool FarSideTracer::TraceBeyondSurface(const Corners& corners, const Rows& rows,
  const std::vector<AdvectionResult>& before, std::vector<SampleResult>& sampleResults)
{
  Rows hit;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(hit),
    [&](std::size_t row) { return this->ReachesSurfaceNearby(before[row], corners[row]); });
  std::vector<Streamlines::Velocity> velocities = this->Context.Field.GetVelocities(
    static_cast<vtkIdType>(hit.size()),
    [&](vtkIdType i, double x[3])
    { std::copy_n(before[hit[static_cast<std::size_t>(i)]].Position, 3, x); },
    false);
  struct Start
  {
    std::size_t Row;
    double PathLength;
    double Time;
    double X[3];
  };
  std::vector<Start> starts;
  for (std::size_t i = 0; i < hit.size(); ++i)
  {
    if (this->OrientVelocity(velocities[i]))
    {
      const AdvectionResult& to = before[hit[i]];
      const double speed = Vectors::SafeLength(glm::make_vec3(velocities[i].V));
      const double way = StartBehind * corners[hit[i]].Length;
      Start start{ hit[i], way, to.Time + way / speed, {} };
      for (int axis = 0; axis < 3; ++axis)
      {
        start.X[axis] = to.Position[axis] + way / speed * velocities[i].V[axis];
      }
      starts.push_back(start);
    }
  }
  return this->Context.Field.Follow(
    this->Options, static_cast<vtkIdType>(starts.size()),
    [&](vtkIdType i, double x[3]) { std::copy_n(starts[static_cast<std::size_t>(i)].X, 3, x); },
    [&](vtkIdType i, const AdvectionResult& result)
    {
      const Start& start = starts[static_cast<std::size_t>(i)];
      sampleResults[start.Row].FarSide = result;
      Append(before[start.Row], start.PathLength, start.Time, sampleResults[start.Row].FarSide);
    },
    this->Context.Progress, this->Context.Progress);
}

}
