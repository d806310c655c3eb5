// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/ChildProcess.h"

#include <array>
#include <cstdio>
#include <stdexcept>

#ifdef _WIN32
#define popen _popen
#define pclose _pclose
#endif

std::string QuoteForShell(const std::string& text)
{
  std::string quoted = "'";
  for (char letter : text)
  {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return quoted + "'";
}

nlohmann::ordered_json RunProgram(
  const std::string& program, const std::string& arguments, const BenchOptions& options)
{
  const std::string command = QuoteForShell(program) + " " + arguments + " --seed " +
    std::to_string(options.Seed) + " --threads " + std::to_string(options.Threads) +
    options.Pick<std::string>("", " --quick", " --tiny");
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe)
  {
    throw std::runtime_error("Cannot start the command: " + command);
  }
  std::string output;
  std::array<char, 4096> buffer;
  std::size_t length = 0;
  while ((length = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0)
  {
    output.append(buffer.data(), length);
  }
  const int status = pclose(pipe);
  if (status != 0)
  {
    throw std::runtime_error(
      "The command failed with status " + std::to_string(status) + ": " + command);
  }
  return nlohmann::ordered_json::parse(output);
}
