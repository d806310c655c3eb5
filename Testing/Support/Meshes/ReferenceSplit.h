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

/// The mean of some points of a grid: one of its points, or the centre of one of its cells.
using MeanPoint = std::vector<vtkIdType>;
using SplitTetrahedron = std::array<MeanPoint, 4>;

/// The mean of what \a get gives at the points of \a mean.
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
 * Cuts the three-dimensional cells of a mesh into tetrahedra, which are oriented as the faces of
 * the cells are: a tetrahedron is itself; any other cell is cut from its centre over its faces,
 * each cut from its point of the lowest number, so that two cells cut the face they share alike.
 */
void ForEachTetrahedron(
  vtkDataSet* mesh, const std::function<void(vtkIdType cell, const SplitTetrahedron&)>& visit);

}

#endif
