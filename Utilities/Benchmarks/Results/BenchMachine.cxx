// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchMachine.h"

#include "vtkSMPTools.h"

#include <vtksys/SystemInformation.hxx>

#include <cmath>
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

/// The name that Linux gives; vtksys knows fewer families, but other systems as well.
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
  machine["system"] = std::string(information.GetOSName()) + " " + information.GetOSRelease() +
    " " + information.GetOSPlatform();
  machine["compiler"] = Compiler();
  machine["build"] = INTERLUME_BUILD_TYPE;
  machine["smp"] = vtkSMPTools::GetBackend();
  return machine;
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
