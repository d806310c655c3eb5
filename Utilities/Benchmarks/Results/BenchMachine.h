// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchMachine_h
#define BenchMachine_h

#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/**
 * Returns the machine and build: cpu, cores, memory_gib, system, compiler, build, smp.
 */
nlohmann::ordered_json DescribeMachine();

/**
 * Returns the conditions: date (UTC), size, threads, seed, and, if the system reports it, load, the
 * mean number of running or waiting processes in the last minute.
 */
nlohmann::ordered_json DescribeConditions(const BenchOptions& options);

/**
 * Combines the conditions of runs: the conditions of the first run, all commands, the first and the
 * last date, and `parts` with the command, date and load of each run instead of `load`. Conditions
 * of a single run are returned unchanged.
 */
nlohmann::ordered_json JoinConditions(const std::vector<nlohmann::ordered_json>& runs);

/**
 * Returns the machine from DescribeMachine() and the VTK version in one line, for a caption.
 */
std::string MachineInOneLine(const nlohmann::ordered_json& machine, const std::string& vtk);

/**
 * Returns the conditions from DescribeConditions() in one line.
 */
std::string ConditionsInOneLine(const nlohmann::ordered_json& conditions);

#endif
