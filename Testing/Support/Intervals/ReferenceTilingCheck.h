// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTilingCheck_h
#define ReferenceTilingCheck_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <vector> // for the bounds

class vtkUnstructuredGrid;

namespace reference
{

/// Counts over many extractions, for the report.
struct TilingCounts
{
  long long Tetrahedra = 0;
  long long Triangles = 0;
  long long Inverted = 0;
  double NegativeVolume = 0; ///< as a share of the domains, summed
  double VolumeError = 0;    ///< the largest, relative to the domain
  int Extractions = 0;
};

/**
 * Extracts the adjacent intervals [bounds[0], bounds[1]], [bounds[1], bounds[2]], ... of the active
 * scalars of \a mesh in one filter, the first bound at or below all values and the last at or
 * above, and checks that they tile the domain:
 * - the signed volumes add up to the domain's to 1e-12;
 * - the boundary of the tetrahedra of an interval is its triangles on port 1 and a part of the
 *   domain's boundary; the parts of all intervals cover that boundary;
 * - interval i's upper triangles are interval i+1's lower ones with the other side up, but for
 * those of interval i in faces of the domain, where values equal its bound and no cell lies beyond;
 * - inside the domain the triangles of an interval are closed, and none is there twice;
 * - the scalar is between the bounds on each tetrahedron and equal to the bound on each triangle;
 * and, when no value equals a bound inside the range (\a generic):
 * - every face of the tetrahedra is used once, or twice with opposite orientation;
 * - each side of an interval is a two-manifold.
 */
void CheckTiling(vtkUnstructuredGrid* mesh, const std::vector<double>& bounds, bool generic,
  Check& check, TilingCounts& counts);

/// Prints the counts of a kind of mesh in one line.
void Print(const TilingCounts& counts, const std::string& name);

}

#endif
