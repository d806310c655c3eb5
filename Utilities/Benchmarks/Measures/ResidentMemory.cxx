// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/ResidentMemory.h"

#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{
/// Returns N from the line `name: N kB` of /proc/self/status.
std::optional<long> StatusKib(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, name.size() + 1, name + ":") == 0)
    {
      return std::stol(line.substr(name.size() + 1));
    }
  }
  return std::nullopt;
}
}

std::optional<long> ResidentKib()
{
  return StatusKib("VmRSS");
}

std::optional<long> PeakResidentKib()
{
  return StatusKib("VmHWM");
}

void ResetPeakMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << "5";
}
