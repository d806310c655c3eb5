// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BracketedRoot_h
#define interlume_BracketedRoot_h

#include <cmath>
#include <limits>

namespace interlume
{

/**
 * @class   BracketedRoot
 * @brief   finds a root of a function between two positions at which its signs differ
 *
 * The method is from T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding
 * the zero of a nonlinear function without using derivatives", Adv. Eng. Software 28 (1997). It
 * uses inverse quadratic interpolation where it converges, otherwise bisection. It ends at adjacent
 * floating-point numbers or at a discontinuity.
 */
struct BracketedRoot
{
  template <typename Function>
  static double Find(Function& function, double a, double fa, double b, double fb)
  {
    double c = a;
    double fc = fa;
    double part = 0.5;
    for (int iteration = 0; iteration < 200; ++iteration)
    {
      const double x = a + part * (b - a);
      const double fx = function(x);
      if ((fx < 0.0) == (fa < 0.0))
      {
        c = a;
        fc = fa;
      }
      else
      {
        c = b;
        b = a;
        fc = fb;
        fb = fa;
      }
      a = x;
      fa = fx;
      const double best = std::abs(fa) < std::abs(fb) ? a : b;
      const double minimum =
        2.0 * std::numeric_limits<double>::epsilon() * std::abs(best) / std::abs(b - a);
      if (fa == 0.0 || fb == 0.0 || !(minimum < 0.5))
      {
        return fa == 0.0 ? a : best;
      }
      const double xi = (a - b) / (c - b);
      const double phi = (fa - fb) / (fc - fb);
      part = 0.5;
      if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)
      {
        part =
          fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
      }
      part = std::fmin(1.0 - minimum, std::fmax(minimum, part));
    }
    return a;
  }
};

}

#endif
