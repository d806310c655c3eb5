// SPDX-License-Identifier: BSD-3-Clause
#ifndef PowerFit_h
#define PowerFit_h

#include <vector>

/**
 * The exponent p of y = c x^p through positive numbers: the slope of a straight line through their
 * logarithms, by least squares.
 */
double FitExponent(const std::vector<double>& x, const std::vector<double>& y);

#endif
