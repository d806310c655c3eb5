// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartField_h
#define interlume_PartField_h

#include "Fields/FieldPart.h"
#include "Fields/FlowField.h"
#include "Fields/ImageFlowField.h"
#include "Fields/LatticeWalker.h"
#include "Fields/RectilinearFlowField.h"
#include "Streams/RankField.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   PartField
 * @brief   a field on a grid of rows of which a process holds a part
 *
 * Cells, indices and positions are those of the whole grid, to the last bit, so that a streamline
 * is the same wherever it is followed. A walker may stand in any cell that is held; it is to go on
 * only in cells that are the process's own (IsHere), all of whose neighbours are held.
 *
 * \a Whole is ImageFlowField, RectilinearFlowField, or StructuredFlowField.
 */
template <typename Whole>
class PartField : public Whole
{
public:
  using Place = typename Whole::Place;
  /// Whether cells have to be searched for a position; else it tells their index.
  static constexpr bool IsSearched = false;

  /// Builds the field as Whole does, of the data of \a part. Its speeds are not known before
  /// SetSpeeds.
  template <typename Data>
  Error BuildPart(Data* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays,
    const FieldPart& part)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int whole = part.WholeExtent[2 * axis];
      this->First[axis] = part.Own[2 * axis] - whole;
      this->Last[axis] = part.Own[2 * axis + 1] - whole - 1;
    }
    return Whole::Build(data, vectors, arrays, {}, &part);
  }
  /// Counts the speeds in points such that all processes together count each once.
  SpeedCount CountOwnSpeeds() const
  {
    return this->CountHeldSpeeds([this](const int index[3]) { return this->IsOwn(index); });
  }
  /// Takes the speeds of all parts.
  using Whole::SetSpeeds;

  /// Returns the process whose own a cell is.
  int FindRank(const RankField& ranks, vtkIdType cell) const
  {
    return ranks.FindRank(this->GetPlace(cell).Index);
  }

  /// Returns whether the cell is the process's own.
  bool IsHere(const Place& place) const
  {
    bool isHere = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isHere =
        isHere && place.Index[axis] >= this->First[axis] && place.Index[axis] <= this->Last[axis];
    }
    return isHere;
  }

  /// Goes to the cell beyond a face as Step does, where that is the process's own.
  bool StepHere(Place& place, int face) const
  {
    Place next = place;
    const bool isThere = this->Step(next, face) && this->IsHere(next);
    place = isThere ? next : place;
    return isThere;
  }

protected:
  /// Returns the indices of the first and the last own cell; the last is less without any.
  void GetOwn(int first[3], int last[3]) const
  {
    std::copy_n(this->First, 3, first);
    std::copy_n(this->Last, 3, last);
  }

private:
  /// Returns whether a point counts as one of this process: that of the lower corner of an own
  /// cell, and those at the upper end of the grid.
  bool IsOwn(const int index[3]) const
  {
    bool isOwn = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int last = this->Last[axis] + (this->Last[axis] == this->Cells[axis] - 1 ? 1 : 0);
      isOwn = isOwn && index[axis] >= this->First[axis] && index[axis] <= last;
    }
    return isOwn;
  }

  // The indices of the own cells.
  int First[3] = { 0, 0, 0 };
  int Last[3] = { -1, -1, -1 };
};

using ImagePartField = PartField<ImageFlowField>;
using RectilinearPartField = PartField<RectilinearFlowField>;
using ImagePartWalker = LatticeWalker<ImagePartField>;
using RectilinearPartWalker = LatticeWalker<RectilinearPartField>;

}

#endif
