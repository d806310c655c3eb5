// SPDX-License-Identifier: BSD-3-Clause
// The stability helper itself: what is reported is what is gathered, and what is wrong fails.
#include "Pages/StabilityCase.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace
{
bool Right = true;

void Expect(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
    Right = false;
  }
}

void TestExitCodes()
{
  char program[] = "test";
  char* arguments[] = { program };
  StabilityCatalogue none("None", 1, arguments);
  Expect(none.GetExitCode() == EXIT_FAILURE, "a test without a case must fail");

  const double nan = std::numeric_limits<double>::quiet_NaN();
  StabilityCatalogue wrong("Wrong", 1, arguments);
  Expect(wrong.Measure("inside", "", "", -1.0, 1.0), "a number at its bound passes");
  Expect(wrong.GetExitCode() == EXIT_SUCCESS, "a test whose cases pass succeeds");
  Expect(!wrong.Measure("outside", "", "", -1.5, 1.0), "a number beyond its bound fails");
  Expect(!wrong.Measure("nan", "", "", nan, 1.0), "NaN fails");
  Expect(wrong.GetExitCode() == EXIT_FAILURE, "one failed case fails the test");
}

void TestGathered(const std::string& folder)
{
  char program[] = "test";
  char option[] = "-T";
  std::string copy = folder;
  char* arguments[] = { program, option, &copy[0] };
  StabilityCatalogue second("B", 3, arguments);
  second.Check("message", "a byte that is not UTF-8", "kept", "\xff", true);
  StabilityCatalogue first("A", 3, arguments);
  first.Measure("number", "tiny", "small error", 0.25, 0.5);
  first.Check("words", "empty", "no crash", "crash", false);

  const std::vector<StabilityCase> cases = StabilityCatalogue::Gather(folder);
  Expect(cases.size() == 3, "every case is gathered");
  if (cases.size() == 3)
  {
    Expect(cases[0].Test == "A" && cases[0].Name == "number" && cases[0].Extreme == "tiny" &&
        cases[0].Expected == "small error" && cases[0].Measured == "0.25" &&
        cases[0].Bound == 0.5 && cases[0].Passed,
      "a measured case comes back as it was");
    Expect(cases[1].Measured == "crash" && std::isnan(cases[1].Bound) && !cases[1].Passed,
      "a checked case comes back as it was");
    Expect(cases[2].Test == "B", "cases are ordered by test");
  }
  Expect(StabilityCatalogue::Gather(folder + "/missing").empty(), "a missing folder is empty");

  std::ofstream(folder + "/broken.stability.json") << "{";
  bool thrown = false;
  try
  {
    StabilityCatalogue::Gather(folder);
  }
  catch (const std::runtime_error& error)
  {
    thrown = std::string(error.what()).find("broken") != std::string::npos;
  }
  Expect(thrown, "a broken file is named");
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
  return Right ? EXIT_SUCCESS : EXIT_FAILURE;
}
