// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntervalDrag_h
#define IntervalDrag_h

#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

/**
 * The part of the suite `interval` about bounds that are dragged.
 */
namespace interval
{
/**
 * Methods `drag` and, with bounds that equal values of the data, `drag-tied`: the lower bound of an
 * interval up to the end of the range of values goes on by a two hundredth of the range, low, in
 * the middle and high in it, with KeepMemory, by one thread and by all; against the peers
 * `new-memory`, the same without, and `copy`, which copies as many bytes as the output has between
 * memory that is there. Counts: `changed`, the cells that the bound passes through between two
 * updates, and `share`, their share; the size of the output; what is used again and held.
 */
void AddDragRows(const BenchOptions& options, BenchRows& rows);
}

#endif
