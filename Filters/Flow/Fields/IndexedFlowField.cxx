// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/IndexedFlowField.h"

#include "vtkDataSet.h"

namespace interlume
{

Error IndexedFlowField::BuildTopologyAndArrays(vtkDataSet* data, const int points[3],
  vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays, const StageProgress& progress,
  const FieldPartition* part)
{
  const bool isEmpty = part && !FieldPartition::HasCells(part->Own);
  if (!isEmpty && (points[0] < 2 || points[1] < 2 || points[2] < 2))
  {
    return GetErrorWithoutCells();
  }
  const vtkIdType number = static_cast<vtkIdType>(points[0]) * points[1] * points[2];
  if (data->GetNumberOfPoints() != number)
  {
    return "the grid has " + std::to_string(data->GetNumberOfPoints()) +
      " points; its dimensions require " + std::to_string(number);
  }
  if (Error error = this->SetArrays(data, vectors, arrays))
  {
    return error;
  }
  this->FirstPoint = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->HeldCells[axis] = points[axis] - 1;
    this->Cells[axis] =
      part ? part->WholeExtent[2 * axis + 1] - part->WholeExtent[2 * axis] : this->HeldCells[axis];
    this->HeldFirst[axis] = part ? part->Held[2 * axis] - part->WholeExtent[2 * axis] : 0;
    if (axis > 0)
    {
      this->CellStrides[axis] = this->CellStrides[axis - 1] * this->Cells[axis - 1];
      this->PointStrides[axis] = this->PointStrides[axis - 1] * points[axis - 1];
    }
    this->FirstPoint -= this->HeldFirst[axis] * this->PointStrides[axis];
  }
  if (part)
  {
    this->SetBounds(part->FullGrid->GetBounds());
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    this->CornerOffsets[corner] = (corner & 1) * this->PointStrides[0] +
      (corner >> 1 & 1) * this->PointStrides[1] + (corner >> 2) * this->PointStrides[2];
  }
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face >> 1;
    const int side = face & 1;
    vtkIdType* offset = this->NeighborOffsets[face];
    for (int corner = 0; corner < 8; ++corner)
    {
      if ((corner >> axis & 1) == side)
      {
        *offset++ = (side ? 1 : -1) * this->PointStrides[axis] + this->CornerOffsets[corner];
      }
    }
  }
  const auto getPoints = [this](vtkIdType cell, vtkIdType* ids)
  { return this->GetLocalCellPoints(cell, ids); };
  this->SetBlanking(data, getPoints);
  if (progress.Reach(0.5) && !part)
  {
    this->Measure(getPoints, false);
  }
  return {};
}

vtkIdType IndexedFlowField::GetLocalCellId(const CellLocation& location) const
{
  const vtkIdType i = location.Index[0] - this->HeldFirst[0];
  const vtkIdType j = location.Index[1] - this->HeldFirst[1];
  const vtkIdType k = location.Index[2] - this->HeldFirst[2];
  return i + this->HeldCells[0] * (j + this->HeldCells[1] * k);
}

int IndexedFlowField::GetLocalCellPoints(vtkIdType cell, vtkIdType* points) const
{
  const vtkIdType row = cell / this->HeldCells[0];
  const vtkIdType first = cell % this->HeldCells[0] +
    row % this->HeldCells[1] * this->PointStrides[1] +
    row / this->HeldCells[1] * this->PointStrides[2];
  for (int corner = 0; corner < 8; ++corner)
  {
    points[corner] = first + this->CornerOffsets[corner];
  }
  return 8;
}

SpeedCount IndexedFlowField::CountLocalSpeeds(
  const std::function<bool(const int index[3])>& isCounted) const
{
  return this->CountSpeeds([this](vtkIdType cell, vtkIdType* points)
    { return this->GetLocalCellPoints(cell, points); },
    false,
    [this, &isCounted](vtkIdType point)
    {
      const vtkIdType layer = point % this->PointStrides[2];
      const int index[3] = { this->HeldFirst[0] + static_cast<int>(layer % this->PointStrides[1]),
        this->HeldFirst[1] + static_cast<int>(layer / this->PointStrides[1]),
        this->HeldFirst[2] + static_cast<int>(point / this->PointStrides[2]) };
      return isCounted(index);
    });
}

bool IndexedFlowField::FindIndex(
  const double q[3], const double slack[3], int index[3], double p[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(q[axis] >= -slack[axis] && q[axis] <= this->Cells[axis] + slack[axis]))
    {
      return false;
    }
    const double inside = std::min(std::max(q[axis], 0.0), static_cast<double>(this->Cells[axis]));
    index[axis] = std::min(static_cast<int>(inside), this->Cells[axis] - 1);
    p[axis] = inside - index[axis];
  }
  return true;
}

bool IndexedFlowField::Find(
  const double q[3], const double slack[3], CellLocation& location, double p[3]) const
{
  int index[3];
  if (!this->FindIndex(q, slack, index, p))
  {
    return false;
  }
  location = this->GetCellLocation(index);
  return this->IsCellIncluded(location.Cell) || this->FindIncludedNeighbor(slack, location, p);
}

bool IndexedFlowField::FindIncludedNeighbor(
  const double slack[3], CellLocation& location, double p[3]) const
{
  // Bit masks of the axes along which to move to the neighbor: one axis first, then two, then
  // three.
  constexpr int combinations[7] = { 1, 2, 4, 3, 5, 6, 7 };
  for (const int axes : combinations)
  {
    int index[3];
    double moved[3];
    bool exists = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = location.Index[axis];
      moved[axis] = p[axis];
      if (axes >> axis & 1)
      {
        const bool isUp = p[axis] > 0.5;
        exists = exists && (isUp ? 1.0 - p[axis] : p[axis]) <= slack[axis];
        index[axis] += isUp ? 1 : -1;
        moved[axis] = isUp ? 0.0 : 1.0;
        exists = exists && index[axis] >= 0 && index[axis] < this->Cells[axis];
      }
    }
    const CellLocation neighbor = exists ? this->GetCellLocation(index) : location;
    if (exists && this->IsCellIncluded(neighbor.Cell))
    {
      location = neighbor;
      std::copy(moved, moved + 3, p);
      return true;
    }
  }
  return false;
}

}
