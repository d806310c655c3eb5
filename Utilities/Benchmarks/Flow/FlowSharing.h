// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowSharing_h
#define FlowSharing_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * What the suite `flow-sharing` measures: samples that take the answers of those around them.
 */
namespace flow
{
/**
 * The fields of MakeSharingCases, about 100,000 samples on an image each, a quarter as wide for
 * `dense`. Method `shared`, the parameter being MaximumError over the largest speed: processor time
 * of vtkImplicitFlowField with ShareStreamlines against that without. The error of a sample is the
 * distance of the ends, or the difference of times at the largest speed, whichever is more, over
 * MaximumError times the time of the streamline; infinite where status or id differ, written as
 * 1e30. `median`, `q99`, `q999` and `largest` are of the samples that were interpolated, `within`
 * is the share of all samples whose error is at most 10.
 */
void AddSharingRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckSharingClaims(const std::vector<BenchRow>& rows);
}

#endif
