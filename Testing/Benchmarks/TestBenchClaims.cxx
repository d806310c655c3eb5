// SPDX-License-Identifier: BSD-3-Clause
// Tests claims of a suite: the rows that they select, their evaluation, the names of cases, and
// rows that were written and read again, including NaN values.
#include "Benchmarks/Results/BenchClaim.h"
#include "Support/Checks/ReferenceCheck.h"

#include <cmath>

namespace
{
BenchRow MakeRow(const char* theCase, const char* method, const nlohmann::ordered_json& parameter)
{
  BenchRow row;
  row.Case = theCase;
  row.Method = method;
  row.Parameter = parameter;
  return row;
}

/// Returns the names of the cases of a claim that selects all rows.
std::string NamesOf(const std::vector<BenchRow>& rows)
{
  const auto number = [&rows](const BenchRow& row) -> std::optional<double>
  { return static_cast<double>(&row - rows.data()); };
  std::string names;
  for (const BenchClaim::Measured& measured : BenchClaim::AtMost("few", 1.0, rows, number).Cases)
  {
    names += measured.Case + "; ";
  }
  return names;
}
}

int main()
{
  reference::Check check;
  const auto isNamed = [&check](const std::vector<BenchRow>& rows, const std::string& expected)
  { check.That(NamesOf(rows) == expected, "names of cases: " + NamesOf(rows)); };
  isNamed({ MakeRow("disk", "a", 1), MakeRow("fin", "b", 2) }, "disk; fin; ");
  isNamed({ MakeRow("disk", "a", 1), MakeRow("disk", "a", 2), MakeRow("fin", "a", 1) },
    "disk, 1; disk, 2; fin; ");
  isNamed({ MakeRow("disk", "a", "x"), MakeRow("disk", "b", "x") }, "disk, a; disk, b; ");
  isNamed({ MakeRow("disk", "a", 1), MakeRow("disk", "b", 2) }, "disk, a, 1; disk, b, 2; ");
  isNamed(
    { MakeRow("disk", "a", 0.1), MakeRow("disk", "a", 0.1 * 0.1) }, "disk, 0.1; disk, 0.01; ");

  std::vector<BenchRow> baselines = { MakeRow("disk", "a", 1), MakeRow("disk", "a", 1) };
  baselines[0].Baseline = "clip";
  baselines[1].Baseline = "contour";
  isNamed(baselines, "disk, clip; disk, contour; ");

  std::vector<BenchRow> rows = { MakeRow("disk", "a", 1), MakeRow("disk", "b", 2),
    MakeRow("fin", "a", 1) };
  rows[0].Counts["steps"] = 2;
  rows[1].Counts["steps"] = 9;
  const BenchClaim claim = BenchClaim::AtMost("few", 2.0, rows, CountOf("a", "steps"));
  check.Equal(claim.Cases.size(), 1, "rows of other methods or without the count are skipped");
  check.That(claim.IsMet() && claim.Cases[0].Case == "disk", "the row of disk meets the claim");
  check.That(!BenchClaim::AtLeast("many", 2.5, rows, CountOf("a", "steps")).IsMet(),
    "a count below the lower bound fails the claim");

  rows[0].Error = std::nan("");
  rows[0].Counts["steps"] = std::nan("");
  const BenchRow read = BenchRow::FromJson(nlohmann::ordered_json::parse(rows[0].ToJson().dump()));
  check.That(read.Error && std::isnan(*read.Error), "a NaN error survives writing and reading");
  const BenchClaim missed = BenchClaim::AtMost("few", 2.0, { read }, CountOf("a", "steps"));
  check.That(missed.Cases.size() == 1 && !missed.IsMet(), "a NaN count fails the claim");
  return check.Result();
}
