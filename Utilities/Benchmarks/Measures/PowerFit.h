// SPDX-License-Identifier: BSD-3-Clause
#ifndef PowerFit_h
#define PowerFit_h

#include <vector>

/**
 * Returns the exponent p of y = c x^p, fitted to positive numbers by linear regression of the
 * logarithms.
 */
double FitExponent(const std::vector<double>& x, const std::vector<double>& y);

#endif
