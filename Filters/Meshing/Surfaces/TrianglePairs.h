// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TrianglePairs_h
#define interlume_TrianglePairs_h

#include <functional>

namespace interlume
{

class ClosedSurface;

/**
 * Enumerates pairs of triangles with nearby bounding boxes.
 */
namespace TrianglePairs
{
/// Calls \a function with the indices of each pair of triangles whose bounding boxes are at most \a
/// distance apart along every axis.
void ForEach(
  const ClosedSurface& surface, double distance, const std::function<void(int, int)>& function);
}

}

#endif
