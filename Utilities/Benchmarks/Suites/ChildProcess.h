// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChildProcess_h
#define ChildProcess_h

#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <string>

/**
 * Runs \a program with \a arguments, as a shell has them, and with the seed, the threads and the
 * size of \a options, and returns the JSON that it prints. Throws std::runtime_error, with the
 * command, where the process fails.
 */
nlohmann::ordered_json RunProgram(
  const std::string& program, const std::string& arguments, const BenchOptions& options);

/// \a text as one argument.
std::string Quoted(const std::string& text);

#endif
