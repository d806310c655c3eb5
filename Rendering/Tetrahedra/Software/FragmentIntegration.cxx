// SPDX-License-Identifier: BSD-3-Clause
#include "Software/FragmentIntegration.h"

#include "Common/SimdDispatch.h"
#include "Frame/PiecewiseLinearTransferFunction.h"
#include "Frame/SegmentTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace interlume
{

namespace
{
/// Series expansions are used below this optical depth.
constexpr float THIN = 0.3f;

// Returns exp(-x) for x >= 0, with a relative error below 2e-7.
inline float ExpOfMinus(float x)
{
  const float y = std::min(x * 1.44269504f, 126.0f);
  const int exponent = static_cast<int>(y);
  const float f = y - static_cast<float>(exponent);
  // Minimax polynomial of 2^-f on [0, 1].
  const float p = 1.0f +
    f *
      (-0.693147181f +
        f *
          (0.240226462f +
            f *
              (-0.0555033400f + f * (0.00961403240f + f * (-0.00132710570f + f * 0.000137200f)))));
  const int bits = (127 - exponent) << 23;
  float scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return p * scale;
}

// Returns 1 - exp(-x) for x below THIN, accurate to float precision.
inline float ThinOpacityOf(float x)
{
  return x *
    (1.0f -
      x *
        (0.5f -
          x * (0.166666667f - x * (0.0416666667f - x * (0.00833333333f - x * 0.00138888889f)))));
}

inline float OpacityOf(float x)
{
  return x < THIN ? ThinOpacityOf(x) : 1.0f - ExpOfMinus(x);
}

// Optical depth per unit of length, and its distribution along a segment on which extinction and
// extent in time vary linearly.
struct Moments
{
  float Mean;
  // Relative change (back - front) / (back + front) of a linear distribution with the same
  // centroid.
  float Delta;
};

inline Moments GetMoments(float t0, float t1)
{
  const float sum = t0 + t1;
  const float delta = (t1 - t0) / std::max(sum, 1e-37f);
  return { 0.5f * sum, std::max(-1.0f, std::min(delta, 1.0f)) };
}

inline Moments GetMoments(float t0, float t1, float d0, float d1)
{
  const float a = t0 * d0;
  const float b = t0 * d1 + t1 * d0;
  const float c = t1 * d1;
  const float mean = (2.0f * a + b + 2.0f * c) * (1.0f / 6.0f);
  const float center = (a + b + 3.0f * c) * (1.0f / 12.0f) / std::max(mean, 1e-37f);
  return { mean, std::max(-1.0f, std::min(6.0f * center - 3.0f, 1.0f)) };
}

using Fragments = interlume::Fragments;

// Calls action(i) for each i for which test(i) is true. This is fast if few i pass the test,
// because tests are vectorized in groups.
template <typename Test, typename Action>
inline void ForEachWhere(int size, const Test& test, const Action& action)
{
  constexpr int group = 16;
  int first = 0;
  for (; first + group <= size; first += group)
  {
    int number = 0;
    for (int i = first; i < first + group; ++i)
    {
      number += test(i) ? 1 : 0;
    }
    for (int i = first; number > 0 && i < first + group; ++i)
    {
      if (test(i))
      {
        action(i);
      }
    }
  }
  for (; first < size; ++first)
  {
    if (test(first))
    {
      action(first);
    }
  }
}

void DivideByDepth(const float* front, const float* back, float* front0, float* back0, int size)
{
  SimdDispatch::CallFused(
    [](const float* front, const float* back, float* front0, float* back0, int size)
    {
      for (int i = 0; i < size; ++i)
      {
        front0[i] /= front[i];
        back0[i] /= back[i];
      }
    },
    front, back, front0, back0, size);
}

void MakePerspectiveLengths(Fragments& f)
{
  SimdDispatch::CallFused(
    [](Fragments& f)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        f.Length[i] /= f.Depth[0][i] * f.Depth[1][i];
      }
    },
    f);
}

void MakeMoments(Fragments& f)
{
  SimdDispatch::CallFused(
    [](Fragments& f)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        const Moments m = GetMoments(f.Extinction[0][i], f.Extinction[1][i]);
        f.OpticalDepth[i] = m.Mean * f.Length[i];
        f.Slope[i] = m.Delta;
      }
    },
    f);
}

void MakeMomentsWithTime(Fragments& f)
{
  SimdDispatch::CallFused(
    [](Fragments& f)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        const Moments m =
          GetMoments(f.Extinction[0][i], f.Extinction[1][i], f.DeltaT[0][i], f.DeltaT[1][i]);
        f.OpticalDepth[i] = m.Mean * f.Length[i];
        f.Slope[i] = m.Delta;
      }
    },
    f);
}

void MakeMeans(Fragments& f, bool hasDeltaT)
{
  SimdDispatch::CallFused(
    [](Fragments& f, bool hasDeltaT)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        const float time = hasDeltaT ? 0.5f * (f.DeltaT[0][i] + f.DeltaT[1][i]) : 1.0f;
        f.OpticalDepth[i] = 0.5f * (f.Extinction[0][i] + f.Extinction[1][i]) * time * f.Length[i];
        f.Slope[i] = 0.0f;
      }
    },
    f, hasDeltaT);
}

// Computes weights and opacity from optical depth and slope. Accurate only for optical depths below
// THIN.
void MakeThinOpacities(Fragments& f)
{
  SimdDispatch::CallFused(
    [](Fragments& f)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        const float depth = f.OpticalDepth[i];
        const float delta = f.Slope[i];
        // Series expansion of 1 - Psi (see SegmentTable) in the optical depth. Its coefficients are
        // moments of the fraction of the optical depth in front of a point on the segment.
        const float g1 = 0.5f - delta * (1.0f / 6.0f);
        const float g2 = 1.0f / 3.0f - delta * (1.0f / 6.0f - delta * (1.0f / 30.0f));
        const float g3 = 0.25f - delta * (0.15f - delta * (0.05f - delta * (1.0f / 140.0f)));
        const float front = depth *
          (g1 - depth * (1.0f / 2.0f) * (g2 - depth * (1.0f / 3.0f) * (g3 - depth * 0.05f)));
        const float opacity = ThinOpacityOf(depth);
        f.Weight[0][i] = front;
        f.Weight[1][i] = opacity - front;
        f.Total[i] = opacity;
      }
    },
    f);
}

// Computes weights and opacity from SegmentTable, for optical depths of at least THIN.
void MakeThickOpacities(Fragments& f)
{
  const SegmentTable& table = SegmentTable::Get();
  ForEachWhere(
    f.Size, [&f](int i) { return f.OpticalDepth[i] >= THIN; },
    [&](int i)
    {
      const float depth = f.OpticalDepth[i];
      const float opacity = 1.0f - ExpOfMinus(depth);
      const float front = table.GetFrontWeight(std::min(depth, 1e7f), f.Slope[i]) * opacity;
      f.Weight[0][i] = front;
      f.Weight[1][i] = opacity - front;
      f.Total[i] = opacity;
    });
}

// Computes opacity and equal weights for both ends.
void MakeEvenOpacities(Fragments& f)
{
  SimdDispatch::CallFused(
    [](Fragments& f)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        const float depth = f.OpticalDepth[i];
        const float opacity = OpacityOf(depth);
        f.Weight[0][i] = f.Weight[1][i] = 0.5f * opacity;
        f.Total[i] = opacity;
      }
    },
    f);
}

void MakeDepths(Fragments& f, bool isExact)
{
  SimdDispatch::CallFused(
    [](Fragments& f, bool isExact)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        const float depth = f.OpticalDepth[i];
        const float front = depth * (0.5f - (isExact ? f.Slope[i] * (1.0f / 6.0f) : 0.0f));
        f.Weight[0][i] = front;
        f.Weight[1][i] = depth - front;
        f.Total[i] = depth;
      }
    },
    f, isExact);
}

// Converts the weights of the colors at both ends to weights of the value and slope of their
// transfer function piece. f.Scalar is relative to the start of the piece.
void MakePieceWeights(Fragments& f)
{
  SimdDispatch::CallFused(
    [](Fragments& f)
    {
      for (int i = 0; i < f.Size; ++i)
      {
        const float front = f.Weight[0][i];
        const float back = f.Weight[1][i];
        f.Weight[0][i] = front + back;
        f.Weight[1][i] = front * f.Scalar[0][i] + back * f.Scalar[1][i];
      }
    },
    f);
}
}

void FragmentIntegration::ApplyPerspectiveDivision(
  interlume::Fragments& f, const Channels& channels)
{
  MakePerspectiveLengths(f);
  const auto divide = [&f](interlume::Fragments::Values* ends)
  { DivideByDepth(f.Depth[0].data(), f.Depth[1].data(), ends[0].data(), ends[1].data(), f.Size); };
  if (channels.HasScalars)
  {
    divide(f.Scalar);
  }
  if (channels.HasDeltaT)
  {
    divide(f.DeltaT);
  }
  for (int end = 0; channels.HasColors && end < 2; ++end)
  {
    for (int i = 0; i < f.Size; ++i)
    {
      for (float& channel : f.Colors[end][i])
      {
        channel /= f.Depth[end][i];
      }
    }
  }
}

void FragmentIntegration::CutAtOpaqueSurfaces(
  interlume::Fragments& f, const Channels& channels, bool isParallel, const float* opaque)
{
  const auto cutOne = [&](int i, float opaqueDepth)
  {
    const float front = f.Depth[0][i];
    const float back = f.Depth[1][i];
    if (front <= opaqueDepth)
    {
      f.Length[i] = 0.0f;
      return;
    }
    // Fraction of the length in front of the opaque surface. In perspective, the length is linear
    // in 1/depth.
    float fraction = (front - opaqueDepth) / (front - back);
    fraction = isParallel ? fraction : fraction * back / opaqueDepth;
    fraction = std::min(fraction, 1.0f);
    f.Length[i] *= fraction;
    f.Depth[1][i] = opaqueDepth;
    const auto cut = [fraction](float from, float& to) { to = from + fraction * (to - from); };
    if (channels.HasScalars)
    {
      cut(f.Scalar[0][i], f.Scalar[1][i]);
    }
    if (channels.HasDeltaT)
    {
      cut(f.DeltaT[0][i], f.DeltaT[1][i]);
    }
    for (int c = 0; channels.HasColors && c < 4; ++c)
    {
      cut(f.Colors[0][i][c], f.Colors[1][i][c]);
    }
  };
  for (int run = 0; run < f.NumberOfRuns; ++run)
  {
    const interlume::Fragments::Run& r = f.Runs[run];
    const float* opaqueDepths = opaque + r.Pixel;
    for (int i = r.Begin; i < r.End; ++i)
    {
      const float opaqueDepth = opaqueDepths[i - r.Begin];
      if (f.Depth[1][i] < opaqueDepth)
      {
        cutOne(i, opaqueDepth);
      }
    }
  }
}

namespace
{
/// For at most this many pieces, comparing a scalar with the start of each piece is faster than a
/// search.
constexpr int FEW = 12;

inline std::int32_t ToBits(float value)
{
  std::int32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

inline float FromBits(std::int32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

/// Starts of all pieces, and the values and slopes of their extinction.
struct PieceArrays
{
  const float* Starts;
  const float* Values;
  const float* Slopes;
};

// For one end of each segment, finds the piece, replaces the scalar with its offset from the start
// of the piece, and computes the extinction. Number is at most 4, so comparing the scalar with the
// start of each piece and selecting with masks is faster than a search and lookups.
template <int Number>
inline void LookUpEach(
  float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces)
{
  std::array<float, Number> starts;
  std::array<std::int32_t, Number> startBits;
  std::array<std::int32_t, Number> valueBits;
  std::array<std::int32_t, Number> slopeBits;
  for (int piece = 0; piece < Number; ++piece)
  {
    starts[piece] = pieces.Starts[piece];
    startBits[piece] = ToBits(pieces.Starts[piece]);
    valueBits[piece] = ToBits(pieces.Values[piece]);
    slopeBits[piece] = ToBits(pieces.Slopes[piece]);
  }
  for (int i = 0; i < size; ++i)
  {
    const float low = scalars[i] > 0.0f ? scalars[i] : 0.0f;
    const float scalar = low < 1.0f ? low : 1.0f;
    std::int32_t index = 0;
    std::int32_t start = startBits[0];
    std::int32_t value = valueBits[0];
    std::int32_t slope = slopeBits[0];
    for (int piece = 1; piece < Number; ++piece)
    {
      // Select with integer masks. If floats were selected, compilers would create branches and not
      // vectorize the loop.
      const std::int32_t isPast = -static_cast<std::int32_t>(scalar >= starts[piece]);
      index -= isPast;
      start ^= (start ^ startBits[piece]) & isPast;
      value ^= (value ^ valueBits[piece]) & isPast;
      slope ^= (slope ^ slopeBits[piece]) & isPast;
    }
    const float offset = scalar - FromBits(start);
    scalars[i] = offset;
    extinctions[i] = FromBits(value) + FromBits(slope) * offset;
    found[i] = index;
  }
}

template <int Number>
void LookUp(
  float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces)
{
  SimdDispatch::CallFused(
    [](float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces)
    { LookUpEach<Number>(scalars, extinctions, found, size, pieces); },
    scalars, extinctions, found, size, pieces);
}

// The functions for one to four pieces.
constexpr std::array LookUpUpToFour = { &LookUp<1>, &LookUp<2>, &LookUp<3>, &LookUp<4> };

void LookUpFew(float* scalars, float* extinctions, std::int32_t* found, int size,
  const PieceArrays& pieces, int number)
{
  SimdDispatch::CallFused(
    [](float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces,
      int number)
    {
      for (int i = 0; i < size; ++i)
      {
        const float low = scalars[i] > 0.0f ? scalars[i] : 0.0f;
        scalars[i] = low < 1.0f ? low : 1.0f;
        found[i] = 0;
      }
      for (int piece = 1; piece < number; ++piece)
      {
        const float start = pieces.Starts[piece];
        for (int i = 0; i < size; ++i)
        {
          found[i] += scalars[i] >= start ? 1 : 0;
        }
      }
      for (int i = 0; i < size; ++i)
      {
        const float offset = scalars[i] - pieces.Starts[found[i]];
        scalars[i] = offset;
        extinctions[i] = pieces.Values[found[i]] + pieces.Slopes[found[i]] * offset;
      }
    },
    scalars, extinctions, found, size, pieces, number);
}

void LookUpMany(float* scalars, float* extinctions, std::int32_t* found, int size,
  const PiecewiseLinearTransferFunction& pieces)
{
  for (int i = 0; i < size; ++i)
  {
    const float value = std::max(0.0f, std::min(scalars[i], 1.0f));
    const int piece = pieces.Find(value);
    const float offset = value - pieces.GetStarts()[piece];
    scalars[i] = offset;
    extinctions[i] = pieces.GetExtinctions()[piece] + pieces.GetExtinctionSlopes()[piece] * offset;
    found[i] = piece;
  }
}
}

void FragmentIntegration::LookUpExtinction(
  interlume::Fragments& f, const PiecewiseLinearTransferFunction& pieces)
{
  const int number = pieces.GetNumberOfPieces();
  const PieceArrays arrays{ pieces.GetStarts().data(), pieces.GetExtinctions().data(),
    pieces.GetExtinctionSlopes().data() };
  for (int end = 0; end < 2; ++end)
  {
    float* scalars = f.Scalar[end].data();
    float* extinctions = f.Extinction[end].data();
    std::int32_t* found = f.Pieces[end].data();
    if (number <= static_cast<int>(LookUpUpToFour.size()))
    {
      LookUpUpToFour[number - 1](scalars, extinctions, found, f.Size, arrays);
    }
    else if (number <= FEW)
    {
      LookUpFew(scalars, extinctions, found, f.Size, arrays, number);
    }
    else
    {
      LookUpMany(scalars, extinctions, found, f.Size, pieces);
    }
  }
  f.NumberOfSplits = 0;
  if (number > 1)
  {
    ForEachWhere(
      f.Size, [&f](int i) { return f.Pieces[0][i] != f.Pieces[1][i]; },
      [&f](int i) { f.Split[f.NumberOfSplits++] = static_cast<std::uint16_t>(i); });
  }
}

void FragmentIntegration::SetExtinction(interlume::Fragments& f)
{
  for (int end = 0; end < 2; ++end)
  {
    for (int i = 0; i < f.Size; ++i)
    {
      f.Extinction[end][i] = f.Colors[end][i][3];
    }
  }
}

void FragmentIntegration::SetExtinction(
  interlume::Fragments& f, const interlume::Fragments::Color* cells)
{
  for (int run = 0; run < f.NumberOfRuns; ++run)
  {
    const interlume::Fragments::Run& r = f.Runs[run];
    for (interlume::Fragments::Values& extinction : f.Extinction)
    {
      std::fill(&extinction[r.Begin], &extinction[r.End], cells[r.Tetrahedron][3]);
    }
  }
}

void FragmentIntegration::Integrate(
  interlume::Fragments& f, bool hasDeltaT, bool isExact, Results results)
{
  if (isExact && hasDeltaT)
  {
    MakeMomentsWithTime(f);
  }
  else if (isExact)
  {
    MakeMoments(f);
  }
  else
  {
    MakeMeans(f, hasDeltaT);
  }
  if (results == OPTICAL_DEPTH)
  {
    MakeDepths(f, isExact);
  }
  else if (isExact)
  {
    MakeThinOpacities(f);
    MakeThickOpacities(f);
  }
  else
  {
    MakeEvenOpacities(f);
  }
}

namespace
{
using Results = FragmentIntegration::Results;

// Integrates segment i piece by piece. Its front end is in the piece `piece`, its back end in the
// piece `end`.
void IntegrateSplit(interlume::Fragments& f, int i, int piece, int end,
  const PiecewiseLinearTransferFunction& pieces, bool hasDeltaT, Results results,
  interlume::Fragments::Color& color)
{
  const SegmentTable& table = SegmentTable::Get();
  const std::vector<float>& starts = pieces.GetStarts();
  const float first = f.Scalar[0][i] + starts[piece];
  const float last = f.Scalar[1][i] + starts[end];
  const int step = end > piece ? 1 : -1;
  float depth = 0.0f;
  float from = 0.0f;
  float value = first;
  while (true)
  {
    // The current part ends where the piece or the segment ends.
    const bool isLast = piece == end;
    const float bound = starts[step > 0 ? piece + 1 : piece];
    const float to = isLast ? 1.0f : std::min((bound - first) / (last - first), 1.0f);
    const float next = isLast ? last : bound;
    const PiecewiseLinearTransferFunction::Sample front = pieces.Evaluate(piece, value);
    const PiecewiseLinearTransferFunction::Sample back = pieces.Evaluate(piece, next);
    Moments m = GetMoments(front[3], back[3]);
    if (hasDeltaT)
    {
      const float rise = f.DeltaT[1][i] - f.DeltaT[0][i];
      m = GetMoments(front[3], back[3], f.DeltaT[0][i] + from * rise, f.DeltaT[0][i] + to * rise);
    }
    const float part = std::max(to - from, 0.0f) * f.Length[i] * m.Mean;
    float weight = part;
    float frontWeight = part * (0.5f - m.Delta * (1.0f / 6.0f));
    if (results == FragmentIntegration::OPACITY)
    {
      weight = OpacityOf(part) * ExpOfMinus(depth);
      frontWeight = weight * table.GetFrontWeight(std::min(part, 1e7f), m.Delta);
    }
    for (int c = 0; c < 3; ++c)
    {
      color[c] += frontWeight * front[c] + (weight - frontWeight) * back[c];
    }
    depth += part;
    if (isLast)
    {
      break;
    }
    from = to;
    value = next;
    piece += step;
  }
  f.Total[i] = results == FragmentIntegration::OPACITY ? OpacityOf(depth) : depth;
}

// Computes the weighted sum of the colors at both ends, which are in different pieces.
void AverageSplit(const interlume::Fragments& f, int i, int piece, int end,
  const PiecewiseLinearTransferFunction& pieces, interlume::Fragments::Color& color)
{
  const std::vector<float>& starts = pieces.GetStarts();
  const PiecewiseLinearTransferFunction::Sample front =
    pieces.Evaluate(piece, f.Scalar[0][i] + starts[piece]);
  const PiecewiseLinearTransferFunction::Sample back =
    pieces.Evaluate(end, f.Scalar[1][i] + starts[end]);
  for (int c = 0; c < 3; ++c)
  {
    color[c] = f.Weight[0][i] * front[c] + f.Weight[1][i] * back[c];
  }
}
}

void FragmentIntegration::ConvertToPieceWeights(interlume::Fragments& f,
  const PiecewiseLinearTransferFunction& pieces, bool hasDeltaT, bool isExact, Results results)
{
  for (int split = 0; split < f.NumberOfSplits; ++split)
  {
    const int i = f.Split[split];
    const int piece = f.Pieces[0][i];
    const int end = f.Pieces[1][i];
    interlume::Fragments::Color& color = f.SplitColors[split];
    color = { { 0.0f, 0.0f, 0.0f, 0.0f } };
    if (isExact)
    {
      IntegrateSplit(f, i, piece, end, pieces, hasDeltaT, results, color);
    }
    else
    {
      AverageSplit(f, i, piece, end, pieces, color);
    }
    f.Pieces[0][i] = -1 - split;
  }
  MakePieceWeights(f);
}

}
