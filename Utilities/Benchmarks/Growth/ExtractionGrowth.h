// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExtractionGrowth_h
#define ExtractionGrowth_h

#include "Benchmarks/Growth/GrowthQuantity.h"

namespace growth
{
///@{
/**
 * On the wavelet, which has the same waves at every size, by one thread: the interval volume and
 * the contour against cells. The interval volume of one size against threads.
 */
extern const char* const Cells;
Quantity MakeCells(const BenchOptions& options);
Quantity MakeContour(const BenchOptions& options);
Quantity MakeThreads(const BenchOptions& options);
///@}
}

#endif
