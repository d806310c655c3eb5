// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFilling_h
#define ReferenceFilling_h

#include "Support/Checks/ReferenceCheck.h"          // for the result
#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include <string> // for names
#include <vector> // for the bounds

namespace reference
{

/// Statistics of many extractions, which the test prints.
struct FillingCounts
{
  long long Simplices = 0;
  long long Inverted = 0;
  long long Tetrahedra = 0;
  double Error = 0; ///< largest hypervolume error of the 4-simplices, relative to the domain
  double WeightedError = 0; ///< largest such error of the tetrahedron volumes times DeltaT
  int Extractions = 0;
};

/**
 * Extracts the adjacent intervals [bounds[0], bounds[1]], [bounds[1], bounds[2]], ... of the active
 * scalars of all steps with one filter, and checks that they fill the domain in space and time. The
 * bounds must enclose all scalar values. The checks are:
 * - The signed hypervolumes of the 4-simplices add up to the hypervolume of the domain within
 *   1e-12, and so do the volumes of the tetrahedra times DeltaT.
 * - On each 4-simplex, the scalar is between the bounds of its interval, and the time is between
 *   the two steps of its slab.
 * - The boundary of the 4-simplices of an interval, over all slabs, consists of the tetrahedra of
 *   port 1 and parts of the domain's side walls. Each cell of port 1 occurs once, and its points
 *   match its boundary kind.
 * - The triangles of port 1 are the boundary of its tetrahedra at the first and last step, except
 *   in side walls.
 * - The upper boundary of interval i is the lower boundary of interval i + 1. Exceptions are cells
 *   on side walls and at the first and last step, with values equal to the bound.
 *
 * If no value equals an interior bound (\a generic), it also checks that:
 * - Every face of the 4-simplices is used once, or twice with opposite orientation.
 * - Every cell of port 1 is a face of one 4-simplex, or of one tetrahedron at a step.
 *
 * The domain is static, or a box whose sides move linearly.
 */
void CheckFilling(const TimeSteps& steps, const std::vector<double>& bounds, bool generic,
  Check& check, FillingCounts& counts);

/// Prints the counts in one line that starts with the name of the grid.
void Print(const FillingCounts& counts, const std::string& name);

}

#endif
