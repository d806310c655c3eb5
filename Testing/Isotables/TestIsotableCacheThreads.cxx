// SPDX-License-Identifier: BSD-3-Clause
// The same cases, simplex by simplex, however many threads ask and in whichever order; and counts
// of all threads that add up.

#include "Support/Checks/ReferenceCheck.h"

#include "SpaceTime/SpaceTimeTable.h"
#include "Hulls/Polytope.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

using namespace interlume;

namespace
{

using CaseList = std::vector<const SpaceTimeTable::Case*>;

// Some keys come often, and each has others of its kind.
std::vector<std::uint32_t> MakeKeys()
{
  std::mt19937 random(29);
  std::vector<std::uint32_t> keys;
  for (int i = 0; i < 300; ++i)
  {
    std::uint32_t key = 0;
    for (int v = 0; v < 16; ++v)
    {
      key = 3 * key + (random() % 4 == 0 ? random() % 3 : 1);
    }
    keys.push_back(key);
    // Mirrored along time.
    keys.push_back(key / 6561 + key % 6561 * 6561);
    keys.push_back(keys[random() % keys.size()]);
  }
  return keys;
}

// Each thread asks for all keys, beginning at another one.
std::vector<CaseList> Ask(
  SpaceTimeTable& cache, const std::vector<std::uint32_t>& keys, int numberOfThreads)
{
  std::vector<CaseList> found(numberOfThreads, CaseList(keys.size()));
  std::vector<std::thread> threads;
  threads.reserve(numberOfThreads);
  for (int t = 0; t < numberOfThreads; ++t)
  {
    threads.emplace_back(
      [&, t]
      {
        SpaceTimeTable::Reader reader(cache);
        const std::size_t first = t * keys.size() / numberOfThreads;
        for (std::size_t i = 0; i < keys.size(); ++i)
        {
          const std::size_t at = (first + i) % keys.size();
          found[t][at] = &reader.GetCase(keys[at]);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  return found;
}

}

int TestIsotableCacheThreads(int, char*[])
{
  reference::Check check;
  const std::vector<std::uint32_t> keys = MakeKeys();
  const std::uint64_t distinct = std::set<std::uint32_t>(keys.begin(), keys.end()).size();
  const Polytope cell = Polytope::Cube(3).Prism();
  // From the last key to the first, so that another case of a kind comes first.
  SpaceTimeTable expected(cell);
  for (auto key = keys.rbegin(); key != keys.rend(); ++key)
  {
    expected.GetCase(*key);
  }
  check.That(
    expected.GetNumberOfKinds() < expected.GetNumberOfCases(), "some cases are of one kind");
  for (const int threads : { 1, 2, 8 })
  {
    check.SetContext(std::to_string(threads) + " threads");
    SpaceTimeTable cache(cell);
    const std::vector<CaseList> found = Ask(cache, keys, threads);
    for (const CaseList& mine : found)
    {
      check.That(mine == found[0], "all threads are given the same copy of a case");
    }
    bool areEqual = true;
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      const SpaceTimeTable::Case& other = expected.GetCase(keys[i]);
      areEqual = areEqual && found[0][i]->Simplices == other.Simplices &&
        found[0][i]->Slots == other.Slots && found[0][i]->Symmetry == other.Symmetry;
    }
    check.That(areEqual, "cases do not depend on who asks first");
    check.Equal(cache.GetNumberOfCases(), distinct, "every case is made once");
    check.Equal(cache.GetNumberOfLookups(), threads * keys.size(), "lookups");
    check.Equal(cache.GetNumberOfHits(), threads * keys.size() - distinct, "hits");
    check.Equal(cache.GetNumberOfKinds(), expected.GetNumberOfKinds(), "kinds");
    check.Equal(cache.GetBytes(), expected.GetBytes(), "bytes");
  }
  return check.Result();
}
