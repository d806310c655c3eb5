// SPDX-License-Identifier: BSD-3-Clause
#include "Software/TileRasterizer.h"

#include "Common/Prefetch.h"
#include "Common/SimdDispatch.h"
#include "Software/FragmentBlending.h"
#include "Software/FragmentRow.h"
#include "View/SilhouetteRows.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace interlume
{

namespace
{
using Pixel = TileRasterizer::Pixel;
using Blends = TetrahedraFrame::Blends;

/// A pixel with at least this opacity hides everything behind it.
constexpr float OPAQUE_ENOUGH = 1.0f - 1e-5f;
/// Number of flushes after which to test again whether the tile is opaque.
constexpr int CHECK_INTERVAL = 16;
/// A range of pixels in a row, from Begin to End - 1.
struct Span
{
  int Begin;
  int End;
};

/// If edge functions or the crease have a slope per pixel larger than this, single precision along
/// a row cannot resolve where they cross 0 and 1.
constexpr double STEEP = 100.0;

bool IsSteep(const TetrahedronSilhouette& shape)
{
  double steepest = std::abs(shape.GetCrease().X);
  for (int e = 0; e < 4; ++e)
  {
    steepest = std::max(steepest, std::abs(shape.GetEdge(e).X));
  }
  return steepest > STEEP;
}

// Returns true if a steep edge function or a steep crease has a value in or near [0, 1] at a pixel
// center of a row. (dx, dy) is the row's start relative to the thick point.
bool HasSteepPixel(const TetrahedronSilhouette& shape, double dx, double dy, int size)
{
  const auto isPassed = [&](const TetrahedronSilhouette::Slope& slope, double atThick)
  {
    if (!(std::abs(slope.X) > STEEP))
    {
      return false;
    }
    const double value = atThick + slope.X * dx + slope.Y * dy;
    const double nearest = std::round(-value / slope.X);
    // The rounding error in a row is about 1e-7 of the largest value in it.
    const double rounding = 1e-6 * size * std::abs(slope.X);
    return nearest > -1.0 && nearest < size && std::abs(value + nearest * slope.X) < 2.0 + rounding;
  };
  bool isAny = isPassed(shape.GetCrease(), 0.0);
  for (int e = 0; e < 4; ++e)
  {
    isAny = isAny || isPassed(shape.GetEdge(e), 1.0);
  }
  return isAny;
}
}

TileRasterizer::TileRasterizer(const TetrahedraFrame& frame, const TileBins& bins)
  : Frame(frame)
  , Bins(bins)
  , Pixels(SIZE * SIZE)
  , Slant(SIZE * SIZE + interlume::Fragments::GROUP)
{
  const TetrahedraFields& fields = *frame.Fields;
  this->Channels.HasScalars = fields.Kind == TetrahedraFields::SCALARS;
  this->Channels.HasColors = fields.Kind == TetrahedraFields::POINT_COLORS;
  this->Channels.HasDeltaT = !fields.DeltaT.empty();
  if (frame.Blend == Blends::PRIORITY)
  {
    this->Layer.resize(SIZE * SIZE);
  }
  if (frame.Opaque)
  {
    this->Opaque.resize(SIZE * SIZE);
  }
  if (frame.Surface)
  {
    this->Surface = std::make_unique<SurfaceFragments>(frame, bins);
  }
  if (frame.IsSelection)
  {
    this->Seen = std::make_unique<SeenTetrahedra>(frame, SIZE * SIZE);
  }
}

void TileRasterizer::Draw(int tile)
{
  this->Begin(tile);
  const auto draw = [this, tile](auto hasScalars, auto hasColors, auto hasDeltaT)
  {
    SimdDispatch::CallFused(
      [](TileRasterizer& rasterizer, int at)
      {
        rasterizer.DrawTetrahedra<decltype(hasScalars)::value, decltype(hasColors)::value,
          decltype(hasDeltaT)::value>(at);
      },
      *this, tile);
  };
  const auto drawFields = [this, &draw](auto hasScalars, auto hasColors)
  {
    this->Channels.HasDeltaT ? draw(hasScalars, hasColors, std::true_type())
                             : draw(hasScalars, hasColors, std::false_type());
  };
  if (this->Channels.HasScalars)
  {
    drawFields(std::true_type(), std::false_type());
  }
  else if (this->Channels.HasColors)
  {
    drawFields(std::false_type(), std::true_type());
  }
  else
  {
    drawFields(std::false_type(), std::false_type());
  }
  this->Finish();
}

void TileRasterizer::Begin(int tile)
{
  const TetrahedraView& view = this->Frame.View;
  this->Left = SIZE * (tile % this->Bins.GetColumns());
  this->Bottom = SIZE * (tile / this->Bins.GetColumns());
  this->Width = std::min(SIZE, view.GetWidth() - this->Left);
  this->Height = std::min(SIZE, view.GetHeight() - this->Bottom);
  Pixel empty{ { 0.0f, 0.0f, 0.0f, 0.0f } };
  if (this->Frame.Blend == Blends::MAXIMUM && this->Channels.HasScalars)
  {
    empty[0] = -1.0f;
  }
  std::fill(this->Pixels.begin(), this->Pixels.end(), empty);
  std::fill(this->Layer.begin(), this->Layer.end(), Pixel{ { 0.0f, 0.0f, 0.0f, 0.0f } });
  if (this->Seen)
  {
    this->Seen->Clear();
  }
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      const int column = this->Left + x;
      const int row = this->Bottom + y;
      this->Slant[y * SIZE + x] =
        static_cast<float>(view.GetViewRayLengthRatio(column + 0.5, row + 0.5));
      if (this->Frame.Opaque)
      {
        this->Opaque[y * SIZE + x] =
          this->Frame.Opaque[static_cast<std::size_t>(row) * view.GetWidth() + column];
      }
    }
  }
}

template <bool Scalars, bool Colors, bool DeltaT>
void TileRasterizer::DrawTetrahedra(int tile)
{
  const std::vector<int>& layers = this->Frame.Fields->Layers;
  const bool isLayered = this->Frame.Blend == Blends::PRIORITY;
  const bool canEnd = this->Frame.Blend == Blends::COMPOSITE && !this->Seen;
  int flushes = 0;
  const std::uint32_t* end = this->Bins.End(tile);
  for (const std::uint32_t* t = this->Bins.Begin(tile); t != end; ++t)
  {
    if (isLayered && t != this->Bins.Begin(tile) && layers[*t] != layers[*(t - 1)])
    {
      this->ResolveLayer();
    }
    this->FetchAhead(t, end);
    const int before = this->Fragments.Size;
    this->DrawTetrahedron<Scalars, Colors, DeltaT>(*t);
    if (canEnd && this->Fragments.Size < before && ++flushes % CHECK_INTERVAL == 0 &&
      this->IsOpaque())
    {
      this->Fragments.Size = 0;
      this->Fragments.NumberOfRuns = 0;
      return;
    }
  }
}

void TileRasterizer::FetchAhead(const std::uint32_t* t, const std::uint32_t* end) const
{
  // In visibility order, corners and points are scattered in memory, so prefetch them.
  constexpr int cornersAhead = 8;
  constexpr int pointsAhead = 4;
  if (end - t > cornersAhead)
  {
    Prefetch::Read(this->Frame.Mesh->GetCorners(t[cornersAhead]));
    const std::uint32_t* corners = this->Frame.Mesh->GetCorners(t[pointsAhead]);
    for (int k = 0; k < 4; ++k)
    {
      Prefetch::Read(this->Bins.GetPoints() + corners[k]);
    }
  }
}

template <bool Scalars, bool Colors, bool DeltaT>
void TileRasterizer::DrawTetrahedron(std::uint32_t tetrahedron)
{
  const std::uint32_t* corners = this->Frame.Mesh->GetCorners(tetrahedron);
  const TileBins::Point* points = this->Bins.GetPoints();
  const std::array<const TileBins::Point*, 4> p = { { points + corners[0], points + corners[1],
    points + corners[2], points + corners[3] } };
  TetrahedronSilhouette shape;
  if (!shape.Set(p[0]->Position, p[1]->Position, p[2]->Position, p[3]->Position))
  {
    return;
  }
  const SilhouetteRows rows(shape);
  const int bottom = rows.GetBegin(this->Bottom);
  const int top = rows.GetEnd(this->Bottom, this->Height);
  std::array<Span, SIZE> spans;
  int pixels = 0;
  for (int y = bottom; y < top; ++y)
  {
    Span& span = spans[y];
    rows.GetSpan(this->Bottom + y + 0.5, this->Left, this->Width, span.Begin, span.End);
    pixels += std::max(span.End - span.Begin, 0);
  }
  if (pixels == 0)
  {
    return;
  }
  shape.SetSlopes();
  const bool isParallel = this->Frame.View.IsParallel();
  const auto getValue = [&](auto&& get)
  {
    std::array<double, 4> v;
    for (int k = 0; k < 4; ++k)
    {
      v[k] = isParallel ? get(k) : get(k) * p[k]->Position.Depth;
    }
    return shape.GetValue(v);
  };

  // The channels are depth, then the attributes.
  constexpr int channels = 1 + (Scalars ? 1 : 0) + (DeltaT ? 1 : 0) + (Colors ? 4 : 0);
  std::array<TetrahedronSilhouette::Value, channels> values;
  values[0] = shape.GetValue(
    { { p[0]->Position.Depth, p[1]->Position.Depth, p[2]->Position.Depth, p[3]->Position.Depth } });
  int channel = 1;
  if (Scalars)
  {
    values[channel++] = getValue([&p](int k) { return p[k]->Scalar; });
  }
  if (DeltaT)
  {
    values[channel++] = getValue([&p](int k) { return p[k]->DeltaT; });
  }
  for (int c = 0; Colors && c < 4; ++c)
  {
    const auto& colors = this->Frame.Fields->Colors;
    values[channel++] = getValue([&](int k) { return colors[corners[k]][c]; });
  }
  // The closer side has the larger depth.
  const int base = values[0].Difference > 0.0 ? 1 : 0;
  FragmentRow row;
  row.Thickness = static_cast<float>(std::abs(values[0].Difference));
  interlume::Fragments& f = this->Fragments;
  // These values are the same in all rows.
  for (int c = 0; c < channels; ++c)
  {
    row.Slopes[c] = static_cast<float>(values[c].Base.X);
    row.Bends[c] = static_cast<float>(values[c].Bend);
    row.Differences[c] = static_cast<float>(values[c].Difference);
  }
  for (int e = 0; e < 4; ++e)
  {
    row.EdgeSlopes[e] = static_cast<float>(shape.GetEdge(e).X);
  }
  const TetrahedronSilhouette::Slope crease = shape.GetCrease();
  row.CreaseSlope = static_cast<float>(crease.X);
  const auto setEnds = [&row, base](int c, interlume::Fragments::Values* ends)
  {
    row.Base[c] = ends[base].data();
    row.Other[c] = ends[1 - base].data();
  };
  setEnds(0, f.Depth);
  if (Scalars)
  {
    setEnds(1, f.Scalar);
  }
  if (DeltaT)
  {
    setEnds(Scalars ? 2 : 1, f.DeltaT);
  }

  const bool isSteep = IsSteep(shape);
  for (int y = bottom; y < top; ++y)
  {
    const double center = this->Bottom + y + 0.5;
    const int begin = spans[y].Begin;
    const int end = spans[y].End;
    if (begin >= end)
    {
      continue;
    }
    const double dy = center - shape.GetThickY();
    // If single precision is insufficient, start a row at each pixel, because the start values are
    // computed in double precision.
    const bool isPerPixel = isSteep &&
      HasSteepPixel(shape, this->Left + begin + 0.5 - shape.GetThickX(), dy, end - begin);
    const int size = isPerPixel ? 1 : end - begin;
    for (int first = begin; first < end; first += size)
    {
      if (f.Size + size > interlume::Fragments::CAPACITY ||
        f.NumberOfRuns == interlume::Fragments::CAPACITY)
      {
        this->Flush();
      }
      const double dx = this->Left + first + 0.5 - shape.GetThickX();
      for (int e = 0; e < 4; ++e)
      {
        const TetrahedronSilhouette::Slope& edge = shape.GetEdge(e);
        row.EdgeValues[e] = static_cast<float>(1.0 + edge.X * dx + edge.Y * dy);
      }
      row.Crease = static_cast<float>(crease.X * dx + crease.Y * dy);
      for (int c = 0; c < channels; ++c)
      {
        const TetrahedronSilhouette::Value& value = values[c];
        row.Values[c] = static_cast<float>(value.At + value.Base.X * dx + value.Base.Y * dy);
      }
      row.Slants = &this->Slant[y * SIZE + first];
      constexpr int withoutColors = channels - (Colors ? 4 : 0);
      row.Write(f, withoutColors, size);
      if (Colors)
      {
        row.WriteColors(f, withoutColors, base, size);
      }
      f.Runs[f.NumberOfRuns++] = { tetrahedron, static_cast<std::uint16_t>(y * SIZE + first),
        static_cast<std::uint16_t>(f.Size), static_cast<std::uint16_t>(f.Size + size) };
      f.Size += size;
    }
  }
}

void TileRasterizer::Flush()
{
  interlume::Fragments& f = this->Fragments;
  const TetrahedraView& view = this->Frame.View;
  if (!view.IsParallel())
  {
    FragmentIntegration::ApplyPerspectiveDivision(f, this->Channels);
  }
  if (this->Frame.Opaque)
  {
    FragmentIntegration::CutAtOpaqueSurfaces(
      f, this->Channels, view.IsParallel(), this->Opaque.data());
  }
  this->IntegrateAndBlend();
  f.Size = 0;
  f.NumberOfRuns = 0;
}

void TileRasterizer::IntegrateAndBlend()
{
  interlume::Fragments& f = this->Fragments;
  const TetrahedraFields& fields = *this->Frame.Fields;
  const Blends blend = this->Frame.Blend;
  if (blend == Blends::MAXIMUM && this->Channels.HasScalars)
  {
    this->Seen ? this->Seen->AddMaximum(f, f.Scalar)
               : FragmentBlending::UpdateMaximumScalar(f, this->Pixels.data());
    return;
  }
  if (blend == Blends::MAXIMUM && !this->Seen)
  {
    FragmentBlending::UpdateMaximumColor(
      f, fields, static_cast<float>(1.0 / this->Frame.ExtinctionUnit), this->Pixels.data());
    return;
  }
  if (this->Channels.HasScalars)
  {
    FragmentIntegration::LookUpExtinction(f, *this->Frame.Pieces);
  }
  else if (this->Channels.HasColors)
  {
    FragmentIntegration::SetExtinction(f);
  }
  else
  {
    FragmentIntegration::SetExtinction(f, fields.Colors.data());
  }
  if (blend == Blends::MAXIMUM)
  {
    this->Seen->AddMaximum(f, f.Extinction);
    return;
  }
  const bool isDepth = this->Seen || blend == Blends::PRIORITY || blend == Blends::OPTICAL_DEPTH;
  const auto results = isDepth ? FragmentIntegration::OPTICAL_DEPTH : FragmentIntegration::OPACITY;
  const bool hasDeltaT = this->Channels.HasDeltaT;
  FragmentIntegration::Integrate(f, hasDeltaT, this->Frame.IsExact, results);
  if (this->Channels.HasScalars)
  {
    FragmentIntegration::ConvertToPieceWeights(
      f, *this->Frame.Pieces, hasDeltaT, this->Frame.IsExact, results);
  }
  if (this->Surface)
  {
    this->Surface->Compute(
      f, this->Left, this->Bottom, this->Frame.Opaque ? this->Opaque.data() : nullptr);
  }
  if (this->Seen)
  {
    this->Seen->Add(f, this->Surface.get());
    return;
  }
  switch (blend)
  {
    case Blends::COMPOSITE:
      if (this->Surface)
      {
        FragmentBlending::CompositeWithSurface(f, this->Frame, *this->Surface, this->Pixels.data());
      }
      else
      {
        FragmentBlending::Composite(f, this->Frame, this->Pixels.data());
      }
      break;
    case Blends::ADDITIVE:
    case Blends::OPTICAL_DEPTH:
      FragmentBlending::Sum(f, this->Frame, this->Pixels.data());
      break;
    default:
      FragmentBlending::Sum(f, this->Frame, this->Layer.data());
  }
}

bool TileRasterizer::IsOpaque() const
{
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      if (this->Pixels[y * SIZE + x][3] < OPAQUE_ENOUGH)
      {
        return false;
      }
    }
  }
  return true;
}

void TileRasterizer::ResolveLayer()
{
  this->Flush();
  if (this->Seen)
  {
    this->Seen->BeginLayer();
    return;
  }
  for (int i = 0; i < SIZE * SIZE; ++i)
  {
    FragmentBlending::CompositeBehind(this->Pixels[i], FragmentBlending::Resolve(this->Layer[i]));
    this->Layer[i] = { { 0.0f, 0.0f, 0.0f, 0.0f } };
  }
}

void TileRasterizer::Finish()
{
  if (this->Frame.Blend == Blends::PRIORITY)
  {
    this->ResolveLayer();
  }
  else
  {
    this->Flush();
  }
  if (this->Seen)
  {
    this->Seen->Find();
    return;
  }
  if (this->Frame.IsSum)
  {
    return;
  }
  for (Pixel& pixel : this->Pixels)
  {
    pixel = FragmentBlending::Finish(pixel, this->Frame);
  }
}

}
