// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoxExit_h
#define interlume_BoxExit_h

#include "Numerics/BernsteinRoot.h"
#include "Numerics/NumberMath.h"

#include <limits>

namespace interlume
{

/**
 * @class   BoxExit
 * @brief   finds the face through which an integration step leaves the cell [0,1]^3
 *
 * \a Number is double, or a SIMD pack with one streamline per lane. The masks mark unambiguous
 * results: the step crosses each face at most once and does not start on a face that it must cross.
 * CellExit handles all other steps. Distances are in cell widths.
 */
template <typename Number>
class BoxExit
{
public:
  using Math = NumberMath<Number>;
  using Mask = typename Math::Mask;

  /// Maximum distance outside a face for streamlines that run along the face.
  static constexpr double Tolerance = 1e-12;

  /// Prepares the search from \a p along \a rate. Returns a mask of the points at which no face
  /// must be crossed before the step.
  INTERLUME_RETURNS_VECTOR Mask PrepareSearch(const Number p[3], const Number rate[3])
  {
    const Number zero = Math::Of(0.0);
    this->Fastest = zero;
    this->Outside = zero;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Fastest = Math::Max(this->Fastest, Math::Abs(rate[axis]));
      this->Distances[2 * axis] = p[axis];
      this->Distances[2 * axis + 1] = 1.0 - p[axis];
    }
    const Number threshold = -1e-12 * this->Fastest;
    Mask isInside = zero == zero;
    for (int face = 0; face < 6; ++face)
    {
      const Number& distance = this->Distances[face];
      const Number outside = Math::Max(zero, -distance);
      this->Outside = Math::Max(this->Outside, outside);
      this->Slacks[face] = 2.0 * outside + Tolerance;
      const Number away = face & 1 ? -rate[face >> 1] : rate[face >> 1];
      isInside &= Math::Not(
        ((away < threshold) & (distance <= Tolerance)) | (distance < Math::Of(-MuchOutside)));
    }
    this->TimeLimit = Math::Of(std::numeric_limits<double>::infinity());
    this->FaceAhead = zero;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Mask isDown = rate[axis] < zero;
      const Number ahead =
        Math::Select(isDown, this->Distances[2 * axis], this->Distances[2 * axis + 1]);
      const Number time = (1.1 * Math::Max(zero, ahead) + 0.05) / Math::Abs(rate[axis]);
      const Number face = Math::Select(isDown, Math::Of(2.0 * axis), Math::Of(2.0 * axis + 1.0));
      this->FaceAhead = Math::Select(time < this->TimeLimit, face, this->FaceAhead);
      this->TimeLimit = Math::Min(this->TimeLimit, time);
    }
    return isInside;
  }

  /**
   * Computes \a first, the fraction of the step (theta) at which it leaves the cell, and the exit
   * face. If the step remains inside, they are BernsteinRoot::None and -1. \a points are the
   * control points of the step. Returns a mask of the unambiguous results.
   */
  INTERLUME_RETURNS_VECTOR Mask Find(
    const Number (*points)[3], int degree, Number& first, Number& exitFace) const
  {
    first = Math::Of(BernsteinRoot::None);
    exitFace = Math::Of(-1.0);
    Sides sides;
    Mask isClear = this->FindSides(points, degree, sides);
    if (!Math::IsAny(isClear & sides.IsAnyLeft()))
    {
      return isClear;
    }
    // For each axis, Bernstein coefficients of the distance to the possible exit face, plus the
    // slack.
    Number b[3][Size];
    for (int axis = 0; axis < 3; ++axis)
    {
      const Number slack =
        Math::Select(sides.IsUpper[axis], this->Slacks[2 * axis + 1], this->Slacks[2 * axis]);
      for (int k = 0; k <= degree; ++k)
      {
        const Number& inside = points[k][axis];
        b[axis][k] = Math::Select(sides.IsUpper[axis], 1.0 - inside, inside) + slack;
      }
    }
    for (int round = 0; round < 3; ++round)
    {
      const Mask mask = isClear & sides.IsAnyLeft();
      if (!Math::IsAny(mask))
      {
        break;
      }
      Number own[Size];
      Number slack;
      Number face;
      this->RemoveNextFace(b, degree, sides, own, slack, face);
      Number root;
      Number theta;
      isClear &= BoxExit::FindCrossing(own, degree, slack, mask, root, theta) | Math::Not(mask);
      const Mask isFirst = mask & ((theta < first) | ((theta == first) & (face < exitFace)));
      first = Math::Select(isFirst, theta, first);
      exitFace = Math::Select(isFirst, face, exitFace);
      if (round < 2 && Math::IsAny(sides.IsAnyLeft()))
      {
        // Faces that are reached well after \a root cannot be the exit face.
        const Number end = root + Math::Of(Margin);
        for (int axis = 0; axis < 3; ++axis)
        {
          sides.IsLeft[axis] &= Math::Not(BoxExit::IsInside(b[axis], degree, end));
        }
      }
    }
    return isClear;
  }

  /// Moves a root of (distance + slack) back to the root of the distance. \a slack is the tolerance
  /// by which the point may be outside. If the streamline moves almost parallel to the face, the
  /// root remains unchanged.
  INTERLUME_RETURNS_VECTOR static Number MoveBack(
    const Number* b, int degree, const Number& slack, const Number& root)
  {
    Number at[Size];
    for (int k = 0; k <= degree; ++k)
    {
      at[k] = b[k];
    }
    Number slope = Math::Of(0.0);
    for (int level = 1; level <= degree; ++level)
    {
      slope = double(degree) * (at[1] - at[0]);
      BoxExit::Subdivide(at, degree - level, root);
    }
    return Math::Select(slope < -1e4 * slack, Math::Max(Math::Of(0.0), root + slack / slope), root);
  }

  /// Time step after which a straight streamline is slightly outside the cell.
  Number TimeLimit;
  /// Likely exit face of a straight streamline.
  Number FaceAhead;
  /// Largest rate of change of a distance to a face, in cell widths per unit of time.
  Number Fastest;

protected:
  static constexpr int Size = BernsteinRoot::MaximumDegree + 1;
  /// Maximum overshoot of a step past a face.
  static constexpr double LargestOvershoot = 0.5;
  /// A streamline this far outside a face must cross it, regardless of its direction.
  static constexpr double MuchOutside = 1e-6;

  Number Outside;
  Number Distances[6];
  Number Slacks[6];

private:
  /// Minimum difference between two roots, as a fraction of a step, so that neither rounding nor
  /// the slack can change their order.
  static constexpr double Margin = 1e-3;

  /// Possible exit faces of a step, at most one per axis.
  struct Sides
  {
    Mask IsUpper[3];
    Mask IsLeft[3];

    INTERLUME_RETURNS_VECTOR Mask IsAnyLeft() const
    {
      return this->IsLeft[0] | this->IsLeft[1] | this->IsLeft[2];
    }
  };

  /// Finds the faces that have at least one control point on their outer side. Returns a mask of
  /// the steps that do not end far outside the cell, and whose control points are outside at most
  /// one face per axis.
  INTERLUME_RETURNS_VECTOR Mask FindSides(const Number (*points)[3], int degree, Sides& sides) const
  {
    Number end = Math::Of(std::numeric_limits<double>::infinity());
    Mask isClear = end == end;
    for (int axis = 0; axis < 3; ++axis)
    {
      Number low = points[0][axis];
      Number high = points[0][axis];
      for (int k = 1; k <= degree; ++k)
      {
        low = Math::Min(low, points[k][axis]);
        high = Math::Max(high, points[k][axis]);
      }
      end = Math::Min(end, Math::Min(points[degree][axis], 1.0 - points[degree][axis]));
      const Mask isLow = low <= -this->Slacks[2 * axis];
      sides.IsUpper[axis] = 1.0 - high <= -this->Slacks[2 * axis + 1];
      sides.IsLeft[axis] = isLow | sides.IsUpper[axis];
      isClear &= Math::Not(isLow & sides.IsUpper[axis]);
    }
    return isClear & Math::Not(end < Math::Of(-LargestOvershoot) - this->Outside);
  }

  /// Removes from \a sides, per SIMD lane, the face that the chord of the step reaches first, which
  /// is usually the exit face. \a own, \a slack and \a face receive the coefficients, slack and
  /// index of this face.
  void RemoveNextFace(const Number (*b)[Size], int degree, Sides& sides, Number* own, Number& slack,
    Number& face) const
  {
    const Mask isSecond =
      sides.IsLeft[1] & (Math::Not(sides.IsLeft[0]) | BoxExit::IsBefore(b[1], b[0], degree));
    Mask isThis[3];
    isThis[2] = sides.IsLeft[2] &
      ((isSecond & BoxExit::IsBefore(b[2], b[1], degree)) |
        (Math::Not(isSecond) &
          (Math::Not(sides.IsLeft[0]) | BoxExit::IsBefore(b[2], b[0], degree))));
    isThis[1] = isSecond & Math::Not(isThis[2]);
    isThis[0] = Math::Not(isThis[1]) & Math::Not(isThis[2]);
    for (int k = 0; k <= degree; ++k)
    {
      own[k] = Math::Select(isThis[2], b[2][k], Math::Select(isThis[1], b[1][k], b[0][k]));
    }
    slack = Math::Of(0.0);
    face = Math::Of(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Mask isUpper = sides.IsUpper[axis];
      slack = Math::Select(isThis[axis],
        Math::Select(isUpper, this->Slacks[2 * axis + 1], this->Slacks[2 * axis]), slack);
      face = Math::Select(isThis[axis],
        Math::Select(isUpper, Math::Of(2.0 * axis + 1.0), Math::Of(2.0 * axis)), face);
      sides.IsLeft[axis] &= Math::Not(isThis[axis]);
    }
  }

  /// Returns a mask of the lanes in which the chord from the first to the last coefficient of
  /// \a one becomes negative before the chord of \a other.
  INTERLUME_RETURNS_VECTOR static Mask IsBefore(const Number* one, const Number* other, int degree)
  {
    return one[0] * (other[0] - other[degree]) < other[0] * (one[0] - one[degree]);
  }

  /// Performs one level of de Casteljau's algorithm at \a theta on the first \a number + 1
  /// coefficients.
  static void Subdivide(Number* b, int number, const Number& theta)
  {
    for (int i = 0; i <= number; ++i)
    {
      b[i] = b[i] + theta * (b[i + 1] - b[i]);
    }
  }

  /// Returns a mask of the lanes in which all Bernstein coefficients of the polynomial on [0,
  /// \a end] are positive.
  INTERLUME_RETURNS_VECTOR static Mask IsInside(const Number* b, int degree, const Number& end)
  {
    const Number zero = Math::Of(0.0);
    Number at[Size];
    for (int k = 0; k <= degree; ++k)
    {
      at[k] = b[k];
    }
    Mask isInside = zero < b[0];
    for (int level = 1; level <= degree; ++level)
    {
      BoxExit::Subdivide(at, degree - level, end);
      isInside &= zero < at[0];
    }
    return isInside;
  }

  /// Finds the root of a distance polynomial with a first coefficient >= 0 and at most one sign
  /// change. \a theta is the root after MoveBack. Without a sign change, \a root is 1 and \a theta
  /// is BernsteinRoot::None. Returns a mask of the lanes that satisfy the assumptions.
  INTERLUME_RETURNS_VECTOR static Mask FindCrossing(
    const Number* b, int degree, const Number& slack, const Mask& mask, Number& root, Number& theta)
  {
    const Number zero = Math::Of(0.0);
    Mask isNegative = b[0] < zero;
    const Mask isClear = Math::Not(isNegative);
    Mask hasChanged = zero < zero;
    Mask hasChangedAgain = hasChanged;
    for (int k = 1; k <= degree; ++k)
    {
      const Mask isBelow = b[k] < zero;
      hasChangedAgain |= hasChanged & (isNegative ^ isBelow);
      hasChanged |= isNegative ^ isBelow;
      isNegative = isBelow;
    }
    const Mask isOne = mask & isClear & hasChanged & Math::Not(hasChangedAgain);
    root = Math::Select(isOne, BernsteinRoot::FindSingleRoot(b, degree, isOne), Math::Of(1.0));
    theta =
      Math::Select(isOne, BoxExit::MoveBack(b, degree, slack, root), Math::Of(BernsteinRoot::None));
    return isClear & Math::Not(hasChangedAgain);
  }
};

}

#endif
