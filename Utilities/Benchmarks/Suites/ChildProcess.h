// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChildProcess_h
#define ChildProcess_h

#include "Benchmarks/Suites/BenchOptions.h"

#include <nlohmann/json.hpp>

#include <string>

/**
 * Runs \a program with \a arguments (in shell syntax) and with the seed, threads and size of
 * \a options. Returns the JSON that the program prints. Throws std::runtime_error, with the command
 * in the message, if the process fails.
 */
nlohmann::ordered_json RunProgram(
  const std::string& program, const std::string& arguments, const BenchOptions& options);

/// Returns \a text quoted as one shell argument.
std::string QuoteForShell(const std::string& text);

#endif
