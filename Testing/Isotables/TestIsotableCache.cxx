// SPDX-License-Identifier: BSD-3-Clause
// The tables of cells extruded in time: every cut equals the exact pulling triangulation, in
// ascending order and in random orders. Also tests the number of simplices of whole tables and the
// statistics of the cache.

#include "Support/Checks/ReferenceCheck.h"
#include "Isotables/ReferenceIsotable.h"

#include "vtkIsotable.h"
#include "SpaceTime/SpaceTimeTable.h"
#include "Hulls/Polytope.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace interlume;

namespace
{

using Cuts = std::multiset<reference::OrientedSimplex>;
using Slot = SpaceTimeTable::Slot;
using VertexRanks = std::array<Slot, SpaceTimeTable::MaximumNumberOfVertices>;

const char* const Names[] = { "tetrahedron x time", "pyramid x time", "wedge x time",
  "hexahedron x time" };

VertexRanks GetAscending()
{
  VertexRanks ranks;
  std::iota(ranks.begin(), ranks.end(), Slot(0));
  return ranks;
}

std::uint32_t GetNumberOfCases(const SpaceTimeTable& cache)
{
  std::uint32_t number = 1;
  for (int v = 0; v < cache.GetNumberOfVertices(); ++v)
  {
    number *= 3;
  }
  return number;
}

Cuts Cut(
  const SpaceTimeTable& cache, const SpaceTimeTable::Case& what, const VertexRanks& vertexRanks)
{
  Cuts cuts;
  cache.Cut(what, cache.GetSlotRanks(vertexRanks.data()),
    [&cuts](const SpaceTimeTable::Simplex& simplex) {
      cuts.insert(reference::Orient({ simplex.begin(), simplex.end() }));
    });
  return cuts;
}

Cuts PullExactly(const SpaceTimeTable& cache, std::uint32_t key, const VertexRanks& vertexRanks)
{
  const auto ranks = cache.GetSlotRanks(vertexRanks.data());
  return reference::PullExactly(cache.GetCell(), true, key, { ranks.begin(), ranks.end() });
}

// Returns a case key with random digits, depending on the round: any digits, only 0 and 1, only 1
// and 2, or mostly 1 and 2.
std::uint32_t MakeKey(int numberOfVertices, int round, std::mt19937& random)
{
  std::uint32_t key = 0;
  for (int v = 0; v < numberOfVertices; ++v)
  {
    const std::uint32_t any = random() % 3;
    const bool differs = random() % 5 == 0;
    const std::uint32_t some = round % 4 == 1 ? any % 2 : 1 + any % 2;
    key = 3 * key + (round % 4 == 0 ? any : round % 4 == 3 && differs ? any : some);
  }
  return key;
}

void TestCuts(SpaceTimeTable& cache, reference::Check& check)
{
  std::mt19937 random(3);
  const int n = cache.GetNumberOfVertices();
  for (int round = 0; round < 240; ++round)
  {
    const std::uint32_t key = MakeKey(n, round, random);
    const SpaceTimeTable::Case& what = cache.GetCase(key);
    Cuts ascending;
    std::set<Slot> used;
    for (const SpaceTimeTable::Simplex& simplex : what.Simplices)
    {
      ascending.insert(reference::Orient({ simplex.begin(), simplex.end() }));
      used.insert(simplex.begin(), simplex.end());
    }
    check.That(ascending == PullExactly(cache, key, GetAscending()), "ascending order");
    check.That(std::equal(used.begin(), used.end(), what.Slots.begin(), what.Slots.end()),
      "the slots used by the case");
    VertexRanks order = GetAscending();
    std::shuffle(order.begin(), order.begin() + n, random);
    check.That(Cut(cache, what, order) == PullExactly(cache, key, order), "random order");
  }
}

void TestSlotRanks(const SpaceTimeTable& cache, reference::Check& check)
{
  std::mt19937 random(17);
  const int n = cache.GetNumberOfVertices();
  const int m = cache.GetNumberOfEdges();
  VertexRanks order = GetAscending();
  std::shuffle(order.begin(), order.begin() + n, random);
  const auto ranks = cache.GetSlotRanks(order.data());
  std::set<std::array<int, 4>> keys;
  for (int slot = 0; slot < n + 2 * m; ++slot)
  {
    const int kind = slot < n ? 0 : 1 + (slot - n) / m;
    const auto edge =
      kind == 0 ? std::array<Slot, 2>{ { Slot(slot), Slot(slot) } } : cache.GetEdge((slot - n) % m);
    const auto ends = std::minmax(order[edge[0]], order[edge[1]]);
    keys.insert({ { kind, ends.first, ends.second, slot } });
  }
  int last = -1;
  for (const auto& key : keys)
  {
    check.That(ranks[key[3]] > last, "slots are ordered by kind, then by the ranks of both ends");
    last = ranks[key[3]];
  }
}

// The expected numbers are from the exact triangulations of all cases.
void TestTetrahedron(reference::Check& check)
{
  SpaceTimeTable& cache = SpaceTimeTable::Get(vtkIsotable::TETRAHEDRON);
  std::size_t sum = 0;
  std::size_t most = 0;
  for (std::uint32_t key = 0; key < GetNumberOfCases(cache); ++key)
  {
    const std::size_t number = cache.GetCase(key).Simplices.size();
    sum += number;
    most = std::max(most, number);
  }
  check.Equal(sum, 123516, "simplices of all cases");
  check.Equal(most, 34, "maximum number of simplices of a case");
}

void TestConstantHypercube(reference::Check& check)
{
  SpaceTimeTable& cache = SpaceTimeTable::Get(vtkIsotable::HEXAHEDRON);
  const std::uint32_t last = GetNumberOfCases(cache) - 1;
  check.Equal(cache.GetCase(last / 2).Simplices.size(), 24, "a cell of constant value");
  check.Equal(cache.GetCase(0).Simplices.size(), 0, "all vertices below");
  check.Equal(cache.GetCase(last).Simplices.size(), 0, "all vertices above");
}

// The edge graph of a frustum has symmetries that the cell does not have.
void TestFrustum(reference::Check& check)
{
  using Point = Polytope::Point;
  SpaceTimeTable cache(Polytope::FromVertices(3,
    { Point{ { 0, 0, 0 } }, Point{ { 12, 0, 0 } }, Point{ { 0, 12, 0 } }, Point{ { 12, 12, 0 } },
      Point{ { 4, 4, 4 } }, Point{ { 8, 4, 4 } }, Point{ { 4, 8, 4 } },
      Point{
        { 8, 8, 4 } } }).Prism());
  TestCuts(cache, check);
}

void TestStatistics(reference::Check& check)
{
  SpaceTimeTable cache(Polytope::Simplex(3).Prism());
  // In these 8 cases, one vertex is inside the interval and all others are below. Symmetries map
  // the cases onto each other.
  std::vector<std::uint32_t> keys{ 1 };
  while (keys.size() < 8)
  {
    keys.push_back(3 * keys.back());
  }
  for (const std::uint32_t key : keys)
  {
    cache.GetCase(key);
  }
  check.Equal(cache.GetNumberOfSymmetryClasses(), 1, "one kind");
  check.Equal(cache.GetNumberOfCases(), 8, "cases");
  check.Equal(cache.GetNumberOfLookups(), 8, "lookups");
  check.Equal(cache.GetNumberOfHits(), 0, "hits");
  const std::uint64_t bytes = cache.GetBytes();
  {
    SpaceTimeTable::Reader reader(cache);
    for (int round = 0; round < 3; ++round)
    {
      check.That(
        &reader.GetCase(1) == &cache.GetCase(1), "a reader finds the same case as the cache");
      reader.GetCase(2);
    }
    check.Equal(reader.GetNumberOfLookups(), 6, "lookups of the reader");
    check.Equal(reader.GetNumberOfCasesMade(), 1, "cases built by the reader");
    check.Equal(cache.GetNumberOfLookups(), 11, "lookups before the reader is destroyed");
  }
  check.Equal(cache.GetNumberOfLookups(), 17, "lookups after the reader is destroyed");
  check.Equal(cache.GetNumberOfHits(), 8, "hits after the reader is destroyed");
  check.Equal(cache.GetNumberOfCases(), 9, "cases after the reader is destroyed");
  check.Equal(cache.GetNumberOfSymmetryClasses(), 2, "kinds after the reader is destroyed");
  check.That(cache.GetBytes() > bytes, "a new case uses memory");
}

}

int TestIsotableCache(int, char*[])
{
  reference::Check check;
  for (int shape = 0; shape < vtkIsotable::NUMBER_OF_SOLIDS; ++shape)
  {
    check.SetContext(Names[shape]);
    SpaceTimeTable& cache = SpaceTimeTable::Get(static_cast<vtkIsotable::Shapes>(shape));
    TestCuts(cache, check);
    TestSlotRanks(cache, check);
  }
  check.SetContext("frustum x time");
  TestFrustum(check);
  check.SetContext("tetrahedron x time, whole table");
  TestTetrahedron(check);
  check.SetContext("hexahedron x time, constant");
  TestConstantHypercube(check);
  check.SetContext("statistics");
  TestStatistics(check);
  return check.Result();
}
