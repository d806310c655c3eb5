// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchMachine.h"

#include "vtkSMPTools.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

namespace
{
std::string Compiler()
{
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

/// Returns the processor name from /proc/cpuinfo, or from vtksys on systems without that file.
/// vtksys recognizes fewer processor families.
std::string ProcessorName(vtksys::SystemInformation& information)
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos && line.compare(0, 10, "model name") == 0)
    {
      return line.substr(colon + 2);
    }
  }
  return information.GetExtendedProcessorName();
}
}

nlohmann::ordered_json DescribeMachine()
{
  vtksys::SystemInformation information;
  information.RunCPUCheck();
  information.RunOSCheck();
  information.RunMemoryCheck();
  nlohmann::ordered_json machine;
  machine["cpu"] = ProcessorName(information);
  machine["cores"] = std::thread::hardware_concurrency();
  machine["memory_gib"] = std::round(information.GetTotalPhysicalMemory() / 102.4) / 10.0;
  // Kernel version, without the suffix of a custom build.
  const std::string release = information.GetOSRelease();
  machine["system"] = std::string(information.GetOSName()) + " " +
    release.substr(0, release.find('-')) + " " + information.GetOSPlatform();
  machine["compiler"] = Compiler();
  machine["build"] = INTERLUME_BUILD_TYPE;
  machine["smp"] = vtkSMPTools::GetBackend();
  return machine;
}

nlohmann::ordered_json DescribeConditions(const BenchOptions& options)
{
  const std::time_t now = std::time(nullptr);
  char date[16];
  std::strftime(date, sizeof(date), "%Y-%m-%d", std::gmtime(&now));
  nlohmann::ordered_json conditions;
  conditions["date"] = date;
  conditions["size"] = options.GetSizeName();
  conditions["threads"] = options.Threads;
  conditions["seed"] = options.Seed;
  std::ifstream file("/proc/loadavg");
  if (double load = 0.0; file >> load)
  {
    conditions["load"] = load;
  }
  return conditions;
}

std::string MachineInOneLine(const nlohmann::ordered_json& machine, const std::string& vtk)
{
  std::ostringstream line;
  line << machine.value("cpu", "") << ", " << machine.value("cores", 0) << " cores, "
       << machine.value("memory_gib", 0.0) << " GiB; VTK " << vtk << ", "
       << machine.value("smp", "") << ", " << machine.value("compiler", "") << " "
       << machine.value("build", "");
  return line.str();
}

nlohmann::ordered_json JoinConditions(const std::vector<nlohmann::ordered_json>& runs)
{
  if (runs.size() == 1)
  {
    return runs.front();
  }
  auto parts = nlohmann::ordered_json::array();
  for (const nlohmann::ordered_json& run : runs)
  {
    if (run.contains("parts"))
    {
      parts.insert(parts.end(), run["parts"].begin(), run["parts"].end());
      continue;
    }
    nlohmann::ordered_json part;
    for (const char* name : { "command", "date", "load" })
    {
      if (run.contains(name))
      {
        part[name] = run[name];
      }
    }
    parts.push_back(part);
  }
  nlohmann::ordered_json joined = runs.front();
  joined.erase("load");
  std::string commands;
  std::string first = parts[0].at("date");
  std::string last = first;
  for (const nlohmann::ordered_json& part : parts)
  {
    commands += (commands.empty() ? "" : "; ") + part.value("command", "");
    const std::string date = part.at("date");
    first = std::min(first, date);
    last = std::max(last, date);
  }
  joined["command"] = commands;
  joined["date"] = first == last ? first : first + " to " + last;
  joined["parts"] = parts;
  return joined;
}

std::string ConditionsInOneLine(const nlohmann::ordered_json& conditions)
{
  std::ostringstream line;
  line << conditions.value("size", "") << " size, up to " << conditions.value("threads", 0)
       << " threads, " << conditions.value("date", "");
  if (conditions.contains("load"))
  {
    line << ", load before " << conditions["load"];
  }
  if (conditions.contains("parts"))
  {
    const char* before = ", loads before ";
    for (const nlohmann::ordered_json& part : conditions["parts"])
    {
      line << before << (part.contains("load") ? part["load"].dump() : "unknown") << " on "
           << part.value("date", "");
      before = ", ";
    }
  }
  return line.str();
}
