// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowKernels_h
#define interlume_RowKernels_h

#include <cstdint>

namespace interlume
{

/**
 * The loops of ExtractionKernels over the rows of a grid, compiled for wider vectors too; which of
 * them is run, the machine decides. They are of integers: the results are the same.
 */
namespace RowKernels
{
using Code = std::uint16_t;

void Summarize(const Code* codes, std::int64_t number, Code& least, Code& greatest, Code& bits);

void CountOwned(const Code* here, const Code* along, const Code* above, std::int64_t number,
  const Code* first, Code* second, Code* third, Code* all);

/// Computes the keys of \a number cells in base 2 or 3, from the codes of the four rows around
/// them; \a columns is room for one more number than there are cells.
void FillKeys(int base, const Code* const rows[4], Code first, Code second, std::int64_t number,
  Code* columns, Code* keys);

void FindRanges(
  const Code* const rows[8], std::int64_t number, Code* least, Code* greatest, Code* all);
}

}

#endif
