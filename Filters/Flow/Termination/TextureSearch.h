// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TextureSearch_h
#define interlume_TextureSearch_h

#include "Termination/BoxTree.h"
#include "Termination/TerminationTriangles.h"

namespace interlume
{

/**
 * @class   TextureSearch
 * @brief   the point of a mesh that has given texture coordinates
 *
 * Triangles without area in the texture are left out. Where triangles overlap in the texture one of
 * them is found, always the same.
 */
class TextureSearch
{
public:
  /// Takes triangles that stay where they are.
  void Build(const TerminationTriangles* mesh, const bool isPeriodic[2]);

  /// Finds the point with these coordinates. Returns false where no triangle is within
  /// vtkTerminationSurface::BorderTolerance.
  bool FindPoint(const double uv[2], double x[3]) const;

private:
  const TerminationTriangles* Mesh = nullptr;
  BoxTree Tree;
  bool IsPeriodic[2] = { false, false };
};

}

#endif
