// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchMachine_h
#define BenchMachine_h

#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <string>

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
 * A machine so described, and the VTK version, in one line for a caption.
 */
std::string MachineInOneLine(const nlohmann::ordered_json& machine, const std::string& vtk);

/**
 * Conditions so described, in one line.
 */
std::string ConditionsInOneLine(const nlohmann::ordered_json& conditions);

#endif
