// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntervalMemory_h
#define IntervalMemory_h

#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <string>

/**
 * The parts of the suite `interval` that need a process of their own.
 */
namespace interval
{
/**
 * What one extraction of the case takes, in KiB:
 * - `input_kib` and `output_kib`, the data's own sizes;
 * - `working_kib`, what the filter reports;
 * - `peak_kib`, the input and by how much the resident memory of this process grew at most;
 * - `first_use_kib`, what tables and code took before, once and for all.
 *
 * The last two are absent where the system cannot tell. With \a asHexahedra the case is made a
 * vtkUnstructuredGrid first.
 */
nlohmann::ordered_json MeasureMemory(
  const std::string& theCase, bool asHexahedra, const BenchOptions& options);

/**
 * Seconds of the first extraction in this process, `cold`, and of a second one, `warm`, of a grid
 * of random cells of that VTK type.
 */
nlohmann::ordered_json MeasureFirstUse(int cellType, const BenchOptions& options);
}

#endif
