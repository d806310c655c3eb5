// SPDX-License-Identifier: BSD-3-Clause
#include "Software/SeenTetrahedra.h"

#include "Software/FragmentBlending.h"
#include "Software/SurfaceFragments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace interlume
{

SeenTetrahedra::SeenTetrahedra(const TetrahedraFrame& frame, int pixels)
  : Frame(frame)
  , Pixels(static_cast<std::size_t>(pixels))
{
}

bool SeenTetrahedra::Segment::operator<(const Segment& other) const
{
  return std::tie(this->Layer, other.Depth, this->Tetrahedron) <
    std::tie(other.Layer, this->Depth, other.Tetrahedron);
}

void SeenTetrahedra::Clear()
{
  this->Layer = 0;
  this->Segments.clear();
  this->PixelOfSegment.clear();
  std::fill(this->Pixels.begin(), this->Pixels.end(), Seen());
  if (this->Frame.Blend == TetrahedraFrame::MAXIMUM)
  {
    this->Maxima.assign(this->Pixels.size(), std::numeric_limits<float>::lowest());
  }
}

void SeenTetrahedra::Add(const Fragments& f, const SurfaceFragments* surface)
{
  FragmentBlending::ForEachSegment(f,
    [&](int pixel, int i, const Fragments::Run& run)
    {
      float depth = f.Total[i];
      if (surface)
      {
        depth -= std::log1p(-surface->GetFront(i)[3]) + std::log1p(-surface->GetBack(i)[3]);
      }
      if (depth > 0.0f)
      {
        this->Segments.push_back({ this->Layer, run.Tetrahedron, f.Depth[0][i], depth });
        this->PixelOfSegment.push_back(static_cast<std::uint16_t>(pixel));
      }
    });
}

void SeenTetrahedra::AddMaximum(const Fragments& f, const Fragments::Values* values)
{
  FragmentBlending::ForEachSegment(f,
    [&](int pixel, int i, const Fragments::Run& run)
    {
      const int end = values[1][i] > values[0][i] ? 1 : 0;
      Seen& seen = this->Pixels[pixel];
      float& maximum = this->Maxima[pixel];
      const float value = values[end][i];
      if (value > maximum || (value == maximum && f.Depth[0][i] > seen.Depth))
      {
        maximum = value;
        seen = { run.Tetrahedron + 1, f.Depth[0][i] };
      }
    });
}

bool SeenTetrahedra::IsVisible(float maximum) const
{
  if (this->Frame.Fields->Kind != TetrahedraFields::SCALARS)
  {
    return maximum > 0.0f;
  }
  const PiecewiseLinearTransferFunction& pieces = *this->Frame.Pieces;
  const float scalar = std::min(maximum, 1.0f);
  return pieces.Evaluate(pieces.Find(scalar), scalar)[3] > 0.0f;
}

const SeenTetrahedra::Segment& SeenTetrahedra::FindMedian(Segment* begin, Segment* end)
{
  const auto sum = [](const Segment* from, const Segment* to)
  {
    double depth = 0.0;
    for (; from != to; ++from)
    {
      depth += from->OpticalDepth;
    }
    return depth;
  };
  // Optical depth in front of the position where the opacity is half of the pixel's.
  double target = -std::log1p(0.5 * std::expm1(-sum(begin, end)));
  while (end - begin > 1)
  {
    Segment* middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    const double inFront = sum(begin, middle);
    if (target <= inFront)
    {
      end = middle;
    }
    else
    {
      target -= inFront;
      begin = middle;
    }
  }
  return *begin;
}

void SeenTetrahedra::Find()
{
  for (std::size_t pixel = 0; pixel < this->Maxima.size(); ++pixel)
  {
    Seen& seen = this->Pixels[pixel];
    seen = seen.Tetrahedron > 0 && this->IsVisible(this->Maxima[pixel]) ? seen : Seen();
  }
  if (!this->Maxima.empty())
  {
    return;
  }
  std::vector<std::size_t> ends(this->Pixels.size() + 1, 0);
  for (std::uint16_t pixel : this->PixelOfSegment)
  {
    ++ends[pixel + 1u];
  }
  for (std::size_t pixel = 1; pixel < ends.size(); ++pixel)
  {
    ends[pixel] += ends[pixel - 1];
  }
  // ends[p] is first the beginning of pixel p, then its end.
  this->Sorted.resize(this->Segments.size());
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    this->Sorted[ends[this->PixelOfSegment[i]]++] = this->Segments[i];
  }
  std::size_t begin = 0;
  for (std::size_t pixel = 0; pixel < this->Pixels.size(); ++pixel)
  {
    if (ends[pixel] > begin)
    {
      const Segment& seen = FindMedian(&this->Sorted[begin], this->Sorted.data() + ends[pixel]);
      this->Pixels[pixel] = { seen.Tetrahedron + 1, seen.Depth };
    }
    begin = ends[pixel];
  }
}

}
