// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/BeyondTrace.h"

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
// The most steps that are taken to the surface beside a sample; a cell is crossed in a few.
constexpr int MostSteps = 100;
// The largest way, as a share of a cell's diagonal, that a streamline may go to the surface
// beside it, and the share from which it goes on behind the surface.
constexpr double MostWay = 4.0;
constexpr double StartBehind = 1e-4;

/// Joins what a streamline has to the surface, and on a short way through it, to the rest.
void Join(const AdvectionResult& to, double way, double before, AdvectionResult& on)
{
  const double after = on.Time;
  const auto unite = [&](double first, double second)
  { return (before * first + after * second) / (before + after); };
  on.Time = before + after;
  on.MaximumSpeed = std::max(to.MaximumSpeed, on.MaximumSpeed);
  on.ArcLength += to.ArcLength + way;
  on.MeanVorticity = unite(to.MeanVorticity, on.MeanVorticity);
  for (std::size_t i = 0; i < on.Means.size(); ++i)
  {
    on.Means[i] = unite(to.Means[i], on.Means[i]);
  }
}
}

bool BeyondTrace::Find(const Corners& corners, std::vector<Answer>& answers)
{
  answers.resize(corners.size());
  const std::vector<Streamlines::Velocity> velocities =
    this->Context.Field.GetVelocities(static_cast<vtkIdType>(corners.size()),
      [&](vtkIdType i, double x[3])
      { this->Samples->GetPoint(corners[static_cast<std::size_t>(i)].Sample, x); });
  Rows back;
  Rows on;
  for (std::size_t row = 0; row < corners.size(); ++row)
  {
    this->Describe(corners, row, velocities[row], answers[row], back, on);
  }
  std::vector<AdvectionResult> results(corners.size());
  if (!this->FollowTo(corners, back, true, results) || !this->FollowTo(corners, on, false, results))
  {
    return false;
  }
  for (const std::size_t row : back)
  {
    AdvectionResult& beyond = answers[row].Beyond;
    beyond = results[row];
    beyond.Status =
      this->IsHit(beyond, corners[row]) ? beyond.Status : static_cast<int>(vtkFlowStatus::OUTSIDE);
    beyond.Time = -beyond.Time;
    beyond.ArcLength = -beyond.ArcLength;
  }
  if (!this->FollowOn(corners, on, results, answers))
  {
    return false;
  }
  for (Answer& answer : answers)
  {
    if (answer.Beyond.Status != vtkFlowStatus::REACHED_SURFACE)
    {
      answer.Beyond.Id = -1;
    }
  }
  return true;
}

bool BeyondTrace::TurnToWay(Streamlines::Velocity& velocity) const
{
  for (double& component : velocity.V)
  {
    component = this->Options.IsBackward() ? -component : component;
  }
  const double speed = Vectors::SafeLength(glm::make_vec3(velocity.V));
  return velocity.IsInField && std::isfinite(speed) && speed > this->Options.MinimumSpeed;
}

void BeyondTrace::Describe(const Corners& corners, std::size_t row, Streamlines::Velocity velocity,
  Answer& answer, Rows& back, Rows& on) const
{
  const BeyondCorners::Corner& corner = corners[row];
  answer.Beyond.Means.assign(this->Options.MeanNumbers.size(), 0.0);
  double x[3];
  this->Samples->GetPoint(corner.Sample, x);
  this->Options.Surfaces[static_cast<std::size_t>(corner.Surface)].Shape->EvaluateNormal(
    x, answer.Normal);
  const bool isMoving = this->TurnToWay(velocity);
  answer.IsStill = !isMoving && corner.Distance == 0.0;
  // A streamline along the surface counts as leaving, as in TerminationSide.
  const double speed = vtkMath::Dot(answer.Normal, velocity.V);
  const bool isAway =
    (corner.Distance >= 0.0 && speed >= 0.0) || (corner.Distance <= 0.0 && speed <= 0.0);
  const int side = corner.Distance == 0.0 ? 0 : (corner.Distance < 0.0 ? -1 : 1);
  answer.Side =
    static_cast<signed char>(side * (isAway ? vtkFlowStatus::AWAY : vtkFlowStatus::TOWARDS));
  if (isMoving && side != 0 && isAway)
  {
    back.push_back(row);
  }
  else if (isMoving && corner.IsOtherReached)
  {
    on.push_back(row);
  }
}

bool BeyondTrace::IsHit(const AdvectionResult& result, const BeyondCorners::Corner& corner) const
{
  double x[3];
  this->Samples->GetPoint(corner.Sample, x);
  return result.Status == vtkFlowStatus::REACHED_SURFACE &&
    Vectors::SafeLength(Vectors::Difference(result.Position, x)) <= MostWay * corner.Length;
}

bool BeyondTrace::FollowTo(
  const Corners& corners, const Rows& rows, bool isBack, std::vector<AdvectionResult>& results)
{
  AdvectionOptions options = this->Options;
  options.DomainFaces = false;
  options.MaximumTime = VTK_DOUBLE_MAX;
  options.MaximumNumberOfSteps = MostSteps;
  options.SetBackward(this->Options.IsBackward() != isBack);
  bool goesOn = true;
  for (std::size_t surface = 0; goesOn && surface < this->Options.Surfaces.size(); ++surface)
  {
    Rows own;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
      [&](std::size_t row) { return corners[row].Surface == static_cast<int>(surface); });
    options.Surfaces = { this->Options.Surfaces[surface] };
    goesOn = this->Context.Field.Follow(
      options, static_cast<vtkIdType>(own.size()),
      [&](vtkIdType i, double x[3])
      { this->Samples->GetPoint(corners[own[static_cast<std::size_t>(i)]].Sample, x); },
      [&](vtkIdType i, const AdvectionResult& result)
      { results[own[static_cast<std::size_t>(i)]] = result; },
      this->Context.Progress, this->Context.Progress);
  }
  return goesOn;
}

bool BeyondTrace::FollowOn(const Corners& corners, const Rows& rows,
  const std::vector<AdvectionResult>& before, std::vector<Answer>& answers)
{
  Rows hit;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(hit),
    [&](std::size_t row) { return this->IsHit(before[row], corners[row]); });
  std::vector<Streamlines::Velocity> velocities =
    this->Context.Field.GetVelocities(static_cast<vtkIdType>(hit.size()),
      [&](vtkIdType i, double x[3])
      { std::copy_n(before[hit[static_cast<std::size_t>(i)]].Position, 3, x); });
  struct Start
  {
    std::size_t Row;
    double Way;
    double Time;
    double X[3];
  };
  std::vector<Start> starts;
  for (std::size_t i = 0; i < hit.size(); ++i)
  {
    if (this->TurnToWay(velocities[i]))
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
      answers[start.Row].Beyond = result;
      Join(before[start.Row], start.Way, start.Time, answers[start.Row].Beyond);
    },
    this->Context.Progress, this->Context.Progress);
}

}
