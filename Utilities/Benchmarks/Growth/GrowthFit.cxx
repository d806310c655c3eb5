// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/Growth.h"

#include "Benchmarks/Measures/PowerFit.h"

#include <algorithm>
#include <sstream>

namespace growth
{
namespace
{
/// A cost whose exponent is fitted, and the method of the rows with this exponent.
struct Measure
{
  const char* Method;
  std::optional<double> (*Get)(const BenchRow& row);
};

std::optional<double> GetSeconds(const BenchRow& row)
{
  // The processor clock has finite resolution and may report 0.
  return std::max(row.Counts["processor_seconds"].get<double>(), 1e-6);
}

std::optional<double> GetKib(const BenchRow& row)
{
  return row.Counts.contains("kib")
    ? std::optional<double>(std::max(row.Counts["kib"].get<double>(), MinimumKib))
    : std::nullopt;
}

const Measure OfTime = { TimeExponent, GetSeconds };
const Measure OfMemory = { MemoryExponent, GetKib };

struct Points
{
  std::vector<double> N;
  std::vector<double> Cost;
};

/// Returns N and the cost in each row of the quantity \a name.
Points GetPoints(const std::string& name, const Measure& measure, const std::vector<BenchRow>& rows)
{
  Points points;
  for (const BenchRow& row : rows)
  {
    if (row.Case != name || row.Method != SizeMethod)
    {
      continue;
    }
    if (const auto cost = measure.Get(row))
    {
      points.N.push_back(row.Counts["n"].get<double>());
      points.Cost.push_back(*cost);
    }
  }
  return points;
}

void AddExponent(
  const std::string& name, const Measure& measure, const Theory& theory, BenchRows& rows)
{
  const Points points = GetPoints(name, measure, rows.Get());
  if (points.N.size() < 2)
  {
    return;
  }
  const auto range = std::minmax_element(points.N.begin(), points.N.end());
  BenchRow row = rows.Make(name, measure.Method, theory.Reason);
  row.Set({ { "exponent", FitExponent(points.N, points.Cost) }, { "least", theory.Minimum },
    { "most", theory.Maximum }, { "sizes", points.N.size() },
    { "factor", *range.second / *range.first } });
  rows.Add(row);
}

std::string ToText(double number)
{
  std::ostringstream text;
  text.precision(2);
  text << number;
  return text.str();
}

std::string TheoryText(const BenchRow& row)
{
  const double least = row.Counts["least"];
  const double most = row.Counts["most"];
  return least == most ? ToText(least) : ToText(least) + " to " + ToText(most);
}

BenchClaim CheckExponent(
  const std::string& text, const Measure& measure, const std::vector<BenchRow>& rows)
{
  BenchClaim claim;
  claim.Text = text + ": fitted exponent within " + ToText(Margin) + " of theory's, in brackets";
  for (const BenchRow& row : rows)
  {
    if (row.Method == measure.Method)
    {
      const double exponent = row.Counts["exponent"];
      const bool isMet = exponent >= row.Counts["least"].get<double>() - Margin &&
        exponent <= row.Counts["most"].get<double>() + Margin;
      claim.Cases.push_back({ row.Case + " (" + TheoryText(row) + ")", exponent, isMet });
    }
  }
  return claim;
}
}

const char* const TimeExponent = "time exponent";
const char* const MemoryExponent = "memory exponent";

void AddExponentRows(const Quantity& quantity, BenchRows& rows)
{
  AddExponent(quantity.Name, OfTime, quantity.Time, rows);
  AddExponent(quantity.Name, OfMemory, quantity.Memory, rows);
}

std::vector<BenchClaim> CheckExponents(const std::vector<BenchRow>& rows)
{
  return { CheckExponent("processor time against N", OfTime, rows),
    CheckExponent("memory against N", OfMemory, rows) };
}
}
