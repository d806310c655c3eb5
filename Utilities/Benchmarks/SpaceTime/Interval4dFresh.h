// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dFresh_h
#define Interval4dFresh_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

/**
 * The parts of the suite `interval4d` that need a process of their own: tables that are filled at
 * run time, and memory.
 */
namespace interval4d
{
/// Runs a task in a process of its own and returns what it found.
using TaskRunner = std::function<nlohmann::ordered_json(const std::string& task)>;

/**
 * For every case:
 * - method `cold`, by one thread: the first execution in the process against later ones, the peer
 *   `warm`. `hit_share` is the share of lookups that found their case made, `kind_hit_share` that
 * of lookups that found it or one of its kind, so that no convex hull had to be computed;
 * - method `later-slabs`, with three steps and more: the lookups of all slabs but the first, in a
 *   process that has seen the first slab and nothing else;
 * - method `memory`, with the table filled: `steps_kib`, two of the time steps; `output_kib`, the
 *   output's own size; `working_kib`, what the filter reports; `peak_kib`, two steps and by how
 *   much the resident memory of the process grew at most; `peak_share`, that divided by two steps
 *   and the output. The last two are absent where the system cannot tell.
 */
void AddFreshRows(const BenchOptions& options, const TaskRunner& runTask, BenchRows& rows);

/// Does what AddFreshRows() asks of a process of its own; nothing for any other task.
std::optional<nlohmann::ordered_json> RunFreshTask(
  const std::string& task, const BenchOptions& options);

std::vector<BenchClaim> CheckFreshClaims(const std::vector<BenchRow>& rows);
std::vector<BenchPlot> MakeFreshPlots(const std::vector<BenchRow>& rows);
}

#endif
