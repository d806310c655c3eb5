// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dCounts_h
#define Interval4dCounts_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `interval4d` about numbers of simplices: tables 3.5 and 3.6 of C. Zhang,
 * dissertation, Ohio State 2006.
 */
namespace interval4d
{
/**
 * For the vortex and the wave methods `hexahedra` and `tetrahedra-5`, every hexahedron cut into
 * five tetrahedra beforehand: 3-simplices of the interval volume of the first step, 4-simplices
 * between the steps, projected tetrahedra by class; each with the number of the source as
 * `stated_...`, where it has one.
 */
void AddCountRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckCountClaims(const std::vector<BenchRow>& rows);
}

#endif
