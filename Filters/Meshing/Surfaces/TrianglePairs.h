// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TrianglePairs_h
#define interlume_TrianglePairs_h

#include <functional>
#include <vector>

namespace interlume
{

/**
 * Pairs of triangles whose boxes are near each other.
 */
namespace TrianglePairs
{
/// Calls \a function with each two of the \a triangles, three indices of \a points each, whose
/// boxes are at most \a distance apart along every axis.
void ForEach(const std::vector<double>& points, const std::vector<int>& triangles, double distance,
  const std::function<void(int, int)>& function);
}

}

#endif
