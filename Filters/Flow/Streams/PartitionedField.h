// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartitionedField_h
#define interlume_PartitionedField_h

#include "Fields/FieldPartition.h"
#include "Fields/FlowField.h"
#include "Fields/ImageFlowField.h"
#include "Fields/BoxWalker.h"
#include "Fields/RectilinearFlowField.h"
#include "Streams/DistributedField.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   PartitionedField
 * @brief   partition of a field on an image, rectilinear grid or structured grid
 *
 * Cell numbers, indices and positions are bit-identical to those of the whole grid. Therefore a
 * streamline does not depend on the process that traces it. A walker may be in any cell that the
 * process holds. It may continue only from cells that the process owns (IsHere), because the
 * process also holds all of their neighbors.
 *
 * \a BaseField is ImageFlowField, RectilinearFlowField or StructuredFlowField.
 */
template <typename BaseField>
class PartitionedField : public BaseField
{
public:
  using CellLocation = typename BaseField::CellLocation;
  /// True if finding the cell at a position requires a search. If false, the position determines
  /// the cell index.
  static constexpr bool IsSearched = false;

  /// Builds the field from the data of this process, as BaseField::Build does. Its speeds are
  /// undefined until SetSpeeds is called.
  template <typename Data>
  Error BuildPart(Data* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays,
    const FieldPartition& part)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int whole = part.WholeExtent[2 * axis];
      this->First[axis] = part.Own[2 * axis] - whole;
      this->Last[axis] = part.Own[2 * axis + 1] - whole - 1;
    }
    return BaseField::Build(data, vectors, arrays, {}, &part);
  }
  /// Counts the speeds at points such that all processes together count each point once.
  SpeedCount CountOwnSpeeds() const
  {
    return this->CountLocalSpeeds([this](const int index[3]) { return this->OwnsPoint(index); });
  }
  /// Sets the speeds of the whole field.
  using BaseField::SetSpeeds;

  /// Returns the process that owns a cell.
  int FindRank(const DistributedField& ranks, vtkIdType cell) const
  {
    return ranks.FindRank(this->GetCellLocation(cell).Index);
  }

  /// Returns true if this process owns the cell.
  bool IsHere(const CellLocation& location) const
  {
    bool isHere = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isHere = isHere && location.Index[axis] >= this->First[axis] &&
        location.Index[axis] <= this->Last[axis];
    }
    return isHere;
  }

  /// Moves to the cell on the other side of a face, as Step does, if this process owns that cell.
  bool StepHere(CellLocation& location, int face) const
  {
    CellLocation next = location;
    const bool isThere = this->Step(next, face) && this->IsHere(next);
    location = isThere ? next : location;
    return isThere;
  }

protected:
  /// Returns the indices of the first and last cells that this process owns. If it owns no cells,
  /// the last index is less than the first.
  void GetOwnedCellRange(int first[3], int last[3]) const
  {
    std::copy_n(this->First, 3, first);
    std::copy_n(this->Last, 3, last);
  }

private:
  /// Returns true if this process counts the point. A process counts the points at the lower
  /// corners of its cells and, if its cells reach the upper end of the grid, the points there.
  bool OwnsPoint(const int index[3]) const
  {
    bool isOwn = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int last = this->Last[axis] + (this->Last[axis] == this->Cells[axis] - 1 ? 1 : 0);
      isOwn = isOwn && index[axis] >= this->First[axis] && index[axis] <= last;
    }
    return isOwn;
  }

  // Indices of the first and last cells that this process owns.
  int First[3] = { 0, 0, 0 };
  int Last[3] = { -1, -1, -1 };
};

using ImagePartField = PartitionedField<ImageFlowField>;
using RectilinearPartField = PartitionedField<RectilinearFlowField>;
using ImagePartWalker = BoxWalker<ImagePartField>;
using RectilinearPartWalker = BoxWalker<RectilinearPartField>;

}

#endif
