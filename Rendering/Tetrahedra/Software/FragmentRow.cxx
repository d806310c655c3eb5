// SPDX-License-Identifier: BSD-3-Clause
#include "Software/FragmentRow.h"

#include "Common/SimdDispatch.h"

namespace interlume
{

namespace
{
// Unlike std::min and std::max, these compile to single SIMD instructions.
inline float Min(float a, float b)
{
  return a < b ? a : b;
}

inline float Max(float a, float b)
{
  return a > b ? a : b;
}

constexpr int GROUP = Fragments::GROUP;

// GCC vectorizes a loop over a group only if it does not unroll the loop first.
#if defined(__GNUC__) && !defined(__clang__)
#define INTERLUME_GROUP_LOOP _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define INTERLUME_GROUP_LOOP
#endif

void WriteGroups(const FragmentRow& row, float* lengths, int at, int channels, int size)
{
  SimdDispatch::CallFused(
    [](const FragmentRow& row, float* lengths, int at, int channels, int size)
    {
      alignas(32) float steps[GROUP] = { 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f };
      alignas(32) float lambda[GROUP];
      alignas(32) float pastCrease[GROUP];
      const float a = row.EdgeValues[0];
      const float b = row.EdgeValues[1];
      const float c = row.EdgeValues[2];
      const float d = row.EdgeValues[3];
      const float aSlope = row.EdgeSlopes[0];
      const float bSlope = row.EdgeSlopes[1];
      const float cSlope = row.EdgeSlopes[2];
      const float dSlope = row.EdgeSlopes[3];
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
          const float minimum =
            Min(Min(a + aSlope * x, b + bSlope * x), Min(c + cSlope * x, d + dSlope * x));
          lambda[i] = Max(0.0f, minimum);
          pastCrease[i] = Max(0.0f, crease + creaseSlope * x);
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
            const float here = value + slope * steps[i] + bend * pastCrease[i];
            base[i] = here;
            other[i] = here + lambda[i] * difference;
          }
        }
      }
    },
    row, lengths, at, channels, size);
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
    // Recover lambda from the length, which Write() computed from it.
    const float lambda = this->Thickness > 0.0f
      ? fragments.Length[fragments.Size + i] / (this->Thickness * this->Slants[i])
      : 0.0f;
    for (int c = 0; c < 4; ++c)
    {
      const float pastCrease = Max(0.0f, this->Crease + this->CreaseSlope * static_cast<float>(i));
      const float color = this->Values[channel + c] +
        this->Slopes[channel + c] * static_cast<float>(i) + this->Bends[channel + c] * pastCrease;
      fragments.Colors[base][fragments.Size + i][c] = color;
      fragments.Colors[1 - base][fragments.Size + i][c] =
        color + lambda * this->Differences[channel + c];
    }
  }
}

}
