// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeGrowth_h
#define TimeGrowth_h

#include "Benchmarks/Growth/GrowthQuantity.h"

namespace growth
{
///@{
/**
 * vtkTimeVaryingIntervalVolume by one thread: against 4-simplices, of a growing interval of the
 * field VORTEX on one grid; against cells, two steps of a gyroid that moves; and against slabs
 * between steps of that, which all have as much in them, on one grid.
 */
extern const char* const CellsInTime;
extern const char* const Steps;
Quantity MakeSimplices(const BenchOptions& options);
Quantity MakeCellsInTime(const BenchOptions& options);
Quantity MakeSteps(const BenchOptions& options);
///@}

/**
 * vtkTimeSlabWriter on the same slabs, each step made when it is asked for, into a folder for
 * temporary files. Its job throws std::runtime_error where they cannot be written.
 */
Quantity MakeWrittenSteps(const BenchOptions& options);
}

#endif
