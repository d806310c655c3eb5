// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedronMath_h
#define interlume_TetrahedronMath_h

namespace interlume
{

/**
 * Geometry of one tetrahedron a, b, c, d, positive when (b-a) . (c-a) x (d-a) is.
 */
namespace TetrahedronMath
{

/// Returns the sine of the solid angle at a, a measure of shape without a unit: at most 1 in
/// magnitude.
double PolarSine(const double* a, const double* b, const double* c, const double* d);

/// Returns the radius of the circumscribed sphere over the shortest edge; at least sqrt(6)/4 =
/// 0.612.
double RadiusEdgeRatio(const double* a, const double* b, const double* c, const double* d);

}

}

#endif
