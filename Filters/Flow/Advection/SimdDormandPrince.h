// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimdDormandPrince_h
#define interlume_SimdDormandPrince_h

#include "Advection/AdvectionOptions.h"
#include "Advection/DormandPrinceStep.h"
#include "Advection/StepController.h"
#include "Advection/StepMeasures.h"
#include "Advection/StiffnessTest.h"
#include "Cells/BoxExit.h"
#include "Numerics/NumberMath.h"

#include "vtkType.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace interlume
{

/**
 * @class   SimdDormandPrince
 * @brief   Dormand-Prince steps for several streamlines at once
 *
 * A step includes everything that Advection does between two calls of its Enter function in the
 * ordinary case: the step is accepted, reaches no surface, and remains in the cell or crosses one
 * face. The result is bit-identical to that of Advection. In all other cases the SIMD lane remains
 * unchanged, and Advection takes the step. For the interface of \a SimdWalker see SimdBoxWalker.
 */
template <typename SimdWalker>
class SimdDormandPrince
{
public:
  using SimdPack = typename SimdWalker::SimdPack;
  using Mask = typename SimdPack::Mask;

  SimdDormandPrince(const SimdWalker& walker, const AdvectionOptions& options)
    : Walker(walker)
    , Clearances(options.Surfaces.size(), SimdPack::Of(0.0))
    , Sign(options.IsBackward() ? -1.0 : 1.0)
    , MaximumError(SimdPack::Of(options.MaximumError))
    , MaximumTime(SimdPack::Of(options.MaximumTime))
    , MinimumSpeed(options.MinimumSpeed)
    , ClearancesLeft(options.Surfaces.size(), SimdPack::Of(0.0))
  {
    for (SimdPack& p : this->Point)
    {
      p = SimdPack::Of(0.5);
    }
  }

  /// Takes steps in the lanes whose bits are set in \a lanes until at least one of them cannot
  /// continue. Returns the bits of the lanes that cannot continue.
  [[gnu::always_inline]] unsigned int Take(unsigned int lanes)
  {
    unsigned int taken = lanes;
    while (taken == lanes)
    {
      taken = this->MakeOneStep(lanes);
    }
    return lanes & ~taken;
  }

  ///@{
  /// IsNear returns true if the lane's last step was rejected only because it may reach a surface.
  /// GetStepDistance returns a bound on the length of that step.
  bool IsNear(int lane) const { return (this->Near >> lane & 1U) != 0; }
  double GetStepDistance(int lane) const { return this->StepDistance.Get(lane); }
  ///@}

  ///@{
  /// State of each streamline between two steps.
  SimdWalker Walker;
  SimdPack Point[3];
  SimdPack Time = SimdPack::Of(0.0);
  SimdPack Step = SimdPack::Of(1.0);
  SimdPack PathLength = SimdPack::Of(0.0);
  SimdPack Previous = SimdPack::Of(StepController::MinimumPrevious);
  /// 1 after a rejected step, otherwise 0.
  SimdPack WasRejected = SimdPack::Of(0.0);
  /// Number of steps before Advection must take over.
  SimdPack StepsLeft = SimdPack::Of(0.0);
  std::vector<SimdPack> Clearances;
  ///@}

  /// Counters since the streamline was copied to the SIMD lane, and their limits.
  struct Count
  {
    int Steps = 0;
    int Cells = 0;
    /// Number of steps whose first rate was not already computed by the previous step.
    int Rates = 0;
    vtkIdType MaximumCells = 0;
    /// Cells on both sides of the face that RecurrenceTest stores.
    vtkIdType From = -1;
    vtkIdType To = -1;
    /// Cell before the last crossing, or -1.
    vtkIdType CellBefore = -1;
    bool HasRate = false;
  };
  Count Counts[SimdPack::Number];

private:
  using Math = NumberMath<SimdPack>;
  using Measures = StepMeasures<SimdPack>;
  static constexpr double Epsilon = std::numeric_limits<double>::epsilon();

  /// Tentative step of each lane.
  struct Trial
  {
    SimdPack H;
    SimdPack Ratio;
    SimdPack Speed;
    /// Fraction of the step up to the exit face, or 1 if the step remains in the cell.
    SimdPack End;
    SimdPack Face;
    Mask Leaves;
    DormandPrinceStep<SimdPack> Method;
    DenseOutput<SimdPack> Dense;
  };

  [[gnu::always_inline]] void GetRate(const SimdPack p[3], SimdPack rate[3]) const
  {
    this->Walker.GetVelocity(p, rate);
    for (int i = 0; i < 3; ++i)
    {
      rate[i] = this->Sign * rate[i];
    }
  }

  /// Returns a mask of the steps that are certainly not stiff.
  [[gnu::always_inline]] static Mask IsNonStiff(const Trial& trial)
  {
    SimdPack direction[3];
    SimdPack changes[3];
    trial.Method.GetEndDifference(direction, changes);
    for (SimdPack& change : changes)
    {
      // The squares of unscaled rates may overflow.
      change = trial.H * change;
    }
    constexpr double maximum = 0.99 * StiffnessTest::MinimumStiff * StiffnessTest::MinimumStiff;
    return Math::Dot(changes, changes) <= maximum * Math::Dot(direction, direction);
  }

  /// Tries a step in each SIMD lane. Returns a mask of the ordinary steps.
  [[gnu::always_inline]] Mask Try(Trial& trial)
  {
    SimdPack rate[3];
    SimdPack world[3];
    this->GetRate(this->Point, rate);
    this->Walker.GetWorldVector(this->Point, rate, world);
    const SimdPack squaredSpeed = Math::Dot(world, world);
    trial.Speed = SimdPack::Sqrt(squaredSpeed);
    Mask isUsual = Measures::IsOrdinary(squaredSpeed) & ~(trial.Speed < this->MinimumSpeed);

    BoxExit<SimdPack> exit;
    isUsual &= exit.PrepareSearch(this->Point, rate);
    trial.H = SimdPack::Min(this->Step, exit.TimeLimit);
    isUsual &= trial.H < this->MaximumTime - this->Time;
    for (int lane = 0; lane < SimdPack::Number; ++lane)
    {
      this->Walker.Prefetch(lane, static_cast<int>(exit.FaceAhead.Get(lane)));
    }
    const auto getRate = [this](const SimdPack* p, SimdPack* k) { this->GetRate(p, k); };
    trial.Method.Take(getRate, this->Point, rate, trial.H);
    isUsual &= SimdDormandPrince::IsNonStiff(trial);
    const SimdPack time = SimdPack::Min(1.0 / exit.Fastest, this->Time + trial.H);
    const SimdPack error =
      Measures::GetUndampedError(this->Walker, this->Point, trial.Method, trial.H, time, isUsual);
    const SimdPack largestError = SimdPack::Max(this->MaximumError, 64.0 * Epsilon * trial.Speed);
    trial.Ratio = error / trial.H / largestError;
    isUsual &= trial.Ratio <= 1.0;

    trial.Method.GetDenseOutput(trial.Dense);
    SimdPack controls[DenseOutput<SimdPack>::MaximumDegree + 1][3];
    trial.Dense.GetControlPoints(controls);
    SimdPack first;
    isUsual &= exit.Find(controls, trial.Dense.Degree, first, trial.Face);
    trial.Leaves = trial.Face > -0.5;
    trial.End = SimdPack::Select(trial.Leaves, first, SimdPack::Of(1.0));
    isUsual &= trial.End * trial.H * exit.Fastest > BoxExit<SimdPack>::Tolerance;
    isUsual &= SimdPack::Of(0.0) < this->StepsLeft;
    return this->Clearances.empty() ? isUsual : this->IsClear(trial, controls, isUsual);
  }

  /// Returns a mask of the ordinary steps that cannot reach a surface.
  [[gnu::always_inline]] Mask IsClear(
    const Trial& trial, const SimdPack (*controls)[3], const Mask& usual)
  {
    Mask isUsual = usual;
    this->StepDistance = trial.End *
      Measures::GetAffineReach(this->Walker, this->Point, trial.Dense, controls, isUsual);
    Mask isClear = isUsual;
    for (std::size_t i = 0; i < this->Clearances.size(); ++i)
    {
      isClear &= this->StepDistance < this->Clearances[i];
      this->ClearancesLeft[i] = this->Clearances[i] - this->StepDistance;
    }
    this->Near = SimdPack::GetBits(isUsual & ~isClear);
    return isClear;
  }

  /// Takes one step. Returns the bits of the lanes that took it.
  [[gnu::always_inline]] unsigned int MakeOneStep(unsigned int lanes)
  {
    Trial trial;
    lanes &= SimdPack::GetBits(this->Try(trial));
    const unsigned int leaving = SimdPack::GetBits(trial.Leaves);
    const unsigned int crossing = this->Cross(lanes & leaving, trial.Face);
    lanes &= ~leaving | crossing;
    this->Commit(trial, SimdPack::GetMask(lanes));
    for (int lane = 0; lane < SimdPack::Number; ++lane)
    {
      if (lanes >> lane & 1U)
      {
        Count& count = this->Counts[lane];
        const bool isCrossing = crossing >> lane & 1U;
        ++count.Steps;
        count.Rates += count.HasRate ? 0 : 1;
        count.Cells += isCrossing ? 1 : 0;
        count.HasRate = !isCrossing;
        count.CellBefore = isCrossing ? this->CellsLeft[lane] : -1;
      }
    }
    return lanes;
  }

  /// Moves the lanes selected by \a isTaken to the end of the step.
  [[gnu::always_inline]] void Commit(const Trial& trial, const Mask& isTaken)
  {
    const auto set = [&isTaken](SimdPack& number, const SimdPack& next)
    { number = SimdPack::Select(isTaken, next, number); };
    SimdPack previous = this->Previous;
    const SimdPack factor = StepController::GetFactor(trial.Ratio,
      DormandPrinceStep<SimdPack>::ErrorOrder, SimdPack::Of(0.0) < this->WasRejected, previous);
    SimdPack at[3];
    trial.Dense.GetPoint(trial.End, at);
    for (int i = 0; i < 3; ++i)
    {
      // A step that ends on a face gets the parametric coordinate of the face in the next cell.
      const Mask isLower = trial.Face == SimdPack::Of(2.0 * i);
      const Mask isUpper = trial.Face == SimdPack::Of(2.0 * i + 1.0);
      at[i] = SimdPack::Select(
        isLower, SimdPack::Of(1.0), SimdPack::Select(isUpper, SimdPack::Of(0.0), at[i]));
      set(this->Point[i], SimdPack::Select(trial.Leaves, at[i], trial.Method.End[i]));
    }
    set(this->Time, this->Time + trial.End * trial.H);
    set(this->PathLength, this->PathLength + trial.Speed * trial.End * trial.H);
    set(this->Step, StepController::GetNext(this->Step, trial.H, factor, trial.Ratio));
    set(this->Previous, previous);
    set(this->WasRejected, SimdPack::Of(0.0));
    set(this->StepsLeft, this->StepsLeft + -1.0);
    for (std::size_t i = 0; i < this->Clearances.size(); ++i)
    {
      set(this->Clearances[i], this->ClearancesLeft[i]);
    }
  }

  /// Crosses the exit faces of the given lanes. Returns the lanes that have entered the next cell
  /// and can continue there.
  [[gnu::always_inline]] unsigned int Cross(unsigned int lanes, const SimdPack& face)
  {
    if (lanes == 0)
    {
      return lanes;
    }
    typename SimdWalker::CellLocation before[SimdPack::Number];
    for (int lane = 0; lane < SimdPack::Number; ++lane)
    {
      before[lane] = this->Walker.GetCellLocation(lane);
      if (lanes >> lane & 1U)
      {
        const Count& count = this->Counts[lane];
        const vtkIdType from = before[lane].Cell;
        const bool isThere = this->Walker.Step(lane, static_cast<int>(face.Get(lane)));
        const bool isWatched = count.Cells + 1 >= count.MaximumCells ||
          (from == count.From && this->Walker.GetCell(lane) == count.To);
        lanes &= isThere && !isWatched ? ~0U : ~(1U << lane);
        this->CellsLeft[lane] = from;
      }
    }
    // A lane that did not enter the next cell returns to its previous cell, so that Advection can
    // take over.
    const unsigned int entered = lanes & SimdPack::GetBits(this->Walker.Enter());
    for (int lane = 0; lane < SimdPack::Number; ++lane)
    {
      if (!(entered >> lane & 1U))
      {
        this->Walker.MoveLane(lane, before[lane]);
      }
    }
    return entered;
  }

  const double Sign;
  const SimdPack MaximumError;
  const SimdPack MaximumTime;
  const double MinimumSpeed;

  std::vector<SimdPack> ClearancesLeft;
  SimdPack StepDistance = SimdPack::Of(0.0);
  unsigned int Near = 0;
  vtkIdType CellsLeft[SimdPack::Number] = {};
};

}

#endif
