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
 * @brief   traces streamlines through the field of a cell walker, one at a time
 *
 * For the interface of the walker see CellWalker; for the method see
 * Documentation/methods/implicit-flow.md.
 *
 * Integration uses the parametric coordinates of the cell: dp/dt = velocity, or its negative for
 * backward integration. A step may end slightly outside the cell. It is accepted if its error,
 * measured in world space, is at most MaximumError times its duration; MaximumError is raised if it
 * is below the rounding error of the speed. The dense output then cuts the step at the face where
 * it leaves the cell. If the step reaches a termination surface, it is repeated with its end at the
 * surface. The duration of the first step follows from the time to cross the cell and the curvature
 * of the streamline. Each later cell starts with the step duration of the previous cell.
 *
 * At edges and vertices a streamline may cross several faces without advancing in time. After 64
 * such crossings in a row, or a return to the previous cell, the next step starts from the current
 * point without another crossing. A streamline stagnates if its speed is 0 or below MinimumSpeed,
 * or if StagnationTest finds that it no longer makes progress. RecurrenceTest detects closed
 * orbits.
 *
 * A streamline may end at the boundary of the field, by leaving, stagnating or starting there. It
 * then counts as having reached a surface if the surface is within ArrivalTolerance times the cell
 * width, plus the deviation of the face from a plane. Without this tolerance, rounding and the
 * triangulation of a surface made from the field's own faces would decide whether the streamline
 * reaches it.
 *
 * Do not share an object between threads. If the result object is reused, only the constructor
 * allocates memory.
 */
template <typename Walker>
class Advection : private StreamlineState
{
public:
  /// Copies \a field. \a options must outlive this object and must not change.
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
    bool isActive = this->Start(x);
    while (isActive)
    {
      isActive = this->Advance();
    }
    this->Finish(result);
  }

  ///@{
  /// Traces one streamline step by step. Start and Advance return false when the streamline ends.
  /// Finish must then be called.
  bool Start(const double x[3])
  {
    this->Reset(StreamlineState());
    return this->Begin(x);
  }
  bool Advance() { return this->Enter() && this->MakeStep(); }
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
  /// Start and Advance also return false if the streamline enters a cell of another process.
  /// IsOnOtherProcess then returns true, and Finish must not be called. The other process calls
  /// Resume with the saved state instead of Start.
  bool IsOnOtherProcess() const { return this->IsLeaving; }
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
    this->RecordCrossing();
    return this->Field.IsFinite() || this->EndWith(vtkFlowStatus::NOT_FINITE);
  }
  ///@}

  /// Returns the number of steps of the streamline, including rejected ones.
  int GetNumberOfSteps() const { return this->Result.GetNumberOfSteps(); }

  ///@{
  /// Copies the streamline to a SIMD lane, and back to this object. StoreToSimdLane returns false
  /// if SimdDormandPrince cannot take the next step.
  template <typename Steps>
  bool StoreToSimdLane(Steps& steps, int lane) const
  {
    const int maximumSteps = std::min(this->Stagnation.GetStepsLeft(),
      this->Options.MaximumNumberOfSteps - this->GetNumberOfSteps());
    const bool isExplicit = this->Options.Integrator == vtkFlowSettings::DORMAND_PRINCE ||
      (this->Options.Integrator == vtkFlowSettings::AUTOMATIC && !this->Stiffness.IsStiff());
    if (!isExplicit || maximumSteps <= 0 || this->HasIntegrals || this->Recurrence.IsWatching() ||
      this->Step == 0.0 || this->Crossings >= MaximumCrossings || this->ClosedFace >= 0)
    {
      return false;
    }
    steps.Walker.CopyFrom(lane, this->Field);
    for (int i = 0; i < 3; ++i)
    {
      steps.Point[i].Set(lane, this->Point[i]);
    }
    steps.Time.Set(lane, this->Time);
    steps.Step.Set(lane, this->Step);
    steps.PathLength.Set(lane, this->Stagnation.GetPathLength());
    steps.Previous.Set(lane, this->Controller.GetPrevious());
    steps.WasRejected.Set(lane, this->Controller.GetWasRejected() ? 1.0 : 0.0);
    steps.StepsLeft.Set(lane, maximumSteps);
    for (std::size_t i = 0; i < steps.Clearances.size(); ++i)
    {
      steps.Clearances[i].Set(lane, this->Surfaces.GetClearance(i));
    }
    typename Steps::Count& count = steps.Counts[lane];
    count = typename Steps::Count();
    count.MaximumCells = this->Recurrence.GetNextFace() - this->Result.Cells;
    count.From = this->Recurrence.GetFrom();
    count.To = this->Recurrence.GetTo();
    count.HasRate = this->HasPointRate;
    return true;
  }
  /// Returns true if the SIMD lane can continue because only a nearby surface stopped it, and the
  /// exact distance shows that the next step cannot reach the surface. Otherwise call
  /// LoadFromSimdLane.
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
    // With several surfaces, a hit on one shortens the range in which the others are tested.
    // Therefore only a single surface is handled here.
    if (!steps.IsNear(lane) || this->Surfaces.GetNumber() != 1)
    {
      return false;
    }
    const double p[3] = { steps.Point[0].Get(lane), steps.Point[1].Get(lane),
      steps.Point[2].Get(lane) };
    double x[3];
    steps.Walker.GetPosition(lane, p, x);
    if (!this->Surfaces.UpdateClearance(x, steps.GetStepDistance(lane)))
    {
      return false;
    }
    steps.Clearances.front().Set(lane, this->Surfaces.GetClearance(0));
    return true;
  }
  template <typename Steps>
  void LoadFromSimdLane(const Steps& steps, int lane)
  {
    const typename Steps::Count& count = steps.Counts[lane];
    if (count.Steps == 0)
    {
      return;
    }
    this->Field.StandIn(steps.Walker.GetCellLocation(lane));
    for (int i = 0; i < 3; ++i)
    {
      this->Point[i] = steps.Point[i].Get(lane);
    }
    this->Time = steps.Time.Get(lane);
    this->Step = steps.Step.Get(lane);
    this->Controller.Restore(steps.Previous.Get(lane), false);
    this->Stagnation.Restore(steps.PathLength.Get(lane), count.Steps);
    this->Stiffness.AddNonStiff(count.Steps);
    this->HasPointRate = count.HasRate;
    if (this->HasPointRate)
    {
      this->Rate(this->Point, this->PointRate);
      --this->Result.Evaluations;
    }
    this->Result.Steps += count.Steps;
    this->Result.SimdSteps += count.Steps;
    this->Result.Cells += count.Cells;
    this->Result.Evaluations +=
      DormandPrinceStep<double>::NumberOfRates * count.Steps + count.Rates;
    this->Crossings = count.CellBefore >= 0 ? 1 : 0;
    this->CellBefore = count.CellBefore;
  }
  ///@}

private:
  using Measures = StepMeasures<double>;
  static constexpr int MaximumCrossings = 64;
  static constexpr double Epsilon = std::numeric_limits<double>::epsilon();

  void Reset(const StreamlineState& state)
  {
    static_cast<StreamlineState&>(*this) = state;
    this->HasPointRate = false;
    this->ClosedFace = -1;
    this->LeavingFace = -1;
    this->IsLeaving = false;
  }

  /// Stops because another process owns the cell. Always returns false.
  bool LeaveToOtherProcess()
  {
    this->IsLeaving = true;
    return false;
  }

  /// Starts a streamline. Returns false if it ends at its start point.
  bool Begin(const double x[3])
  {
    std::copy(x, x + 3, this->Result.Position);
    if (!this->Field.Locate(x, this->Point))
    {
      return this->EndWith(vtkFlowStatus::OUTSIDE);
    }
    return this->Field.IsHere() ? this->BeginInCell(x) : this->LeaveToOtherProcess();
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
    if (this->Surfaces.GetClearance() <= this->Size && this->ReachesSurfaceAtOuterFace(1e-9))
    {
      return this->EndWith(vtkFlowStatus::REACHED_SURFACE);
    }
    return this->Field.IsFinite() || this->EndWith(vtkFlowStatus::NOT_FINITE);
  }

  /// Returns true if the streamline has reached a surface at a boundary face, which is a face
  /// without a neighbor. The face must be within \a maximumDistance cell widths of the current
  /// point.
  bool ReachesSurfaceAtOuterFace(double maximumDistance)
  {
    for (int face = 0; face < this->Field.GetNumberOfFaces(); ++face)
    {
      if (this->Field.GetFaceDistance(face, this->Point) <= maximumDistance &&
        !this->Field.HasNeighbor(face) && this->ReachesSurfaceAtFace(face))
      {
        return true;
      }
    }
    return false;
  }

  /// Returns true if the streamline has reached a surface at the given boundary face.
  bool ReachesSurfaceAtFace(int face)
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

  /// Returns true if the streamline reached a surface at the boundary of the field.
  bool ReachesSurfaceAtEnd()
  {
    if (this->Result.Status == vtkFlowStatus::STAGNATED)
    {
      return this->ReachesSurfaceAtOuterFace(this->Options.ArrivalTolerance);
    }
    return this->LeavingFace >= 0 && this->ReachesSurfaceAtFace(this->LeavingFace);
  }

  bool EndWith(int status)
  {
    this->Result.Status = status;
    return false;
  }

  void End()
  {
    AdvectionEnd& result = this->Result;
    if (this->ReachesSurfaceAtEnd())
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

  /// Enters the cell in which the streamline continues, and computes the rate there. Returns false
  /// if the streamline ends.
  bool Enter()
  {
    unsigned int closed = 0;
    int leavingFace = -1;
    const auto close = [&](int face)
    {
      closed |= 1U << face;
      leavingFace = leavingFace < 0 ? face : leavingFace;
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
      const bool isHeld = this->Crossings >= MaximumCrossings;
      const int face =
        this->Exit.PrepareSearch(this->Field, this->Point, this->PointRate, isHeld, closed);
      if (face < 0)
      {
        return leavingFace < 0 || this->Leave(leavingFace);
      }
      if (!this->Cross(face))
      {
        close(face);
        continue;
      }
      closed = 0;
      leavingFace = -1;
      if (!this->Field.IsHere())
      {
        return this->LeaveToOtherProcess();
      }
      if (!this->Field.IsFinite())
      {
        return this->EndWith(vtkFlowStatus::NOT_FINITE);
      }
    }
  }

  /// Crosses a face into the neighboring cell. Returns false if there is none.
  bool Cross(int face)
  {
    const vtkIdType from = this->Field.GetCell();
    if (!this->Field.Cross(face, this->Point))
    {
      return false;
    }
    // Prevent endless alternation between two cells, caused by rounding or by velocities that point
    // toward the face on both sides.
    this->Crossings =
      this->Field.GetCell() == this->CellBefore ? MaximumCrossings : this->Crossings + 1;
    this->CellBefore = from;
    this->HasPointRate = false;
    ++this->Result.Cells;
    // If another process owns the cell, it calls RecordCrossing in Resume.
    if (this->Field.IsHere())
    {
      this->RecordCrossing();
    }
    return true;
  }

  /// Records the entry into a cell for the recurrence test if the test needs it.
  void RecordCrossing()
  {
    if (this->Recurrence.IsDue(this->Result.Cells, this->CellBefore, this->Field.GetCell()))
    {
      this->TestForReturn(this->CellBefore);
    }
  }

  void TestForReturn(vtkIdType from)
  {
    double x[3];
    this->Field.GetPosition(this->Point, x);
    this->Recurrence.Enter(this->Result.Cells, from, this->Field.GetCell(), x,
      { static_cast<double>(this->GetNumberOfSteps()), this->Time },
      { static_cast<double>(this->Options.MaximumNumberOfSteps), this->Options.MaximumTime });
  }

  /// Records the step, up to \a end, in the recurrence test, with the distance to the nearest
  /// surface and the maximum drift, which depends on domain faces.
  void WatchReturn(double end)
  {
    double p[3];
    double x[3];
    this->Dense.GetPoint(end, p);
    this->Field.GetPosition(p, x);
    double limit = std::numeric_limits<double>::infinity();
    for (int face = 0; this->Options.DomainFaces && face < this->Field.GetNumberOfFaces(); ++face)
    {
      // A streamline also ends at a domain face. Therefore an orbit that enters a cell with such a
      // face does not count as closed.
      limit = this->Field.GetDomainFace(face) >= 0 ? 0.0 : limit;
    }
    for (int i = 0; this->Options.DomainFaces && i < 3; ++i)
    {
      const double unit[3] = { i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0 };
      limit = std::min(limit, 0.1 * this->GetWorldLength(p, unit));
    }
    this->Recurrence.Watch(x, this->Surfaces.GetMinimumDistance(x), end * this->GetReach(), limit);
  }

  bool Leave(int face)
  {
    this->LeavingFace = face;
    const int domainFace = this->Options.DomainFaces ? this->Field.GetDomainFace(face) : -1;
    if (domainFace < 0)
    {
      return this->EndWith(vtkFlowStatus::LEFT_DOMAIN);
    }
    this->Result.Id = this->Options.DomainFaceId + domainFace;
    this->Field.GetDomainParameters(face, this->Point, this->Result.Parameters);
    return this->EndWith(vtkFlowStatus::REACHED_SURFACE);
  }

  bool MakeStep()
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
      if (this->Stagnation.CompleteWindow(x, this->Time, this->Options.MaximumError))
      {
        return this->EndWith(vtkFlowStatus::STAGNATED);
      }
    }
    switch (this->Options.Integrator)
    {
      case vtkFlowSettings::DORMAND_PRINCE:
        return this->MakeStepWith(this->DormandPrince);
      case vtkFlowSettings::RUNGE_KUTTA_4:
        return this->MakeStepWith(this->RungeKutta4);
      case vtkFlowSettings::ROSENBROCK:
        return this->MakeStepWith(this->Rosenbrock);
      default:
        return this->Stiffness.IsStiff() ? this->MakeStepWith(this->Rosenbrock)
                                         : this->MakeStepWith(this->DormandPrince);
    }
  }

  /// Estimates the duration of the first step.
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
    // The curvature is the relative change of the rate per unit of time. The error is modeled as a
    // power of it. The speed is scaled to about 1, so that no quotient overflows.
    const double scale = MultilinearCell::GetScale(this->Speed);
    const double curvature =
      scale * this->GetWorldLength(this->Point, change) / probe / (scale * this->Speed);
    const double scaled = std::pow(largestError / this->Speed, 1.0 / order);
    return curvature * step > scaled ? scaled / curvature : (curvature >= 0.0 ? step : probe);
  }

  template <typename Method>
  double GetUndampedError(const Method& method, double h) const
  {
    const double transit =
      this->Exit.GetFastest() > 0.0 ? 1.0 / this->Exit.GetFastest() : this->Size / this->Speed;
    bool isOrdinary = true;
    return Measures::GetUndampedError(
      this->Field, this->Point, method, h, std::min(transit, this->Time + h), isOrdinary);
  }

  void PrefetchAhead(int round) const
  {
    if (this->Exit.GetFaceAhead() >= 0)
    {
      this->Field.Prefetch(this->Exit.GetFaceAhead(), round);
    }
  }

  /// Tries one step, which may be rejected. Returns false if the streamline ends.
  template <typename Method>
  bool MakeStepWith(Method& method)
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
    const double ratio = isTaken ? this->GetUndampedError(method, h) / h / largestError
                                 : std::numeric_limits<double>::infinity();
    // If the step is so short that rounding dominates, a shorter step does not reduce the error.
    const double distance = h * Vectors::InfinityNorm(glm::make_vec3(this->PointRate));
    const bool isTiny =
      distance <= 4.0 * Epsilon * Vectors::InfinityNorm(glm::make_vec3(this->Point)) ||
      distance < 1.0 / std::numeric_limits<double>::max();
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
      this->WatchReturn(end);
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
      return this->CrossExitFace(face);
    }
    return this->MoveToStepEnd(method, h, isLast);
  }

  /// Returns a bound on the distance that the step covers. Any fraction of the step covers at most
  /// that fraction of the bound, even with rounding.
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
    return Measures::ReachMargin * this->Field.GetMaximumWorldLength(largest);
  }

  /// Cuts the step at the first surface that it reaches, if any.
  template <typename Method>
  bool MeetsSurface(Method& method, double end, double h)
  {
    if (this->Surfaces.IsEmpty())
    {
      return false;
    }
    auto getPosition = [this](double theta, double x[3])
    {
      double p[3];
      this->Dense.GetPoint(theta, p);
      this->Field.GetPosition(p, x);
    };
    int surface = -1;
    double theta = this->Surfaces.Find(getPosition, end, this->GetReach(), surface);
    if (surface < 0)
    {
      return false;
    }
    // The error control applies only to the end of a step, not to its dense output. Therefore the
    // step is repeated to end at the surface.
    const DenseOutput<double> found = this->Dense;
    const double shorter = theta * h * (1.0 + SurfaceCrossing::Margin);
    if (theta < 1.0 && method.Take(this->Rate, this->Point, this->PointRate, shorter))
    {
      method.GetDenseOutput(this->Dense);
      const double refined = this->Surfaces.Refine(getPosition, surface);
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

  bool CrossExitFace(int face)
  {
    if (!this->Cross(face))
    {
      // The point may be on an edge. The streamline may then continue through another face.
      this->ClosedFace = face;
      return true;
    }
    if (!this->Field.IsHere())
    {
      return this->LeaveToOtherProcess();
    }
    return this->Field.IsFinite() || this->EndWith(vtkFlowStatus::NOT_FINITE);
  }

  /// Moves to the end of a step that stays in the cell.
  template <typename Method>
  bool MoveToStepEnd(const Method& method, double h, bool isLast)
  {
    std::copy(method.End, method.End + 3, this->Point);
    this->HasPointRate = Method::HasEndRate;
    std::copy(method.EndRate, method.EndRate + 3, this->PointRate);
    this->Time = isLast ? this->Options.MaximumTime : this->Time + h;
    return !isLast || this->EndWith(vtkFlowStatus::OUT_OF_TIME);
  }

  // Declared first because of its alignment.
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
  /// Control points of Dense, valid until Dense is cut at a surface.
  double Controls[DenseOutput<double>::MaximumDegree + 1][3];

  double PointRate[3];
  double Speed = 0.0;
  int ClosedFace = -1;
  /// Exit face if the streamline left the field, or -1.
  int LeavingFace = -1;
  bool HasPointRate = false;
  bool HasIntegrals;
  /// True if the streamline continues in another process.
  bool IsLeaving = false;
};

}

#endif
