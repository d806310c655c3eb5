// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSplit_h
#define ReferenceSplit_h

#include "vtkType.h" // for vtkIdType

#include <array>      // for tetrahedra
#include <functional> // for the visitor
#include <vector>     // for corners

class vtkDataSet;

namespace reference
{

/// A grid point or a cell center, stored as the ids of the grid points of which it is the mean.
using MeanPoint = std::vector<vtkIdType>;
using SplitTetrahedron = std::array<MeanPoint, 4>;

/// Returns the mean of get(id) over the ids in \a mean.
template <typename Real, typename Get>
Real MeanOf(const MeanPoint& mean, Get&& get)
{
  Real sum = 0;
  for (vtkIdType id : mean)
  {
    sum += get(id);
  }
  return sum / static_cast<Real>(mean.size());
}

/**
 * Splits the three-dimensional cells of a mesh into tetrahedra with the orientation of the cells. A
 * tetrahedron is not split. Any other cell is split into tetrahedra that connect its center with
 * the triangles of its faces. Each face is split into a triangle fan around its point with the
 * lowest id, so two cells split their common face in the same way.
 */
void ForEachTetrahedron(
  vtkDataSet* mesh, const std::function<void(vtkIdType cell, const SplitTetrahedron&)>& visit);

}

#endif
