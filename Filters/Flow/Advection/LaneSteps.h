// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LaneSteps_h
#define interlume_LaneSteps_h

#include "Advection/AdvectionOptions.h"
#include "Advection/DormandPrinceStep.h"
#include "Advection/LaneExit.h"
#include "Advection/StepController.h"
#include "Advection/StiffnessTest.h"
#include "Common/Lanes.h"

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
  static constexpr double Epsilon = std::numeric_limits<double>::epsilon();
  static constexpr int Degree = LaneExit<Lanes>::Degree;

  [[gnu::always_inline]] void GetRate(const Lanes p[3], Lanes rate[3]) const
  {
    this->Walker.GetVelocity(p, rate);
    for (int i = 0; i < 3; ++i)
    {
      rate[i] = this->Sign * rate[i];
    }
  }

  [[gnu::always_inline]] static Lanes Dot(const Lanes a[3], const Lanes b[3])
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /// Returns where the root of a square is the length, without scaling.
  [[gnu::always_inline]] static Mask IsOrdinary(const Lanes& square)
  {
    return (square > 1e-280) & (square < 1e280);
  }

  /// Takes a step of DormandPrinceStep.
  [[gnu::always_inline]] void TakeStages(const Lanes first[3], const Lanes& h)
  {
    const Lanes* p = this->Point;
    Lanes at[3];
    Lanes k2[3];
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + h * (1.0 / 5.0 * first[i]);
    }
    this->GetRate(at, k2);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + h * (3.0 / 40.0 * first[i] + 9.0 / 40.0 * k2[i]);
    }
    this->GetRate(at, this->K3);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] + h * (44.0 / 45.0 * first[i] - 56.0 / 15.0 * k2[i] + 32.0 / 9.0 * this->K3[i]);
    }
    this->GetRate(at, this->K4);
    for (int i = 0; i < 3; ++i)
    {
      at[i] = p[i] +
        h *
          (19372.0 / 6561.0 * first[i] - 25360.0 / 2187.0 * k2[i] + 64448.0 / 6561.0 * this->K3[i] -
            212.0 / 729.0 * this->K4[i]);
    }
    this->GetRate(at, this->K5);
    for (int i = 0; i < 3; ++i)
    {
      this->SixthPlace[i] = p[i] +
        h *
          (9017.0 / 3168.0 * first[i] - 355.0 / 33.0 * k2[i] + 46732.0 / 5247.0 * this->K3[i] +
            49.0 / 176.0 * this->K4[i] - 5103.0 / 18656.0 * this->K5[i]);
    }
    this->GetRate(this->SixthPlace, this->K6);
    for (int i = 0; i < 3; ++i)
    {
      this->End[i] = p[i] +
        h *
          (35.0 / 384.0 * first[i] + 500.0 / 1113.0 * this->K3[i] + 125.0 / 192.0 * this->K4[i] -
            2187.0 / 6784.0 * this->K5[i] + 11.0 / 84.0 * this->K6[i]);
    }
    this->GetRate(this->End, this->EndRate);
    for (int i = 0; i < 3; ++i)
    {
      this->Error[i] = h *
        (71.0 / 57600.0 * first[i] - 71.0 / 16695.0 * this->K3[i] + 71.0 / 1920.0 * this->K4[i] -
          17253.0 / 339200.0 * this->K5[i] + 22.0 / 525.0 * this->K6[i] -
          1.0 / 40.0 * this->EndRate[i]);
    }
  }

  /// Computes the dense output as DormandPrinceStep does, and its control points.
  [[gnu::always_inline]] void FindCurve(const Lanes first[3], const Lanes& h)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Lanes way = this->End[i] - this->Point[i];
      const Lanes bend = h * first[i] - way;
      const Lanes twist = way - h * this->EndRate[i] - bend;
      const Lanes fourth = h *
        (-12715105075.0 / 11282082432.0 * first[i] + 87487479700.0 / 32700410799.0 * this->K3[i] -
          10690763975.0 / 1880347072.0 * this->K4[i] +
          701980252875.0 / 199316789632.0 * this->K5[i] - 1453857185.0 / 822651844.0 * this->K6[i] +
          69997945.0 / 29380423.0 * this->EndRate[i]);
      this->Curve[0][i] = this->Point[i];
      this->Curve[1][i] = h * first[i];
      this->Curve[2][i] = twist - bend + fourth;
      this->Curve[3][i] = -twist - 2.0 * fourth;
      this->Curve[4][i] = fourth;
    }
    const auto& weights = Binomials::Get().Elevation[Degree];
    for (int j = 0; j <= Degree; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        Lanes sum = Lanes::Of(0.0);
        for (int k = 0; k <= j; ++k)
        {
          sum = sum + weights[j][k] * this->Curve[k][i];
        }
        this->Controls[j][i] = sum;
      }
    }
  }

  /// Returns the error as Advection::GetLastingError does; \a isOrdinary loses the lanes in which
  /// that is not clear, or in which the step is stiff.
  [[gnu::always_inline]] Lanes GetLastingError(
    const Lanes& h, const Lanes& fastest, Mask& isOrdinary) const
  {
    Lanes error[3];
    this->Walker.GetWorldVector(this->Error, error);
    Lanes direction[3];
    Lanes rates[3];
    // Rates by themselves may have no square.
    Lanes ways[3];
    for (int i = 0; i < 3; ++i)
    {
      direction[i] = this->End[i] - this->SixthPlace[i];
      rates[i] = this->EndRate[i] - this->K6[i];
      ways[i] = h * rates[i];
    }
    const Lanes square = Dot(direction, direction);
    constexpr double most = 0.99 * StiffnessTest::LeastStiff * StiffnessTest::LeastStiff;
    isOrdinary &= Dot(ways, ways) <= most * square;
    const Lanes damping = Lanes::Select(square > std::numeric_limits<double>::min(),
      -h * (Dot(direction, rates) / square), Lanes::Of(0.0));
    const Lanes time = Lanes::Min(1.0 / fastest, this->Time + h);
    const Mask isDamped = (damping > 0.1) & (h < time);
    if (Lanes::IsAny(isDamped))
    {
      Lanes axis[3];
      this->Walker.GetWorldVector(direction, axis);
      const Lanes squaredAxis = Dot(axis, axis);
      isOrdinary &= IsOrdinary(squaredAxis) | ~isDamped;
      const Lanes part = Dot(error, axis) / squaredAxis;
      const Lanes lost = 1.0 - (damping + 1.0) / (damping * (time / h) + 1.0);
      for (int i = 0; i < 3; ++i)
      {
        error[i] = Lanes::Select(isDamped, error[i] - part * lost * axis[i], error[i]);
      }
    }
    const Lanes length = Dot(error, error);
    const Lanes largest =
      Lanes::Max(Lanes::Abs(error[0]), Lanes::Max(Lanes::Abs(error[1]), Lanes::Abs(error[2])));
    isOrdinary &= IsOrdinary(length) | (largest == Lanes::Of(0.0));
    return Lanes::Sqrt(length);
  }

  /// Returns how far the step can go, as Advection does for cells of constant frame; \a isOrdinary
  /// loses the lanes in which that is not clear.
  [[gnu::always_inline]] Lanes GetReach(Mask& isOrdinary) const
  {
    Lanes square = Lanes::Of(0.0);
    for (int j = 0; j < Degree; ++j)
    {
      Lanes slope[3];
      for (int i = 0; i < 3; ++i)
      {
        slope[i] = double(Degree) * (this->Controls[j + 1][i] - this->Controls[j][i]);
      }
      Lanes world[3];
      this->Walker.GetWorldVector(slope, world);
      square = Lanes::Max(square, Dot(world, world));
    }
    isOrdinary &= IsOrdinary(square);
    return 1.01 * Lanes::Sqrt(square);
  }

  /// Takes one step of each lane. Returns the bits of those that it was taken in.
  [[gnu::always_inline]] unsigned int TakeOne(unsigned int lanes)
  {
    Lanes rate[3];
    Lanes world[3];
    this->GetRate(this->Point, rate);
    this->Walker.GetWorldVector(rate, world);
    const Lanes squaredSpeed = Dot(world, world);
    const Lanes speed = Lanes::Sqrt(squaredSpeed);
    Mask isUsual = IsOrdinary(squaredSpeed) & ~(speed < this->MinimumSpeed);

    LaneExit<Lanes> exit;
    isUsual &= exit.Approach(this->Point, rate);
    const Lanes h = Lanes::Min(this->Step, exit.TimeLimit);
    isUsual &= h < this->MaximumTime - this->Time;
    for (int lane = 0; lane < Lanes::Number; ++lane)
    {
      this->Walker.Prefetch(lane, static_cast<int>(exit.FaceAhead.Get(lane)));
    }
    this->TakeStages(rate, h);
    const Lanes largestError = Lanes::Max(this->MaximumError, 64.0 * Epsilon * speed);
    const Lanes ratio = this->GetLastingError(h, exit.Fastest, isUsual) / h / largestError;
    isUsual &= ratio <= 1.0;

    this->FindCurve(rate, h);
    Lanes first;
    Lanes face;
    isUsual &= exit.Find(this->Controls, first, face);
    const Mask leaves = face > -0.5;
    const Lanes end = Lanes::Select(leaves, first, Lanes::Of(1.0));
    const Lanes time = end * h;
    isUsual &= time * exit.Fastest > ExitLimits::Tolerance;
    isUsual &= Lanes::Of(0.0) < this->StepsLeft;
    if (!this->Clearances.empty())
    {
      this->StepWay = end * this->GetReach(isUsual);
      Mask isClear = isUsual;
      for (std::size_t i = 0; i < this->Clearances.size(); ++i)
      {
        isClear &= this->StepWay < this->Clearances[i];
        this->ClearancesLeft[i] = this->Clearances[i] - this->StepWay;
      }
      this->Near = Lanes::GetBits(isUsual & ~isClear);
      isUsual = isClear;
    }
    lanes &= Lanes::GetBits(isUsual);
    const unsigned int crossing = this->Cross(lanes & Lanes::GetBits(leaves), face);
    lanes &= ~Lanes::GetBits(leaves) | crossing;

    // The next step is as Advection has it: a short one in a cell leaves a longer one as it is.
    Lanes previous = this->Previous;
    const Lanes factor = StepController::GetFactor(
      ratio, DormandPrinceStep::ErrorOrder, Lanes::Of(0.0) < this->WasRejected, previous);
    const Lanes longer = Lanes::Min(h * factor, Lanes::Of(std::numeric_limits<double>::max()));
    const Lanes nextStep = Lanes::Select(ratio < 1e-3, Lanes::Max(this->Step, longer), longer);
    const Mask isTaken = Lanes::GetMask(lanes);
    for (int i = 0; i < 3; ++i)
    {
      Lanes at = this->Curve[Degree][i];
      for (int k = Degree - 1; k >= 0; --k)
      {
        at = at * end + this->Curve[k][i];
      }
      // The place on the face has the coordinate of the face in the neighbour.
      const Mask isLower = face == Lanes::Of(2.0 * i);
      const Mask isUpper = face == Lanes::Of(2.0 * i + 1.0);
      at = Lanes::Select(isLower, Lanes::Of(1.0), Lanes::Select(isUpper, Lanes::Of(0.0), at));
      at = Lanes::Select(leaves, at, this->End[i]);
      this->Point[i] = Lanes::Select(isTaken, at, this->Point[i]);
    }
    this->Time = Lanes::Select(isTaken, this->Time + time, this->Time);
    this->Way = Lanes::Select(isTaken, this->Way + speed * end * h, this->Way);
    this->Step = Lanes::Select(isTaken, nextStep, this->Step);
    this->Previous = Lanes::Select(isTaken, previous, this->Previous);
    this->WasRejected = Lanes::Select(isTaken, Lanes::Of(0.0), this->WasRejected);
    this->StepsLeft = Lanes::Select(isTaken, this->StepsLeft + -1.0, this->StepsLeft);
    for (std::size_t i = 0; i < this->Clearances.size(); ++i)
    {
      this->Clearances[i] = Lanes::Select(isTaken, this->ClearancesLeft[i], this->Clearances[i]);
    }
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

  // The step that is taken.
  Lanes K3[3];
  Lanes K4[3];
  Lanes K5[3];
  Lanes K6[3];
  Lanes SixthPlace[3];
  Lanes End[3];
  Lanes EndRate[3];
  Lanes Error[3];
  /// The dense output by powers, and by control points.
  Lanes Curve[Degree + 1][3];
  Lanes Controls[Degree + 1][3];
  std::vector<Lanes> ClearancesLeft;
  Lanes StepWay = Lanes::Of(0.0);
  unsigned int Near = 0;
  vtkIdType CellsLeft[Lanes::Number] = {};
};

}

#endif
