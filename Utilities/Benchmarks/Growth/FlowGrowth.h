// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowGrowth_h
#define FlowGrowth_h

#include "Benchmarks/Growth/GrowthQuantity.h"

namespace growth
{
/**
 * vtkImplicitFlowField by all threads against samples, of one flow.
 */
Quantity MakeSamples(const BenchOptions& options);
}

#endif
