// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/TieCaseCache.h"

#include "Cuts/CoincidentSlots.h"

#include <numeric>

namespace interlume
{

TieCaseCache::Tied& TieCaseCache::Find(const vtkIsotable& table,
  const vtkIsotable::RankArray& ranks, const ExtractionValues::Item& item, int number,
  const Code* codes, const vtkIsotable::Case& found, bool hasSides)
{
  const int lower = 2 * item.Lower + 1;
  const int upper = 2 * item.Upper + 1;
  std::uint64_t key = static_cast<std::uint64_t>(number) + 1;
  for (int v = 0; v < 8; ++v)
  {
    const int code = codes[v];
    key = 8 * key +
      static_cast<unsigned>((code >= lower) + (code > lower) + (code >= upper) + (code > upper));
  }
  constexpr int bits = 12;
  this->Cases.resize(std::size_t(1) << bits);
  Tied& tied = this->Cases[(key * 0x9E3779B97F4A7C15u) >> (64 - bits)];
  if (tied.Key != key)
  {
    MergedCut::Slot same[vtkIsotable::MaximumNumberOfSlots];
    std::iota(same, same + vtkIsotable::MaximumNumberOfSlots, MergedCut::Slot(0));
    for (const MergedCut::Slot slot : found.Slots)
    {
      same[slot] = CoincidentSlots::FindRepresentative(table, item, codes, slot);
    }
    tied.Key = key;
    tied.IsMerged = MergedCut::IsNeeded(found, same);
    if (tied.IsMerged)
    {
      tied.Cut.Make(table, item, codes, found, ranks, same, hasSides);
    }
  }
  return tied;
}

}
