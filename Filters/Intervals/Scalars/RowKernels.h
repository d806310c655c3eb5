// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowKernels_h
#define interlume_RowKernels_h

#include <cstdint>

namespace interlume
{

/**
 * Loops over the rows of a grid, compiled with and without AVX2. The version is selected at run
 * time. The results do not depend on the instruction set. The loops are written for automatic
 * vectorization: no aliasing, 16-bit arithmetic throughout, no branches.
 */
namespace RowKernels
{
using Code = std::uint16_t;

///@{
/// Compute the number of thresholds that each value reaches. \a count, the number of thresholds, is
/// 2 or 4.
void Classify(
  const float* values, std::int64_t number, const float* thresholds, int count, Code* codes);
void Classify(
  const double* values, std::int64_t number, const double* thresholds, int count, Code* codes);
///@}

///@{
/// Return whether all values are finite.
bool AreFinite(const float* values, std::int64_t number);
bool AreFinite(const double* values, std::int64_t number);
///@}

/// Computes a mark for each code: 1 plus the sum of steps[k] for all k less than the code. Codes
/// must be less than 256. \a count, the number of steps, is 3 or 5.
void FillMarks(const Code* codes, std::int64_t number, const std::uint8_t* steps, int count,
  std::uint8_t* marks);

/// Computes the minimum and maximum code, and the bitwise OR of all codes.
void Summarize(const Code* codes, std::int64_t number, Code& minimum, Code& maximum, Code& bits);

/**
 * Counts the output points that each grid point of a row owns. The input \a first is 1 if the grid
 * point itself is an output point, and 0 otherwise. \a second adds the points on the edge along i,
 * \a third also those along j, and \a all also those along k.
 */
void CountOwnedPoints(const Code* here, const Code* along, const Code* above, std::int64_t number,
  const Code* first, Code* second, Code* third, Code* all);

/// Counts the edge points along i, j and k of all grid points of a row.
std::int64_t CountCrossings(
  const Code* here, const Code* along, const Code* above, std::int64_t number);

/// Computes the keys of \a number cells in base 2 or 3 from the codes of the four rows around them.
/// \a columns is a buffer of \a number + 1 values.
void FillKeys(int base, const Code* const rows[4], Code first, Code second, std::int64_t number,
  Code* columns, Code* keys);

/**
 * Computes, for each of \a number cells in a row, the minimum and maximum code of its corners, and
 * the code of all corners if they are equal, otherwise ExtractionKernels::Mixed. \a rows contains
 * the four rows of points around the cells at each of two time steps. \a minimum and \a maximum
 * must have space for \a number + 1 values.
 */
void FindRanges(
  const Code* const rows[8], std::int64_t number, Code* minimum, Code* maximum, Code* all);
}

}

#endif
