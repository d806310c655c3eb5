// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceNoise_h
#define ReferenceNoise_h

#include <array>

namespace reference
{

/// The weight of a lattice point of the noise at distance \a t, in lattice lengths.
double GetTent(double t);

/// The noise of vtkFlowLIC at a place, written down again from its header's words.
double GetNoise(const std::array<double, 3>& x, double scale, int seed);

}

#endif
