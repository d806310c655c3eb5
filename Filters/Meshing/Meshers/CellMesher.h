// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellMesher_h
#define interlume_CellMesher_h

#include <string>

namespace interlume
{

struct MeshingJob;

/**
 * @class   CellMesher
 * @brief   cuts the three-dimensional cells of a dataset into tetrahedra that fit together
 *
 * A face is cut by FaceTriangulation, in the order of the point data's global ids where there
 * are some and of the point ids otherwise, so that cells on both sides have the same triangles.
 */
class CellMesher
{
public:
  /// Fills the job's mesh. Returns why it cannot, or nothing.
  static std::string Execute(MeshingJob& job);
};

}

#endif
