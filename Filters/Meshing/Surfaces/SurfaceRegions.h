// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceRegions_h
#define interlume_SurfaceRegions_h

#include "vtkType.h"

#include <vector>

namespace interlume
{

struct TetGenSolution;

/**
 * @class   SurfaceRegions
 * @brief   which part of the space within a surface a tetrahedron is in
 *
 * The triangles on facets cut the mesh into regions. The depth of a region is the least number of
 * facets between it and the outside, where one that two parts share counts twice beyond the first
 * region. Regions are numbered in the order of the first input cell that
 * bounds them, of two with the same cell the one of lower depth first.
 */
class SurfaceRegions
{
public:
  /// Finds the regions. \a cellIds and \a layers have the input cell of a marker, less one, and the
  /// number of parts that share its facet. Regions of even depth
  /// are kept only if \a fillNestedShells.
  SurfaceRegions(const TetGenSolution& solution, const std::vector<vtkIdType>& cellIds,
    const std::vector<int>& layers, bool fillNestedShells);

  /// Returns the number of the region of a tetrahedron; -1 for one that is not kept.
  int operator()(int tetrahedron) const { return this->Numbers[this->Regions[tetrahedron]]; }
  int GetNumberOfRegions() const { return this->NumberOfRegions; }

private:
  std::vector<int> Regions;
  std::vector<int> Numbers;
  int NumberOfRegions = 0;
};

}

#endif
