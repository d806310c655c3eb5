// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceMesher_h
#define interlume_SurfaceMesher_h

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
  static void Execute(MeshingJob& job);
};

}

#endif
