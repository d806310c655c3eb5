#include "vtkTilePainter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Pixel = vtkTilePainter::Pixel;
using Blends = vtkTetrahedraPicture::Blends;

/// Less of the background than this is not seen.
constexpr float TRANSMITTANCE_END = 1e-5f;
/// Flushes between two looks whether the tile is opaque.
constexpr int LOOK_INTERVAL = 16;

void BlendComposite(const vtkFragments& f, Pixel* pixels)
{
  for (int i = 0; i < f.Size; ++i)
  {
    Pixel& pixel = pixels[f.Pixels[i]];
    const float through = pixel[3];
    const float front = f.Weight[0][i] * through;
    const float back = f.Weight[1][i] * through;
    for (int c = 0; c < 3; ++c)
    {
      pixel[c] += front * f.Color[0][i][c] + back * f.Color[1][i][c];
    }
    pixel[3] = through * f.Total[i];
  }
}

// Sums of weighted colour, and of opacity or optical depth.
void BlendSum(const vtkFragments& f, bool isOpacity, Pixel* pixels)
{
  for (int i = 0; i < f.Size; ++i)
  {
    Pixel& pixel = pixels[f.Pixels[i]];
    for (int c = 0; c < 3; ++c)
    {
      pixel[c] += f.Weight[0][i] * f.Color[0][i][c] + f.Weight[1][i] * f.Color[1][i][c];
    }
    pixel[3] += isOpacity ? 1.0f - f.Total[i] : f.Total[i];
  }
}

// The largest scalar; every tetrahedron has a length, so that an end on the silhouette counts.
void BlendLargestScalar(const vtkFragments& f, Pixel* pixels)
{
  for (int i = 0; i < f.Size; ++i)
  {
    if (f.Length[i] > 0.0f)
    {
      float& largest = pixels[f.Pixels[i]][0];
      largest = std::max({ largest, f.Scalar[0][i], f.Scalar[1][i] });
    }
  }
}

void BlendLargestColor(const vtkFragments& f, float unit, Pixel* pixels)
{
  for (int i = 0; i < f.Size; ++i)
  {
    for (int end = 0; end < 2 && f.Length[i] > 0.0f; ++end)
    {
      Pixel& pixel = pixels[f.Pixels[i]];
      const std::array<float, 4>& color = f.Color[end][i];
      const float opacity = std::min(color[3] * unit, 1.0f);
      for (int c = 0; c < 3; ++c)
      {
        pixel[c] = std::max(pixel[c], color[c] * opacity);
      }
      pixel[3] = std::max(pixel[3], opacity);
    }
  }
}

// Colour times opacity of what was summed up as optical depth.
Pixel Resolve(const Pixel& sum)
{
  if (!(sum[3] > 0.0f))
  {
    return { { 0.0f, 0.0f, 0.0f, 0.0f } };
  }
  const float opacity = -std::expm1(-sum[3]);
  const float scale = opacity / sum[3];
  return { { sum[0] * scale, sum[1] * scale, sum[2] * scale, opacity } };
}
}

//------------------------------------------------------------------------------
vtkTilePainter::vtkTilePainter(const vtkTetrahedraPicture& picture, const vtkTileBins& bins)
  : Picture(picture)
  , Bins(bins)
  , LengthScale(static_cast<float>(picture.TetrahedronStride))
  , Pixels(SIZE * SIZE)
  , Slant(SIZE * SIZE)
{
  const vtkTetrahedraFields& fields = *picture.Fields;
  this->Channels.HasScalars = fields.Kind == vtkTetrahedraFields::SCALARS;
  this->Channels.HasColors = fields.Kind == vtkTetrahedraFields::POINT_COLORS;
  this->Channels.HasDeltaT = !fields.DeltaT.empty();
  if (picture.Blend == Blends::PRIORITY)
  {
    this->Layer.resize(SIZE * SIZE);
  }
  if (picture.Opaque)
  {
    this->Opaque.resize(SIZE * SIZE);
  }
  if (picture.Blend == Blends::SELECTION)
  {
    this->Nearest.resize(SIZE * SIZE);
    this->NearestDepth.resize(SIZE * SIZE);
  }
}

//------------------------------------------------------------------------------
void vtkTilePainter::Draw(int tile)
{
  this->Begin(tile);
  const bool hasDeltaT = this->Channels.HasDeltaT;
  if (this->Channels.HasScalars)
  {
    hasDeltaT ? this->DrawTetrahedra<true, false, true>(tile)
              : this->DrawTetrahedra<true, false, false>(tile);
  }
  else if (this->Channels.HasColors)
  {
    hasDeltaT ? this->DrawTetrahedra<false, true, true>(tile)
              : this->DrawTetrahedra<false, true, false>(tile);
  }
  else
  {
    hasDeltaT ? this->DrawTetrahedra<false, false, true>(tile)
              : this->DrawTetrahedra<false, false, false>(tile);
  }
  this->Finish();
}

//------------------------------------------------------------------------------
void vtkTilePainter::Begin(int tile)
{
  const vtkTetrahedraView& view = this->Picture.View;
  this->Left = SIZE * (tile % this->Bins.GetColumns());
  this->Bottom = SIZE * (tile / this->Bins.GetColumns());
  this->Width = std::min(SIZE, view.GetWidth() - this->Left);
  this->Height = std::min(SIZE, view.GetHeight() - this->Bottom);
  Pixel empty{ { 0.0f, 0.0f, 0.0f, 0.0f } };
  if (this->Picture.Blend == Blends::COMPOSITE || this->Picture.Blend == Blends::PRIORITY)
  {
    empty[3] = 1.0f;
  }
  if (this->Picture.Blend == Blends::MAXIMUM && this->Channels.HasScalars)
  {
    empty[0] = -1.0f;
  }
  std::fill(this->Pixels.begin(), this->Pixels.end(), empty);
  std::fill(this->Layer.begin(), this->Layer.end(), Pixel{ { 0.0f, 0.0f, 0.0f, 0.0f } });
  std::fill(this->Nearest.begin(), this->Nearest.end(), 0u);
  std::fill(this->NearestDepth.begin(), this->NearestDepth.end(),
    std::numeric_limits<float>::lowest());
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      const int column = this->Left + x;
      const int row = this->Bottom + y;
      if (!view.IsParallel())
      {
        this->Slant[y * SIZE + x] =
          this->LengthScale * static_cast<float>(view.GetSlant(column + 0.5, row + 0.5));
      }
      if (this->Picture.Opaque)
      {
        this->Opaque[y * SIZE + x] =
          this->Picture.Opaque[static_cast<std::size_t>(row) * view.GetWidth() + column];
      }
    }
  }
}

//------------------------------------------------------------------------------
template <bool Scalars, bool Colors, bool DeltaT>
void vtkTilePainter::DrawTetrahedra(int tile)
{
  const std::vector<int>& layers = this->Picture.Fields->Layers;
  const bool isLayered = this->Picture.Blend == Blends::PRIORITY;
  const bool canEnd = this->Picture.Blend == Blends::COMPOSITE;
  int flushes = 0;
  const std::uint32_t* end = this->Bins.End(tile);
  for (const std::uint32_t* t = this->Bins.Begin(tile); t != end; ++t)
  {
    if (isLayered && t != this->Bins.Begin(tile) && layers[*t] != layers[*(t - 1)])
    {
      this->ResolveLayer();
    }
    const int before = this->Fragments.Size;
    this->DrawTetrahedron<Scalars, Colors, DeltaT>(*t);
    if (canEnd && this->Fragments.Size < before && ++flushes % LOOK_INTERVAL == 0 &&
      this->IsOpaque())
    {
      this->Fragments.Size = 0;
      return;
    }
  }
}

//------------------------------------------------------------------------------
template <bool Scalars, bool Colors, bool DeltaT>
void vtkTilePainter::DrawTetrahedron(std::uint32_t tetrahedron)
{
  const std::uint32_t* corners = this->Picture.Mesh->GetCorners(tetrahedron);
  const vtkTileBins::Point* points = this->Bins.GetPoints();
  const std::array<const vtkTileBins::Point*, 4> p = { { points + corners[0], points + corners[1],
    points + corners[2], points + corners[3] } };
  vtkTetrahedronSilhouette shape;
  if (!shape.Set(p[0]->Place, p[1]->Place, p[2]->Place, p[3]->Place))
  {
    return;
  }
  using Value = vtkTetrahedronSilhouette::Value;
  const bool isParallel = this->Picture.View.IsParallel();
  const auto weighted = [&](int k, float value)
  { return isParallel ? value : value * p[k]->Place.Depth; };

  // Depth, then what is carried.
  constexpr int CHANNELS = 1 + (Scalars ? 1 : 0) + (DeltaT ? 1 : 0) + (Colors ? 4 : 0);
  std::array<Value, CHANNELS> values;
  values[0] = shape.GetValue(
    { { p[0]->Place.Depth, p[1]->Place.Depth, p[2]->Place.Depth, p[3]->Place.Depth } });
  int channel = 1;
  if (Scalars)
  {
    values[channel++] = shape.GetValue({ { weighted(0, p[0]->Scalar), weighted(1, p[1]->Scalar),
      weighted(2, p[2]->Scalar), weighted(3, p[3]->Scalar) } });
  }
  if (DeltaT)
  {
    values[channel++] = shape.GetValue({ { weighted(0, p[0]->DeltaT), weighted(1, p[1]->DeltaT),
      weighted(2, p[2]->DeltaT), weighted(3, p[3]->DeltaT) } });
  }
  for (int c = 0; Colors && c < 4; ++c)
  {
    const auto& colors = this->Picture.Fields->Colors;
    values[channel++] = shape.GetValue({ { weighted(0, colors[corners[0]][c]),
      weighted(1, colors[corners[1]][c]), weighted(2, colors[corners[2]][c]),
      weighted(3, colors[corners[3]][c]) } });
  }
  // The nearer side has the larger depth.
  const int base = values[0].Difference > 0.0 ? 1 : 0;
  const int other = 1 - base;
  const auto thickness = static_cast<float>(std::abs(values[0].Difference));

  // Rows between the lowest and the highest corner.
  const int edges = shape.GetNumberOfEdges();
  double low = shape.GetPoint(0).Y;
  double high = low;
  for (int i = 1; i < edges; ++i)
  {
    low = std::min(low, shape.GetPoint(i).Y);
    high = std::max(high, shape.GetPoint(i).Y);
  }
  const int firstRow = std::max(0, static_cast<int>(std::ceil(std::max(low - 0.5 - this->Bottom, -1.0))));
  const int lastRow = static_cast<int>(
    std::ceil(std::min(high - 0.5 - this->Bottom, static_cast<double>(this->Height))));
  for (int row = firstRow; row < lastRow; ++row)
  {
    const double y = this->Bottom + row + 0.5;
    double left = std::numeric_limits<double>::max();
    double right = std::numeric_limits<double>::lowest();
    for (int i = 0; i < edges; ++i)
    {
      const Projected* a = &shape.GetPoint(i);
      const Projected* b = &shape.GetPoint((i + 1) % edges);
      if ((a->Y <= y) == (b->Y <= y))
      {
        continue;
      }
      // From the lower end, so that both neighbours of an edge find the same crossing.
      if (b->Y < a->Y)
      {
        std::swap(a, b);
      }
      const double x = a->X + (y - a->Y) * ((b->X - a->X) / (b->Y - a->Y));
      left = std::min(left, x);
      right = std::max(right, x);
    }
    int column =
      std::max(0, static_cast<int>(std::ceil(std::max(left - 0.5 - this->Left, -1.0))));
    const int end = static_cast<int>(
      std::ceil(std::min(right - 0.5 - this->Left, static_cast<double>(this->Width))));
    while (column < end)
    {
      // Up to the crease, then beyond.
      int half = 0;
      int stop = end;
      if (shape.HasCrease())
      {
        const Projected& a = shape.GetPoint(0);
        const Projected& b = shape.GetPoint(2);
        const Projected& inFirst = shape.GetPoint(1);
        const auto side = [&a, &b](double px, double py)
        { return (b.X - a.X) * (py - a.Y) - (b.Y - a.Y) * (px - a.X); };
        const double x = this->Left + column + 0.5;
        const bool isFirst = (side(x, y) > 0.0) == (side(inFirst.X, inFirst.Y) > 0.0);
        half = isFirst ? 0 : 1;
        const double slope = -(b.Y - a.Y);
        const double crossing = x - side(x, y) / slope;
        if (crossing > x && crossing < this->Left + end)
        {
          stop = std::max(column + 1,
            std::min(end, static_cast<int>(std::ceil(crossing - 0.5 - this->Left))));
        }
      }
      if (this->Fragments.Size + stop - column > vtkFragments::CAPACITY)
      {
        this->Flush();
      }
      const double dx = this->Left + column + 0.5 - shape.GetThickX();
      const double dy = y - shape.GetThickY();
      float share[4];
      float shareSlope[4];
      for (int i = 0; i < 4; ++i)
      {
        const bool isEdge = i < edges;
        const vtkTetrahedronSilhouette::Edge edge = shape.GetEdge(isEdge ? i : 0);
        share[i] = static_cast<float>(1.0 + edge.X * dx + edge.Y * dy);
        shareSlope[i] = static_cast<float>(edge.X);
      }
      Line lines[CHANNELS];
      for (int c = 0; c < CHANNELS; ++c)
      {
        const Value& value = values[c];
        lines[c] = { static_cast<float>(value.At + value.X[half] * dx + value.Y[half] * dy),
          static_cast<float>(value.X[half]), static_cast<float>(value.Difference) };
      }
      vtkFragments& f = this->Fragments;
      const int size = stop - column;
      const int at = f.Size;
      const auto pixel = static_cast<std::uint32_t>(row * SIZE + column);
      for (int i = 0; i < size; ++i)
      {
        const auto x = static_cast<float>(i);
        const float lambda =
          std::max(0.0f, std::min(std::min(share[0] + shareSlope[0] * x, share[1] + shareSlope[1] * x),
                           std::min(share[2] + shareSlope[2] * x, share[3] + shareSlope[3] * x)));
        f.Pixels[at + i] = pixel + static_cast<std::uint32_t>(i);
        f.Tetrahedra[at + i] = tetrahedron;
        f.Length[at + i] = lambda * thickness;
        const auto put = [&](int c, float& baseEnd, float& otherEnd)
        {
          const float value = lines[c].At + lines[c].Slope * x;
          baseEnd = value;
          otherEnd = value + lambda * lines[c].Difference;
        };
        put(0, f.Depth[base][at + i], f.Depth[other][at + i]);
        if (Scalars)
        {
          put(1, f.Scalar[base][at + i], f.Scalar[other][at + i]);
        }
        if (DeltaT)
        {
          put(Scalars ? 2 : 1, f.DeltaT[base][at + i], f.DeltaT[other][at + i]);
        }
        for (int c = 0; Colors && c < 4; ++c)
        {
          put(CHANNELS - 4 + c, f.Color[base][at + i][c], f.Color[other][at + i][c]);
        }
      }
      f.Size += size;
      column = stop;
    }
  }
}

//------------------------------------------------------------------------------
void vtkTilePainter::Flush()
{
  vtkFragments& f = this->Fragments;
  const vtkTetrahedraView& view = this->Picture.View;
  if (view.IsParallel())
  {
    vtkFragmentIntegration::FinishParallel(
      f, this->LengthScale * static_cast<float>(view.GetSlant(0.0, 0.0)));
  }
  else
  {
    vtkFragmentIntegration::FinishPerspective(f, this->Channels, this->Slant.data());
  }
  if (this->Picture.Opaque)
  {
    vtkFragmentIntegration::CutAt(f, this->Channels, view.IsParallel(), this->Opaque.data());
  }
  this->IntegrateAndBlend();
  f.Size = 0;
}

//------------------------------------------------------------------------------
void vtkTilePainter::IntegrateAndBlend()
{
  vtkFragments& f = this->Fragments;
  const vtkTetrahedraFields& fields = *this->Picture.Fields;
  const Blends blend = this->Picture.Blend;
  if (blend == Blends::MAXIMUM && this->Channels.HasScalars)
  {
    BlendLargestScalar(f, this->Pixels.data());
    return;
  }
  if (fields.Kind == vtkTetrahedraFields::CELL_COLORS)
  {
    for (int i = 0; i < f.Size; ++i)
    {
      f.Color[0][i] = f.Color[1][i] = fields.Colors[f.Tetrahedra[i]];
    }
  }
  else if (this->Channels.HasScalars)
  {
    vtkFragmentIntegration::LookUp(f, *this->Picture.Pieces);
  }
  if (blend == Blends::MAXIMUM)
  {
    BlendLargestColor(f, static_cast<float>(1.0 / this->Picture.ExtinctionUnit), this->Pixels.data());
    return;
  }
  const bool isDepth = blend == Blends::PRIORITY || blend == Blends::OPTICAL_DEPTH;
  const auto results =
    isDepth ? vtkFragmentIntegration::OPTICAL_DEPTH : vtkFragmentIntegration::OPACITY;
  vtkFragmentIntegration::Integrate(f, this->Channels.HasDeltaT, this->Picture.IsExact, results);
  if (this->Channels.HasScalars && this->Picture.IsExact &&
    this->Picture.Pieces->GetNumberOfPieces() > 1)
  {
    vtkFragmentIntegration::IntegratePieces(
      f, *this->Picture.Pieces, this->Channels.HasDeltaT, results);
  }
  switch (blend)
  {
    case Blends::COMPOSITE:
      BlendComposite(f, this->Pixels.data());
      break;
    case Blends::ADDITIVE:
      BlendSum(f, true, this->Pixels.data());
      break;
    case Blends::PRIORITY:
      BlendSum(f, false, this->Layer.data());
      break;
    case Blends::OPTICAL_DEPTH:
      BlendSum(f, false, this->Pixels.data());
      break;
    default:
      for (int i = 0; i < f.Size; ++i)
      {
        const std::uint32_t pixel = f.Pixels[i];
        if (f.Total[i] < 1.0f && f.Depth[0][i] > this->NearestDepth[pixel])
        {
          this->NearestDepth[pixel] = f.Depth[0][i];
          this->Nearest[pixel] = f.Tetrahedra[i] + 1;
        }
      }
  }
}

//------------------------------------------------------------------------------
bool vtkTilePainter::IsOpaque() const
{
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      if (this->Pixels[y * SIZE + x][3] > TRANSMITTANCE_END)
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTilePainter::ResolveLayer()
{
  this->Flush();
  for (int i = 0; i < SIZE * SIZE; ++i)
  {
    const Pixel layer = Resolve(this->Layer[i]);
    Pixel& pixel = this->Pixels[i];
    for (int c = 0; c < 3; ++c)
    {
      pixel[c] += pixel[3] * layer[c];
    }
    pixel[3] *= 1.0f - layer[3];
    this->Layer[i] = { { 0.0f, 0.0f, 0.0f, 0.0f } };
  }
}

//------------------------------------------------------------------------------
void vtkTilePainter::Finish()
{
  if (this->Picture.Blend == Blends::PRIORITY)
  {
    this->ResolveLayer();
  }
  else
  {
    this->Flush();
  }
  for (Pixel& pixel : this->Pixels)
  {
    switch (this->Picture.Blend)
    {
      case Blends::COMPOSITE:
      case Blends::PRIORITY:
        pixel[3] = 1.0f - pixel[3];
        break;
      case Blends::ADDITIVE:
        for (float& channel : pixel)
        {
          channel = std::min(channel, 1.0f);
        }
        break;
      case Blends::OPTICAL_DEPTH:
        pixel = Resolve(pixel);
        break;
      case Blends::MAXIMUM:
        if (this->Channels.HasScalars)
        {
          const float largest = pixel[0];
          pixel = { { 0.0f, 0.0f, 0.0f, 0.0f } };
          if (largest >= 0.0f)
          {
            const float value = std::min(largest, 1.0f);
            const vtkTransferPieces& pieces = *this->Picture.Pieces;
            const vtkTransferPieces::Sample sample = pieces.Evaluate(pieces.Find(value), value);
            const float opacity =
              std::min(sample[3] / static_cast<float>(this->Picture.ExtinctionUnit), 1.0f);
            pixel = { { sample[0] * opacity, sample[1] * opacity, sample[2] * opacity, opacity } };
          }
        }
        break;
      default:
        break;
    }
  }
}
