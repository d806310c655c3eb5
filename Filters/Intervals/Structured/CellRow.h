// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellRow_h
#define interlume_CellRow_h

#include "Scalars/ExtractionValues.h"

#include "vtkIsotable.h"

namespace interlume
{

/**
 * @class   CellRow
 * @brief   a row of cells and the four rows of grid points around it
 *
 * The rows of grid points are in the order of SlotLocation::Row, and the vertices of a cell are in
 * the order of VTK_VOXEL. The argument \a i of a function is the column of a cell.
 */
struct CellRow
{
  using Code = ExtractionValues::Code;

  /// Output point ids of a slot along the row. For the cell at column i, First + Starts[i] +
  /// Offsets[i] is the id of the first point on the slot's vertex or edge.
  struct SlotRow
  {
    vtkIdType First;
    const std::uint32_t* Starts;
    const Code* Offsets;
  };

  vtkIdType J;
  vtkIdType K;
  /// Ids of the grid point and of the cell at column 0.
  vtkIdType FirstPoint;
  vtkIdType FirstCell;
  const Code* Codes[4];
  /// The point ids of each slot; not set while cells are only counted.
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

  /// Returns the output id of a vertex. The vertex must be an output point.
  vtkIdType GetVertexId(vtkIdType i, int vertex) const
  {
    return this->Slots[vertex].First + this->Slots[vertex].Starts[i];
  }

  /// Returns true if no vertex of a cell has the code \a nonFinite.
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

  /// Returns true if \a ties or the code of a vertex indicates a tie, that is, a scalar equal to an
  /// isovalue.
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
