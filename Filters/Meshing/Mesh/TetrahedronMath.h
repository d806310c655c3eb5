// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedronMath_h
#define interlume_TetrahedronMath_h

namespace interlume
{

/**
 * Geometric measures of the tetrahedron with vertices a, b, c, d. Its orientation is positive if
 * (b-a) . ((c-a) x (d-a)) > 0.
 */
namespace TetrahedronMath
{

/// Returns the polar sine of the edges at a: six times the signed volume, divided by the product of
/// the lengths of these three edges. It is a scale-invariant quality measure with a magnitude of at
/// most 1.
double PolarSine(const double* a, const double* b, const double* c, const double* d);

/// Returns the circumradius divided by the shortest edge length. It is at least sqrt(6)/4 = 0.612.
double RadiusEdgeRatio(const double* a, const double* b, const double* c, const double* d);

}

}

#endif
