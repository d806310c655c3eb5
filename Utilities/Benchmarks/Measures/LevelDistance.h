// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelDistance_h
#define LevelDistance_h

#include <cmath>

/**
 * Returns the distance of \a point from the level set where a function equals \a value, measured
 * along the gradient. Newton's method stops when the remaining distance is below 1e-14 times
 * \a length, or after 10 steps.
 *
 * \a evaluate(at, gradient) returns the value of the function and sets its gradient.
 */
template <typename Function>
double DistanceToLevel(Function&& evaluate, const double point[3], double value, double length)
{
  const int maximumSteps = 10;
  double at[3] = { point[0], point[1], point[2] };
  for (int step = 0; step < maximumSteps; ++step)
  {
    double gradient[3];
    const double excess = evaluate(at, gradient) - value;
    const double square =
      gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2];
    if (square == 0.0 || excess * excess < 1e-28 * square * length * length)
    {
      break;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] -= excess * gradient[axis] / square;
    }
  }
  return std::hypot(at[0] - point[0], at[1] - point[1], at[2] - point[2]);
}

#endif
