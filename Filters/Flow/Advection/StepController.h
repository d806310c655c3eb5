// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StepController_h
#define interlume_StepController_h

#include "Numerics/NumberMath.h"
#include "Numerics/SimdPowers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

/**
 * @class   StepController
 * @brief   computes the duration of the next step from the error of the last one
 *
 * This is a proportional-integral (PI) controller for the error per unit of time. Its constants are
 * from the programs of E. Hairer, S. P. Norsett and G. Wanner, "Solving Ordinary Differential
 * Equations I", section II.4, and volume II, section IV.2.
 */
class StepController
{
public:
  /// Returns the factor from 0.2 to 5 by which to change the step duration after an accepted step.
  /// \a ratio is the error divided by the largest permitted error (<= 1).
  double Accept(double ratio, int order)
  {
    using Two = SimdPack<2>;
    Two previous = Two::Of(this->Previous);
    const Two none = Two::Of(0.0);
    const typename Two::Mask wasRejected = this->WasRejected ? none == none : none < none;
    const double factor = GetFactor(Two::Of(ratio), order, wasRejected, previous).Get(0);
    this->WasRejected = false;
    this->Previous = previous.Get(0);
    return factor;
  }

  /// Returns the factor by which to shorten a rejected step. Returns the smallest factor if \a
  /// ratio is NaN or infinite.
  double Reject(double ratio, int order)
  {
    this->WasRejected = true;
    const double factor = Safety * std::pow(ratio, -1.0 / order);
    return factor > Smallest ? std::min(factor, Safety) : Smallest;
  }

  /// Returns the factors after accepted steps with the error ratios \a ratio. \a previous is the
  /// binary logarithm of the previous error ratio on input and of \a ratio on output.
  template <typename SimdPack>
  [[gnu::always_inline]] static SimdPack GetFactor(const SimdPack& ratio, int order,
    const typename SimdPack::Mask& wasRejected, SimdPack& previous)
  {
    const SimdPack one = SimdPack::Of(1.0);
    const SimdPack largest = SimdPack::Of(Largest);
    // The bound keeps the logarithm finite. Ratios of at most SmallRatio yield the largest factor
    // anyway.
    const SimdPack error = SimdPowers::Log2(SimdPack::Max(SimdPack::Of(0.5 * SmallRatio), ratio));
    const SimdPack power = (-1.0 / order + 0.75 * Integral) * error + Integral * previous;
    const SimdPack controlled = Safety * SimdPowers::Exp2(power);
    const SimdPack limited =
      SimdPack::Min(largest, SimdPack::Max(SimdPack::Of(Smallest), controlled));
    const SimdPack factor = SimdPack::Select(ratio > SmallRatio, limited, largest);
    previous = SimdPack::Max(error, SimdPack::Of(MinimumPrevious));
    return SimdPack::Select(wasRejected, SimdPack::Min(factor, one), factor);
  }

  /// Returns the duration of the next step: \a h times \a factor, where \a h is the duration of the
  /// last step. If \a ratio is small because \a h was shortened to stay in the cell, returns at
  /// least \a step, the duration that the error control allowed.
  template <typename Number>
  [[gnu::always_inline]] static Number GetNext(
    const Number& step, const Number& h, const Number& factor, const Number& ratio)
  {
    using Math = NumberMath<Number>;
    const Number next = Math::Min(h * factor, Math::Of(std::numeric_limits<double>::max()));
    return Math::Select(ratio < 1e-3, Math::Max(step, next), next);
  }

  static constexpr double Largest = 5.0;
  /// Error ratio up to which the factor is Largest.
  static constexpr double SmallRatio = 1e-5;
  /// Lower bound of the stored binary logarithm of an error ratio: log2(1e-4).
  static constexpr double MinimumPrevious = -13.287712379549449;

  /// State exchanged with SimdDormandPrince. GetPrevious returns the binary logarithm of
  /// the previous error ratio.
  double GetPrevious() const { return this->Previous; }
  bool GetWasRejected() const { return this->WasRejected; }
  void Restore(double previous, bool wasRejected)
  {
    this->Previous = previous;
    this->WasRejected = wasRejected;
  }

private:
  static constexpr double Safety = 0.9;
  static constexpr double Integral = 0.04;
  static constexpr double Smallest = 0.2;

  double Previous = MinimumPrevious;
  bool WasRejected = false;
};

}

#endif
