// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexSigns.h"

namespace interlume
{

namespace
{
using Signs = std::array<int, SimplexSigns::NumberOfPoints>;

constexpr int GetClass(int larger, int smaller)
{
  switch (10 * larger + smaller)
  {
    case 32:
      return 0;
    case 41:
      return 1;
    case 22:
      return 2;
    case 31:
      return 3;
    case 21:
      return 4;
    default:
      return 5;
  }
}

// Returns the points of the tetrahedron without the given positive and negative point.
constexpr std::array<std::uint8_t, 3> GetTetrahedron(int positive, int negative)
{
  std::array<std::uint8_t, 3> rest{};
  for (int k = 0, n = 0; k < SimplexSigns::NumberOfPoints; ++k)
  {
    if (k != positive && k != negative)
    {
      rest[n++] = static_cast<std::uint8_t>(k);
    }
  }
  // If the thick point is replaced by p_i, the result is the tetrahedron without p_j. Its sign is
  // (-1)^j lambda_j, up to the sign of the permutation that sorts p_i into its position.
  if ((positive + negative + (negative < positive ? 1 : 0)) % 2 == 0)
  {
    return rest;
  }
  return { { rest[1], rest[0], rest[2] } };
}

constexpr SimplexSigns::Cut MakeCut(const Signs& signs)
{
  SimplexSigns::Cut cut;
  int positive = 0;
  int negative = 0;
  for (const int sign : signs)
  {
    positive += sign > 0 ? 1 : 0;
    negative += sign < 0 ? 1 : 0;
  }
  cut.Class = static_cast<std::uint8_t>(
    positive < negative ? GetClass(negative, positive) : GetClass(positive, negative));
  const int meant = positive < negative ? 1 : -1;
  for (int i = 0; i < SimplexSigns::NumberOfPoints; ++i)
  {
    if (signs[i] == meant)
    {
      cut.MeanPoints[cut.NumberOfMeanPoints++] = static_cast<std::uint8_t>(i);
    }
    for (int j = 0; j < SimplexSigns::NumberOfPoints && signs[i] > 0; ++j)
    {
      if (signs[j] < 0)
      {
        cut.Tetrahedra[cut.NumberOfTetrahedra++] = GetTetrahedron(i, j);
      }
    }
  }
  return cut;
}
}

constexpr SimplexSigns::CutArray SimplexSigns::MakeDecompositions()
{
  CutArray cuts;
  for (unsigned int bits = 0; bits < InvertedBit; ++bits)
  {
    const unsigned int positive = bits & ((1u << NumberOfPoints) - 1);
    const unsigned int negative = bits >> NumberOfPoints;
    // Skip combinations in which a number is both positive and negative.
    if ((positive & negative) == 0)
    {
      Signs signs{};
      for (int i = 0; i < NumberOfPoints; ++i)
      {
        signs[i] = static_cast<int>((positive >> i) & 1u) - static_cast<int>((negative >> i) & 1u);
      }
      cuts[bits] = MakeCut(signs);
    }
  }
  return cuts;
}

const SimplexSigns::CutArray SimplexSigns::Cuts = SimplexSigns::MakeDecompositions();

}
