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
 * Where the points of an extraction by rows go: into the arrays of the output, where the context
 * has them, or else into the list of the mesh, which is interpolated later.
 */
namespace PointOutput
{
/// Puts \a points in their places on the edges, then writes them from \a place on.
inline void Write(const ExtractionContext& context, const ExtractionScalars& scalars,
  ExtractionPoint* points, vtkIdType number, vtkIdType place, ExtractionMesh& mesh)
{
  scalars.Place(points, number);
  if (context.Arrays)
  {
    context.Arrays->Write(points, number, place);
  }
  else
  {
    std::copy_n(points, number, mesh.Points.GetData() + place);
  }
}
}

}

#endif
