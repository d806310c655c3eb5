// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/CornerOrder.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"

#include <algorithm>

namespace interlume
{

CornerOrder::CornerOrder(vtkPointData* points)
{
  vtkIdTypeArray* ids = vtkIdTypeArray::SafeDownCast(points->GetGlobalIds());
  this->GlobalIds = ids ? ids->GetPointer(0) : nullptr;
}

void CornerOrder::Rank(const vtkIdType* ids, int number, vtkIsotable::Slot* ranks) const
{
  std::fill_n(ranks, number, vtkIsotable::Slot(0));
  for (int a = 0; a < number; ++a)
  {
    for (int b = a + 1; b < number; ++b)
    {
      ++ranks[this->IsBefore(ids[b], ids[a]) ? a : b];
    }
  }
}

void CornerOrder::Turn(vtkIsotable::Shapes shape, vtkIdType* ids) const
{
  switch (shape)
  {
    case vtkIsotable::TETRAHEDRON:
      std::sort(ids, ids + 4, [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); });
      break;
    case vtkIsotable::PYRAMID:
      this->TurnPyramid(ids);
      break;
    case vtkIsotable::WEDGE:
      this->TurnWedge(ids);
      break;
    default:
      this->TurnHexahedron(ids);
  }
}

void CornerOrder::TurnPyramid(vtkIdType* ids) const
{
  const auto before = [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); };
  std::rotate(ids, std::min_element(ids, ids + 4, before), ids + 4);
  if (before(ids[3], ids[1]))
  {
    std::swap(ids[1], ids[3]);
  }
}

void CornerOrder::TurnWedge(vtkIdType* ids) const
{
  const auto before = [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); };
  if (std::min_element(ids, ids + 6, before) - ids >= 3)
  {
    std::swap_ranges(ids, ids + 3, ids + 3);
  }
  // Makes the same exchanges in both triangles.
  const auto order = [&](int a, int b)
  {
    if (before(ids[b], ids[a]))
    {
      std::swap(ids[a], ids[b]);
      std::swap(ids[a + 3], ids[b + 3]);
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
}

void CornerOrder::TurnHexahedron(vtkIdType* ids) const
{
  const auto before = [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); };
  const int corner = static_cast<int>(std::min_element(ids, ids + 8, before) - ids);
  int axes[3] = { 1, 2, 4 };
  const auto order = [&](int& a, int& b)
  {
    if (before(ids[corner ^ b], ids[corner ^ a]))
    {
      std::swap(a, b);
    }
  };
  order(axes[0], axes[1]);
  order(axes[1], axes[2]);
  order(axes[0], axes[1]);
  vtkIdType turned[8];
  for (int v = 0; v < 8; ++v)
  {
    turned[v] =
      ids[corner ^ ((v & 1) ? axes[0] : 0) ^ ((v & 2) ? axes[1] : 0) ^ ((v & 4) ? axes[2] : 0)];
  }
  std::copy_n(turned, 8, ids);
}

}
