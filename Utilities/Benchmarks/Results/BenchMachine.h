// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchMachine_h
#define BenchMachine_h

#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/**
 * Returns the machine and build as fields: cpu, cores, memory_gib, system, compiler, build, smp.
 */
nlohmann::ordered_json DescribeMachine();

/**
 * Returns the conditions of a run as fields: date (UTC), size, threads, seed, and, if the system
 * reports it, load, the mean number of running or waiting processes in the last minute.
 */
nlohmann::ordered_json DescribeConditions(const BenchOptions& options);

/**
 * Combines the conditions of several runs. The result has the fields of the first run, except that
 * `command` contains all commands, `date` is the range of dates, and `parts`, with the command,
 * date and load of each run, replaces `load`. Conditions of a single run are returned unchanged.
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
