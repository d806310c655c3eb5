// SPDX-License-Identifier: BSD-3-Clause
// Exponents and claims on rows that are made up.
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
bool Right = true;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
    Right = false;
  }
}

void ExpectNear(double measured, double exact, const std::string& what)
{
  // Written so that NaN fails.
  Expect(std::abs(measured - exact) <= 1e-9 * std::max(1.0, std::abs(exact)),
    what + ": " + std::to_string(measured) + ", expected " + std::to_string(exact));
}

/// A quantity of theory 1 in time, 0 in memory.
growth::Quantity MakeQuantity(const std::string& name)
{
  growth::Quantity made;
  made.Name = name;
  made.Time = { 1.0, 1.0, "one after the other" };
  made.Memory = { 0.0, 0.0, "nothing is kept" };
  return made;
}

/// Rows of 1, 2, 4 and 8 things, of 2 n^time processor seconds, 3 / n seconds and about 10,000
/// n^memory KiB.
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
  static const BenchRow none;
  const auto found = std::find_if(rows.begin(), rows.end(),
    [&](const BenchRow& row) { return row.Case == theCase && row.Method == method; });
  Expect(found != rows.end(), "no row " + theCase + " " + method);
  return found == rows.end() ? none : *found;
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
    Expect(claim.IsMet(), "not met: " + claim.Text);
  }

  // Beyond the margin on either side of theory.
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
      "not one of three is met: " + claims[i].ToJson().dump());
  }

  // From 2/3 to 1 is as theory says, and what is between as well.
  growth::Quantity between = MakeQuantity("between");
  between.Time.Least = 2.0 / 3.0;
  AddSizes(between, 0.8, 0.0, rows);
  growth::AddExponentRows(between, rows);
  Expect(growth::CheckExponents(rows.Get())[0].Cases.back().Met, "0.8 is not from 2/3 to 1");
}

void TestOneSize()
{
  BenchRows rows("growth");
  const growth::Quantity one = MakeQuantity("one");
  AddSizes(one, 0.0, 0.0, rows);
  BenchRows first("growth");
  first.Add(rows.Get().front());
  growth::AddExponentRows(one, first);
  Expect(growth::CheckExponents(first.Get())[0].Cases.empty(), "one point makes no exponent");
}

/// Memory of some pages is none, and memory that was not measured has no exponent.
void TestMemory()
{
  const growth::Quantity quantity = MakeQuantity("pages");
  BenchRows pages("growth");
  BenchRows none("growth");
  for (const int n : { 1, 2, 4 })
  {
    nlohmann::ordered_json found = { { "n", n }, { "input_kib", 1.0 }, { "seconds", 9.0 },
      { "processor_seconds", 1.0 * n } };
    none.Add(growth::MakeSizeRow(none, quantity, found, BenchOptions()));
    found["kib"] = 10 * n;
    pages.Add(growth::MakeSizeRow(pages, quantity, found, BenchOptions()));
  }
  growth::AddExponentRows(quantity, pages);
  growth::AddExponentRows(quantity, none);
  ExpectNear(GetExponent("pages", growth::TimeExponent, pages.Get()), 1.0, "time");
  ExpectNear(GetExponent("pages", growth::MemoryExponent, pages.Get()), 0.0, "memory of pages");
  Expect(std::none_of(none.Get().begin(), none.Get().end(),
           [](const BenchRow& row) { return row.Method == growth::MemoryExponent; }),
    "an exponent of memory that was not measured");
}

/// Each with a name of its own, four to six sizes, and a reason.
void TestQuantities()
{
  std::set<std::string> names;
  BenchOptions options;
  options.Threads = 8;
  for (const growth::Quantity& quantity : growth::MakeQuantities(options))
  {
    Expect(names.insert(quantity.Name).second, "two quantities are " + quantity.Name);
    Expect(quantity.Sizes.size() >= 4 && quantity.Sizes.size() <= 6, "sizes of " + quantity.Name);
    Expect(quantity.Make && !quantity.Time.Reason.empty() && !quantity.Memory.Reason.empty() &&
        quantity.Time.Least <= quantity.Time.Most,
      "theory of " + quantity.Name);
  }
  Expect(names.size() == 6, "not all quantities are there");
}
}

int main()
{
  TestQuantities();
  TestClaims();
  TestOneSize();
  TestMemory();
  return Right ? EXIT_SUCCESS : EXIT_FAILURE;
}
