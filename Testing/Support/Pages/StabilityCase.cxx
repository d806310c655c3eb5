// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Pages/StabilityCase.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace
{
const char* const FileSuffix = ".stability.json";

std::string DirectoryFor(int argc, char* argv[])
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

/// The string members of StabilityCase and their JSON keys.
const std::pair<const char*, std::string StabilityCase::*> Texts[] = { { "class",
                                                                         &StabilityCase::Class },
  { "name", &StabilityCase::Name }, { "extreme", &StabilityCase::Extreme },
  { "expected", &StabilityCase::Expected }, { "measured", &StabilityCase::Measured },
  { "method", &StabilityCase::Method }, { "test", &StabilityCase::Test } };

nlohmann::json ToJson(const StabilityCase& oneCase)
{
  nlohmann::json json = { { "passed", oneCase.Passed } };
  for (const auto& [name, text] : Texts)
  {
    json[name] = oneCase.*text;
  }
  if (!std::isnan(oneCase.Bound))
  {
    json["bound"] = oneCase.Bound;
  }
  return json;
}

StabilityCase FromJson(const nlohmann::json& json)
{
  StabilityCase oneCase;
  for (const auto& [name, text] : Texts)
  {
    oneCase.*text = json.at(name);
  }
  oneCase.Bound = json.value("bound", oneCase.Bound);
  oneCase.Passed = json.at("passed");
  return oneCase;
}

/// Reads the path of each test's program from tests.txt.
std::map<std::string, std::string> ReadPrograms(const std::filesystem::path& path)
{
  std::map<std::string, std::string> programs;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
  {
    const std::size_t tab = line.find('\t');
    if (tab != std::string::npos)
    {
      programs[line.substr(0, tab)] = line.substr(tab + 1);
    }
  }
  return programs;
}

/// Returns the names of the tests whose results are in a directory.
std::set<std::string> FindTests(const std::filesystem::path& folder)
{
  std::set<std::string> tests;
  const std::string suffix = FileSuffix;
  if (std::filesystem::is_directory(folder))
  {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
      const std::string name = entry.path().filename().string();
      if (name.size() > suffix.size() &&
        name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
      {
        tests.insert(name.substr(0, name.size() - suffix.size()));
      }
    }
  }
  return tests;
}

/// Appends the cases of one file. Returns an error message, or an empty string on success.
std::string ReadCases(const std::filesystem::path& path, const std::filesystem::path& program,
  std::vector<StabilityCase>& cases)
{
  if (!std::filesystem::exists(path) || !std::filesystem::exists(program))
  {
    return "has not run";
  }
  if (std::filesystem::last_write_time(path) < std::filesystem::last_write_time(program))
  {
    return "ran before its program was last built";
  }
  try
  {
    std::ifstream file(path);
    const nlohmann::json catalogue = nlohmann::json::parse(file);
    if (!catalogue.at("ended"))
    {
      return "did not run to its end";
    }
    for (const auto& json : catalogue.at("cases"))
    {
      cases.push_back(FromJson(json));
    }
    return catalogue.at("cases").empty() ? "has no cases" : "";
  }
  catch (const nlohmann::json::exception& error)
  {
    return error.what();
  }
}
}

StabilityCatalogue::StabilityCatalogue(const std::string& test, int argc, char* argv[])
  : Test(test)
  , Folder(DirectoryFor(argc, argv))
{
  if (!this->Folder.empty())
  {
    std::filesystem::create_directories(this->Folder);
  }
}

void StabilityCatalogue::SetClass(const std::string& name)
{
  this->Class = name;
}

bool StabilityCatalogue::Measure(const std::string& name, const std::string& extreme,
  const std::string& expected, double measured, double bound, const std::string& method)
{
  return this->Report({ this->Class, name, extreme, expected, InShort(measured), bound,
    std::abs(measured) <= bound, method, this->Test });
}

bool StabilityCatalogue::Check(const std::string& name, const std::string& extreme,
  const std::string& expected, const std::string& measured, bool passed, const std::string& method)
{
  return this->Report({ this->Class, name, extreme, expected, measured,
    std::numeric_limits<double>::quiet_NaN(), passed, method, this->Test });
}

bool StabilityCatalogue::Report(StabilityCase oneCase)
{
  if (this->Class.empty())
  {
    throw std::logic_error(this->Test + " reported a case before SetClass(): " + oneCase.Name);
  }
  std::cout << (oneCase.Passed ? "pass  " : "FAIL  ") << oneCase.Class << " " << oneCase.Name
            << ": " << oneCase.Extreme << "; expected: " << oneCase.Expected
            << "; measured: " << oneCase.Measured;
  if (!std::isnan(oneCase.Bound))
  {
    std::cout << " (bound " << oneCase.Bound << ")";
  }
  if (!oneCase.Method.empty())
  {
    std::cout << "; method: " << oneCase.Method;
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
  nlohmann::json json = { { "test", this->Test }, { "ended", this->IsAtEnd },
    { "cases", nlohmann::json::array() } };
  for (const StabilityCase& oneCase : this->Cases)
  {
    json["cases"].push_back(ToJson(oneCase));
  }
  const std::filesystem::path path =
    std::filesystem::path(this->Folder) / (this->Test + FileSuffix);
  std::ofstream file(path);
  // Error messages may contain any byte. Invalid UTF-8 is replaced, since dump() would otherwise
  // throw.
  file << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  if (!file)
  {
    throw std::runtime_error("cannot write " + path.string());
  }
}

int StabilityCatalogue::GetExitCode()
{
  this->IsAtEnd = true;
  this->Write();
  const bool passed = !this->Cases.empty() &&
    std::all_of(this->Cases.begin(), this->Cases.end(),
      [](const StabilityCase& oneCase) { return oneCase.Passed; });
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

std::vector<StabilityCase> StabilityCatalogue::Gather(const std::string& folder)
{
  const std::filesystem::path root = folder;
  const std::map<std::string, std::string> programs = ReadPrograms(root / "tests.txt");
  std::vector<StabilityCase> cases;
  std::string problems = programs.empty() ? "\n  tests.txt is missing or lists no test" : "";
  for (const auto& [test, program] : programs)
  {
    const std::string problem = ReadCases(root / (test + FileSuffix), program, cases);
    problems += problem.empty() ? problem : "\n  " + test + ": " + problem;
  }
  for (const std::string& test : FindTests(root))
  {
    problems += programs.count(test) == 0 ? "\n  " + test + ": is not a test of this build" : "";
  }
  if (!problems.empty())
  {
    throw std::runtime_error("The stability cases in " + folder +
      " do not match this build. Run ctest --label-regex stability:" + problems);
  }
  return cases;
}

std::vector<StabilityCount> CountByClass(const std::vector<StabilityCase>& cases)
{
  std::map<std::string, StabilityCount> counts;
  for (const StabilityCase& oneCase : cases)
  {
    StabilityCount& count = counts[oneCase.Class];
    count.Class = oneCase.Class;
    ++count.Cases;
    count.Passed += oneCase.Passed ? 1 : 0;
    count.Measured += std::isnan(oneCase.Bound) ? 0 : 1;
  }
  std::vector<StabilityCount> list;
  for (const auto& [name, count] : counts)
  {
    list.push_back(count);
  }
  return list;
}
