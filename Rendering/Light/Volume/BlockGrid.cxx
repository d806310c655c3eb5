// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/BlockGrid.h"

#include <algorithm>

namespace interlume
{

BlockGrid::BlockGrid(
  const std::array<std::vector<double>, 3>& borders, const std::vector<unsigned char>& visible)
  : Borders(borders)
  , Visible(visible)
{
}

void BlockGrid::Crop(
  const std::array<std::array<double, 2>, 3>& box, const std::array<double, 3>& margin)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double lower = box[axis][0];
    const double upper = box[axis][1];
    const int blocks = this->GetSize(axis);
    const std::vector<double>& from = this->Borders[axis];
    std::vector<int> layers;
    std::vector<double> borders;
    for (int i = 0; i < blocks; ++i)
    {
      const auto index = static_cast<std::size_t>(i);
      const double start = i == 0 ? lower : std::max(from[index], lower);
      const double end = i == blocks - 1 ? upper : std::min(from[index + 1], upper);
      if (start < end)
      {
        layers.push_back(i);
        borders.push_back(start);
      }
    }
    borders.push_back(upper);
    borders.front() -= margin[axis];
    borders.back() += margin[axis];
    this->Keep(axis, layers, borders);
  }
}

void BlockGrid::Join()
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::vector<int> layers;
    std::vector<double> borders;
    for (int i = 0; i < this->GetSize(axis); ++i)
    {
      if (layers.empty() || !this->AreEqual(axis, layers.back(), i))
      {
        layers.push_back(i);
        borders.push_back(this->Borders[axis][static_cast<std::size_t>(i)]);
      }
    }
    borders.push_back(this->Borders[axis].back());
    this->Keep(axis, layers, borders);
  }
}

bool BlockGrid::IsVisible(const std::array<int, 3>& block) const
{
  const int index = (block[2] * this->GetSize(1) + block[1]) * this->GetSize(0) + block[0];
  return this->Visible[static_cast<std::size_t>(index)] != 0;
}

std::vector<std::array<int, 3>> BlockGrid::GetVisible() const
{
  std::vector<std::array<int, 3>> blocks;
  for (int k = 0; k < this->GetSize(2); ++k)
  {
    for (int j = 0; j < this->GetSize(1); ++j)
    {
      for (int i = 0; i < this->GetSize(0); ++i)
      {
        if (this->IsVisible({ { i, j, k } }))
        {
          blocks.push_back({ { i, j, k } });
        }
      }
    }
  }
  return blocks;
}

bool BlockGrid::AreEqual(std::size_t axis, int layer, int other) const
{
  const std::size_t across = (axis + 1) % 3;
  const std::size_t up = (axis + 2) % 3;
  std::array<int, 3> block{};
  for (block[up] = 0; block[up] < this->GetSize(up); ++block[up])
  {
    for (block[across] = 0; block[across] < this->GetSize(across); ++block[across])
    {
      block[axis] = layer;
      const bool isVisible = this->IsVisible(block);
      block[axis] = other;
      if (this->IsVisible(block) != isVisible)
      {
        return false;
      }
    }
  }
  return true;
}

void BlockGrid::Keep(
  std::size_t axis, const std::vector<int>& layers, const std::vector<double>& borders)
{
  std::vector<unsigned char> retained;
  std::array<int, 3> size;
  for (std::size_t i = 0; i < 3; ++i)
  {
    size[i] = i == axis ? static_cast<int>(layers.size()) : this->GetSize(i);
  }
  std::array<int, 3> block{};
  for (block[2] = 0; block[2] < size[2]; ++block[2])
  {
    for (block[1] = 0; block[1] < size[1]; ++block[1])
    {
      for (block[0] = 0; block[0] < size[0]; ++block[0])
      {
        std::array<int, 3> from = block;
        from[axis] = layers[static_cast<std::size_t>(block[axis])];
        retained.push_back(this->IsVisible(from) ? 1 : 0);
      }
    }
  }
  this->Visible = retained;
  this->Borders[axis] = borders;
}

}
