// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LaneExit_h
#define interlume_LaneExit_h

#include "Cells/CellExit.h"
#include "Common/Lanes.h"
#include "Numerics/Binomials.h"

namespace interlume
{

/**
 * @class   LaneExit
 * @brief   what CellExit finds for a cell that is a box, for several streamlines at once
 *
 * Each lane has the bytes that CellExit computes, or is told to be unclear: then CellExit has to
 * look. Clear are steps that cross each face at most once, at which the streamline does not stand.
 */
template <typename Lanes>
class LaneExit
{
public:
  using Mask = typename Lanes::Mask;
  static constexpr int Degree = 4;

  /// As CellExit::Approach, not held. Returns the lanes that stand at no face which is to be
  /// crossed.
  [[gnu::always_inline]] Mask Approach(const Lanes p[3], const Lanes rate[3])
  {
    this->Fastest = Lanes::Of(0.0);
    this->Outside = Lanes::Of(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Fastest = Lanes::Max(this->Fastest, Lanes::Abs(rate[axis]));
      this->Distances[2 * axis] = p[axis];
      this->Distances[2 * axis + 1] = 1.0 - p[axis];
    }
    const Lanes zero = Lanes::Of(0.0);
    const Lanes least = -1e-12 * this->Fastest;
    Mask isInside = zero == zero;
    for (int face = 0; face < 6; ++face)
    {
      const Lanes& distance = this->Distances[face];
      const Lanes outside = Lanes::Max(zero, -distance);
      this->Outside = Lanes::Max(this->Outside, outside);
      this->Slacks[face] = 2.0 * outside + Tolerance;
      const Lanes away = face & 1 ? -rate[face >> 1] : rate[face >> 1];
      isInside &= ~(((away < least) & (distance <= Tolerance)) | (distance < -MuchOutside));
    }
    this->TimeLimit = Lanes::Of(std::numeric_limits<double>::infinity());
    this->FaceAhead = zero;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Lanes ahead =
        Lanes::Select(rate[axis] < zero, this->Distances[2 * axis], this->Distances[2 * axis + 1]);
      const Lanes room = 1.1 * Lanes::Max(zero, ahead) + 0.05;
      const Lanes time = room / Lanes::Abs(rate[axis]);
      const Lanes face =
        Lanes::Select(rate[axis] < zero, Lanes::Of(2.0 * axis), Lanes::Of(2.0 * axis + 1.0));
      this->FaceAhead = Lanes::Select(time < this->TimeLimit, face, this->FaceAhead);
      this->TimeLimit = Lanes::Min(this->TimeLimit, time);
    }
    return isInside;
  }

  /**
   * Finds where steps first leave their cells, and by which face, as numbers. Where they stay,
   * \a first is above 1. Returns the lanes in which that is clear. \a points are control points.
   */
  [[gnu::always_inline]] Mask Find(
    const Lanes points[Degree + 1][3], Lanes& first, Lanes& exitFace) const
  {
    first = Lanes::Of(BernsteinRoot::None);
    exitFace = Lanes::Of(-1.0);
    Lanes end = Lanes::Of(std::numeric_limits<double>::infinity());
    Mask isClear = first == first;
    Mask isUpper[3];
    Mask isLeft[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      Lanes low = points[0][axis];
      Lanes high = points[0][axis];
      for (int k = 1; k <= Degree; ++k)
      {
        low = Lanes::Min(low, points[k][axis]);
        high = Lanes::Max(high, points[k][axis]);
      }
      end = Lanes::Min(end, Lanes::Min(points[Degree][axis], 1.0 - points[Degree][axis]));
      const Mask isLow = low <= -this->Slacks[2 * axis];
      isUpper[axis] = 1.0 - high <= -this->Slacks[2 * axis + 1];
      isLeft[axis] = isLow | isUpper[axis];
      isClear &= ~(isLow & isUpper[axis]);
    }
    isClear &= ~(end < -LargestOvershoot - this->Outside);
    // Most often the face to which a straight way would be shortest is the one.
    Lanes b[3][Degree + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      const Lanes slack =
        Lanes::Select(isUpper[axis], this->Slacks[2 * axis + 1], this->Slacks[2 * axis]);
      for (int k = 0; k <= Degree; ++k)
      {
        const Lanes& inside = points[k][axis];
        b[axis][k] = Lanes::Select(isUpper[axis], 1.0 - inside, inside) + slack;
      }
    }
    for (int round = 0; round < 3; ++round)
    {
      const Mask looks = isClear & (isLeft[0] | isLeft[1] | isLeft[2]);
      if (!Lanes::IsAny(looks))
      {
        break;
      }
      const Mask isSecond = isLeft[1] & (~isLeft[0] | LaneExit::IsBefore(b[1], b[0]));
      Mask isThis[3];
      isThis[2] = isLeft[2] &
        ((isSecond & LaneExit::IsBefore(b[2], b[1])) |
          (~isSecond & (~isLeft[0] | LaneExit::IsBefore(b[2], b[0]))));
      isThis[1] = isSecond & ~isThis[2];
      isThis[0] = ~isThis[1] & ~isThis[2];
      Lanes own[Degree + 1];
      for (int k = 0; k <= Degree; ++k)
      {
        own[k] = Lanes::Select(isThis[2], b[2][k], Lanes::Select(isThis[1], b[1][k], b[0][k]));
      }
      Lanes slack = Lanes::Of(0.0);
      Lanes face = Lanes::Of(0.0);
      for (int axis = 0; axis < 3; ++axis)
      {
        slack = Lanes::Select(isThis[axis],
          Lanes::Select(isUpper[axis], this->Slacks[2 * axis + 1], this->Slacks[2 * axis]), slack);
        face = Lanes::Select(isThis[axis],
          Lanes::Select(isUpper[axis], Lanes::Of(2.0 * axis + 1.0), Lanes::Of(2.0 * axis)), face);
        isLeft[axis] &= ~isThis[axis];
      }
      Lanes root;
      Lanes theta;
      isClear &= LaneExit::FindAffine(own, slack, looks, root, theta) | ~looks;
      const Mask isFirst = looks & ((theta < first) | ((theta == first) & (face < exitFace)));
      first = Lanes::Select(isFirst, theta, first);
      exitFace = Lanes::Select(isFirst, face, exitFace);
      if (round < 2)
      {
        // No other face comes first that the streamline stays inside of for somewhat longer.
        const Lanes end = root + Margin;
        for (int axis = 0; axis < 3; ++axis)
        {
          isLeft[axis] &= ~LaneExit::IsInside(b[axis], end);
        }
      }
    }
    return isClear;
  }

  Lanes TimeLimit;
  /// The faces that straight steps are likely to leave by, as numbers.
  Lanes FaceAhead;
  Lanes Fastest;
  Lanes Outside;

private:
  static constexpr double Tolerance = ExitLimits::Tolerance;
  static constexpr double MuchOutside = ExitLimits::MuchOutside;
  static constexpr double LargestOvershoot = ExitLimits::LargestOvershoot;

  /// By how much of a step a root must be behind another one, so that neither rounding nor the
  /// slack changes which is first.
  static constexpr double Margin = 1e-3;

  /// Returns where the straight way from the first to the last of \a one falls below 0 before that
  /// of \a other.
  [[gnu::always_inline]] static Mask IsBefore(
    const Lanes one[Degree + 1], const Lanes other[Degree + 1])
  {
    return one[0] * (other[0] - other[Degree]) < other[0] * (one[0] - one[Degree]);
  }

  /// Returns where a polynomial is above 0 from 0 to \a end, by its control points there.
  [[gnu::always_inline]] static Mask IsInside(const Lanes b[Degree + 1], const Lanes& end)
  {
    const Lanes zero = Lanes::Of(0.0);
    Lanes at[Degree + 1];
    for (int k = 0; k <= Degree; ++k)
    {
      at[k] = b[k];
    }
    Mask isInside = zero < at[0];
    for (int level = 1; level <= Degree; ++level)
    {
      for (int i = 0; i <= Degree - level; ++i)
      {
        at[i] = at[i] + end * (at[i + 1] - at[i]);
      }
      isInside &= zero < at[0];
    }
    return isInside;
  }

  /// As CellExit::FindAffine, the slack being added, where the distance is 0 or above at first and
  /// changes sign at most once; returns where that is so. \a looks are the lanes that count.
  [[gnu::always_inline]] static Mask FindAffine(
    const Lanes b[Degree + 1], const Lanes& slack, const Mask& looks, Lanes& root, Lanes& theta)
  {
    Mask changes{};
    const Lanes zero = Lanes::Of(0.0);
    for (int k = 1; k <= Degree; ++k)
    {
      changes += (b[k - 1] < zero) ^ (b[k] < zero);
    }
    const Mask isNegative = b[0] < zero;
    const Mask isOne = looks & ~isNegative & (changes == -1);
    Mask isFound;
    root = LaneExit::FindOnly(b, isOne, isFound);
    Lanes at[Degree + 1];
    for (int k = 0; k <= Degree; ++k)
    {
      at[k] = b[k];
    }
    Lanes slope;
    for (int level = 1; level <= Degree; ++level)
    {
      slope = double(Degree) * (at[1] - at[0]);
      for (int i = 0; i <= Degree - level; ++i)
      {
        at[i] = at[i] + root * (at[i + 1] - at[i]);
      }
    }
    const Lanes moved =
      Lanes::Select(slope < -1e4 * slack, Lanes::Max(zero, root + slack / slope), root);
    theta = Lanes::Select(isOne, moved, Lanes::Of(BernsteinRoot::None));
    return ~isNegative & ((changes == 0) | isFound);
  }

  /// As BernsteinRoot::FindOnly, in the lanes \a looks. \a isFound are those that have a root.
  [[gnu::always_inline]] static Lanes FindOnly(
    const Lanes b[Degree + 1], const Mask& looks, Mask& isFound)
  {
    Lanes differences[Degree + 1];
    Lanes powers[Degree + 1];
    for (int i = 0; i <= Degree; ++i)
    {
      differences[i] = b[i];
    }
    constexpr double binomials[Degree + 1] = { 1.0, 4.0, 6.0, 4.0, 1.0 };
    for (int k = 0; k <= Degree; ++k)
    {
      powers[k] = binomials[k] * differences[0];
      for (int i = 0; i < Degree - k; ++i)
      {
        differences[i] = differences[i + 1] - differences[i];
      }
    }
    Lanes bend = Lanes::Of(0.0);
    for (int k = 2; k <= Degree; ++k)
    {
      bend = bend + (0.5 * k * (k - 1)) * Lanes::Abs(powers[k]);
    }
    const Lanes zero = Lanes::Of(0.0);
    Lanes low = zero;
    Lanes high = Lanes::Of(1.0);
    Lanes theta = LaneExit::GuessOnly(powers[0], powers[1], b[Degree]);
    Lanes root = theta;
    Mask isOpen = looks;
    for (int iteration = 0; iteration < 100 && Lanes::IsAny(isOpen); ++iteration)
    {
      Lanes value = powers[Degree];
      Lanes slope = zero;
      for (int i = Degree - 1; i >= 0; --i)
      {
        slope = slope * theta + value;
        value = value * theta + powers[i];
      }
      const Mask isBelow = value < zero;
      high = Lanes::Select(isBelow, theta, high);
      low = Lanes::Select(isBelow, low, theta);
      Lanes next = theta - value / slope;
      const Mask isNewton = (low < next) & (next < high);
      const Lanes halved = Lanes::Select(value == zero, theta, 0.5 * (low + high));
      next = Lanes::Select(isNewton, next, halved);
      const Lanes way = next - theta;
      const Mask isDone = (isNewton & (bend * (way * way) <= 1e-14 * Lanes::Abs(slope))) |
        (Lanes::Abs(way) <= 2e-16) | (next == low) | (next == high);
      root = Lanes::Select(isOpen & isDone, next, root);
      isOpen &= ~isDone;
      theta = next;
    }
    isFound = looks & ~isOpen;
    return root;
  }

  [[gnu::always_inline]] static Lanes GuessOnly(
    const Lanes& start, const Lanes& slope, const Lanes& end)
  {
    const Lanes bend = end - start - slope;
    const Lanes square = slope * slope - 4.0 * bend * start;
    const Lanes divisor = Lanes::Sqrt(square) - slope;
    const Lanes theta = 2.0 * start / divisor;
    return Lanes::Select((theta > 0.0) & (theta < 1.0), theta, start / (start - end));
  }

  Lanes Distances[6];
  Lanes Slacks[6];
};

}

#endif
