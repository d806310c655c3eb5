// SPDX-License-Identifier: BSD-3-Clause
// Runs random pipelines of the public classes: see FuzzCases.h. A family and a seed reproduce a
// case on every machine.
#include "FuzzCases.h"
#include "FuzzWatchdog.h"

#include "vtkLogger.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <unistd.h>

namespace fuzz
{

const std::vector<Family>& GetFamilies()
{
  static const std::vector<Family> families = { { "intervals", RunIntervals },
    { "contours", RunContours }, { "time", RunTime }, { "flow", RunFlow }, { "damage", RunDamage },
    { "files", RunFiles }, { "tetrahedra", RunTetrahedra }, { "shadows", RunShadows } };
  return families;
}

namespace
{

std::string CurrentCase;

/// Prints the arguments of the current case after a fatal signal. Uses only async-signal-safe
/// functions.
void OnSignal(int signal)
{
  const std::string& name = CurrentCase;
  const ssize_t written = write(STDERR_FILENO, name.data(), name.size());
  std::signal(signal, SIG_DFL);
  if (written >= 0)
  {
    std::raise(signal);
  }
}

}

}

int main(int argc, char* argv[])
{
  std::vector<std::string> names;
  for (const fuzz::Family& family : fuzz::GetFamilies())
  {
    names.push_back(family.Name);
  }
  CLI::App app("Random pipelines through Interlume's public classes");
  std::vector<std::string> chosen = names;
  std::uint64_t first = 1;
  int count = 50;
  double limit = 600.0;
  bool isVerbose = false;
  app.add_option("--family", chosen, "Families to run; default all")->check(CLI::IsMember(names));
  app.add_option("--first", first, "The first seed; default 1");
  app.add_option("--cases", count, "Number of cases per family; default 50");
  app.add_option("--limit", limit, "Maximum duration of a case in seconds; default 600")
    ->check(CLI::PositiveNumber);
  app.add_flag("--verbose", isVerbose, "Print each case before it runs");
  CLI11_PARSE(app, argc, argv);

  for (const int signal : { SIGSEGV, SIGFPE, SIGABRT, SIGILL, SIGBUS })
  {
    std::signal(signal, fuzz::OnSignal);
  }
  // Logged messages are not printed because fuzz::Messages collects them.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  reference::Check check;
  fuzz::FuzzWatchdog watch(limit);
  for (const fuzz::Family& family : fuzz::GetFamilies())
  {
    if (std::find(chosen.begin(), chosen.end(), family.Name) == chosen.end())
    {
      continue;
    }
    const int before = check.GetNumberOfFailures();
    for (int i = 0; i < count; ++i)
    {
      const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
      const std::string arguments =
        "--family " + family.Name + " --first " + std::to_string(seed) + " --cases 1";
      fuzz::CurrentCase = "\n" + arguments + "\n";
      if (isVerbose)
      {
        std::cerr << fuzz::CurrentCase;
      }
      fuzz::FuzzRandom random(seed);
      std::string text;
      const int failures = check.GetNumberOfFailures();
      check.SetContext(family.Name + " " + std::to_string(seed));
      watch.Begin(arguments, i, count);
      try
      {
        family.Run(random, text, check);
      }
      catch (const std::exception& error)
      {
        check.That(false, std::string("no exception; caught ") + error.what());
      }
      watch.End();
      if (isVerbose || check.GetNumberOfFailures() > failures)
      {
        std::cerr << "  " << family.Name << " " << seed << ": " << text << "\n";
      }
    }
    std::cout << family.Name << ": " << count << " cases, " << check.GetNumberOfFailures() - before
              << " failed expectations" << std::endl;
  }
  return check.Result();
}
