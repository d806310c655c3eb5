// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntervalWhole_h
#define IntervalWhole_h

#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

/**
 * The part of the suite `interval` about cells that are kept whole.
 */
namespace interval
{
/**
 * Method `whole-cells`: vtkIntervalVolume with KeepWholeCells by one thread against the peers
 * `tetrahedra`, the same without, and `clip2`, which keeps whole cells too. Counts: cells and
 * KiB of each output, and the largest growth of resident memory, from \a measure(task), which runs
 * MeasureWholeMemory in a process of its own.
 */
void AddWholeRows(const BenchOptions& options,
  const std::function<nlohmann::ordered_json(const std::string& task)>& measure, BenchRows& rows);

/**
 * `growth_kib`, by how much the resident memory of this process grew at most in one execution of
 * \a task, a method and a case with a space between; absent where the system cannot tell.
 */
nlohmann::ordered_json MeasureWholeMemory(const std::string& task, const BenchOptions& options);
}

#endif
