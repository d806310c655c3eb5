// SPDX-License-Identifier: BSD-3-Clause
// Tests the stability catalog: gathered cases equal the reported ones, and errors are detected.
#include "Support/Pages/StabilityCase.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
bool Success = true;

void Expect(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
    Success = false;
  }
}

void TestExitCodes()
{
  char program[] = "test";
  char* arguments[] = { program };
  StabilityCatalogue empty("None", 1, arguments);
  Expect(empty.GetExitCode() == EXIT_FAILURE, "a test without a case must fail");

  const double nan = std::numeric_limits<double>::quiet_NaN();
  StabilityCatalogue thing("Wrong", 1, arguments);
  thing.SetClass("vtkThing");
  Expect(thing.Measure("inside", "", "", -1.0, 1.0), "a number at its bound passes");
  Expect(thing.GetExitCode() == EXIT_SUCCESS, "a test whose cases pass succeeds");
  Expect(!thing.Measure("outside", "", "", -1.5, 1.0), "a number outside its bound fails");
  Expect(!thing.Measure("nan", "", "", nan, 1.0), "NaN fails");
  Expect(thing.GetExitCode() == EXIT_FAILURE, "one failed case fails the test");
}

/// Creates a file that stands for the test program, and the list of tests. Call this before writing
/// reports, which must not be older than the program.
void ListTests(const std::string& folder, const std::vector<std::string>& tests)
{
  std::filesystem::create_directories(folder);
  const std::string program = folder + "/program";
  std::ofstream(program) << "program";
  std::ofstream list(folder + "/tests.txt");
  for (const std::string& test : tests)
  {
    list << test << "\t" << program << "\n";
  }
}

StabilityCatalogue MakeCatalogue(const std::string& test, const std::string& folder)
{
  char program[] = "test";
  char option[] = "-T";
  std::string copy = folder;
  char* arguments[] = { program, option, &copy[0] };
  StabilityCatalogue catalogue(test, 3, arguments);
  catalogue.SetClass("vtkThing");
  return catalogue;
}

void TestGathered(const std::string& folder)
{
  ListTests(folder, { "B", "A" });
  StabilityCatalogue second = MakeCatalogue("B", folder);
  second.SetClass("vtkOther");
  second.Check("message", "a byte that is not UTF-8", "kept", "\xff", true);
  second.GetExitCode();
  StabilityCatalogue first = MakeCatalogue("A", folder);
  first.Measure("number", "tiny", "small error", 0.25, 0.5, "explicit: 7");
  first.Check("words", "empty", "no crash", "crash", false);
  first.GetExitCode();

  const std::vector<StabilityCase> cases = StabilityCatalogue::Gather(folder);
  Expect(cases.size() == 3, "every case is gathered");
  if (cases.size() == 3)
  {
    Expect(cases[0].Test == "A" && cases[0].Class == "vtkThing" && cases[0].Name == "number" &&
        cases[0].Extreme == "tiny" && cases[0].Expected == "small error" &&
        cases[0].Measured == "0.25" && cases[0].Bound == 0.5 && cases[0].Passed &&
        cases[0].Method == "explicit: 7",
      "a measured case is read unchanged");
    Expect(cases[1].Measured == "crash" && std::isnan(cases[1].Bound) && !cases[1].Passed,
      "a checked case is read unchanged");
    Expect(cases[2].Test == "B" && cases[2].Class == "vtkOther", "cases are ordered by test");
  }
  const std::vector<StabilityCount> counts = CountByClass(cases);
  Expect(counts.size() == 2 && counts[0].Class == "vtkOther" && counts[0].Cases == 1 &&
      counts[0].Measured == 0 && counts[1].Cases == 2 && counts[1].Measured == 1 &&
      counts[1].Passed == 1,
    "cases are counted by class");
}

/// Returns true if Gather rejects a directory with a message that contains \a words.
bool IsRefused(const std::string& folder, const std::string& words)
{
  try
  {
    StabilityCatalogue::Gather(folder);
  }
  catch (const std::runtime_error& error)
  {
    return std::string(error.what()).find(words) != std::string::npos;
  }
  return false;
}

void TestRefused(const std::string& folder)
{
  Expect(IsRefused(folder, "tests.txt is missing"), "a missing directory is an error");
  ListTests(folder, {});
  Expect(IsRefused(folder, "lists no test"), "an empty list of tests is an error");
  ListTests(folder, { "Test" });
  Expect(IsRefused(folder, "Test: has not run"), "missing cases are an error");

  StabilityCatalogue catalogue = MakeCatalogue("Test", folder);
  catalogue.GetExitCode();
  Expect(IsRefused(folder, "Test: has no case"), "no cases are an error");
  StabilityCatalogue crashed = MakeCatalogue("Test", folder);
  crashed.Check("before", "", "", "", true);
  Expect(IsRefused(folder, "Test: did not run to its end"), "a crash is an error");
  crashed.GetExitCode();
  Expect(StabilityCatalogue::Gather(folder).size() == 1, "a complete run is gathered");

  const auto modified = std::filesystem::last_write_time(folder + "/program");
  std::filesystem::last_write_time(folder + "/program", modified + std::chrono::hours(1));
  Expect(
    IsRefused(folder, "Test: ran before its program"), "cases older than a program are an error");
  std::filesystem::last_write_time(folder + "/program", modified);
  MakeCatalogue("Gone", folder).GetExitCode();
  Expect(IsRefused(folder, "Gone: is not a test"), "cases of an unknown test are an error");
  std::filesystem::remove(folder + "/Gone.stability.json");
  std::ofstream(folder + "/Test.stability.json") << "{";
  Expect(IsRefused(folder, "Test: [json"), "a broken file is an error");

  bool isThrown = false;
  try
  {
    char program[] = "test";
    char* arguments[] = { program };
    StabilityCatalogue("Nameless", 1, arguments).Check("row", "", "", "", true);
  }
  catch (const std::logic_error&)
  {
    isThrown = true;
  }
  Expect(isThrown, "a case without a class is an error");
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: TestStabilityCatalogue FOLDER" << std::endl;
    return EXIT_FAILURE;
  }
  std::filesystem::remove_all(argv[1]);
  TestExitCodes();
  TestGathered(argv[1]);
  TestRefused(std::string(argv[1]) + "/refused");
  return Success ? EXIT_SUCCESS : EXIT_FAILURE;
}
