// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TiedCases_h
#define interlume_TiedCases_h

#include "Cuts/MergedCut.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   TiedCases
 * @brief   the cuts of hexahedra in rows where values equal isovalues, kept for cells that are
 * alike
 *
 * Such a cut follows from the item and from how each corner's value compares with both of its
 * bounds; cells that are alike follow each other. Each thread has an object of its own.
 */
class TiedCases
{
public:
  using Code = ExtractionValues::Code;

  struct Tied
  {
    std::uint64_t Key = 0;
    /// Whether slots are made one, and what is left then.
    bool IsMerged = false;
    MergedCut Cut;
  };

  /// Returns the cut of a cell with these codes; \a number is that of \a item, \a found its case.
  Tied& Find(const vtkIsotable& table, const vtkIsotable::RankArray& ranks,
    const ExtractionValues::Item& item, int number, const Code* codes,
    const vtkIsotable::Case& found, bool hasSides);

private:
  std::vector<Tied> Cases;
};

}

#endif
