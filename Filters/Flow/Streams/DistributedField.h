// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DistributedField_h
#define interlume_DistributedField_h

#include "Fields/FieldPartition.h"
#include "Streams/RankExchange.h"

#include "vtkDataSet.h" // for smart pointers to it
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkMultiProcessController;

namespace interlume
{

/**
 * @class   DistributedField
 * @brief   field on a grid of any type that is partitioned among processes
 *
 * For images, rectilinear grids and structured grids, the whole extent is split into blocks, as VTK
 * does for pieces. A process holds its own cells and one layer of cells around them, like a piece
 * with one ghost level. For unstructured grids, a process holds the piece that the upstream filter
 * generates for it, without duplicate cells. Cells are numbered consecutively from piece to piece.
 */
class DistributedField
{
public:
  using Extent = std::array<int, 6>;

  /// Partitions the extent \a whole among the processes of \a controller. \a whole is null for an
  /// unstructured grid.
  DistributedField(vtkMultiProcessController* controller, const int* whole);

  /// Returns the extent that this process must hold. It is empty if the process owns no cells.
  Extent GetHeldExtent() const;
  /// Returns true if this process owns no cells.
  bool IsEmpty() const;
  /// Returns the process that owns the cell with the given (i, j, k) index in the whole grid.
  int FindRank(const int cell[3]) const;
  /// Returns the process that owns a cell of an unstructured grid.
  int FindRank(vtkIdType cell) const;

  /// Sets the data of this process, which must cover GetHeldExtent(). Shared points are identified
  /// only if this is necessary to decide whether the field has more than \a few points. If \a
  /// isOfBlocks is true, the data are merged from this process's blocks of a composite dataset. A
  /// point that several processes share then receives the values of the first process that has it.
  /// Collective. If the data of any process cannot be used, all processes return the same error.
  Error SetData(vtkDataSet* data, vtkIdType few, bool isOfBlocks = false);

  ///@{
  /// Error message if the field cannot be partitioned. It is the same in all processes.
  const Error& GetPartitionError() const { return this->PartitionError; }
  void SetPartitionError(const Error& error) { this->PartitionError = error; }
  ///@}

  vtkDataSet* GetData() const { return this->Data; }
  /// Returns the whole grid without arrays. For a structured grid, this is a rectilinear grid with
  /// the same bounds and number of points. For an unstructured grid, it has only two points, at
  /// opposite corners of the bounds.
  vtkDataSet* GetFullGrid() const { return this->FullGrid; }
  /// Returns the number of cells of the whole grid.
  vtkIdType GetNumberOfCells() const;
  /// Returns the number of points of the whole grid. Shared points count once, unless SetData did
  /// not need to identify them.
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  const FieldPartition& GetPart() const { return this->Part; }
  RankExchange& GetExchange() { return this->Exchange; }

private:
  Error CheckData(vtkDataSet* data) const;
  Error MakeImage(vtkDataSet* data);
  void MakeRectilinearGrid(vtkDataSet* data);
  void MakeStructuredGrid(vtkDataSet* data);
  void MakeUnstructuredGrid(vtkIdType few);
  Error FindPartitionError();
  /// Combines the blocks of all processes. Returns an error if they cannot form one grid.
  Error UniteBlocks();
  /// Returns the bounds of the data of all processes.
  std::array<double, 6> FindBounds();

  RankExchange Exchange;
  Extent WholeExtent;
  /// For each process, the point extent of the cells that it owns.
  std::vector<Extent> Own;
  /// Index of the first cell of each process in an unstructured grid, followed by the total number
  /// of cells. Empty for other grids.
  std::vector<vtkIdType> FirstCells;
  vtkIdType NumberOfPoints = 0;
  Error PartitionError;
  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkDataSet> FullGrid;
  FieldPartition Part;
};

}

#endif
