// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowConservation_h
#define FlowConservation_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `flow` about flux through the time surfaces of stream volumes.
 */
namespace flow
{
/**
 * Method `conservation`: stream volumes from a disc in fields without divergence, `contraction`,
 * `sphere` (beside it) and `abc`; the error is the largest deviation of the flux through a time
 * surface from that through the disc, relative to it.
 */
void AddConservationRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckConservationClaims(const std::vector<BenchRow>& rows);
}

#endif
