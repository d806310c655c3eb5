// SPDX-License-Identifier: BSD-3-Clause
// Tests that every public class has cases in the stability catalog of this build, and prints
// their number. Arguments: the directory of the catalog and the classes.
#include "Support/Pages/StabilityCase.h"

#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <set>
#include <string>

namespace
{
bool HaveCases(const std::vector<StabilityCount>& counts, std::set<std::string> classes)
{
  std::cout << std::left << std::setw(34) << "class"
            << "cases  bounds  passed\n";
  bool isValid = true;
  for (const StabilityCount& count : counts)
  {
    std::cout << std::left << std::setw(34) << count.Class << std::right << std::setw(5)
              << count.Cases << std::setw(8) << count.Measured << std::setw(8) << count.Passed
              << "\n";
    isValid = isValid && count.Passed == count.Cases;
    if (classes.erase(count.Class) == 0)
    {
      std::cerr << "ERROR: the catalog has cases of " << count.Class
                << ", which is not a public class\n";
      isValid = false;
    }
  }
  for (const std::string& name : classes)
  {
    std::cerr << "ERROR: " << name << " has no case in the catalog\n";
  }
  return isValid && classes.empty();
}
}

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: TestStabilityClasses FOLDER CLASS..." << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    const auto counts = CountByClass(StabilityCatalogue::Gather(argv[1]));
    return HaveCases(counts, { argv + 2, argv + argc }) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
