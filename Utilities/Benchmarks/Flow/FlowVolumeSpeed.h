// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowVolumeSpeed_h
#define FlowVolumeSpeed_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `flow` about stream volumes that change.
 */
namespace flow
{
/**
 * The field HURRICANE, followed back to the domain's faces, but at most 10 units of time; samples
 * are the points of an image of that many points a side, twice those of the field. Methods:
 * - `samples`: the advection, all threads, once;
 * - `new-mapping`, `new-interval`, `new-times`: a new stream volume after a change of the inflow
 *   mapping, of its interval alone, of the range of times alone; the peer `advection` is that of
 *   `samples`, the count `advections` how often it was done again.
 */
void AddVolumeRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckVolumeClaims(const std::vector<BenchRow>& rows);
}

#endif
