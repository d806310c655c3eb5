// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TieCaseCache_h
#define interlume_TieCaseCache_h

#include "Cuts/MergedCut.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   TieCaseCache
 * @brief   cache of the cuts of hexahedra where values equal isovalues (ties)
 *
 * The cut depends on the item and on how each corner value compares with both bounds. These are
 * often the same for neighboring cells of a row. Use one object per thread.
 */
class TieCaseCache
{
public:
  using Code = ExtractionValues::Code;

  struct Tied
  {
    std::uint64_t Key = 0;
    /// If true, slots were merged and Cut holds the result.
    bool IsMerged = false;
    MergedCut Cut;
  };

  /// Returns the cut of a cell with the given codes. \a number is the index of \a item and \a found
  /// is the case of the cell.
  Tied& Find(const vtkIsotable& table, const vtkIsotable::RankArray& ranks,
    const ExtractionValues::Item& item, int number, const Code* codes,
    const vtkIsotable::Case& found, bool hasSides);

private:
  std::vector<Tied> Cases;
};

}

#endif
