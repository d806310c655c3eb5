// SPDX-License-Identifier: BSD-3-Clause
#include "Software/FragmentIntegration.h"

#include "Frame/PiecewiseLinearTransfer.h"
#include "Frame/SegmentTable.h"
#include "Software/FragmentClones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace interlume
{

namespace
{
/// The optical depth below which series are used.
constexpr float THIN = 0.3f;

// Returns exp(-x) for x >= 0, within 2e-7 of it relatively.
inline float ExpOfMinus(float x)
{
  const float y = std::min(x * 1.44269504f, 126.0f);
  const int whole = static_cast<int>(y);
  const float f = y - static_cast<float>(whole);
  // The polynomial is 2^-f on [0, 1], minimax.
  const float p = 1.0f +
    f *
      (-0.693147181f +
        f *
          (0.240226462f +
            f *
              (-0.0555033400f + f * (0.00961403240f + f * (-0.00132710570f + f * 0.000137200f)))));
  const int bits = (127 - whole) << 23;
  float scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return p * scale;
}

// Returns 1 - exp(-x) for x below THIN, with the relative error of a float.
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

// The optical depth over a unit of length and its distribution, for extinction and extent in time
// that are linear.
struct Moments
{
  float Mean;
  // The relative change (back - front) / (back + front) of a linear extinction with the same
  // centre.
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
  const float centre = (a + b + 3.0f * c) * (1.0f / 12.0f) / std::max(mean, 1e-37f);
  return { mean, std::max(-1.0f, std::min(6.0f * centre - 3.0f, 1.0f)) };
}

using Fragments = interlume::Fragments;

// Calls action(i) where test(i) holds, which is rare: groups of segments are tested at once.
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

// Each loop is in a function of its own, since a clone is made of functions.
INTERLUME_CLONES
void DivideByDepth(const float* front, const float* back, float* front0, float* back0, int size)
{
  for (int i = 0; i < size; ++i)
  {
    front0[i] /= front[i];
    back0[i] /= back[i];
  }
}

INTERLUME_CLONES
void MakePerspectiveLengths(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    f.Length[i] /= f.Depth[0][i] * f.Depth[1][i];
  }
}

INTERLUME_CLONES
void MakeMoments(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const Moments m = GetMoments(f.Extinction[0][i], f.Extinction[1][i]);
    f.OpticalDepth[i] = m.Mean * f.Length[i];
    f.Slope[i] = m.Delta;
  }
}

INTERLUME_CLONES
void MakeMomentsWithTime(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const Moments m =
      GetMoments(f.Extinction[0][i], f.Extinction[1][i], f.DeltaT[0][i], f.DeltaT[1][i]);
    f.OpticalDepth[i] = m.Mean * f.Length[i];
    f.Slope[i] = m.Delta;
  }
}

INTERLUME_CLONES
void MakeMeans(Fragments& f, bool hasDeltaT)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float time = hasDeltaT ? 0.5f * (f.DeltaT[0][i] + f.DeltaT[1][i]) : 1.0f;
    f.OpticalDepth[i] = 0.5f * (f.Extinction[0][i] + f.Extinction[1][i]) * time * f.Length[i];
    f.Slope[i] = 0.0f;
  }
}

// Turns optical depth and slope into weights and opacity, right below THIN.
INTERLUME_CLONES
void MakeThinOpacities(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float depth = f.OpticalDepth[i];
    const float delta = f.Slope[i];
    // 1 - Psi as a series in optical depth: moments of the optical depth in front.
    const float g1 = 0.5f - delta * (1.0f / 6.0f);
    const float g2 = 1.0f / 3.0f - delta * (1.0f / 6.0f - delta * (1.0f / 30.0f));
    const float g3 = 0.25f - delta * (0.15f - delta * (0.05f - delta * (1.0f / 140.0f)));
    const float front =
      depth * (g1 - depth * (1.0f / 2.0f) * (g2 - depth * (1.0f / 3.0f) * (g3 - depth * 0.05f)));
    const float opacity = ThinOpacityOf(depth);
    f.Weight[0][i] = front;
    f.Weight[1][i] = opacity - front;
    f.Total[i] = opacity;
  }
}

// Turns optical depth and slope into weights and opacity by the table, for segments that are not
// thin.
void MakeThickOpacities(Fragments& f)
{
  const SegmentTable& table = SegmentTable::Get();
  ForEachWhere(
    f.Size, [&f](int i) { return f.OpticalDepth[i] >= THIN; },
    [&](int i)
    {
      const float depth = f.OpticalDepth[i];
      const float opacity = 1.0f - ExpOfMinus(depth);
      const float front = table.GetFrontShare(std::min(depth, 1e7f), f.Slope[i]) * opacity;
      f.Weight[0][i] = front;
      f.Weight[1][i] = opacity - front;
      f.Total[i] = opacity;
    });
}

// Computes weights that are alike at both ends.
INTERLUME_CLONES
void MakeEvenOpacities(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float depth = f.OpticalDepth[i];
    const float opacity = OpacityOf(depth);
    f.Weight[0][i] = f.Weight[1][i] = 0.5f * opacity;
    f.Total[i] = opacity;
  }
}

INTERLUME_CLONES
void MakeDepths(Fragments& f, bool isExact)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float depth = f.OpticalDepth[i];
    const float front = depth * (0.5f - (isExact ? f.Slope[i] * (1.0f / 6.0f) : 0.0f));
    f.Weight[0][i] = front;
    f.Weight[1][i] = depth - front;
    f.Total[i] = depth;
  }
}

// A colour is value + slope * scalar, the scalar counted from its piece's start.
INTERLUME_CLONES
void MakePieceWeights(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float front = f.Weight[0][i];
    const float back = f.Weight[1][i];
    f.Weight[0][i] = front + back;
    f.Weight[1][i] = front * f.Scalar[0][i] + back * f.Scalar[1][i];
  }
}
}

void FragmentIntegration::FinishPerspective(interlume::Fragments& f, const Channels& channels)
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

void FragmentIntegration::CutAt(
  interlume::Fragments& f, const Channels& channels, bool isParallel, const float* opaque)
{
  const auto cutOne = [&](int i, float wall)
  {
    const float front = f.Depth[0][i];
    const float back = f.Depth[1][i];
    if (front <= wall)
    {
      f.Length[i] = 0.0f;
      return;
    }
    // The share of length that is in front, which is linear in 1/depth in perspective.
    float share = (front - wall) / (front - back);
    share = isParallel ? share : share * back / wall;
    share = std::min(share, 1.0f);
    f.Length[i] *= share;
    f.Depth[1][i] = wall;
    const auto cut = [share](float from, float& to) { to = from + share * (to - from); };
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
    const float* walls = opaque + r.Pixel;
    for (int i = r.Begin; i < r.End; ++i)
    {
      const float wall = walls[i - r.Begin];
      if (f.Depth[1][i] < wall)
      {
        cutOne(i, wall);
      }
    }
  }
}

namespace
{
/// The number of pieces up to which comparing with each start is faster than a search.
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

/// What the pieces of the transfer functions have, one array for each.
struct PieceArrays
{
  const float* Starts;
  const float* Values;
  const float* Slopes;
};

// Finds the piece, place in it and extinction of one end of all segments, for so few pieces that
// comparing with each start is faster than a search, and choosing what it has than a lookup.
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
    std::int32_t place = 0;
    std::int32_t start = startBits[0];
    std::int32_t value = valueBits[0];
    std::int32_t slope = slopeBits[0];
    for (int piece = 1; piece < Number; ++piece)
    {
      // Compilers make branches of choices between floats here, and no vector instructions.
      const std::int32_t isBeyond = -static_cast<std::int32_t>(scalar >= starts[piece]);
      place -= isBeyond;
      start ^= (start ^ startBits[piece]) & isBeyond;
      value ^= (value ^ valueBits[piece]) & isBeyond;
      slope ^= (slope ^ slopeBits[piece]) & isBeyond;
    }
    const float offset = scalar - FromBits(start);
    scalars[i] = offset;
    extinctions[i] = FromBits(value) + FromBits(slope) * offset;
    found[i] = place;
  }
}

INTERLUME_CLONES
void LookUpOne(
  float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces)
{
  LookUpEach<1>(scalars, extinctions, found, size, pieces);
}

INTERLUME_CLONES
void LookUpTwo(
  float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces)
{
  LookUpEach<2>(scalars, extinctions, found, size, pieces);
}

INTERLUME_CLONES
void LookUpThree(
  float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces)
{
  LookUpEach<3>(scalars, extinctions, found, size, pieces);
}

INTERLUME_CLONES
void LookUpFour(
  float* scalars, float* extinctions, std::int32_t* found, int size, const PieceArrays& pieces)
{
  LookUpEach<4>(scalars, extinctions, found, size, pieces);
}

INTERLUME_CLONES
void LookUpFew(float* scalars, float* extinctions, std::int32_t* found, int size,
  const PieceArrays& pieces, int number)
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
}

void LookUpMany(float* scalars, float* extinctions, std::int32_t* found, int size,
  const PiecewiseLinearTransfer& pieces)
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

void FragmentIntegration::LookUp(interlume::Fragments& f, const PiecewiseLinearTransfer& pieces)
{
  const int number = pieces.GetNumberOfPieces();
  const PieceArrays arrays{ pieces.GetStarts().data(), pieces.GetExtinctions().data(),
    pieces.GetExtinctionSlopes().data() };
  for (int end = 0; end < 2; ++end)
  {
    float* scalars = f.Scalar[end].data();
    float* extinctions = f.Extinction[end].data();
    std::int32_t* found = f.Pieces[end].data();
    switch (number)
    {
      case 1:
        LookUpOne(scalars, extinctions, found, f.Size, arrays);
        break;
      case 2:
        LookUpTwo(scalars, extinctions, found, f.Size, arrays);
        break;
      case 3:
        LookUpThree(scalars, extinctions, found, f.Size, arrays);
        break;
      case 4:
        LookUpFour(scalars, extinctions, found, f.Size, arrays);
        break;
      default:
        if (number <= FEW)
        {
          LookUpFew(scalars, extinctions, found, f.Size, arrays, number);
        }
        else
        {
          LookUpMany(scalars, extinctions, found, f.Size, pieces);
        }
    }
  }
  f.NumberBent = 0;
  if (number > 1)
  {
    ForEachWhere(
      f.Size, [&f](int i) { return f.Pieces[0][i] != f.Pieces[1][i]; },
      [&f](int i) { f.Bent[f.NumberBent++] = static_cast<std::uint16_t>(i); });
  }
}

void FragmentIntegration::TakeExtinction(interlume::Fragments& f)
{
  for (int end = 0; end < 2; ++end)
  {
    for (int i = 0; i < f.Size; ++i)
    {
      f.Extinction[end][i] = f.Colors[end][i][3];
    }
  }
}

void FragmentIntegration::TakeExtinction(
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

// Integrates segment i from control point to control point, whose ends lie in pieces `piece` and
// `end`.
void IntegrateBent(interlume::Fragments& f, int i, int piece, int end,
  const PiecewiseLinearTransfer& pieces, bool hasDeltaT, Results results,
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
    // The part goes to the end of this piece, or of the segment.
    const bool isLast = piece == end;
    const float bound = starts[step > 0 ? piece + 1 : piece];
    const float to = isLast ? 1.0f : std::min((bound - first) / (last - first), 1.0f);
    const float next = isLast ? last : bound;
    const PiecewiseLinearTransfer::Sample front = pieces.Evaluate(piece, value);
    const PiecewiseLinearTransfer::Sample back = pieces.Evaluate(piece, next);
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
      frontWeight = weight * table.GetFrontShare(std::min(part, 1e7f), m.Delta);
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

// Takes the mean of colour at both ends, which are in different pieces.
void AverageBent(const interlume::Fragments& f, int i, int piece, int end,
  const PiecewiseLinearTransfer& pieces, interlume::Fragments::Color& color)
{
  const std::vector<float>& starts = pieces.GetStarts();
  const PiecewiseLinearTransfer::Sample front =
    pieces.Evaluate(piece, f.Scalar[0][i] + starts[piece]);
  const PiecewiseLinearTransfer::Sample back = pieces.Evaluate(end, f.Scalar[1][i] + starts[end]);
  for (int c = 0; c < 3; ++c)
  {
    color[c] = f.Weight[0][i] * front[c] + f.Weight[1][i] * back[c];
  }
}
}

void FragmentIntegration::FinishPieces(interlume::Fragments& f,
  const PiecewiseLinearTransfer& pieces, bool hasDeltaT, bool isExact, Results results)
{
  for (int bent = 0; bent < f.NumberBent; ++bent)
  {
    const int i = f.Bent[bent];
    const int piece = f.Pieces[0][i];
    const int end = f.Pieces[1][i];
    interlume::Fragments::Color& color = f.BentColors[bent];
    color = { { 0.0f, 0.0f, 0.0f, 0.0f } };
    if (isExact)
    {
      IntegrateBent(f, i, piece, end, pieces, hasDeltaT, results, color);
    }
    else
    {
      AverageBent(f, i, piece, end, pieces, color);
    }
    f.Pieces[0][i] = -1 - bent;
  }
  MakePieceWeights(f);
}

}
