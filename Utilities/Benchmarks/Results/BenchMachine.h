// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchMachine_h
#define BenchMachine_h

#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/**
 * What the numbers were measured on: cpu, cores, memory_gib, system, compiler, build, smp.
 */
nlohmann::ordered_json DescribeMachine();

/**
 * When and how: date (UTC), size, threads, seed, and, where the system tells, load: processes that
 * ran or waited to run, the mean of the minute before.
 */
nlohmann::ordered_json DescribeConditions(const BenchOptions& options);

/**
 * Conditions of runs that are put together: those of the first one, the commands of all, the first
 * and the last date, and in `parts` the command, date and load of each, which `load` itself does
 * not stand for. Those of one run stay as they are.
 */
nlohmann::ordered_json JoinConditions(const std::vector<nlohmann::ordered_json>& runs);

/**
 * A machine so described, and the VTK version, in one line for a caption.
 */
std::string MachineInOneLine(const nlohmann::ordered_json& machine, const std::string& vtk);

/**
 * Conditions so described, in one line.
 */
std::string ConditionsInOneLine(const nlohmann::ordered_json& conditions);

#endif
