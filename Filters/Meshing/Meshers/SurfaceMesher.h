// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceMesher_h
#define interlume_SurfaceMesher_h

#include <string>

namespace interlume
{

struct MeshingJob;

/**
 * @class   SurfaceMesher
 * @brief   fills closed surfaces with tetrahedra
 */
class SurfaceMesher
{
public:
  /// Fills the job's mesh. Returns why it cannot, or nothing.
  static std::string Execute(MeshingJob& job);
};

}

#endif
