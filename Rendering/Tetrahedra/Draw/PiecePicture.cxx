// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/PiecePicture.h"

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

PiecePicture::PiecePicture(const PieceExchange& exchange, const TetrahedraFrame* frame,
  std::size_t pixels, SoftwareRasterizer& rasterizer)
  : Exchange(exchange)
  , Frame(frame)
  , Pixels(pixels)
  , Rasterizer(rasterizer)
{
}

std::vector<float> PiecePicture::Draw(
  Blends blend, const std::map<int, double>& priorities, const std::vector<int>& order)
{
  switch (blend)
  {
    case Blends::COMPOSITE:
      return this->DrawOrdered(order);
    case Blends::MAXIMUM:
      return this->DrawLargest();
    case Blends::PRIORITY:
      return this->DrawLayers(priorities);
    default:
      return this->DrawSum(blend, nullptr);
  }
}

std::vector<float> PiecePicture::DrawPiece(
  Blends blend, const std::vector<std::uint32_t>* tetrahedra)
{
  if (!this->Frame || (tetrahedra && tetrahedra->empty()))
  {
    return std::vector<float>(4 * this->Pixels, 0.0f);
  }
  TetrahedraFrame frame = *this->Frame;
  frame.Blend = blend;
  frame.IsSum = true;
  frame.Order = tetrahedra ? tetrahedra : frame.Order;
  this->Rasterizer.Draw(frame, []() { return false; });
  return this->Rasterizer.GetColors();
}

std::vector<float> PiecePicture::DrawSum(Blends blend, const std::vector<std::uint32_t>* tetrahedra)
{
  std::vector<float> colors = this->DrawPiece(blend, tetrahedra);
  this->Exchange.Add(colors);
  TetrahedraFrame frame;
  frame.Blend = blend;
  for (std::size_t p = 0; p < this->Pixels; ++p)
  {
    Set(colors, p, FragmentBlending::Finish(Get(colors, p), frame));
  }
  return colors;
}

std::vector<float> PiecePicture::DrawOrdered(const std::vector<int>& order)
{
  std::vector<float> colors = this->DrawPiece(Blends::COMPOSITE, nullptr);
  this->Exchange.Composite(colors, order);
  return colors;
}

std::vector<float> PiecePicture::DrawLargest()
{
  const bool isOfScalars = this->Frame && this->Frame->Fields->Kind == TetrahedraFields::SCALARS;
  std::vector<int> isAnyOfScalars{ isOfScalars ? 1 : 0 };
  this->Exchange.Maximize(isAnyOfScalars);
  std::vector<float> colors = this->DrawPiece(Blends::MAXIMUM, nullptr);
  if (isAnyOfScalars[0] != 0)
  {
    // Scalars are 0 to 1 over the own piece's range. The process with the largest has its colour.
    constexpr float none = std::numeric_limits<float>::lowest();
    std::vector<float> own(this->Pixels, none);
    for (std::size_t p = 0; isOfScalars && p < this->Pixels; ++p)
    {
      const double* range = this->Frame->Fields->Range;
      const double scalar = colors[4 * p];
      own[p] = scalar >= 0.0 ? static_cast<float>(range[0] + scalar * (range[1] - range[0])) : none;
    }
    std::vector<float> largest = own;
    this->Exchange.Maximize(largest);
    for (std::size_t p = 0; p < this->Pixels; ++p)
    {
      const bool isOwn = own[p] > none && own[p] == largest[p];
      Set(colors, p, isOwn ? FragmentBlending::Finish(Get(colors, p), *this->Frame) : Pixel{});
    }
  }
  this->Exchange.Maximize(colors);
  return colors;
}

std::vector<float> PiecePicture::DrawLayers(const std::map<int, double>& priorities)
{
  std::map<int, std::vector<std::uint32_t>> members;
  if (this->Frame)
  {
    for (const std::uint32_t tetrahedron : *this->Frame->Order)
    {
      members[this->Frame->Fields->Layers[tetrahedron]].push_back(tetrahedron);
    }
  }
  std::vector<int> names;
  names.reserve(members.size());
  for (const auto& layer : members)
  {
    names.push_back(layer.first);
  }
  names = this->Exchange.Unite(names);
  TetrahedraOrder::SortLayers(names, priorities);
  std::vector<float> colors(4 * this->Pixels, 0.0f);
  for (const int name : names)
  {
    const std::vector<float> layer = this->DrawSum(Blends::OPTICAL_DEPTH, &members[name]);
    for (std::size_t p = 0; p < this->Pixels; ++p)
    {
      Pixel pixel = Get(colors, p);
      FragmentBlending::LayBehind(pixel, Get(layer, p));
      Set(colors, p, pixel);
    }
  }
  return colors;
}

std::vector<bool> PiecePicture::FindShown(const PieceExchange& exchange, std::vector<float>& depths)
{
  const std::vector<float> own = depths;
  exchange.Minimize(depths);
  std::vector<int> ranks(depths.size());
  for (std::size_t p = 0; p < depths.size(); ++p)
  {
    ranks[p] = own[p] == depths[p] ? exchange.GetRank() : exchange.GetNumberOfRanks();
  }
  exchange.Minimize(ranks);
  std::vector<bool> isShown(depths.size());
  for (std::size_t p = 0; p < depths.size(); ++p)
  {
    isShown[p] = ranks[p] == exchange.GetRank();
  }
  return isShown;
}

}
