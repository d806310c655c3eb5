#include "vtkFragmentRow.h"

#include "vtkFragmentClones.h"

#include <algorithm>

namespace
{
constexpr int GROUP = vtkFragments::GROUP;

// Whole groups of constant size become vector instructions without a remainder.
INTERLUME_CLONES
void WriteGroups(const vtkFragmentRow& row, float* lengths, int at, int channels, int size)
{
  for (int first = 0; first < size; first += GROUP)
  {
    float x[GROUP];
    float lambda[GROUP];
    for (int i = 0; i < GROUP; ++i)
    {
      x[i] = static_cast<float>(first + i);
    }
    for (int i = 0; i < GROUP; ++i)
    {
      const float a = row.Shares[0] + row.ShareSlopes[0] * x[i];
      const float b = row.Shares[1] + row.ShareSlopes[1] * x[i];
      const float c = row.Shares[2] + row.ShareSlopes[2] * x[i];
      const float d = row.Shares[3] + row.ShareSlopes[3] * x[i];
      const float least = std::min(std::min(a, b), std::min(c, d));
      lambda[i] = std::max(0.0f, least);
    }
    for (int i = 0; i < GROUP; ++i)
    {
      lengths[first + i] = lambda[i] * row.Thickness;
    }
    for (int c = 0; c < channels; ++c)
    {
      float* base = row.Base[c] + at + first;
      float* other = row.Other[c] + at + first;
      const float value = row.Values[c];
      const float slope = row.Slopes[c];
      const float difference = row.Differences[c];
      for (int i = 0; i < GROUP; ++i)
      {
        base[i] = value + slope * x[i];
      }
      for (int i = 0; i < GROUP; ++i)
      {
        other[i] = value + slope * x[i] + lambda[i] * difference;
      }
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkFragmentRow::Write(vtkFragments& fragments, int channels, int size) const
{
  WriteGroups(*this, &fragments.Length[fragments.Size], fragments.Size, channels, size);
}

//------------------------------------------------------------------------------
void vtkFragmentRow::WriteColors(vtkFragments& fragments, int channel, int base, int size) const
{
  for (int i = 0; i < size; ++i)
  {
    // Lambda, from the length that was made of it.
    const float lambda = this->Thickness > 0.0f
      ? fragments.Length[fragments.Size + i] / this->Thickness
      : 0.0f;
    for (int c = 0; c < 4; ++c)
    {
      const float color =
        this->Values[channel + c] + this->Slopes[channel + c] * static_cast<float>(i);
      fragments.Colors[base][fragments.Size + i][c] = color;
      fragments.Colors[1 - base][fragments.Size + i][c] =
        color + lambda * this->Differences[channel + c];
    }
  }
}
