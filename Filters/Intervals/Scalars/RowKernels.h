// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowKernels_h
#define interlume_RowKernels_h

#include <cstdint>

namespace interlume
{

/**
 * Loops over the rows of a grid, compiled for wider vectors too; the machine decides which version
 * is run. They are of integers: the results are the same. Compilers make vector code of them: no
 * aliasing, 16-bit arithmetic throughout, no branches.
 */
namespace RowKernels
{
using Code = std::uint16_t;

///@{
/// Compute the number of thresholds, of which there are two or four, that each value reaches.
void Classify(
  const float* values, std::int64_t number, const float* thresholds, int count, Code* codes);
void Classify(
  const double* values, std::int64_t number, const double* thresholds, int count, Code* codes);
///@}

///@{
/// Return whether no value is NaN or infinite.
bool AreFinite(const float* values, std::int64_t number);
bool AreFinite(const double* values, std::int64_t number);
///@}

/// Computes a mark for each code, of less than 256: 1, and for each \a k that is less than the code
/// steps[k] more. There are three or five steps.
void FillMarks(const Code* codes, std::int64_t number, const std::uint8_t* steps, int count,
  std::uint8_t* marks);

/// Finds the least and the greatest code, and all codes or-ed.
void Summarize(const Code* codes, std::int64_t number, Code& least, Code& greatest, Code& bits);

/**
 * Counts what each grid point of a row owns: \a first points of its own, in all \a second with the
 * crossings along i, \a third with those along j, \a all with those along k. On entry \a first is
 * filled.
 */
void CountOwned(const Code* here, const Code* along, const Code* above, std::int64_t number,
  const Code* first, Code* second, Code* third, Code* all);

/// Counts the crossings along i, j and k of all grid points of a row.
std::int64_t CountCrossings(
  const Code* here, const Code* along, const Code* above, std::int64_t number);

/// Computes the keys of \a number cells in base 2 or 3, from the codes of the four rows around
/// them; \a columns is room for one more number than there are cells.
void FillKeys(int base, const Code* const rows[4], Code first, Code second, std::int64_t number,
  Code* columns, Code* keys);

/**
 * Finds for each of \a number cells in a row the least and the greatest code of its corners, and
 * the code that all of them have or ExtractionKernels::Mixed. The eight rows are those around the
 * cells at two times; \a least and \a greatest have room for one more number than there are cells.
 */
void FindRanges(
  const Code* const rows[8], std::int64_t number, Code* least, Code* greatest, Code* all);
}

}

#endif
