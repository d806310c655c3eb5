// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellTree.h"

#include "Common/ParallelFor.h"

#include "vtkSMPTools.h"

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <utility>

namespace interlume
{

namespace
{

// Inserts two zero bits after each bit of a number below 2^21.
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x1f00000000ffffULL;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2) & 0x1249249249249249ULL;
}

std::uint64_t GetCode(const double box[6], const double all[6])
{
  constexpr double steps = 2097151.0;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double width = all[2 * axis + 1] - all[2 * axis];
    const double center = 0.5 * box[2 * axis] + 0.5 * box[2 * axis + 1];
    const double part = width > 0.0 ? (center - all[2 * axis]) / width : 0.0;
    const double step = std::min(std::max(part, 0.0), 1.0) * steps;
    code |= Spread(static_cast<std::uint64_t>(step)) << axis;
  }
  return code;
}

}

void CellTree::Box::Clear()
{
  for (int i = 0; i < 6; ++i)
  {
    this->Bounds[i] = i % 2 ? -VTK_DOUBLE_MAX : VTK_DOUBLE_MAX;
  }
}

void CellTree::Box::Add(const double bounds[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Bounds[2 * axis] = std::min(this->Bounds[2 * axis], bounds[2 * axis]);
    this->Bounds[2 * axis + 1] = std::max(this->Bounds[2 * axis + 1], bounds[2 * axis + 1]);
  }
}

void CellTree::Box::Inflate()
{
  double width = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    width = std::max(width, this->Bounds[2 * axis + 1] - this->Bounds[2 * axis]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    double* ends = this->Bounds + 2 * axis;
    const double slack =
      1.01e-6 * width + 64.0 * DBL_EPSILON * std::max(std::abs(ends[0]), std::abs(ends[1]));
    ends[0] -= slack;
    ends[1] += slack;
  }
}

std::uint64_t CellTree::GetOrder(const double box[6]) const
{
  return GetCode(box, this->All.Bounds);
}

void CellTree::Build(vtkIdType numberOfCells, const CellBox& getBox, const Unite& unite)
{
  this->Cells.clear();
  this->Levels.clear();
  // Each task combines the boxes of a block of cells into a separate result, so that threads never
  // wait for each other.
  constexpr vtkIdType part = 4096;
  const vtkIdType parts = (numberOfCells + part - 1) / part;
  std::vector<Box> boxes(numberOfCells);
  std::vector<Box> unions(parts);
  ParallelFor(0, parts,
    [&](vtkIdType i)
    {
      unions[i].Clear();
      for (vtkIdType cell = i * part; cell < std::min((i + 1) * part, numberOfCells); ++cell)
      {
        Box& box = boxes[cell];
        if (!getBox(cell, box.Bounds))
        {
          box.Clear();
        }
        unions[i].Add(box.Bounds);
      }
    });
  this->All.Clear();
  for (const Box& one : unions)
  {
    this->All.Add(one.Bounds);
  }
  if (unite)
  {
    unite(this->All.Bounds);
  }

  constexpr std::uint64_t none = ~std::uint64_t(0);
  std::vector<std::pair<std::uint64_t, vtkIdType>> order(numberOfCells);
  ParallelFor(0, numberOfCells,
    [&](vtkIdType cell)
    {
      const double* box = boxes[cell].Bounds;
      order[cell] = { box[0] <= box[1] ? this->GetOrder(box) : none, cell };
    });
  vtkSMPTools::Sort(order.begin(), order.end());
  while (!order.empty() && order.back().first == none)
  {
    order.pop_back();
  }
  this->Cells.resize(order.size());
  std::transform(order.begin(), order.end(), this->Cells.begin(),
    [](const std::pair<std::uint64_t, vtkIdType>& entry) { return entry.second; });

  const auto addLevel = [this](std::size_t children, int number, auto&& addChild)
  {
    std::vector<Box> level((children + number - 1) / number);
    ParallelFor(0, static_cast<vtkIdType>(level.size()),
      [&](vtkIdType i)
      {
        const std::size_t begin = static_cast<std::size_t>(i) * number;
        level[i].Clear();
        for (std::size_t child = begin; child < std::min(begin + number, children); ++child)
        {
          addChild(child, level[i]);
        }
      });
    this->Levels.push_back(std::move(level));
  };
  if (this->Cells.empty())
  {
    return;
  }
  addLevel(this->Cells.size(), LeafSize,
    [&](std::size_t child, Box& box) { box.Add(boxes[this->Cells[child]].Bounds); });
  for (Box& leaf : this->Levels[0])
  {
    leaf.Inflate();
  }
  while (this->Levels.back().size() > 1)
  {
    const std::vector<Box> children = this->Levels.back();
    addLevel(children.size(), Arity,
      [&](std::size_t child, Box& box) { box.Add(children[child].Bounds); });
  }
}

}
