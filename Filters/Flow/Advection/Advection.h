// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Advection_h
#define interlume_Advection_h

#include "Advection/AdvectionOptions.h"
#include "Advection/AdvectionRate.h"
#include "Advection/AdvectionState.h"
#include "Advection/DormandPrinceStep.h"
#include "Advection/PathIntegrals.h"
#include "Advection/RecurrenceTest.h"
#include "Advection/RosenbrockStep.h"
#include "Advection/RungeKutta4Step.h"
#include "Advection/StagnationTest.h"
#include "Advection/StepController.h"
#include "Advection/StiffnessTest.h"
#include "Advection/StepMeasures.h"
#include "Advection/SurfaceCrossing.h"
#include "Cells/CellExit.h"
#include "Cells/FaceExtent.h"
#include "Cells/MultilinearCell.h"
#include "Common/Vectors.h"
#include "Numerics/DenseOutput.h"

#include "vtkFlowSettings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace interlume
{

/**
 * @class   Advection
 * @brief   follows streamlines of a walker's field, one after another, each to its end
 *
 * The walker is as CellWalker has it, the method as vtkImplicitFlowField has it. Steps are taken
 * in the cell's coordinates, dp/dt = velocity or its negative. A step may end a little outside of
 * the cell; it is accepted when its error, as a vector of world space, is at most MaximumError
 * times the step (or times what rounding leaves of the speed), and then cut by its dense output
 * where it leaves the cell. Where it meets a surface the step is taken once more to there. The
 * first step is from the time through the cell and
 * the bend of the streamline; from then on the step goes on from cell to cell as a time.
 *
 * Faces crossed without time going on, as at edges and corners, are at most 64 in a row, and none
 * of them back: then a step is taken where the streamline stands. A streamline has stagnated where
 * its speed is below the least or 0, and by StagnationTest. It is on a closed orbit by
 * RecurrenceTest.
 *
 * A streamline that ends where the field ends, whether it leaves, stagnates or begins there, has
 * reached a surface that is as near as ArrivalTolerance times the width of the cell there, and as
 * the face is from flat: else rounding, and the triangles of a mesh of the field's own faces, would
 * decide.
 *
 * One object serves one thread. Nothing is allocated but by the constructor, if the result is used
 * again.
 */
template <typename Walker>
class Advection : private StreamlineState
{
public:
  /// Makes an advection on a copy of \a field. \a options must not change while it is used.
  Advection(const Walker& field, const AdvectionOptions& options)
    : Field(field)
    , Options(options)
    , Rate(Field, options.IsBackward(), this->Result)
    , Surfaces(options.Surfaces)
    , Integrals(options)
    , HasIntegrals(!this->Integrals.IsEmpty())
  {
  }
  Advection(const Advection&) = delete;
  void operator=(const Advection&) = delete;

  void Follow(const double x[3], AdvectionResult& result)
  {
    bool goesOn = this->Start(x);
    while (goesOn)
    {
      goesOn = this->GoStep();
    }
    this->Finish(result);
  }

  ///@{
  /// Follows one streamline step by step: Start and GoStep return false where it ends, and then
  /// Finish is called.
  bool Start(const double x[3])
  {
    this->Reset(StreamlineState());
    return this->Begin(x);
  }
  bool GoStep() { return this->Enter() && this->TakeStep(); }
  void Finish(AdvectionResult& result)
  {
    this->End();
    static_cast<AdvectionEnd&>(result) = this->Result;
    result.Means.assign(this->Options.MeanNumbers.size(), 0.0);
    if (this->HasIntegrals && result.Status != vtkFlowStatus::OUTSIDE)
    {
      this->Integrals.End(this->Field, this->Point, result);
    }
  }
  ///@}

  ///@{
  /// Start and GoStep return false too where another process has to go on, in a cell that is not
  /// here. Finish is not called then; the other process resumes the streamline from its state, as
  /// Start begins one.
  bool IsElsewhere() const { return this->Elsewhere; }
  void Save(AdvectionState& state) const
  {
    state.Values = *this;
    state.Values.Cell = this->Field.GetCell();
    state.Numbers.clear();
    this->Surfaces.Save(state.Numbers);
    this->Integrals.Save(state.Numbers);
  }
  bool Resume(const AdvectionState& state)
  {
    this->Reset(state.Values);
    this->Field.GoTo(this->Cell);
    if (this->IsAtStart)
    {
      return this->BeginInCell(this->Result.Position);
    }
    this->Integrals.Restore(this->Surfaces.Restore(state.Numbers.data()));
    this->NoteCrossing();
    return this->Field.IsFinite() || this->EndWith(vtkFlowStatus::NOT_FINITE);
  }
  ///@}

  /// Returns the number of steps of the streamline, rejected ones too.
  int GetNumberOfSteps() const { return this->Result.GetNumberOfSteps(); }

  ///@{
  /// Hands the streamline over to a lane that goes on with it, if the next steps may be those that
  /// LaneSteps takes, and takes it back.
  template <typename Steps>
  bool GiveTo(Steps& steps, int lane) const
  {
    const int most = std::min(this->Stagnation.GetStepsLeft(),
      this->Options.MaximumNumberOfSteps - this->GetNumberOfSteps());
    const bool isExplicit = this->Options.Integrator == vtkFlowSettings::DORMAND_PRINCE ||
      (this->Options.Integrator == vtkFlowSettings::AUTOMATIC && !this->Stiffness.IsStiff());
    if (!isExplicit || most <= 0 || this->HasIntegrals || this->Recurrence.IsWatching() ||
      this->Step == 0.0 || this->Crossings >= MostCrossings || this->ClosedFace >= 0)
    {
      return false;
    }
    steps.Walker.StandAs(lane, this->Field);
    for (int i = 0; i < 3; ++i)
    {
      steps.Point[i].Set(lane, this->Point[i]);
    }
    steps.Time.Set(lane, this->Time);
    steps.Step.Set(lane, this->Step);
    steps.Way.Set(lane, this->Stagnation.GetWay());
    steps.Previous.Set(lane, this->Controller.GetPrevious());
    steps.WasRejected.Set(lane, this->Controller.GetWasRejected() ? 1.0 : 0.0);
    steps.StepsLeft.Set(lane, most);
    for (std::size_t i = 0; i < steps.Clearances.size(); ++i)
    {
      steps.Clearances[i].Set(lane, this->Surfaces.GetClearance(i));
    }
    typename Steps::Count& count = steps.Counts[lane];
    count = typename Steps::Count();
    count.MostCells = this->Recurrence.GetNextFace() - this->Result.Cells;
    count.From = this->Recurrence.GetFrom();
    count.To = this->Recurrence.GetTo();
    count.HasRate = this->HasPointRate;
    return true;
  }
  /// Returns whether the next step meets no surface after all, where that was all that kept a lane
  /// from it, so that the lane goes on. Else TakeFrom is to be called.
  template <typename Steps>
  bool IsClear(Steps& steps, int lane)
  {
    if (steps.Counts[lane].Steps > 0)
    {
      for (std::size_t i = 0; i < steps.Clearances.size(); ++i)
      {
        this->Surfaces.RestoreClearance(i, steps.Clearances[i].Get(lane));
      }
    }
    // Of several surfaces the first that is met decides which others are looked at.
    if (!steps.IsNear(lane) || this->Surfaces.GetNumber() != 1)
    {
      return false;
    }
    const double p[3] = { steps.Point[0].Get(lane), steps.Point[1].Get(lane),
      steps.Point[2].Get(lane) };
    double x[3];
    steps.Walker.GetPosition(lane, p, x);
    if (!this->Surfaces.Renew(x, steps.GetWay(lane)))
    {
      return false;
    }
    steps.Clearances.front().Set(lane, this->Surfaces.GetClearance(0));
    return true;
  }
  template <typename Steps>
  void TakeFrom(const Steps& steps, int lane)
  {
    const typename Steps::Count& count = steps.Counts[lane];
    if (count.Steps == 0)
    {
      return;
    }
    this->Field.StandIn(steps.Walker.GetPlace(lane));
    for (int i = 0; i < 3; ++i)
    {
      this->Point[i] = steps.Point[i].Get(lane);
    }
    this->Time = steps.Time.Get(lane);
    this->Step = steps.Step.Get(lane);
    this->Controller.Restore(steps.Previous.Get(lane), false);
    this->Stagnation.Restore(steps.Way.Get(lane), count.Steps);
    this->Stiffness.AddHarmless(count.Steps);
    this->HasPointRate = count.HasRate;
    if (this->HasPointRate)
    {
      this->Rate(this->Point, this->PointRate);
      --this->Result.Evaluations;
    }
    this->Result.Steps += count.Steps;
    this->Result.LaneSteps += count.Steps;
    this->Result.Cells += count.Cells;
    this->Result.Evaluations +=
      DormandPrinceStep<double>::NumberOfRates * count.Steps + count.Rates;
    this->Crossings = count.CellBefore >= 0 ? 1 : 0;
    this->CellBefore = count.CellBefore;
  }
  ///@}

private:
  using Measures = StepMeasures<double>;
  static constexpr int MostCrossings = 64;
  static constexpr double Epsilon = std::numeric_limits<double>::epsilon();

  void Reset(const StreamlineState& state)
  {
    static_cast<StreamlineState&>(*this) = state;
    this->HasPointRate = false;
    this->ClosedFace = -1;
    this->FaceLeft = -1;
    this->Elsewhere = false;
  }

  /// Leaves the streamline to the process that has the cell.
  bool GoElsewhere()
  {
    this->Elsewhere = true;
    return false;
  }

  /// Begins a streamline. Returns false where it ends at its start.
  bool Begin(const double x[3])
  {
    std::copy(x, x + 3, this->Result.Position);
    if (!this->Field.Locate(x, this->Point))
    {
      return this->EndWith(vtkFlowStatus::OUTSIDE);
    }
    return this->Field.IsHere() ? this->BeginInCell(x) : this->GoElsewhere();
  }

  bool BeginInCell(const double x[3])
  {
    this->IsAtStart = false;
    this->Result.Cells = 1;
    this->Integrals.Begin();
    this->Stagnation.Begin(x);
    this->Size = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double unit[3] = { i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0 };
      this->Size = std::max(this->Size, this->GetWorldLength(this->Point, unit));
    }
    const int surface = this->Surfaces.Begin(x, this->Size);
    if (surface >= 0)
    {
      this->Surfaces.GetResult(surface, x, this->Result);
      return this->EndWith(vtkFlowStatus::REACHED_SURFACE);
    }
    if (this->Surfaces.GetClearance() <= this->Size && this->ArrivesAtOuterFace(1e-9))
    {
      return this->EndWith(vtkFlowStatus::REACHED_SURFACE);
    }
    return this->Field.IsFinite() || this->EndWith(vtkFlowStatus::NOT_FINITE);
  }

  /// Returns whether the streamline, where it stands, is at a surface as it is at the end of the
  /// field: within \a most, in widths of the cell, of a face that has no neighbour.
  bool ArrivesAtOuterFace(double most)
  {
    for (int face = 0; face < this->Field.GetNumberOfFaces(); ++face)
    {
      if (this->Field.GetFaceDistance(face, this->Point) <= most &&
        !this->Field.HasNeighbor(face) && this->Arrives(face))
      {
        return true;
      }
    }
    return false;
  }

  /// Returns whether the streamline is at a surface as it is at one such face.
  bool Arrives(int face)
  {
    if (this->Surfaces.IsEmpty() || !(this->Options.ArrivalTolerance > 0.0))
    {
      return false;
    }
    const FaceExtent extent = this->Field.GetFaceExtent(face);
    const double tolerance = this->Options.ArrivalTolerance * extent.Width + 1.01 * extent.Bend;
    double x[3];
    this->Field.GetPosition(this->Point, x);
    double direction[3] = { 0.0, 0.0, 0.0 };
    if (this->HasPointRate && this->Speed > 0.0)
    {
      this->Field.GetWorldVector(this->Point, this->PointRate, direction);
      for (double& component : direction)
      {
        component /= this->Speed;
      }
    }
    const int surface = this->Surfaces.FindNear(x, tolerance, extent.Normal, direction);
    if (surface < 0)
    {
      return false;
    }
    this->Surfaces.GetResult(surface, x, this->Result);
    this->Result.Nearness = tolerance;
    return true;
  }

  /// Returns whether the streamline ended at a surface, at the end of the field.
  bool ArrivesAtEnd()
  {
    if (this->Result.Status == vtkFlowStatus::STAGNATED)
    {
      return this->ArrivesAtOuterFace(this->Options.ArrivalTolerance);
    }
    return this->FaceLeft >= 0 && this->Arrives(this->FaceLeft);
  }

  bool EndWith(int status)
  {
    this->Result.Status = status;
    return false;
  }

  void End()
  {
    AdvectionEnd& result = this->Result;
    if (this->ArrivesAtEnd())
    {
      result.Status = vtkFlowStatus::REACHED_SURFACE;
    }
    result.Time = this->Time;
    if (result.Status != vtkFlowStatus::OUTSIDE)
    {
      if (this->Time > 0.0)
      {
        this->Field.GetPosition(this->Point, result.Position);
      }
      result.DistanceEvaluations = this->Surfaces.GetNumberOfEvaluations();
    }
  }

  double GetWorldLength(const double p[3], const double d[3]) const
  {
    double world[3];
    this->Field.GetWorldVector(p, d, world);
    return Vectors::SafeLength(glm::make_vec3(world));
  }

  /// Enters the cell that the streamline goes on in, and computes the rate there. Returns false
  /// where the streamline ends.
  bool Enter()
  {
    unsigned int closed = 0;
    int way = -1;
    const auto close = [&](int face)
    {
      closed |= 1U << face;
      way = way < 0 ? face : way;
    };
    if (this->ClosedFace >= 0)
    {
      close(this->ClosedFace);
      this->ClosedFace = -1;
    }
    while (true)
    {
      if (!this->HasPointRate)
      {
        this->Rate(this->Point, this->PointRate);
        this->HasPointRate = true;
      }
      this->Speed = this->GetWorldLength(this->Point, this->PointRate);
      if (!std::isfinite(this->Speed))
      {
        return this->EndWith(vtkFlowStatus::NOT_FINITE);
      }
      if (this->Speed < this->Options.MinimumSpeed || this->Speed == 0.0)
      {
        return this->EndWith(vtkFlowStatus::STAGNATED);
      }
      const bool isHeld = this->Crossings >= MostCrossings;
      const int face =
        this->Exit.Approach(this->Field, this->Point, this->PointRate, isHeld, closed);
      if (face < 0)
      {
        return way < 0 || this->Leave(way);
      }
      if (!this->Cross(face))
      {
        close(face);
        continue;
      }
      closed = 0;
      way = -1;
      if (!this->Field.IsHere())
      {
        return this->GoElsewhere();
      }
      if (!this->Field.IsFinite())
      {
        return this->EndWith(vtkFlowStatus::NOT_FINITE);
      }
    }
  }

  /// Crosses a face into the neighbour. Returns false where there is none.
  bool Cross(int face)
  {
    const vtkIdType from = this->Field.GetCell();
    if (!this->Field.Cross(face, this->Point))
    {
      return false;
    }
    // Going back and forth between two cells would never end: it comes of rounding, or of a field
    // that meets itself in the face.
    this->Crossings =
      this->Field.GetCell() == this->CellBefore ? MostCrossings : this->Crossings + 1;
    this->CellBefore = from;
    this->HasPointRate = false;
    ++this->Result.Cells;
    // Where another process has the cell, that looks.
    if (this->Field.IsHere())
    {
      this->NoteCrossing();
    }
    return true;
  }

  /// Looks for a return where the streamline has come into the cell, if that is due.
  void NoteCrossing()
  {
    if (this->Recurrence.IsDue(this->Result.Cells, this->CellBefore, this->Field.GetCell()))
    {
      this->LookForReturn(this->CellBefore);
    }
  }

  void LookForReturn(vtkIdType from)
  {
    double x[3];
    this->Field.GetPosition(this->Point, x);
    this->Recurrence.Enter(this->Result.Cells, from, this->Field.GetCell(), x,
      { static_cast<double>(this->GetNumberOfSteps()), this->Time },
      { static_cast<double>(this->Options.MaximumNumberOfSteps), this->Options.MaximumTime });
  }

  /// Watches for a return, with the distance of the streamline from its possible ends, after a step
  /// within the cell.
  void WatchForReturn(double end)
  {
    double p[3];
    double x[3];
    this->Dense.GetPoint(end, p);
    this->Field.GetPosition(p, x);
    double limit = std::numeric_limits<double>::infinity();
    for (int face = 0; this->Options.DomainFaces && face < this->Field.GetNumberOfFaces(); ++face)
    {
      // A streamline that leaves the domain ends too: an orbit stays a cell away from there.
      limit = this->Field.GetDomainFace(face) >= 0 ? 0.0 : limit;
    }
    for (int i = 0; this->Options.DomainFaces && i < 3; ++i)
    {
      const double unit[3] = { i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0 };
      limit = std::min(limit, 0.1 * this->GetWorldLength(p, unit));
    }
    this->Recurrence.Watch(x, this->Surfaces.GetLeastDistance(x), end * this->GetReach(), limit);
  }

  bool Leave(int face)
  {
    this->FaceLeft = face;
    const int domainFace = this->Options.DomainFaces ? this->Field.GetDomainFace(face) : -1;
    if (domainFace < 0)
    {
      return this->EndWith(vtkFlowStatus::LEFT_DOMAIN);
    }
    this->Result.Id = this->Options.DomainFaceId + domainFace;
    this->Field.GetDomainParameters(face, this->Point, this->Result.Parameters);
    return this->EndWith(vtkFlowStatus::REACHED_SURFACE);
  }

  bool TakeStep()
  {
    if (this->Recurrence.IsClosed())
    {
      return this->EndWith(vtkFlowStatus::CLOSED_ORBIT);
    }
    if (this->GetNumberOfSteps() >= this->Options.MaximumNumberOfSteps)
    {
      return this->EndWith(vtkFlowStatus::OUT_OF_STEPS);
    }
    if (this->Stagnation.IsDue())
    {
      double x[3];
      this->Field.GetPosition(this->Point, x);
      if (this->Stagnation.Look(x, this->Time, this->Options.MaximumError))
      {
        return this->EndWith(vtkFlowStatus::STAGNATED);
      }
    }
    switch (this->Options.Integrator)
    {
      case vtkFlowSettings::DORMAND_PRINCE:
        return this->TakeStepBy(this->DormandPrince);
      case vtkFlowSettings::RUNGE_KUTTA_4:
        return this->TakeStepBy(this->RungeKutta4);
      case vtkFlowSettings::ROSENBROCK:
        return this->TakeStepBy(this->Rosenbrock);
      default:
        return this->Stiffness.IsStiff() ? this->TakeStepBy(this->Rosenbrock)
                                         : this->TakeStepBy(this->DormandPrince);
    }
  }

  /// Guesses the length of the first step.
  double GuessStep(double largestError, int order)
  {
    const double fastest = Vectors::InfinityNorm(glm::make_vec3(this->PointRate));
    double step = this->Exit.GetTimeLimit();
    if (!std::isfinite(step))
    {
      step = std::max(1.0, Vectors::InfinityNorm(glm::make_vec3(this->Point))) / fastest;
    }
    const double probe = 0.01 * step;
    double ahead[3];
    double change[3];
    for (int i = 0; i < 3; ++i)
    {
      ahead[i] = this->Point[i] + probe * this->PointRate[i];
    }
    this->Rate(ahead, change);
    for (int i = 0; i < 3; ++i)
    {
      change[i] -= this->PointRate[i];
    }
    // The relative change of the rate per unit of time, taken as if the error were made of its
    // powers.
    // At a speed of about 1, so that none of the quotients overflows.
    const double scale = MultilinearCell::GetScale(this->Speed);
    const double bend =
      scale * this->GetWorldLength(this->Point, change) / probe / (scale * this->Speed);
    const double scaled = std::pow(largestError / this->Speed, 1.0 / order);
    return bend * step > scaled ? scaled / bend : (bend >= 0.0 ? step : probe);
  }

  template <typename Method>
  double GetLastingError(const Method& method, double h) const
  {
    const double transit =
      this->Exit.GetFastest() > 0.0 ? 1.0 / this->Exit.GetFastest() : this->Size / this->Speed;
    bool isOrdinary = true;
    return Measures::GetLastingError(
      this->Field, this->Point, method, h, std::min(transit, this->Time + h), isOrdinary);
  }

  void PrefetchAhead(int round) const
  {
    if (this->Exit.GetFaceAhead() >= 0)
    {
      this->Field.Prefetch(this->Exit.GetFaceAhead(), round);
    }
  }

  /// Takes one step, accepted or not. Returns false where the streamline ends.
  template <typename Method>
  bool TakeStepBy(Method& method)
  {
    constexpr bool isStiff = std::is_same_v<Method, RosenbrockStep>;
    const double largestError = std::max(this->Options.MaximumError, 64.0 * Epsilon * this->Speed);
    if (this->Step == 0.0)
    {
      this->Step = this->GuessStep(largestError, Method::ErrorOrder);
    }
    const double remaining = this->Options.MaximumTime - this->Time;
    double h = std::min(this->Step, this->Exit.GetTimeLimit());
    const bool isLast = h >= remaining;
    h = isLast ? remaining : h;

    this->PrefetchAhead(0);
    const bool isTaken = method.Take(this->Rate, this->Point, this->PointRate, h);
    this->PrefetchAhead(1);
    const double ratio = isTaken ? this->GetLastingError(method, h) / h / largestError
                                 : std::numeric_limits<double>::infinity();
    // A step whose way is nearly lost in rounding does not get better when it is shorter.
    const double way = h * Vectors::InfinityNorm(glm::make_vec3(this->PointRate));
    const bool isTiny = way <= 4.0 * Epsilon * Vectors::InfinityNorm(glm::make_vec3(this->Point)) ||
      way < 1.0 / std::numeric_limits<double>::max();
    if (!(ratio <= 1.0) && !(isTaken && isTiny))
    {
      ++(isStiff ? this->Result.RejectedStiffSteps : this->Result.RejectedSteps);
      this->Step = h * this->Controller.Reject(ratio, Method::ErrorOrder);
      return !isTiny || this->EndWith(vtkFlowStatus::NOT_FINITE);
    }

    method.GetDenseOutput(this->Dense);
    this->Dense.GetControlPoints(this->Controls);
    int face = -1;
    bool isFar = false;
    const double exit =
      this->Exit.Find(this->Field, this->Controls, this->Dense.Degree, face, isFar);
    if (isFar && face >= 0 && !isTiny)
    {
      ++(isStiff ? this->Result.RejectedStiffSteps : this->Result.RejectedSteps);
      this->Step = h * std::min(0.9, std::max(0.1, 1.1 * exit));
      return true;
    }
    ++(isStiff ? this->Result.StiffSteps : this->Result.Steps);
    const double factor = this->Controller.Accept(ratio, Method::ErrorOrder);
    this->Step = StepController::GetNext(this->Step, h, factor, ratio);
    if constexpr (!std::is_same_v<Method, RungeKutta4Step>)
    {
      this->Stiffness.Add(method.GetStiffness());
    }

    const double end = face >= 0 ? exit : 1.0;
    if (this->MeetsSurface(method, end, h))
    {
      return this->EndWith(vtkFlowStatus::REACHED_SURFACE);
    }
    if (this->HasIntegrals)
    {
      this->Integrals.Add(this->Field, this->Dense, end, h);
    }
    if (this->Recurrence.IsWatching())
    {
      this->WatchForReturn(end);
    }
    this->Stagnation.Add(this->Speed * end * h);
    if (end * h * this->Exit.GetFastest() > CellExit<Walker>::Tolerance)
    {
      this->Crossings = 0;
      this->CellBefore = -1;
    }
    if (face >= 0)
    {
      this->Time += end * h;
      this->Dense.GetPoint(end, this->Point);
      this->HasPointRate = false;
      return this->GoThrough(face);
    }
    return this->GoOn(method, h, isLast);
  }

  /// Returns how far the step can go: no part of it goes farther than its share of this, whatever
  /// the rounding.
  double GetReach() const
  {
    if (this->Field.IsAffine())
    {
      bool isOrdinary = true;
      return Measures::GetAffineReach(
        this->Field, this->Point, this->Dense, this->Controls, isOrdinary);
    }
    double largest[3] = { 0.0, 0.0, 0.0 };
    for (int j = 0; j < this->Dense.Degree; ++j)
    {
      double slope[3];
      this->Dense.GetSlope(this->Controls, j, slope);
      for (int i = 0; i < 3; ++i)
      {
        largest[i] = std::max(largest[i], std::abs(slope[i]));
      }
    }
    return Measures::ReachMargin * this->Field.GetLongestWorldVector(largest);
  }

  /// Cuts the step at the first surface that it meets, if it meets one.
  template <typename Method>
  bool MeetsSurface(Method& method, double end, double h)
  {
    if (this->Surfaces.IsEmpty())
    {
      return false;
    }
    auto place = [this](double theta, double x[3])
    {
      double p[3];
      this->Dense.GetPoint(theta, p);
      this->Field.GetPosition(p, x);
    };
    int surface = -1;
    double theta = this->Surfaces.Find(place, end, this->GetReach(), surface);
    if (surface < 0)
    {
      return false;
    }
    // A step that ends at the surface has the error that is controlled, which a dense output need
    // not have.
    const DenseOutput<double> found = this->Dense;
    const double shorter = theta * h * (1.0 + SurfaceCrossing::Margin);
    if (theta < 1.0 && method.Take(this->Rate, this->Point, this->PointRate, shorter))
    {
      method.GetDenseOutput(this->Dense);
      const double refined = this->Surfaces.Refine(place, surface);
      theta = refined <= 1.0 ? refined : theta;
      h = refined <= 1.0 ? shorter : h;
      this->Dense = refined <= 1.0 ? this->Dense : found;
    }
    if (this->HasIntegrals)
    {
      this->Integrals.Add(this->Field, this->Dense, theta, h);
    }
    this->Time = std::min(this->Options.MaximumTime, this->Time + theta * h);
    this->Dense.GetPoint(theta, this->Point);
    double x[3];
    this->Field.GetPosition(this->Point, x);
    this->Surfaces.GetResult(surface, x, this->Result);
    return true;
  }

  bool GoThrough(int face)
  {
    if (!this->Cross(face))
    {
      // At an edge another face may lead on.
      this->ClosedFace = face;
      return true;
    }
    if (!this->Field.IsHere())
    {
      return this->GoElsewhere();
    }
    return this->Field.IsFinite() || this->EndWith(vtkFlowStatus::NOT_FINITE);
  }

  /// Goes to the end of a step within the cell.
  template <typename Method>
  bool GoOn(const Method& method, double h, bool isLast)
  {
    std::copy(method.End, method.End + 3, this->Point);
    this->HasPointRate = Method::HasEndRate;
    std::copy(method.EndRate, method.EndRate + 3, this->PointRate);
    this->Time = isLast ? this->Options.MaximumTime : this->Time + h;
    return !isLast || this->EndWith(vtkFlowStatus::OUT_OF_TIME);
  }

  // The walker comes first, since it is aligned.
  Walker Field;
  const AdvectionOptions& Options;
  AdvectionRate<Walker> Rate;
  SurfaceCrossing Surfaces;
  PathIntegrals<Walker> Integrals;
  CellExit<Walker> Exit;
  DormandPrinceStep<double> DormandPrince;
  RungeKutta4Step RungeKutta4;
  RosenbrockStep Rosenbrock;
  DenseOutput<double> Dense;
  /// The control points of Dense, while Dense is the whole step.
  double Controls[DenseOutput<double>::MaximumDegree + 1][3];

  double PointRate[3];
  double Speed = 0.0;
  int ClosedFace = -1;
  /// The face by which the streamline left the field.
  int FaceLeft = -1;
  bool HasPointRate = false;
  bool HasIntegrals;
  /// Whether another process has to go on.
  bool Elsewhere = false;
};

}

#endif
