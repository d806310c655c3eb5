// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointOutput_h
#define interlume_PointOutput_h

#include "Arrays/PointArrays.h"
#include "Pass/ExtractionContext.h"
#include "Scalars/ExtractionScalars.h"

#include <algorithm>

namespace interlume
{

/**
 * Writes the points of a structured extraction directly to the output arrays if the context refers
 * to such arrays. Otherwise the points are stored in the mesh and interpolated later.
 */
namespace PointOutput
{
/// Computes the position of \a points on their edges and writes them, beginning at index \a
/// position.
inline void Write(const ExtractionContext& context, const ExtractionScalars& scalars,
  ExtractionPoint* points, vtkIdType number, vtkIdType position, ExtractionMesh& mesh)
{
  scalars.Place(points, number);
  if (context.Arrays)
  {
    context.Arrays->Write(points, number, position);
  }
  else
  {
    std::copy_n(points, number, mesh.Points.GetData() + position);
  }
}
}

}

#endif
