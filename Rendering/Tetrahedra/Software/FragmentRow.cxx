// SPDX-License-Identifier: BSD-3-Clause
#include "Software/FragmentRow.h"

#include "Software/FragmentClones.h"

namespace interlume
{

namespace
{
// Unlike std::min and std::max these become one instruction for many values.
inline float Min(float a, float b)
{
  return a < b ? a : b;
}

inline float Max(float a, float b)
{
  return a > b ? a : b;
}

constexpr int GROUP = Fragments::GROUP;

// A loop over a group becomes vector instructions only if it is not unrolled first.
#if defined(__GNUC__) && !defined(__clang__)
#define INTERLUME_GROUP_LOOP _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define INTERLUME_GROUP_LOOP
#endif

INTERLUME_CLONES
void WriteGroups(const FragmentRow& row, float* lengths, int at, int channels, int size)
{
  alignas(32) float steps[GROUP] = { 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
  alignas(32) float lambda[GROUP];
  alignas(32) float beyond[GROUP];
  const float a = row.Shares[0];
  const float b = row.Shares[1];
  const float c = row.Shares[2];
  const float d = row.Shares[3];
  const float aSlope = row.ShareSlopes[0];
  const float bSlope = row.ShareSlopes[1];
  const float cSlope = row.ShareSlopes[2];
  const float dSlope = row.ShareSlopes[3];
  const float crease = row.Crease;
  const float creaseSlope = row.CreaseSlope;
  const float thickness = row.Thickness;
  for (int first = 0; first < size; first += GROUP)
  {
    const auto start = static_cast<float>(first);
    float* length = lengths + first;
    const float* slants = row.Slants + first;
    INTERLUME_GROUP_LOOP
    for (int i = 0; i < GROUP; ++i)
    {
      const float x = start + steps[i];
      const float least =
        Min(Min(a + aSlope * x, b + bSlope * x), Min(c + cSlope * x, d + dSlope * x));
      lambda[i] = Max(0.0f, least);
      beyond[i] = Max(0.0f, crease + creaseSlope * x);
      length[i] = lambda[i] * thickness * slants[i];
    }
    for (int channel = 0; channel < channels; ++channel)
    {
      float* base = row.Base[channel] + at + first;
      float* other = row.Other[channel] + at + first;
      const float slope = row.Slopes[channel];
      const float value = row.Values[channel] + slope * start;
      const float bend = row.Bends[channel];
      const float difference = row.Differences[channel];
      INTERLUME_GROUP_LOOP
      for (int i = 0; i < GROUP; ++i)
      {
        const float here = value + slope * steps[i] + bend * beyond[i];
        base[i] = here;
        other[i] = here + lambda[i] * difference;
      }
    }
  }
}
}

void FragmentRow::Write(Fragments& fragments, int channels, int size) const
{
  WriteGroups(*this, &fragments.Length[fragments.Size], fragments.Size, channels, size);
}

void FragmentRow::WriteColors(Fragments& fragments, int channel, int base, int size) const
{
  for (int i = 0; i < size; ++i)
  {
    // Lambda is computed from the length that was made of it.
    const float lambda = this->Thickness > 0.0f
      ? fragments.Length[fragments.Size + i] / (this->Thickness * this->Slants[i])
      : 0.0f;
    for (int c = 0; c < 4; ++c)
    {
      const float beyond = Max(0.0f, this->Crease + this->CreaseSlope * static_cast<float>(i));
      const float color = this->Values[channel + c] +
        this->Slopes[channel + c] * static_cast<float>(i) + this->Bends[channel + c] * beyond;
      fragments.Colors[base][fragments.Size + i][c] = color;
      fragments.Colors[1 - base][fragments.Size + i][c] =
        color + lambda * this->Differences[channel + c];
    }
  }
}

}
