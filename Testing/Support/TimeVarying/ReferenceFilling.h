// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFilling_h
#define ReferenceFilling_h

#include "Support/Checks/ReferenceCheck.h"          // for the result
#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include <string> // for names
#include <vector> // for the bounds

namespace reference
{

/// Counts over many extractions, for the report.
struct FillingCounts
{
  long long Simplices = 0;
  long long Inverted = 0;
  long long Tetrahedra = 0;
  double Error = 0;         ///< the largest of the 4-simplices, relative to the domain
  double WeightedError = 0; ///< the largest of the tetrahedra times DeltaT
  int Extractions = 0;
};

/**
 * Extracts the adjacent intervals [bounds[0], bounds[1]], [bounds[1], bounds[2]], ... of the active
 * scalars of all steps in one filter, the first bound at or below all values and the last at or
 * above, and checks that they fill the domain in space and time:
 * - the signed hypervolumes of the 4-simplices add up to the domain's to 1e-12, and so do the
 *   volumes of the tetrahedra times DeltaT;
 * - the scalar is between the bounds on each 4-simplex, the time in its slab;
 * - the boundary of the 4-simplices of an interval, slabs together, is the tetrahedra of port 1 and
 * a part of the domain's side walls; each cell of port 1 is what its kind says, and is there once;
 * - the triangles of port 1 are the boundary of its tetrahedra at the first and last step, but for
 * the side walls;
 * - interval i's upper boundary is interval i+1's lower one, but for cells of interval i on walls
 * and at the first and last step, where values equal its bound and nothing lies beyond; and, when
 * no value equals a bound inside the range (\a generic):
 * - every face of the 4-simplices is used once, or twice with opposite orientation;
 * - every cell of port 1 is a face of one 4-simplex, or of one tetrahedron at a step.
 *
 * The domain is a box whose sides move linearly, or does not move.
 */
void CheckFilling(const TimeSteps& steps, const std::vector<double>& bounds, bool generic,
  Check& check, FillingCounts& counts);

/// Prints the counts of a kind of grid in one line.
void Print(const FillingCounts& counts, const std::string& name);

}

#endif
