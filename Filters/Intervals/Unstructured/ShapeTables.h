// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShapeTables_h
#define interlume_ShapeTables_h

#include "Output/CrossingKey.h"
#include "Scalars/ExtractionValues.h"

#include "vtkIsotable.h"

#include <algorithm>

namespace interlume
{

/**
 * @class   ShapeTables
 * @brief   the tables of all shapes of cells, and which points the slots of a cell are
 */
class ShapeTables
{
public:
  using Item = ExtractionValues::Item;
  using Slot = vtkIsotable::Slot;

  /// The ends of the edge of a slot, and which isovalue crosses it.
  struct SlotEnds
  {
    Slot A;
    Slot B;
    bool IsUpper;
  };

  explicit ShapeTables(vtkIsotable::Kinds kind)
  {
    for (int shape = 0; shape < vtkIsotable::NUMBER_OF_SHAPES; ++shape)
    {
      this->Tables[shape] = &vtkIsotable::Get(kind, static_cast<vtkIsotable::Shapes>(shape));
      const vtkIsotable& table = *this->Tables[shape];
      const int n = table.GetNumberOfVertices();
      const int m = table.GetNumberOfEdges();
      for (int slot = n; slot < n + 2 * m; ++slot)
      {
        const auto& edge = table.GetEdge((slot - n) % m);
        this->Ends[shape][slot] = { edge[0], edge[1], slot >= n + m };
      }
    }
  }

  const vtkIsotable& operator[](vtkIsotable::Shapes shape) const { return *this->Tables[shape]; }

  const SlotEnds& GetEnds(vtkIsotable::Shapes shape, Slot slot) const
  {
    return this->Ends[shape][slot];
  }

  /// Returns the point of a slot, as its owner and its key there; \a ids are those of the corners,
  /// of which there are \a corners.
  CrossingKey GetPoint(vtkIsotable::Shapes shape, const vtkIdType* ids, int corners,
    const Item& item, Slot slot, vtkIdType& owner) const
  {
    if (slot < corners)
    {
      owner = ids[slot];
      return {};
    }
    const SlotEnds& ends = this->Ends[shape][slot];
    const vtkIdType a = ids[ends.A];
    const vtkIdType b = ids[ends.B];
    owner = std::min(a, b);
    return { std::max(a, b), ends.IsUpper ? item.Upper : item.Lower };
  }

private:
  const vtkIsotable* Tables[vtkIsotable::NUMBER_OF_SHAPES];
  SlotEnds Ends[vtkIsotable::NUMBER_OF_SHAPES][vtkIsotable::MaximumNumberOfSlots];
};

}

#endif
