// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/PieceImage.h"

#include "Order/TetrahedraOrder.h"
#include "Pieces/PieceExchange.h"
#include "Software/FragmentBlending.h"

#include <algorithm>
#include <limits>

namespace interlume
{

using Blends = TetrahedraFrame::Blends;
using Pixel = FragmentBlending::Pixel;

namespace
{
Pixel Get(const std::vector<float>& colors, std::size_t pixel)
{
  const float* c = &colors[4 * pixel];
  return { { c[0], c[1], c[2], c[3] } };
}

void Set(std::vector<float>& colors, std::size_t pixel, const Pixel& color)
{
  std::copy(color.begin(), color.end(), colors.begin() + static_cast<std::ptrdiff_t>(4 * pixel));
}
}

PieceImage::PieceImage(const PieceExchange& exchange, const TetrahedraFrame* frame,
  std::size_t pixels, SoftwareRasterizer& rasterizer)
  : Exchange(exchange)
  , Frame(frame)
  , Pixels(pixels)
  , Rasterizer(rasterizer)
{
}

std::vector<float> PieceImage::Draw(
  Blends blend, const std::map<int, double>& priorities, const std::vector<int>& order)
{
  switch (blend)
  {
    case Blends::COMPOSITE:
      return this->DrawOrdered(order);
    case Blends::MAXIMUM:
      return this->DrawMaximum();
    case Blends::PRIORITY:
      return this->DrawLayers(priorities);
    default:
      return this->DrawSum(blend, nullptr);
  }
}

std::vector<float> PieceImage::DrawPiece(Blends blend, const std::vector<std::uint32_t>* tetrahedra)
{
  if (!this->Frame || (tetrahedra && tetrahedra->empty()))
  {
    return std::vector<float>(4 * this->Pixels, 0.0f);
  }
  TetrahedraFrame frame = *this->Frame;
  frame.Blend = blend;
  frame.IsSum = true;
  frame.Order = tetrahedra ? tetrahedra : frame.Order;
  this->Rasterizer.Draw(frame);
  return this->Rasterizer.GetColors();
}

std::vector<float> PieceImage::DrawSum(Blends blend, const std::vector<std::uint32_t>* tetrahedra)
{
  std::vector<float> colors = this->DrawPiece(blend, tetrahedra);
  this->Exchange.ReduceSum(colors);
  TetrahedraFrame frame;
  frame.Blend = blend;
  for (std::size_t p = 0; p < this->Pixels; ++p)
  {
    Set(colors, p, FragmentBlending::Finish(Get(colors, p), frame));
  }
  return colors;
}

std::vector<float> PieceImage::DrawOrdered(const std::vector<int>& order)
{
  std::vector<float> colors = this->DrawPiece(Blends::COMPOSITE, nullptr);
  this->Exchange.Composite(colors, order);
  return colors;
}

std::vector<float> PieceImage::DrawMaximum()
{
  const bool hasScalars = this->Frame && this->Frame->Fields->Kind == TetrahedraFields::SCALARS;
  std::vector<int> anyHasScalars{ hasScalars ? 1 : 0 };
  this->Exchange.ReduceMax(anyHasScalars);
  std::vector<float> colors = this->DrawPiece(Blends::MAXIMUM, nullptr);
  if (anyHasScalars[0] != 0)
  {
    // Each partition normalizes scalars to its own range, so compare the original values. The
    // process with the maximum sets the color.
    constexpr float none = std::numeric_limits<float>::lowest();
    std::vector<float> local(this->Pixels, none);
    for (std::size_t p = 0; hasScalars && p < this->Pixels; ++p)
    {
      const double* range = this->Frame->Fields->Range;
      const double scalar = colors[4 * p];
      local[p] =
        scalar >= 0.0 ? static_cast<float>(range[0] + scalar * (range[1] - range[0])) : none;
    }
    std::vector<float> largest = local;
    this->Exchange.ReduceMax(largest);
    for (std::size_t p = 0; p < this->Pixels; ++p)
    {
      const bool isLocal = local[p] > none && local[p] == largest[p];
      Set(colors, p, isLocal ? FragmentBlending::Finish(Get(colors, p), *this->Frame) : Pixel{});
    }
  }
  this->Exchange.ReduceMax(colors);
  return colors;
}

std::vector<float> PieceImage::DrawLayers(const std::map<int, double>& priorities)
{
  std::map<int, std::vector<std::uint32_t>> members;
  if (this->Frame)
  {
    for (const std::uint32_t tetrahedron : *this->Frame->Order)
    {
      members[this->Frame->Fields->Layers[tetrahedron]].push_back(tetrahedron);
    }
  }
  std::vector<int> layerIds;
  layerIds.reserve(members.size());
  for (const auto& layer : members)
  {
    layerIds.push_back(layer.first);
  }
  layerIds = this->Exchange.Unite(layerIds);
  TetrahedraOrder::SortLayers(layerIds, priorities);
  std::vector<float> colors(4 * this->Pixels, 0.0f);
  for (const int layerId : layerIds)
  {
    const std::vector<float> layer = this->DrawSum(Blends::OPTICAL_DEPTH, &members[layerId]);
    for (std::size_t p = 0; p < this->Pixels; ++p)
    {
      Pixel pixel = Get(colors, p);
      FragmentBlending::CompositeBehind(pixel, Get(layer, p));
      Set(colors, p, pixel);
    }
  }
  return colors;
}

std::vector<bool> PieceImage::FindShownPixels(
  const PieceExchange& exchange, std::vector<float>& depths)
{
  const std::vector<float> local = depths;
  exchange.ReduceMin(depths);
  std::vector<int> ranks(depths.size());
  for (std::size_t p = 0; p < depths.size(); ++p)
  {
    ranks[p] = local[p] == depths[p] ? exchange.GetRank() : exchange.GetNumberOfRanks();
  }
  exchange.ReduceMin(ranks);
  std::vector<bool> isShown(depths.size());
  for (std::size_t p = 0; p < depths.size(); ++p)
  {
    isShown[p] = ranks[p] == exchange.GetRank();
  }
  return isShown;
}

}
