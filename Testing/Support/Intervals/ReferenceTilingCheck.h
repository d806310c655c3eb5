// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTilingCheck_h
#define ReferenceTilingCheck_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <vector> // for the bounds

class vtkUnstructuredGrid;

namespace reference
{

/// Totals over many extractions, printed by the test.
struct TilingCounts
{
  long long Tetrahedra = 0;
  long long Triangles = 0;
  long long Inverted = 0;
  double NegativeVolume = 0; ///< sum over extractions, each relative to the domain
  double VolumeError = 0;    ///< maximum, relative to the domain
  int Extractions = 0;
};

/**
 * Extracts the adjacent intervals [bounds[0], bounds[1]], [bounds[1], bounds[2]], ... of the active
 * scalars of \a mesh with one filter, and checks that they tile the domain. The bounds must include
 * all values. The checks are:
 * - The signed volumes add up to the volume of the domain within 1e-12.
 * - The boundary of the tetrahedra of an interval consists of its triangles on port 1 and part of
 *   the domain's boundary. The intervals together cover the domain's boundary.
 * - The upper triangles of interval i are the reversed lower triangles of interval i + 1.
 *   Exceptions are upper triangles of interval i in boundary faces of the domain, where the next
 *   interval has no tetrahedra.
 * - Inside the domain, the triangles of an interval have no open edges, and each occurs once.
 * - The scalar is between the bounds on each tetrahedron and equal to the bound on each triangle.
 *
 * If \a generic is true, no value may equal an inner bound, and it also checks that:
 * - Every face of the tetrahedra is used once, or twice with opposite orientation.
 * - The lower and the upper boundary of each interval are two-manifolds.
 */
void CheckTiling(vtkUnstructuredGrid* mesh, const std::vector<double>& bounds, bool generic,
  Check& check, TilingCounts& counts);

/// Prints the counts for a kind of mesh in one line.
void Print(const TilingCounts& counts, const std::string& name);

}

#endif
