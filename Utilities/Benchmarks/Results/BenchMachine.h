// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchMachine_h
#define BenchMachine_h

#include <nlohmann/json.hpp>

#include <string>

/**
 * What the numbers were measured on: cpu, cores, memory_gib, system, compiler, build, smp.
 */
nlohmann::ordered_json DescribeMachine();

/**
 * A machine so described, and the VTK version, in one line for a caption.
 */
std::string MachineInOneLine(const nlohmann::ordered_json& machine, const std::string& vtk);

#endif
