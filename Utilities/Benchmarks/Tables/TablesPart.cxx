// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"
#include "Benchmarks/Tables/HypercubeTable.h"

#include "SpaceTime/SpaceTimeTable.h"
#include "Cases/SlotOrder.h"
#include "Cases/CasePatch.h"
#include "Hulls/Polytope.h"
#include "Benchmarks/Tables/FacetTriangulation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

using namespace interlume;

namespace
{
struct TableCase
{
  const char* Name;
  Polytope Cell;
  // Mean and maximum in table 3.2 of C. Zhang's dissertation (the mean to two decimals), or 0 if
  // the table has no row for the cell.
  double StatedMean;
  int StatedMaximum;
};

std::vector<TableCase> GetCases()
{
  using Cell = Polytope;
  return { { "tetrahedron", Cell::Simplex(3), 3.96, 6 },
    { "4-simplex", Cell::Simplex(4), 8.35, 14 }, { "5-simplex", Cell::Simplex(5), 17.27, 30 },
    { "hexahedron", Cell::Cube(3), 12.09, 22 }, { "wedge", Cell::Wedge(), 0.0, 0 },
    { "pyramid", Cell::Pyramid(), 0.0, 0 },
    { "tetrahedron-time", Cell::Simplex(3).Prism(), 19.71, 34 } };
}

const char* const HypercubeName = "hexahedron-time";
const char* const AllCases = "all cases";

// Returns the ranks of the points in C. Zhang's dissertation, which are the indices of their edges.
std::vector<int> GetSourceRanks(const Polytope& cell)
{
  std::vector<int> ranks(cell.Prism().Edges.size());
  std::iota(ranks.begin(), ranks.end(), 0);
  return ranks;
}

// Returns the point ranks that the filters use on structured grids.
std::vector<int> GetShippedRanks(const Polytope& cell)
{
  const int n = static_cast<int>(cell.Vertices.size());
  const int m = static_cast<int>(cell.Edges.size());
  std::vector<int> ascending(n);
  std::iota(ascending.begin(), ascending.end(), 0);
  std::vector<int> slotRanks(n + 2 * m);
  SlotOrder::RankSlots(n, cell.Edges, true, ascending.data(), slotRanks.data());
  std::vector<int> ranks;
  ranks.reserve(slotRanks.size());
  for (int e = 0; e < n + 2 * m; ++e)
  {
    ranks.push_back(slotRanks[SlotOrder::GetSlot(n, m, e)]);
  }
  return ranks;
}

HypercubeTable::Rule GetRule(const std::string& method, const Polytope& cell)
{
  return method == "source-order"
    ? HypercubeTable::Rule{ FacetTriangulation::PLACING, GetSourceRanks(cell) }
    : HypercubeTable::Rule{ FacetTriangulation::PULLING, GetShippedRanks(cell) };
}

void AddTable(const TableCase& what, const std::string& method, BenchRows& rows)
{
  const HypercubeTable::Rule rule = GetRule(method, what.Cell);
  const Polytope lifted = what.Cell.Prism();
  const int vertices = static_cast<int>(what.Cell.Vertices.size());
  int entries = 1;
  for (int v = 0; v < vertices; ++v)
  {
    entries *= 3;
  }
  std::int64_t sum = 0;
  int maximum = 0;
  for (int key = 0; key < entries; ++key)
  {
    const CasePatch patch(
      lifted, CasePatch::GetSigns(vertices, true, static_cast<std::uint32_t>(key)));
    const int number =
      static_cast<int>(FacetTriangulation::Triangulate(patch, rule.Method, rule.Ranks).size());
    sum += number;
    maximum = std::max(maximum, number);
  }
  BenchRow row = rows.Make(what.Name, method);
  row.Set({ { "entries", entries }, { "sum", sum }, { "mean", static_cast<double>(sum) / entries },
    { "max", maximum } });
  if (method == "source-order" && what.StatedMaximum > 0)
  {
    row.Set({ { "stated_mean", what.StatedMean }, { "stated_max", what.StatedMaximum } });
  }
  rows.Add(row);
}

void AddConstantHypercube(BenchRows& rows)
{
  std::uint32_t inside = 0;
  for (int v = 0; v < 16; ++v)
  {
    inside = 3 * inside + 1;
  }
  BenchRow row = rows.Make("constant-hypercube", "shipped");
  row.Counts["simplices"] =
    SpaceTimeTable::Get(vtkIsotable::HEXAHEDRON).GetCase(inside).Simplices.size();
  rows.Add(row);
}

void AddHypercube(const BenchOptions& options, BenchRows& rows)
{
  const Polytope cube = Polytope::Cube(4);
  const std::vector<std::string> methods{ "source-order", "shipped" };
  std::vector<HypercubeTable::Rule> rules;
  for (const std::string& method : methods)
  {
    rules.push_back(GetRule(method, cube));
  }
  const int stride = options.Pick(1, 40, 2000);
  const auto results = HypercubeTable::Count(rules, stride);
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    const HypercubeTable::Statistics& found = results[m];
    BenchRow row = rows.Make(
      HypercubeName, methods[m], stride == 1 ? AllCases : "a sample of the kinds of case");
    row.Set({ { "entries", found.Cases }, { "entries_up_to_symmetry", found.CasesUpToSymmetry },
      { "facets", found.Facets }, { "facet_orbits", found.FacetOrbits }, { "sum", found.Sum },
      { "mean", static_cast<double>(found.Sum) / static_cast<double>(found.Cases) },
      { "max", found.Maximum }, { "entries_at_max", found.CasesAtMaximum } });
    if (methods[m] == "source-order")
    {
      row.Set({ { "stated_mean", 59.36 }, { "stated_max", 128 } });
    }
    rows.Add(row);
  }
}

void AddRows(const BenchOptions& options, BenchRows& rows)
{
  for (const TableCase& what : GetCases())
  {
    for (const char* method : { "source-order", "shipped" })
    {
      AddTable(what, method, rows);
    }
  }
  AddConstantHypercube(rows);
  AddHypercube(options, rows);
}

std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows)
{
  BenchClaim printed{ "method source-order gives the mean and maximum stated for the method", {} };
  BenchClaim fewer{ "method shipped has no more simplices than source-order, mean and maximum",
    {} };
  for (const BenchRow& row : rows)
  {
    const bool hasAllCases = !row.Parameter.is_string() || row.Parameter == AllCases;
    if (row.Method == "source-order" && row.Counts.contains("stated_mean") && hasAllCases)
    {
      // The tolerance is 0.01, since C. Zhang's dissertation truncates some numbers and rounds
      // others.
      const double mean = row.Counts["mean"].get<double>();
      const bool met = std::abs(mean - row.Counts["stated_mean"].get<double>()) < 0.01 &&
        row.Counts["max"] == row.Counts["stated_max"];
      printed.Cases.push_back({ row.Case, mean, met });
    }
    const auto source = std::find_if(rows.begin(), rows.end(),
      [&row](const BenchRow& other)
      { return other.Case == row.Case && other.Method == "source-order"; });
    if (row.Method == "shipped" && source != rows.end())
    {
      const double mean = row.Counts["mean"].get<double>();
      const bool met = mean <= source->Counts["mean"].get<double>() &&
        row.Counts["max"].get<int>() <= source->Counts["max"].get<int>();
      fewer.Cases.push_back({ row.Case, mean, met });
    }
  }
  return { printed, fewer };
}
}

BenchPart MakeTablesPart()
{
  return { AddRows, nullptr, CheckClaims };
}
