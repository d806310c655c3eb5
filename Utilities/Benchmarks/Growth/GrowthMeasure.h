// SPDX-License-Identifier: BSD-3-Clause
#ifndef GrowthMeasure_h
#define GrowthMeasure_h

#include "Benchmarks/Growth/GrowthQuantity.h"
#include "Benchmarks/Results/BenchRow.h"

namespace growth
{
/// The method of the rows of one size each.
extern const char* const SizeMethod;

/**
 * Measures one size in this process, which should be a fresh one: `n`; `input_kib`; `seconds` and
 * `processor_seconds` of all threads, medians of the repeats; `kib`, by how much the resident
 * memory grew at most over what was there before, in a second execution, when code and tables are
 * loaded. Where something is taken off, the same with `without_` before their names. Those of
 * memory are absent where the system cannot tell.
 */
nlohmann::ordered_json MeasureSize(const Quantity& quantity, int size, const BenchOptions& options);

/**
 * The row of what MeasureSize found: n is its parameter, what is taken off its peer `without`. Kib
 * is then the difference.
 */
BenchRow MakeSizeRow(const BenchRows& rows, const Quantity& quantity,
  const nlohmann::ordered_json& found, const BenchOptions& options);
}

#endif
