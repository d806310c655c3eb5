// SPDX-License-Identifier: BSD-3-Clause
#include "Software/FragmentBlending.h"

#include "Common/SimdDispatch.h"
#include "Software/SurfaceFragments.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
using Pixel = FragmentBlending::Pixel;

// Calls blend(pixel, i, color) for each segment i. Channels 0 to 2 of the color are the weighted
// RGB, and channel 3 is the segment's Total.
template <typename Blend>
void ForEachColor(
  const Fragments& f, const TetrahedraFrame& frame, Pixel* pixels, const Blend& blend)
{
  const TetrahedraFields& fields = *frame.Fields;
  for (int run = 0; run < f.NumberOfRuns; ++run)
  {
    const Fragments::Run& r = f.Runs[run];
    Pixel* pixel = pixels + r.Pixel;
    if (fields.Kind == TetrahedraFields::SCALARS)
    {
      const PiecewiseLinearTransferFunction::Piece* pieces = frame.Pieces->GetPieces().data();
      for (int i = r.Begin; i < r.End; ++i, ++pixel)
      {
        const int piece = f.Pieces[0][i];
        Pixel color;
        if (piece >= 0)
        {
          for (int c = 0; c < 4; ++c)
          {
            color[c] =
              f.Weight[0][i] * pieces[piece].Value[c] + f.Weight[1][i] * pieces[piece].Slope[c];
          }
        }
        else
        {
          color = f.SplitColors[-1 - piece];
        }
        color[3] = f.Total[i];
        blend(*pixel, i, color);
      }
    }
    else if (fields.Kind == TetrahedraFields::POINT_COLORS)
    {
      for (int i = r.Begin; i < r.End; ++i, ++pixel)
      {
        Pixel color;
        for (int c = 0; c < 4; ++c)
        {
          color[c] = f.Weight[0][i] * f.Colors[0][i][c] + f.Weight[1][i] * f.Colors[1][i][c];
        }
        color[3] = f.Total[i];
        blend(*pixel, i, color);
      }
    }
    else
    {
      const Pixel& cell = fields.Colors[r.Tetrahedron];
      for (int i = r.Begin; i < r.End; ++i, ++pixel)
      {
        const float weight = f.Weight[0][i] + f.Weight[1][i];
        Pixel color;
        for (int c = 0; c < 4; ++c)
        {
          color[c] = weight * cell[c];
        }
        color[3] = f.Total[i];
        blend(*pixel, i, color);
      }
    }
  }
}

void CompositeColors(const Fragments& f, const TetrahedraFrame& frame, Pixel* pixels)
{
  SimdDispatch::CallFused(
    [](const Fragments& f, const TetrahedraFrame& frame, Pixel* pixels)
    {
      ForEachColor(f, frame, pixels,
        [](Pixel& pixel, int, const Pixel& color)
        { FragmentBlending::CompositeBehind(pixel, color); });
    },
    f, frame, pixels);
}

void SumColors(const Fragments& f, const TetrahedraFrame& frame, Pixel* pixels)
{
  SimdDispatch::CallFused(
    [](const Fragments& f, const TetrahedraFrame& frame, Pixel* pixels)
    {
      ForEachColor(f, frame, pixels,
        [](Pixel& pixel, int, const Pixel& color)
        {
          for (int c = 0; c < 4; ++c)
          {
            pixel[c] += color[c];
          }
        });
    },
    f, frame, pixels);
}
}

void FragmentBlending::Composite(const Fragments& f, const TetrahedraFrame& frame, Pixel* pixels)
{
  CompositeColors(f, frame, pixels);
}

void FragmentBlending::CompositeWithSurface(
  const Fragments& f, const TetrahedraFrame& frame, const SurfaceFragments& surface, Pixel* pixels)
{
  ForEachColor(f, frame, pixels,
    [&](Pixel& pixel, int i, const Pixel& color)
    {
      CompositeBehind(pixel, surface.GetFront(i));
      CompositeBehind(pixel, color);
      CompositeBehind(pixel, surface.GetBack(i));
    });
}

void FragmentBlending::Sum(const Fragments& f, const TetrahedraFrame& frame, Pixel* pixels)
{
  SumColors(f, frame, pixels);
}

void FragmentBlending::UpdateMaximumScalar(const Fragments& f, Pixel* pixels)
{
  ForEachSegment(f,
    [&f, pixels](int pixel, int i, const Fragments::Run&)
    {
      float& maximum = pixels[pixel][0];
      maximum = std::max({ maximum, f.Scalar[0][i], f.Scalar[1][i] });
    });
}

void FragmentBlending::UpdateMaximumColor(
  const Fragments& f, const TetrahedraFields& fields, float unit, Pixel* pixels)
{
  const bool hasCellColors = fields.Kind == TetrahedraFields::CELL_COLORS;
  ForEachSegment(f,
    [&](int pixel, int i, const Fragments::Run& run)
    {
      for (int end = 0; end < 2; ++end)
      {
        const Pixel& color = hasCellColors ? fields.Colors[run.Tetrahedron] : f.Colors[end][i];
        const float opacity = std::min(color[3] * unit, 1.0f);
        Pixel& maximum = pixels[pixel];
        for (int c = 0; c < 3; ++c)
        {
          maximum[c] = std::max(maximum[c], color[c] * opacity);
        }
        maximum[3] = std::max(maximum[3], opacity);
      }
    });
}

FragmentBlending::Pixel FragmentBlending::Resolve(const Pixel& sum)
{
  if (!(sum[3] > 0.0f))
  {
    return { { 0.0f, 0.0f, 0.0f, 0.0f } };
  }
  const float opacity = -std::expm1(-sum[3]);
  const float scale = opacity / sum[3];
  return { { sum[0] * scale, sum[1] * scale, sum[2] * scale, opacity } };
}

FragmentBlending::Pixel FragmentBlending::Finish(const Pixel& sum, const TetrahedraFrame& frame)
{
  switch (frame.Blend)
  {
    case TetrahedraFrame::ADDITIVE:
    {
      Pixel pixel = sum;
      for (float& channel : pixel)
      {
        channel = std::min(channel, 1.0f);
      }
      return pixel;
    }
    case TetrahedraFrame::OPTICAL_DEPTH:
      return Resolve(sum);
    case TetrahedraFrame::MAXIMUM:
    {
      if (frame.Fields->Kind != TetrahedraFields::SCALARS)
      {
        return sum;
      }
      if (sum[0] < 0.0f)
      {
        return { { 0.0f, 0.0f, 0.0f, 0.0f } };
      }
      const float value = std::min(sum[0], 1.0f);
      const PiecewiseLinearTransferFunction& pieces = *frame.Pieces;
      const PiecewiseLinearTransferFunction::Sample sample =
        pieces.Evaluate(pieces.Find(value), value);
      const float opacity = std::min(sample[3] / static_cast<float>(frame.ExtinctionUnit), 1.0f);
      return { { sample[0] * opacity, sample[1] * opacity, sample[2] * opacity, opacity } };
    }
    default:
      return sum;
  }
}

}
