#include "vtkFragmentIntegration.h"

#include "vtkFragmentClones.h"
#include "vtkSegmentTable.h"
#include "vtkTransferPieces.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
// exp(-x) for x >= 0, within 2e-7 of it relatively.
inline float ExpOfMinus(float x)
{
  const float y = std::min(x * 1.44269504f, 126.0f);
  const int whole = static_cast<int>(y);
  const float f = y - static_cast<float>(whole);
  // 2^-f on [0, 1], minimax.
  const float p = 1.0f +
    f *
      (-0.693147181f +
        f *
          (0.240226462f +
            f * (-0.0555033400f + f * (0.00961403240f + f * (-0.00132710570f + f * 0.000137200f)))));
  const int bits = (127 - whole) << 23;
  float scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return p * scale;
}

// 1 - exp(-x), with the relative error of a float for small x too.
inline float OpacityOf(float x)
{
  const float small = x *
    (1.0f -
      x * (0.5f - x * (0.166666667f - x * (0.0416666667f - x * (0.00833333333f - x * 0.00138888889f)))));
  return x < 0.3f ? small : 1.0f - ExpOfMinus(x);
}

// Optical depth over a unit of length and what tells where it lies, of extinction and extent in time
// that are linear.
struct Moments
{
  float Mean;
  // (back - front) / (back + front) of a linear extinction with the same centre.
  float Delta;
};

inline Moments GetMoments(float t0, float t1)
{
  const float sum = t0 + t1;
  return { 0.5f * sum, (t1 - t0) / std::max(sum, 1e-37f) };
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

template <bool HasDeltaT>
inline Moments GetMoments(const vtkFragments& f, int i)
{
  if (HasDeltaT)
  {
    return GetMoments(f.Color[0][i][3], f.Color[1][i][3], f.DeltaT[0][i], f.DeltaT[1][i]);
  }
  return GetMoments(f.Color[0][i][3], f.Color[1][i][3]);
}

using Fragments = vtkFragments;

// The loops, in a function each, since a clone is made of functions.
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
void MakePerspectiveLengths(Fragments& f, const float* slant)
{
  for (int i = 0; i < f.Size; ++i)
  {
    f.Length[i] *= slant[f.Pixels[i]] / (f.Depth[0][i] * f.Depth[1][i]);
  }
}

INTERLUME_CLONES
void MakeMoments(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const Moments m = GetMoments<false>(f, i);
    f.Total[i] = m.Mean * f.Length[i];
    f.Weight[1][i] = m.Delta;
  }
}

INTERLUME_CLONES
void MakeMomentsWithTime(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const Moments m = GetMoments<true>(f, i);
    f.Total[i] = m.Mean * f.Length[i];
    f.Weight[1][i] = m.Delta;
  }
}

INTERLUME_CLONES
void MakeMeans(Fragments& f, bool hasDeltaT)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float time = hasDeltaT ? 0.5f * (f.DeltaT[0][i] + f.DeltaT[1][i]) : 1.0f;
    f.Total[i] = 0.5f * (f.Color[0][i][3] + f.Color[1][i][3]) * time * f.Length[i];
  }
}

// The front share of small optical depth.
INTERLUME_CLONES
void MakeThinShares(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    f.Weight[0][i] = 0.5f - f.Weight[1][i] * (1.0f / 6.0f);
  }
}

INTERLUME_CLONES
void MakeShares(Fragments& f)
{
  const vtkSegmentTable& table = vtkSegmentTable::Get();
  for (int i = 0; i < f.Size; ++i)
  {
    const float depth = std::min(f.Total[i], 1e7f);
    f.Weight[0][i] = table.GetFrontShare(depth, f.Weight[1][i]);
  }
}

// From front share and optical depth to weights and transmittance.
INTERLUME_CLONES
void MakeOpacities(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float opacity = OpacityOf(f.Total[i]);
    const float front = f.Weight[0][i] * opacity;
    f.Weight[0][i] = front;
    f.Weight[1][i] = opacity - front;
    f.Total[i] = f.Total[i] < 0.3f ? 1.0f - opacity : ExpOfMinus(f.Total[i]);
  }
}

INTERLUME_CLONES
void MakeDepths(Fragments& f)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float front = f.Weight[0][i] * f.Total[i];
    f.Weight[0][i] = front;
    f.Weight[1][i] = f.Total[i] - front;
  }
}
}

//------------------------------------------------------------------------------
void vtkFragmentIntegration::FinishPerspective(
  vtkFragments& f, const Channels& channels, const float* slant)
{
  MakePerspectiveLengths(f, slant);
  const auto divide = [&f](vtkFragments::Values* ends) {
    DivideByDepth(f.Depth[0].data(), f.Depth[1].data(), ends[0].data(), ends[1].data(), f.Size);
  };
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
      for (float& channel : f.Color[end][i])
      {
        channel /= f.Depth[end][i];
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkFragmentIntegration::FinishParallel(vtkFragments& f, float slant)
{
  for (int i = 0; i < f.Size; ++i)
  {
    f.Length[i] *= slant;
  }
}

//------------------------------------------------------------------------------
void vtkFragmentIntegration::CutAt(
  vtkFragments& f, const Channels& channels, bool isParallel, const float* opaque)
{
  for (int i = 0; i < f.Size; ++i)
  {
    const float wall = opaque[f.Pixels[i]];
    const float front = f.Depth[0][i];
    const float back = f.Depth[1][i];
    if (back >= wall)
    {
      continue;
    }
    if (front <= wall)
    {
      f.Length[i] = 0.0f;
      continue;
    }
    // The share of length that is in front: linear in 1/depth in perspective.
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
      cut(f.Color[0][i][c], f.Color[1][i][c]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkFragmentIntegration::LookUp(vtkFragments& f, const vtkTransferPieces& pieces)
{
  for (int end = 0; end < 2; ++end)
  {
    for (int i = 0; i < f.Size; ++i)
    {
      const float value = std::max(0.0f, std::min(f.Scalar[end][i], 1.0f));
      f.Scalar[end][i] = value;
      f.Color[end][i] = pieces.Evaluate(pieces.Find(value), value);
    }
  }
}

//------------------------------------------------------------------------------
void vtkFragmentIntegration::Integrate(
  vtkFragments& f, bool hasDeltaT, bool isExact, Results results)
{
  if (!isExact)
  {
    MakeMeans(f, hasDeltaT);
    std::fill_n(f.Weight[0].begin(), f.Size, 0.5f);
  }
  else
  {
    if (hasDeltaT)
    {
      MakeMomentsWithTime(f);
    }
    else
    {
      MakeMoments(f);
    }
    if (results == OPACITY)
    {
      MakeShares(f);
    }
    else
    {
      MakeThinShares(f);
    }
  }
  if (results == OPACITY)
  {
    MakeOpacities(f);
  }
  else
  {
    MakeDepths(f);
  }
}

//------------------------------------------------------------------------------
void vtkFragmentIntegration::IntegratePieces(
  vtkFragments& f, const vtkTransferPieces& pieces, bool hasDeltaT, Results results)
{
  const vtkSegmentTable& table = vtkSegmentTable::Get();
  const std::vector<vtkTransferPieces::Piece>& all = pieces.GetPieces();
  for (int i = 0; i < f.Size; ++i)
  {
    const float first = f.Scalar[0][i];
    const float last = f.Scalar[1][i];
    int piece = pieces.Find(first);
    const int end = pieces.Find(last);
    if (piece == end || f.Length[i] <= 0.0f)
    {
      continue;
    }
    const int step = last > first ? 1 : -1;
    std::array<float, 3> color{ { 0.0f, 0.0f, 0.0f } };
    float depth = 0.0f;
    float from = 0.0f;
    float value = first;
    while (true)
    {
      // To the end of this piece, or of the segment.
      const float bound = all[step > 0 ? piece + 1 : piece].Start;
      const float to = piece == end ? 1.0f : std::min((bound - first) / (last - first), 1.0f);
      const float next = piece == end ? last : bound;
      const vtkTransferPieces::Sample front = pieces.Evaluate(piece, value);
      const vtkTransferPieces::Sample back = pieces.Evaluate(piece, next);
      Moments m = GetMoments(front[3], back[3]);
      if (hasDeltaT)
      {
        const float rise = f.DeltaT[1][i] - f.DeltaT[0][i];
        m = GetMoments(front[3], back[3], f.DeltaT[0][i] + from * rise, f.DeltaT[0][i] + to * rise);
      }
      const float part = std::max(to - from, 0.0f) * f.Length[i] * m.Mean;
      float frontWeight;
      float weight = part;
      if (results == OPACITY)
      {
        weight = OpacityOf(part) * ExpOfMinus(depth);
        frontWeight = weight * table.GetFrontShare(std::min(part, 1e7f), m.Delta);
      }
      else
      {
        frontWeight = weight * (0.5f - m.Delta * (1.0f / 6.0f));
      }
      for (int c = 0; c < 3; ++c)
      {
        color[c] += frontWeight * front[c] + (weight - frontWeight) * back[c];
      }
      depth += part;
      if (piece == end)
      {
        break;
      }
      from = to;
      value = next;
      piece += step;
    }
    f.Color[0][i] = { { color[0], color[1], color[2], 0.0f } };
    f.Weight[0][i] = 1.0f;
    f.Weight[1][i] = 0.0f;
    f.Total[i] = results == OPACITY ? ExpOfMinus(depth) : depth;
  }
}
