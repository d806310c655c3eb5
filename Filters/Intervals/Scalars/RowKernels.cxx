// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/RowKernels.h"

#include "Common/FunctionClones.h"
#include "Scalars/ExtractionKernels.h"

namespace interlume
{

namespace
{
template <int Base>
inline void FillKeysOf(const RowKernels::Code* const rows[4], RowKernels::Code first,
  RowKernels::Code second, std::int64_t number, RowKernels::Code* columns, RowKernels::Code* keys)
{
  ExtractionKernels::FillColumns<Base>(
    rows[0], rows[1], rows[2], rows[3], first, second, number + 1, columns);
  ExtractionKernels::FillKeys<Base>(columns, number, keys);
}
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::Classify(
  const float* values, std::int64_t number, const float* thresholds, int count, Code* codes)
{
  count == 2 ? ExtractionKernels::Classify<2>(values, number, thresholds, codes)
             : ExtractionKernels::Classify<4>(values, number, thresholds, codes);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::Classify(
  const double* values, std::int64_t number, const double* thresholds, int count, Code* codes)
{
  count == 2 ? ExtractionKernels::Classify<2>(values, number, thresholds, codes)
             : ExtractionKernels::Classify<4>(values, number, thresholds, codes);
}

INTERLUME_FUNCTION_CLONES("avx2")
bool RowKernels::AreFinite(const float* values, std::int64_t number)
{
  return ExtractionKernels::AreFinite(values, number);
}

INTERLUME_FUNCTION_CLONES("avx2")
bool RowKernels::AreFinite(const double* values, std::int64_t number)
{
  return ExtractionKernels::AreFinite(values, number);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::FillMarks(
  const Code* codes, std::int64_t number, const std::uint8_t* steps, int count, std::uint8_t* marks)
{
  count == 3 ? ExtractionKernels::FillMarks<3>(codes, number, steps, marks)
             : ExtractionKernels::FillMarks<5>(codes, number, steps, marks);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::Summarize(
  const Code* codes, std::int64_t number, Code& least, Code& greatest, Code& bits)
{
  ExtractionKernels::Summarize(codes, number, least, greatest, bits);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::CountOwned(const Code* here, const Code* along, const Code* above,
  std::int64_t number, const Code* first, Code* second, Code* third, Code* all)
{
  ExtractionKernels::CountOwned(here, along, above, number, first, second, third, all);
}

INTERLUME_FUNCTION_CLONES("avx2")
std::int64_t RowKernels::CountCrossings(
  const Code* here, const Code* along, const Code* above, std::int64_t number)
{
  return ExtractionKernels::CountCrossings(here, along, above, number);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::FillKeys(int base, const Code* const rows[4], Code first, Code second,
  std::int64_t number, Code* columns, Code* keys)
{
  base == 3 ? FillKeysOf<3>(rows, first, second, number, columns, keys)
            : FillKeysOf<2>(rows, first, second, number, columns, keys);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::FindRanges(
  const Code* const rows[8], std::int64_t number, Code* least, Code* greatest, Code* all)
{
  ExtractionKernels::FindRanges(rows, number, least, greatest, all);
}

}
