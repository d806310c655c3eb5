// SPDX-License-Identifier: BSD-3-Clause
#include "Pages/StabilityCase.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace
{
const char* const FileSuffix = ".stability.json";

std::string FolderFor(int argc, char* argv[])
{
  if (const char* folder = std::getenv("INTERLUME_STABILITY_DIR"))
  {
    return folder;
  }
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::strcmp(argv[i], "-T") == 0)
    {
      return argv[i + 1];
    }
  }
  return {};
}

std::string InShort(double value)
{
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

nlohmann::json ToJson(const StabilityCase& oneCase)
{
  nlohmann::json json = { { "name", oneCase.Name }, { "extreme", oneCase.Extreme },
    { "expected", oneCase.Expected }, { "measured", oneCase.Measured },
    { "passed", oneCase.Passed }, { "test", oneCase.Test } };
  if (!std::isnan(oneCase.Bound))
  {
    json["bound"] = oneCase.Bound;
  }
  return json;
}

StabilityCase FromJson(const nlohmann::json& json)
{
  StabilityCase oneCase;
  oneCase.Name = json.at("name");
  oneCase.Extreme = json.at("extreme");
  oneCase.Expected = json.at("expected");
  oneCase.Measured = json.at("measured");
  oneCase.Bound = json.value("bound", oneCase.Bound);
  oneCase.Passed = json.at("passed");
  oneCase.Test = json.at("test");
  return oneCase;
}
}

StabilityCatalogue::StabilityCatalogue(const std::string& test, int argc, char* argv[])
  : Test(test)
  , Folder(FolderFor(argc, argv))
{
  if (!this->Folder.empty())
  {
    std::filesystem::create_directories(this->Folder);
  }
}

bool StabilityCatalogue::Measure(const std::string& name, const std::string& extreme,
  const std::string& expected, double measured, double bound)
{
  StabilityCase oneCase;
  oneCase.Name = name;
  oneCase.Extreme = extreme;
  oneCase.Expected = expected;
  oneCase.Measured = InShort(measured);
  oneCase.Bound = bound;
  oneCase.Passed = std::abs(measured) <= bound;
  return this->Report(std::move(oneCase));
}

bool StabilityCatalogue::Check(const std::string& name, const std::string& extreme,
  const std::string& expected, const std::string& measured, bool passed)
{
  StabilityCase oneCase;
  oneCase.Name = name;
  oneCase.Extreme = extreme;
  oneCase.Expected = expected;
  oneCase.Measured = measured;
  oneCase.Passed = passed;
  return this->Report(std::move(oneCase));
}

bool StabilityCatalogue::Report(StabilityCase oneCase)
{
  oneCase.Test = this->Test;
  std::cout << (oneCase.Passed ? "pass  " : "FAIL  ") << oneCase.Name << ": " << oneCase.Extreme
            << "; expected: " << oneCase.Expected << "; measured: " << oneCase.Measured;
  if (!std::isnan(oneCase.Bound))
  {
    std::cout << " (bound " << oneCase.Bound << ")";
  }
  std::cout << std::endl;
  this->Cases.push_back(std::move(oneCase));
  this->Write();
  return this->Cases.back().Passed;
}

void StabilityCatalogue::Write() const
{
  if (this->Folder.empty())
  {
    return;
  }
  nlohmann::json json = { { "test", this->Test }, { "cases", nlohmann::json::array() } };
  for (const StabilityCase& oneCase : this->Cases)
  {
    json["cases"].push_back(ToJson(oneCase));
  }
  const std::filesystem::path path =
    std::filesystem::path(this->Folder) / (this->Test + FileSuffix);
  std::ofstream file(path);
  // Text from an error message may hold any byte; what is not UTF-8 is replaced, not refused.
  file << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  if (!file)
  {
    throw std::runtime_error("cannot write " + path.string());
  }
}

int StabilityCatalogue::GetExitCode() const
{
  const bool passed = !this->Cases.empty() &&
    std::all_of(this->Cases.begin(), this->Cases.end(),
      [](const StabilityCase& oneCase) { return oneCase.Passed; });
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

std::vector<StabilityCase> StabilityCatalogue::Gather(const std::string& folder)
{
  std::vector<std::filesystem::path> paths;
  if (std::filesystem::is_directory(folder))
  {
    const std::string suffix = FileSuffix;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
      const std::string name = entry.path().filename().string();
      if (name.size() > suffix.size() &&
        name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
      {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());

  std::vector<StabilityCase> cases;
  for (const auto& path : paths)
  {
    try
    {
      std::ifstream file(path);
      const nlohmann::json catalogue = nlohmann::json::parse(file);
      for (const auto& json : catalogue.at("cases"))
      {
        cases.push_back(FromJson(json));
      }
    }
    catch (const nlohmann::json::exception& error)
    {
      throw std::runtime_error(path.string() + ": " + error.what());
    }
  }
  return cases;
}
