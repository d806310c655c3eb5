// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceNoise_h
#define ReferenceNoise_h

#include <array>

namespace reference
{

/// Returns the weight of a noise grid point at distance \a t, which is in units of the grid
/// spacing.
double GetTent(double t);

/// Returns the noise of vtkFlowLIC at \a x, from an independent implementation.
double GetNoise(const std::array<double, 3>& x, double scale, int seed);

}

#endif
