// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TextureSearch_h
#define interlume_TextureSearch_h

#include "Termination/BoxTree.h"
#include "Termination/TerminationTriangles.h"

namespace interlume
{

/**
 * @class   TextureSearch
 * @brief   finds the point of a mesh with given texture coordinates
 *
 * Triangles of zero area in texture space are skipped. If triangles overlap in texture space, the
 * same one is always found.
 */
class TextureSearch
{
public:
  /// Builds the search structure. The mesh must outlive this object.
  void Build(const TerminationTriangles* mesh, const bool isPeriodic[2]);

  /// Finds the point with the given texture coordinates. Returns false if no triangle is within
  /// vtkTerminationSurface::BorderTolerance of them.
  bool FindPoint(const double uv[2], double x[3]) const;

private:
  const TerminationTriangles* Mesh = nullptr;
  BoxTree Tree;
  bool IsPeriodic[2] = { false, false };
};

}

#endif
