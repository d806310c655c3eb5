// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellRow_h
#define interlume_CellRow_h

#include "Scalars/ExtractionValues.h"

#include "vtkIsotable.h"

namespace interlume
{

/**
 * @class   CellRow
 * @brief   a row of cells and the rows of grid points around it, in the order of SlotPlace::Row
 *
 * Vertices of a cell are in the order of VTK_VOXEL; \a i is its column.
 */
struct CellRow
{
  using Code = ExtractionValues::Code;

  /// The place where the ids of a slot's points begin, and how they go on along the row.
  struct SlotRow
  {
    vtkIdType First;
    const std::uint32_t* Starts;
    const Code* Offsets;
  };

  vtkIdType J;
  vtkIdType K;
  /// Of the cell at column 0.
  vtkIdType FirstPoint;
  vtkIdType FirstCell;
  const Code* Codes[4];
  /// Not set while cells are only counted.
  SlotRow Slots[vtkIsotable::MaximumNumberOfSlots];
  bool HasTies = false;
  bool IsFinite = true;

  Code GetCode(vtkIdType i, int vertex) const { return this->Codes[vertex >> 1][i + (vertex & 1)]; }

  void GetCodes(vtkIdType i, Code* codes) const
  {
    for (int v = 0; v < 8; ++v)
    {
      codes[v] = this->GetCode(i, v);
    }
  }

  /// Returns the output id of a vertex that is a point of the output.
  vtkIdType GetVertexId(vtkIdType i, int vertex) const
  {
    return this->Slots[vertex].First + this->Slots[vertex].Starts[i];
  }

  /// Returns whether no vertex of a cell has the code \a nonFinite.
  bool IsCellFinite(vtkIdType i, Code nonFinite) const
  {
    for (const Code* codes : this->Codes)
    {
      if (codes[i] == nonFinite || codes[i + 1] == nonFinite)
      {
        return false;
      }
    }
    return true;
  }

  /// Returns whether \a ties or the code of a vertex is one of a tie.
  bool HasTiedPoints(vtkIdType i, Code ties = 0) const
  {
    for (const Code* codes : this->Codes)
    {
      ties |= codes[i] | codes[i + 1];
    }
    return ExtractionValues::IsTie(ties);
  }
};

}

#endif
