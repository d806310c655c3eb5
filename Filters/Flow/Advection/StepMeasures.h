// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StepMeasures_h
#define interlume_StepMeasures_h

#include "Cells/MultilinearCell.h"
#include "Common/Vectors.h"
#include "Numerics/DenseOutput.h"
#include "Numerics/NumberMath.h"

#include <type_traits>

namespace interlume
{

/**
 * @class   StepMeasures
 * @brief   computes the error of a step, and a bound on its length, in world units
 *
 * For SIMD packs a length is valid only if its square neither overflows nor underflows. Masks named
 * isOrdinary exclude all other lanes. For double, lengths are always valid and the masks remain
 * unchanged.
 */
template <typename Number>
class StepMeasures
{
public:
  using Math = NumberMath<Number>;
  using Mask = typename Math::Mask;

  /// Returns a mask that is true where the square root of \a square is accurate.
  INTERLUME_RETURNS_VECTOR static Mask IsOrdinary(const Number& square)
  {
    return (square > 1e-280) & (square < Math::Of(1e280));
  }

  /**
   * Returns the error of a step without the part that the field itself damps.
   *
   * In a direction in which errors decay as exp(-t / d), the errors e of all steps of duration h
   * accumulate to e / (1 - exp(-h / d)) instead of e t / h. With 1 - exp(-z) ~ z / (1 + z), and
   * over a finite time t, the sum is (h + d) / (t + d) times e t / h. \a time is t: the time to
   * cross the cell, or the time since the start if shorter.
   */
  template <typename Walker, typename Method>
  INTERLUME_RETURNS_VECTOR static Number GetUndampedError(const Walker& field, const Number p[3],
    const Method& method, const Number& h, const Number& time, Mask& isOrdinary)
  {
    Number error[3];
    field.GetWorldVector(p, method.Error, error);
    Number direction[3];
    const Number damping = method.GetDamping(direction);
    const Mask isDamped = (damping > 0.1) & (h < time);
    if (Math::IsAny(isDamped))
    {
      Number axis[3];
      field.GetWorldVector(p, direction, axis);
      isOrdinary &= StepMeasures::Scale(axis) | Math::Not(isDamped);
      const Number part = Math::Dot(error, axis) / Math::Dot(axis, axis);
      const Number lost = 1.0 - (1.0 + damping) / (1.0 + damping * (time / h));
      for (int i = 0; i < 3; ++i)
      {
        error[i] = Math::Select(isDamped, error[i] - part * lost * axis[i], error[i]);
      }
    }
    return StepMeasures::GetLength(error, isOrdinary);
  }

  /// Returns a bound on the distance that a step covers in a cell with constant dx/dp. Any fraction
  /// of the step covers at most that fraction of the bound, even with rounding. \a points are the
  /// control points of \a dense.
  template <typename Walker>
  INTERLUME_RETURNS_VECTOR static Number GetAffineReach(const Walker& field, const Number p[3],
    const DenseOutput<Number>& dense, const Number (*points)[3], Mask& isOrdinary)
  {
    const auto getWorldSlope = [&](int j, Number world[3])
    {
      Number slope[3];
      dense.GetSlope(points, j, slope);
      field.GetWorldVector(p, slope, world);
    };
    Number world[3];
    Number square = Math::Of(0.0);
    for (int j = 0; j < dense.Degree; ++j)
    {
      getWorldSlope(j, world);
      square = Math::Max(square, Math::Dot(world, world));
    }
    Number length = Math::Sqrt(square);
    if constexpr (!IsDouble)
    {
      isOrdinary &= IsOrdinary(square);
    }
    else if (!IsOrdinary(square))
    {
      length = 0.0;
      for (int j = 0; j < dense.Degree; ++j)
      {
        getWorldSlope(j, world);
        length = Math::Max(length, StepMeasures::GetLength(world, isOrdinary));
      }
    }
    return ReachMargin * length;
  }

  static constexpr double ReachMargin = 1.01;

private:
  static constexpr bool IsDouble = std::is_same_v<Number, double>;

  INTERLUME_RETURNS_VECTOR static Number GetLength(const Number v[3], Mask& isOrdinary)
  {
    if constexpr (IsDouble)
    {
      return Vectors::SafeLength(glm::make_vec3(v));
    }
    else
    {
      const Number square = Math::Dot(v, v);
      const Number largest =
        Math::Max(Math::Abs(v[0]), Math::Max(Math::Abs(v[1]), Math::Abs(v[2])));
      isOrdinary &= IsOrdinary(square) | (largest == Math::Of(0.0));
      return Math::Sqrt(square);
    }
  }

  /// Scales a vector of doubles to a length of about 1; leaves SIMD packs unchanged. Returns a mask
  /// that is true where the square root of the squared length is accurate.
  INTERLUME_RETURNS_VECTOR static Mask Scale(Number v[3])
  {
    if constexpr (IsDouble)
    {
      const double scale = MultilinearCell::GetScale(Vectors::InfinityNorm(glm::make_vec3(v)));
      for (int i = 0; i < 3; ++i)
      {
        v[i] *= scale;
      }
      return true;
    }
    else
    {
      return IsOrdinary(Math::Dot(v, v));
    }
  }
};

}

#endif
