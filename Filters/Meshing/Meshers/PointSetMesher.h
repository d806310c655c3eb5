// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointSetMesher_h
#define interlume_PointSetMesher_h

#include <string>

namespace interlume
{

struct MeshingJob;

/**
 * @class   PointSetMesher
 * @brief   the Delaunay tetrahedra of a set of points, refined where a bound is set
 *
 * A point that refinement adds has the values of the linear interpolation in the Delaunay
 * tetrahedron of the input's points that it lies in.
 */
class PointSetMesher
{
public:
  /// Fills the job's mesh. Returns why it cannot, or nothing.
  static std::string Execute(MeshingJob& job);
};

}

#endif
