// SPDX-License-Identifier: BSD-3-Clause
// Tests growth exponents and their claims on synthetic rows.
#include "Benchmarks/Growth/Growth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <set>
#include <string>

namespace
{
bool Success = true;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
    Success = false;
  }
}

void ExpectNear(double measured, double exact, const std::string& what)
{
  // The condition fails for NaN.
  Expect(std::abs(measured - exact) <= 1e-9 * std::max(1.0, std::abs(exact)),
    what + ": " + std::to_string(measured) + ", expected " + std::to_string(exact));
}

/// Returns a quantity with expected exponents 1 for time and 0 for memory.
growth::Quantity MakeQuantity(const std::string& name)
{
  growth::Quantity made;
  made.Name = name;
  made.Time = { 1.0, 1.0, "one after the other" };
  made.Memory = { 0.0, 0.0, "no data are stored" };
  return made;
}

/// Adds rows for n = 1, 2, 4 and 8, with 2 n^timePower CPU seconds, 3 / n elapsed seconds and about
/// 10,000 n^memoryPower KiB.
void AddSizes(
  const growth::Quantity& quantity, double timePower, double memoryPower, BenchRows& rows)
{
  for (const int n : { 1, 2, 4, 8 })
  {
    const nlohmann::ordered_json found = { { "n", n }, { "input_kib", 1.0 }, { "seconds", 3.0 / n },
      { "processor_seconds", 2.0 * std::pow(n, timePower) },
      { "kib", std::lround(1e4 * std::pow(n, memoryPower)) } };
    rows.Add(growth::MakeSizeRow(rows, quantity, found, BenchOptions()));
  }
}

const BenchRow& Find(
  const std::string& theCase, const std::string& method, const std::vector<BenchRow>& rows)
{
  static const BenchRow unmeasured;
  const auto found = std::find_if(rows.begin(), rows.end(),
    [&](const BenchRow& row) { return row.Case == theCase && row.Method == method; });
  Expect(found != rows.end(), "no row " + theCase + " " + method);
  return found == rows.end() ? unmeasured : *found;
}

double GetExponent(
  const std::string& theCase, const char* method, const std::vector<BenchRow>& rows)
{
  return Find(theCase, method, rows)
    .Counts.value("exponent", std::numeric_limits<double>::quiet_NaN());
}

void TestClaims()
{
  BenchRows rows("growth");
  const growth::Quantity right = MakeQuantity("right");
  AddSizes(right, 1.1, 0.0, rows);
  growth::AddExponentRows(right, rows);
  ExpectNear(GetExponent("right", growth::TimeExponent, rows.Get()), 1.1, "a power of 1.1");
  ExpectNear(GetExponent("right", growth::MemoryExponent, rows.Get()), 0.0, "constant memory");
  for (const BenchClaim& claim : growth::CheckExponents(rows.Get()))
  {
    Expect(claim.IsMet(), "the claim must be met: " + claim.Text);
  }

  // The exponents of `slow` are above, and those of `fast` below, the margin around the expected
  // exponents.
  const growth::Quantity slow = MakeQuantity("slow");
  AddSizes(slow, 1.2, 0.2, rows);
  growth::AddExponentRows(slow, rows);
  const growth::Quantity fast = MakeQuantity("fast");
  AddSizes(fast, 0.8, -0.2, rows);
  growth::AddExponentRows(fast, rows);
  const std::vector<BenchClaim> claims = growth::CheckExponents(rows.Get());
  for (std::size_t i = 0; i < 2; ++i)
  {
    Expect(claims[i].Cases.size() == 3 && claims[i].Cases[0].Met && !claims[i].Cases[1].Met &&
        !claims[i].Cases[2].Met,
      "one of three cases meets the claim: " + claims[i].ToJson().dump());
  }

  // Exponents within the expected range from 2/3 to 1 meet the claim.
  growth::Quantity between = MakeQuantity("between");
  between.Time.Minimum = 2.0 / 3.0;
  AddSizes(between, 0.8, 0.0, rows);
  growth::AddExponentRows(between, rows);
  Expect(growth::CheckExponents(rows.Get())[0].Cases.back().Met,
    "0.8 is accepted for a range from 2/3 to 1");
}

void TestOneSize()
{
  BenchRows rows("growth");
  const growth::Quantity one = MakeQuantity("one");
  AddSizes(one, 0.0, 0.0, rows);
  BenchRows first("growth");
  first.Add(rows.Get().front());
  growth::AddExponentRows(one, first);
  Expect(growth::CheckExponents(first.Get())[0].Cases.empty(), "a single point has no exponent");
}

/// Tests that growth by a few pages of memory counts as constant, and that rows without measured
/// memory have no memory exponent.
void TestMemory()
{
  const growth::Quantity quantity = MakeQuantity("pages");
  BenchRows pages("growth");
  BenchRows unmeasured("growth");
  for (const int n : { 1, 2, 4 })
  {
    nlohmann::ordered_json found = { { "n", n }, { "input_kib", 1.0 }, { "seconds", 9.0 },
      { "processor_seconds", 1.0 * n } };
    unmeasured.Add(growth::MakeSizeRow(unmeasured, quantity, found, BenchOptions()));
    found["kib"] = 10 * n;
    pages.Add(growth::MakeSizeRow(pages, quantity, found, BenchOptions()));
  }
  growth::AddExponentRows(quantity, pages);
  growth::AddExponentRows(quantity, unmeasured);
  ExpectNear(GetExponent("pages", growth::TimeExponent, pages.Get()), 1.0, "time");
  ExpectNear(GetExponent("pages", growth::MemoryExponent, pages.Get()), 0.0, "memory of pages");
  Expect(std::none_of(unmeasured.Get().begin(), unmeasured.Get().end(),
           [](const BenchRow& row) { return row.Method == growth::MemoryExponent; }),
    "no exponent without memory measurements");
}

/// Tests that each quantity has a unique name, four to six sizes, and reasons for its expected
/// exponents.
void TestQuantities()
{
  std::set<std::string> names;
  BenchOptions options;
  options.Threads = 8;
  for (const growth::Quantity& quantity : growth::MakeQuantities(options))
  {
    Expect(names.insert(quantity.Name).second, "unique name " + quantity.Name);
    Expect(quantity.Sizes.size() >= 4 && quantity.Sizes.size() <= 6,
      "four to six sizes of " + quantity.Name);
    Expect(quantity.Make && !quantity.Time.Reason.empty() && !quantity.Memory.Reason.empty() &&
        quantity.Time.Minimum <= quantity.Time.Maximum,
      "expected exponents of " + quantity.Name);
  }
  Expect(names.size() == 6, "there are six quantities");
}
}

int main()
{
  TestQuantities();
  TestClaims();
  TestOneSize();
  TestMemory();
  return Success ? EXIT_SUCCESS : EXIT_FAILURE;
}
