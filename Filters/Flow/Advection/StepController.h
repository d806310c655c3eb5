// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StepController_h
#define interlume_StepController_h

#include "Numerics/NumberMath.h"
#include "Numerics/Powers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

/**
 * @class   StepController
 * @brief   the next step from the error of the last
 *
 * This is proportional-integral control with the constants of Hairer and Wanner's programs (E.
 * Hairer, S. P. Norsett and G. Wanner, "Solving Ordinary Differential Equations" I, section II.4,
 * and II, section IV.2), for an error per unit of time.
 */
class StepController
{
public:
  /// Returns what the step is multiplied by, 0.2 to 5, after an error of \a ratio of the largest,
  /// <= 1.
  double Accept(double ratio, int order)
  {
    using Two = Lanes<2>;
    Two previous = Two::Of(this->Previous);
    const Two none = Two::Of(0.0);
    const typename Two::Mask wasRejected = this->WasRejected ? none == none : none < none;
    const double factor = GetFactor(Two::Of(ratio), order, wasRejected, previous).Get(0);
    this->WasRejected = false;
    this->Previous = previous.Get(0);
    return factor;
  }

  /// Returns what the step is multiplied by, below 1, after an error above the largest; the
  /// smallest factor for NaN and infinity.
  double Reject(double ratio, int order)
  {
    this->WasRejected = true;
    const double factor = Safety * std::pow(ratio, -1.0 / order);
    return factor > Smallest ? std::min(factor, Safety) : Smallest;
  }

  /// Returns what steps are multiplied by after accepted errors of \a ratio. \a previous is what is
  /// kept of the error before, and becomes that of this one.
  template <typename Lanes>
  [[gnu::always_inline]] static Lanes GetFactor(
    const Lanes& ratio, int order, const typename Lanes::Mask& wasRejected, Lanes& previous)
  {
    const Lanes one = Lanes::Of(1.0);
    const Lanes largest = Lanes::Of(Largest);
    // The largest factor comes of all smaller errors.
    const Lanes error = Powers::GetLogarithm(Lanes::Max(Lanes::Of(0.5 * SmallRatio), ratio));
    const Lanes power = (-1.0 / order + 0.75 * Integral) * error + Integral * previous;
    const Lanes controlled = Safety * Powers::GetPower(power);
    const Lanes limited = Lanes::Min(largest, Lanes::Max(Lanes::Of(Smallest), controlled));
    const Lanes factor = Lanes::Select(ratio > SmallRatio, limited, largest);
    previous = Lanes::Max(error, Lanes::Of(LeastPrevious));
    return Lanes::Select(wasRejected, Lanes::Min(factor, one), factor);
  }

  /// Returns the next step after one of \a h that was multiplied by \a factor. \a step is the step
  /// that the error allowed: one that was short to stay in the cell says nothing against it.
  template <typename Number>
  [[gnu::always_inline]] static Number GetNext(
    const Number& step, const Number& h, const Number& factor, const Number& ratio)
  {
    using Math = NumberMath<Number>;
    const Number next = Math::Min(h * factor, Math::Of(std::numeric_limits<double>::max()));
    return Math::Select(ratio < 1e-3, Math::Max(step, next), next);
  }

  static constexpr double Largest = 5.0;
  /// The ratio below which the step is multiplied by the largest factor.
  static constexpr double SmallRatio = 1e-5;
  /// The least binary logarithm of a ratio that is kept, that of 1e-4.
  static constexpr double LeastPrevious = -13.287712379549449;

  /// What is kept of the step before, a logarithm, for those who take steps in its place.
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

  double Previous = LeastPrevious;
  bool WasRejected = false;
};

}

#endif
