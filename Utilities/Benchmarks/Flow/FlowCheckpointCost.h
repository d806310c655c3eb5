// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowCheckpointCost_h
#define FlowCheckpointCost_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `flow` about what checkpoints cost.
 */
namespace flow
{
/**
 * The field HURRICANE, followed back to the domain's faces, at most 10 units of time. Methods, the
 * peer of each the same filter without a file:
 * - `checkpoints`: CheckpointInterval as it is, a minute;
 * - `checkpoints-often`: 0, whenever there is something to write and the last one took less than a
 *   tenth of the time since.
 */
void AddCheckpointRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckCheckpointClaims(const std::vector<BenchRow>& rows);
}

#endif
