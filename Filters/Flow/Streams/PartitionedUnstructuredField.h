// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartitionedUnstructuredField_h
#define interlume_PartitionedUnstructuredField_h

#include "Fields/BoundaryPatches.h"
#include "Fields/FieldPartition.h"
#include "Fields/UnstructuredFlowField.h"
#include "Fields/UnstructuredWalker.h"
#include "Streams/PartitionedInterfaces.h"
#include "Streams/ProcessBounds.h"
#include "Streams/DistributedField.h"

#include <memory>
#include <vector>

namespace interlume
{

/**
 * @class   PartitionedUnstructuredField
 * @brief   partition of a field on an unstructured grid
 *
 * The process holds only its own cells. Cells are numbered as in the whole grid: first the cells of
 * process 0, then the cells of process 1, and so on. Links to cells of other processes are found by
 * comparing the corners of boundary faces (PartitionBoundaryFaces). A link contains all that is
 * necessary to enter the linked cell: its number, its shape and the relative orientation of the
 * faces. Cells are searched as on structured grids (PartitionedCellSearch).
 */
class PartitionedUnstructuredField : public UnstructuredFlowField
{
public:
  static constexpr bool IsSearched = true;

  /// Builds the field of this process's cells. Links and the cell tree are undefined until Join is
  /// called, and speeds until SetSpeeds is called.
  Error BuildPart(vtkUnstructuredGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays, const FieldPartition& part);

  /// Builds the cell tree and finds the links. Call it after BuildPart has succeeded in all
  /// processes. Collective. Returns an error if no process has three-dimensional cells.
  Error Join(RankExchange& exchange);

  /// Counts the speeds at points such that all processes together count each point once.
  SpeedCount CountOwnSpeeds() const;
  using FlowField::SetSpeeds;

  /// Finds the patches of the whole grid's boundary, which are the domain faces. Collective.
  void FindPatches(RankExchange& exchange);
  /// Returns the patches, or null before FindPatches.
  const BoundaryPatches* GetPatches() const { return this->Patches.get(); }

  /// Returns the nonconforming interfaces of the whole grid, and whether one is between two
  /// processes.
  const PartitionedInterfaces& GetInterfaces() const { return this->Interfaces; }
  /// Returns the result of PartitionBoundaryFaces::GetMatchGaps() for this process.
  const FaceLinks::MatchGaps& GetMatchGaps() const { return this->Gaps; }

  /// Calls visit(rank) for each process whose cells may contain x.
  template <typename Visit>
  void ForEachRankAt(const double x[3], Visit&& visit) const
  {
    this->Boxes.ForEachAt(x, 0.0, visit);
  }
  int FindRank(const DistributedField& ranks, vtkIdType cell) const { return ranks.FindRank(cell); }

  ///@{
  /// These members hide those of UnstructuredFlowField. Locations contain cell numbers of the whole
  /// grid. GetHeldCellLocation takes the cell number in this partition.
  CellLocation GetCellLocation(vtkIdType cell) const
  {
    return this->GetHeldCellLocation(cell - this->First);
  }
  CellLocation GetHeldCellLocation(vtkIdType cell) const
  {
    CellLocation location = UnstructuredFlowField::GetCellLocation(cell);
    location.Cell += this->First;
    return location;
  }
  bool IsHere(const CellLocation& location) const
  {
    return location.Cell >= this->First && location.Cell < this->End;
  }
  void Prefetch(const CellLocation& location, int face, int round) const
  {
    const vtkIdType link = this->GetLink(location.Cell - this->First, face);
    if (link >= 0)
    {
      this->PrefetchCell(UnstructuredFlowField::GetCellLocation(link >> 6), round);
    }
  }
  bool Cross(CellLocation& location, int face, double p[3]) const
  {
    const vtkIdType link = this->GetLink(location.Cell - this->First, face);
    if (link >= 0)
    {
      this->CrossTo(this->GetHeldCellLocation(link >> 6), link, location, face, p);
    }
    else if (link < -1)
    {
      const RemoteCell& remote = this->RemoteCells[static_cast<std::size_t>(-2 - link)];
      this->CrossTo(remote.Cell, remote.Link, location, face, p);
    }
    return link != -1;
  }
  ///@}

private:
  /// Number and type of a cell of another process, and the link to the cell.
  struct RemoteCell
  {
    CellLocation Cell;
    vtkIdType Link;
  };

  std::vector<vtkIdType> GetGlobalOuterFaces() const;
  std::vector<vtkIdType> GetPointsOfFaces(const std::vector<vtkIdType>& faces) const;
  void FindRemoteLinks(
    const std::vector<vtkIdType>& faces, MeshLinks& mesh, RankExchange& exchange);

  vtkIdType First = 0;
  vtkIdType End = 0;
  ProcessBounds Boxes;
  // A link below -1 refers to the element with index -2 - link.
  std::vector<RemoteCell> RemoteCells;
  FaceLinks::MatchGaps Gaps;
  PartitionedInterfaces Interfaces;
  // Points of boundary faces that a process of lower rank also has.
  std::vector<vtkIdType> Repeated;
  std::unique_ptr<BoundaryPatches> Patches;
};

/**
 * @class   UnstructuredPartWalker
 * @brief   walker of a partition of an unstructured grid that uses the patches of the field
 */
class UnstructuredPartWalker : public UnstructuredWalkerOf<PartitionedUnstructuredField>
{
public:
  explicit UnstructuredPartWalker(const PartitionedUnstructuredField* field)
    : UnstructuredWalkerOf(field)
  {
    this->SetPatches(field->GetPatches());
  }
};

}

#endif
