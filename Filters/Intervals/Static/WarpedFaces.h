// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_WarpedFaces_h
#define interlume_WarpedFaces_h

#include "Static/ExtractionContext.h"

class vtkPoints;

namespace interlume
{

/**
 * @class   WarpedFaces
 * @brief   counts the quadrilaterals, not planar, where a whole cell meets tetrahedra
 *
 * There a whole cell's face is one surface through four points, and the tetrahedra's are two
 * triangles.
 */
class WarpedFaces
{
public:
  /// Returns their number in the first pass's mesh, whose coordinates are \a points.
  static vtkIdType Count(
    const ExtractionContext& context, const ExtractionMesh& mesh, vtkPoints* points);
};

}

#endif
