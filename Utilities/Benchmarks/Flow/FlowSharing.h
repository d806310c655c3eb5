// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowSharing_h
#define FlowSharing_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `flow` about samples that take the answers of those around them.
 */
namespace flow
{
/**
 * The six fields of MakeFieldCases that are neither uniform nor stiff, about 100,000 samples on an
 * image each. Method `shared`, the parameter being MaximumError over the largest speed: time of
 * vtkImplicitFlowField with ShareStreamlines against that without; `within` is the share of the
 * samples of the same status and id whose ends are no further apart than 10 MaximumError times
 * their time and whose times, at the largest speed, are neither.
 */
void AddSharingRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckSharingClaims(const std::vector<BenchRow>& rows);
}

#endif
