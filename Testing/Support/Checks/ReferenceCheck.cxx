// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Checks/ReferenceCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace reference
{

bool Check::That(bool condition, const std::string& what)
{
  ++this->Checks;
  if (!condition)
  {
    this->Fail(what);
  }
  return condition;
}

bool Check::Equal(long long found, long long expected, const std::string& what)
{
  return this->That(found == expected,
    what + ": found " + std::to_string(found) + ", expected " + std::to_string(expected));
}

bool Check::Near(
  double found, double expected, double tolerance, const std::string& what, double scale)
{
  // If found or expected is NaN, the comparison with this bound is false.
  const double bound = tolerance * std::max(std::abs(expected), scale);
  const bool near = std::abs(found - expected) <= bound;
  std::ostringstream text;
  if (!near)
  {
    text.precision(17);
    text << what << ": found " << found << ", expected " << expected << " within " << bound;
  }
  return this->That(near, text.str());
}

bool Check::Contains(const std::string& text, const std::string& part)
{
  return this->That(text.find(part) != std::string::npos, '"' + part + "\" in \"" + text + '"');
}

void Check::Fail(const std::string& what)
{
  constexpr int printed = 20;
  if (this->Failures++ < printed)
  {
    std::cerr << "FAILED " << this->Context << (this->Context.empty() ? "" : ": ") << what << '\n';
  }
}

int Check::Result() const
{
  std::cout << this->Checks << " checks, " << this->Failures << " failed\n";
  return this->Checks > 0 && this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int RunChecks(std::initializer_list<void (*)(Check&)> checks)
{
  Check check;
  for (const auto run : checks)
  {
    check.SetContext("");
    run(check);
  }
  return check.Result();
}

}
