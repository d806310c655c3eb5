// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteringSlabs_h
#define ScatteringSlabs_h

#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

namespace scattering
{
/**
 * Slabs of van de Hulst's tables, drawn from directions on both sides and integrated over them,
 * against the published reflection and transmission. A case is a row of a table; those of light
 * that grazes are in the full suite alone. Methods `single`, `forward`, `full`; the parameter is
 * the number of cells of the grid through the slab. Errors are relative, the larger of both sides;
 * counts reflected, transmitted (scattered light alone) and what is published. `monte-carlo`: the
 * parameter is the number of paths of reference::TraceSlab, the error its standard error.
 */
void AddSlabRows(const BenchOptions& options, BenchRows& rows);

/**
 * Where `full` holds: the same errors of slabs in light at right angles, against
 * reference::TraceSlab. A row for each phase function and albedo, with the differences at each
 * depth as counts, reflected and transmitted, relative, where that is more than a thousandth of the
 * light; the error is the largest. Then how many of
 * these settings are within 5, 10 and 20 %.
 */
void AddLimitRows(const BenchOptions& options, BenchRows& rows);
}

#endif
