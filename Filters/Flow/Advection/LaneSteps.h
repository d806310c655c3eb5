// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LaneSteps_h
#define interlume_LaneSteps_h

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
 * @class   LaneSteps
 * @brief   steps of Dormand and Prince's method for several streamlines at once
 *
 * A step is all that Advection does from one entry of a cell to the next, where nothing but the
 * usual happens: it is accepted, meets no surface, and goes on within the cell or by one face into
 * another. It has the bytes of that. Of anything else no trace is left in the lane, so that
 * Advection can take the step. \a LaneWalker is as LatticeLanes.
 */
template <typename LaneWalker>
class LaneSteps
{
public:
  using Lanes = typename LaneWalker::Lanes;
  using Mask = typename Lanes::Mask;

  LaneSteps(const LaneWalker& walker, const AdvectionOptions& options)
    : Walker(walker)
    , Clearances(options.Surfaces.size(), Lanes::Of(0.0))
    , Sign(options.IsBackward() ? -1.0 : 1.0)
    , MaximumError(Lanes::Of(options.MaximumError))
    , MaximumTime(Lanes::Of(options.MaximumTime))
    , MinimumSpeed(options.MinimumSpeed)
    , ClearancesLeft(options.Surfaces.size(), Lanes::Of(0.0))
  {
    for (Lanes& p : this->Point)
    {
      p = Lanes::Of(0.5);
    }
  }

  /// Takes steps of the lanes with a bit in \a lanes until one of them cannot go on here. Returns
  /// the bits of these.
  [[gnu::always_inline]] unsigned int Take(unsigned int lanes)
  {
    unsigned int taken = lanes;
    while (taken == lanes)
    {
      taken = this->TakeOne(lanes);
    }
    return lanes & ~taken;
  }

  ///@{
  /// Returns whether the last step that was tried in a lane may come to a surface, and nothing else
  /// kept it back; and the most that it goes.
  bool IsNear(int lane) const { return (this->Near >> lane & 1U) != 0; }
  double GetWay(int lane) const { return this->StepWay.Get(lane); }
  ///@}

  ///@{
  /// What Advection knows of each streamline between two steps.
  LaneWalker Walker;
  Lanes Point[3];
  Lanes Time = Lanes::Of(0.0);
  Lanes Step = Lanes::Of(1.0);
  Lanes Way = Lanes::Of(0.0);
  Lanes Previous = Lanes::Of(StepController::LeastPrevious);
  /// 1 after a rejected step, else 0.
  Lanes WasRejected = Lanes::Of(0.0);
  /// The number of steps that may still be taken here.
  Lanes StepsLeft = Lanes::Of(0.0);
  std::vector<Lanes> Clearances;
  ///@}

  /// What is counted of a lane since it was taken over, and the limits of that.
  struct Count
  {
    int Steps = 0;
    int Cells = 0;
    /// The rates at starts of steps that no step before had computed.
    int Rates = 0;
    vtkIdType MostCells = 0;
    /// The face that is watched: the cells that the streamline goes from and to.
    vtkIdType From = -1;
    vtkIdType To = -1;
    /// The cell that the last step has left, -1 for none.
    vtkIdType CellBefore = -1;
    bool HasRate = false;
  };
  Count Counts[Lanes::Number];

private:
  using Math = NumberMath<Lanes>;
  using Measures = StepMeasures<Lanes>;
  static constexpr double Epsilon = std::numeric_limits<double>::epsilon();

  /// A step that is tried in each lane.
  struct Trial
  {
    Lanes H;
    Lanes Ratio;
    Lanes Speed;
    /// The part of the step up to the face, 1 without one.
    Lanes End;
    Lanes Face;
    Mask Leaves;
    DormandPrinceStep<Lanes> Method;
    DenseOutput<Lanes> Dense;
  };

  [[gnu::always_inline]] void GetRate(const Lanes p[3], Lanes rate[3]) const
  {
    this->Walker.GetVelocity(p, rate);
    for (int i = 0; i < 3; ++i)
    {
      rate[i] = this->Sign * rate[i];
    }
  }

  /// Returns a mask of the steps that are not stiff, up to rounding.
  [[gnu::always_inline]] static Mask IsHarmless(const Trial& trial)
  {
    Lanes direction[3];
    Lanes ways[3];
    trial.Method.GetEndDifference(direction, ways);
    for (Lanes& way : ways)
    {
      // Rates by themselves may have no square.
      way = trial.H * way;
    }
    constexpr double most = 0.99 * StiffnessTest::LeastStiff * StiffnessTest::LeastStiff;
    return Math::Dot(ways, ways) <= most * Math::Dot(direction, direction);
  }

  /// Tries a step of each lane. Returns a mask of those in which nothing unusual happens.
  [[gnu::always_inline]] Mask Try(Trial& trial)
  {
    Lanes rate[3];
    Lanes world[3];
    this->GetRate(this->Point, rate);
    this->Walker.GetWorldVector(this->Point, rate, world);
    const Lanes squaredSpeed = Math::Dot(world, world);
    trial.Speed = Lanes::Sqrt(squaredSpeed);
    Mask isUsual = Measures::IsOrdinary(squaredSpeed) & ~(trial.Speed < this->MinimumSpeed);

    BoxExit<Lanes> exit;
    isUsual &= exit.Approach(this->Point, rate);
    trial.H = Lanes::Min(this->Step, exit.TimeLimit);
    isUsual &= trial.H < this->MaximumTime - this->Time;
    for (int lane = 0; lane < Lanes::Number; ++lane)
    {
      this->Walker.Prefetch(lane, static_cast<int>(exit.FaceAhead.Get(lane)));
    }
    const auto getRate = [this](const Lanes* p, Lanes* k) { this->GetRate(p, k); };
    trial.Method.Take(getRate, this->Point, rate, trial.H);
    isUsual &= LaneSteps::IsHarmless(trial);
    const Lanes time = Lanes::Min(1.0 / exit.Fastest, this->Time + trial.H);
    const Lanes error =
      Measures::GetLastingError(this->Walker, this->Point, trial.Method, trial.H, time, isUsual);
    const Lanes largestError = Lanes::Max(this->MaximumError, 64.0 * Epsilon * trial.Speed);
    trial.Ratio = error / trial.H / largestError;
    isUsual &= trial.Ratio <= 1.0;

    trial.Method.GetDenseOutput(trial.Dense);
    Lanes controls[DenseOutput<Lanes>::MaximumDegree + 1][3];
    trial.Dense.GetControlPoints(controls);
    Lanes first;
    isUsual &= exit.Find(controls, trial.Dense.Degree, first, trial.Face);
    trial.Leaves = trial.Face > -0.5;
    trial.End = Lanes::Select(trial.Leaves, first, Lanes::Of(1.0));
    isUsual &= trial.End * trial.H * exit.Fastest > BoxExit<Lanes>::Tolerance;
    isUsual &= Lanes::Of(0.0) < this->StepsLeft;
    return this->Clearances.empty() ? isUsual : this->IsClear(trial, controls, isUsual);
  }

  /// Returns a mask of the usual steps that cannot come to a surface.
  [[gnu::always_inline]] Mask IsClear(
    const Trial& trial, const Lanes (*controls)[3], const Mask& usual)
  {
    Mask isUsual = usual;
    this->StepWay = trial.End *
      Measures::GetAffineReach(this->Walker, this->Point, trial.Dense, controls, isUsual);
    Mask isClear = isUsual;
    for (std::size_t i = 0; i < this->Clearances.size(); ++i)
    {
      isClear &= this->StepWay < this->Clearances[i];
      this->ClearancesLeft[i] = this->Clearances[i] - this->StepWay;
    }
    this->Near = Lanes::GetBits(isUsual & ~isClear);
    return isClear;
  }

  /// Takes one step of each lane. Returns the bits of those that it was taken in.
  [[gnu::always_inline]] unsigned int TakeOne(unsigned int lanes)
  {
    Trial trial;
    lanes &= Lanes::GetBits(this->Try(trial));
    const unsigned int leaving = Lanes::GetBits(trial.Leaves);
    const unsigned int crossing = this->Cross(lanes & leaving, trial.Face);
    lanes &= ~leaving | crossing;
    this->Commit(trial, Lanes::GetMask(lanes));
    for (int lane = 0; lane < Lanes::Number; ++lane)
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

  /// Goes to the end of a step in some lanes.
  [[gnu::always_inline]] void Commit(const Trial& trial, const Mask& isTaken)
  {
    const auto set = [&isTaken](Lanes& number, const Lanes& next)
    { number = Lanes::Select(isTaken, next, number); };
    Lanes previous = this->Previous;
    const Lanes factor = StepController::GetFactor(trial.Ratio,
      DormandPrinceStep<Lanes>::ErrorOrder, Lanes::Of(0.0) < this->WasRejected, previous);
    Lanes at[3];
    trial.Dense.GetPoint(trial.End, at);
    for (int i = 0; i < 3; ++i)
    {
      // The place on the face has the coordinate of the face in the neighbor.
      const Mask isLower = trial.Face == Lanes::Of(2.0 * i);
      const Mask isUpper = trial.Face == Lanes::Of(2.0 * i + 1.0);
      at[i] = Lanes::Select(isLower, Lanes::Of(1.0), Lanes::Select(isUpper, Lanes::Of(0.0), at[i]));
      set(this->Point[i], Lanes::Select(trial.Leaves, at[i], trial.Method.End[i]));
    }
    set(this->Time, this->Time + trial.End * trial.H);
    set(this->Way, this->Way + trial.Speed * trial.End * trial.H);
    set(this->Step, StepController::GetNext(this->Step, trial.H, factor, trial.Ratio));
    set(this->Previous, previous);
    set(this->WasRejected, Lanes::Of(0.0));
    set(this->StepsLeft, this->StepsLeft + -1.0);
    for (std::size_t i = 0; i < this->Clearances.size(); ++i)
    {
      set(this->Clearances[i], this->ClearancesLeft[i]);
    }
  }

  /// Goes through faces in the lanes with a bit. Returns those in which there is a cell that may be
  /// entered without more ado.
  [[gnu::always_inline]] unsigned int Cross(unsigned int lanes, const Lanes& face)
  {
    if (lanes == 0)
    {
      return lanes;
    }
    typename LaneWalker::Place before[Lanes::Number];
    for (int lane = 0; lane < Lanes::Number; ++lane)
    {
      before[lane] = this->Walker.GetPlace(lane);
      if (lanes >> lane & 1U)
      {
        const Count& count = this->Counts[lane];
        const vtkIdType from = before[lane].Cell;
        const bool isThere = this->Walker.Step(lane, static_cast<int>(face.Get(lane)));
        const bool isWatched = count.Cells + 1 >= count.MostCells ||
          (from == count.From && this->Walker.GetCell(lane) == count.To);
        lanes &= isThere && !isWatched ? ~0U : ~(1U << lane);
        this->CellsLeft[lane] = from;
      }
    }
    // Of a cell that is not entered Advection knows all that is left.
    const unsigned int entered = lanes & Lanes::GetBits(this->Walker.Enter());
    for (int lane = 0; lane < Lanes::Number; ++lane)
    {
      if (!(entered >> lane & 1U))
      {
        this->Walker.Stand(lane, before[lane]);
      }
    }
    return entered;
  }

  const double Sign;
  const Lanes MaximumError;
  const Lanes MaximumTime;
  const double MinimumSpeed;

  std::vector<Lanes> ClearancesLeft;
  Lanes StepWay = Lanes::Of(0.0);
  unsigned int Near = 0;
  vtkIdType CellsLeft[Lanes::Number] = {};
};

}

#endif
