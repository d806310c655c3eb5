// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StepController_h
#define interlume_StepController_h

#include <algorithm>
#include <cmath>

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
    const bool wasRejected = this->WasRejected;
    this->WasRejected = false;
    double factor = Largest;
    if (ratio > SmallRatio)
    {
      factor = StepController::GetFactor(ratio, this->Previous, order);
    }
    this->Previous = std::max(ratio, LeastPrevious);
    return wasRejected ? std::min(factor, 1.0) : factor;
  }

  /// Returns what the step is multiplied by, below 1, after an error above the largest; the
  /// smallest factor for NaN and infinity.
  double Reject(double ratio, int order)
  {
    this->WasRejected = true;
    const double factor = Safety * std::pow(ratio, -1.0 / order);
    return factor > Smallest ? std::min(factor, Safety) : Smallest;
  }

  /// Returns what the step is multiplied by after accepted errors of \a ratio above SmallRatio, and
  /// of \a previous before.
  static double GetFactor(double ratio, double previous, int order)
  {
    // Most often the error before was small.
    static const double least = std::pow(LeastPrevious, Integral);
    const double part = previous == LeastPrevious ? least : std::pow(previous, Integral);
    const double factor = Safety * std::pow(ratio, -1.0 / order + 0.75 * Integral) * part;
    return std::min(Largest, std::max(Smallest, factor));
  }

  static constexpr double Largest = 5.0;
  /// The ratio below which the step is multiplied by the largest factor.
  static constexpr double SmallRatio = 1e-5;
  /// The least ratio that is kept.
  static constexpr double LeastPrevious = 1e-4;

  /// What is kept of the step before, for those who take steps in its place.
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
