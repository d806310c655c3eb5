// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dSpeed_h
#define Interval4dSpeed_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `interval4d` about run time with a table that is filled.
 */
namespace interval4d
{
/**
 * For every case, with the table filled by a run before:
 * - method `warm`, by one thread and by all;
 * - method `threads-2`, two threads against the peer `threads-1`.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows);
}

#endif
