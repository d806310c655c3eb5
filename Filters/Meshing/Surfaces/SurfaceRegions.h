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
 * @brief   assigns tetrahedra to the regions inside a surface
 *
 * Facet triangles divide the mesh into regions. The depth of a region is the minimum number of
 * facets between the region and the outside. A facet between two regions counts twice if two parts
 * of the surface share it. Regions are numbered by the first input cell on their boundary; of two
 * regions with the same cell, the region of lower depth is first.
 */
class SurfaceRegions
{
public:
  /// Finds the regions. Entry i of \a cellIds is the input cell of the facet with marker i + 1, and
  /// entry i of \a layers is the number of parts of the surface that share the facet. Regions of
  /// even depth are kept only if \a fillNestedShells is true.
  SurfaceRegions(const TetGenSolution& solution, const std::vector<vtkIdType>& cellIds,
    const std::vector<int>& layers, bool fillNestedShells);

  /// Returns the region of a tetrahedron, or -1 if it is not kept.
  int operator()(int tetrahedron) const { return this->Numbers[this->Regions[tetrahedron]]; }
  int GetNumberOfRegions() const { return this->NumberOfRegions; }

private:
  std::vector<int> Regions;
  std::vector<int> Numbers;
  int NumberOfRegions = 0;
};

}

#endif
