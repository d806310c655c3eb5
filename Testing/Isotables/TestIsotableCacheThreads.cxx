// SPDX-License-Identifier: BSD-3-Clause
// Cases are equal for any number of threads and any order of requests. The statistics of all
// threads add up.

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

// Returns random keys. Each is followed by its mirror image in time, which is a case of the same
// kind, and by a repeated key.
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
    // The same case mirrored in time.
    keys.push_back(key / 6561 + key % 6561 * 6561);
    keys.push_back(keys[random() % keys.size()]);
  }
  return keys;
}

// Requests all keys in each thread. Every thread starts at a different key.
std::vector<CaseList> RequestCases(
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
  // Requests the keys in reverse order, so that another case of each kind is built first.
  SpaceTimeTable expected(cell);
  for (auto key = keys.rbegin(); key != keys.rend(); ++key)
  {
    expected.GetCase(*key);
  }
  check.That(
    expected.GetNumberOfSymmetryClasses() < expected.GetNumberOfCases(), "some cases share a kind");
  for (const int threads : { 1, 2, 8 })
  {
    check.SetContext(std::to_string(threads) + " threads");
    SpaceTimeTable cache(cell);
    const std::vector<CaseList> found = RequestCases(cache, keys, threads);
    for (const CaseList& mine : found)
    {
      check.That(mine == found[0], "all threads receive the same copy of a case");
    }
    bool areEqual = true;
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      const SpaceTimeTable::Case& other = expected.GetCase(keys[i]);
      areEqual = areEqual && found[0][i]->Simplices == other.Simplices &&
        found[0][i]->Slots == other.Slots && found[0][i]->Symmetry == other.Symmetry;
    }
    check.That(areEqual, "cases do not depend on the order of requests");
    check.Equal(cache.GetNumberOfCases(), distinct, "every case is built once");
    check.Equal(cache.GetNumberOfLookups(), threads * keys.size(), "lookups");
    check.Equal(cache.GetNumberOfHits(), threads * keys.size() - distinct, "hits");
    check.Equal(cache.GetNumberOfSymmetryClasses(), expected.GetNumberOfSymmetryClasses(), "kinds");
    check.Equal(cache.GetBytes(), expected.GetBytes(), "bytes");
  }
  return check.Result();
}
