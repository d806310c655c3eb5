// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RankField_h
#define interlume_RankField_h

#include "Fields/FieldPart.h"
#include "Streams/RankExchange.h"

#include "vtkDataSet.h" // for smart pointers to it
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkMultiProcessController;

namespace interlume
{

/**
 * @class   RankField
 * @brief   a field on any grid, in parts that processes hold
 *
 * Of an image, a rectilinear or a structured grid the cells of the whole extent are split as VTK
 * splits extents in blocks. A process holds its own cells and one layer of cells around them, as a
 * piece with one ghost level. Of an unstructured grid it holds what its source gives as the
 * process's piece, without duplicates of other pieces' cells, and cells are numbered piece after
 * piece.
 */
class RankField
{
public:
  using Extent = std::array<int, 6>;

  /// Splits an extent of points between the processes of \a controller; null for an unstructured
  /// grid.
  RankField(vtkMultiProcessController* controller, const int* whole);

  /// Returns the extent that this process has to hold; an empty one where no cell is its own.
  Extent GetHeld() const;
  /// Returns whether no cell is this process's own.
  bool IsEmpty() const;
  /// Returns the process whose own a cell is, by its index in the whole grid.
  int FindRank(const int cell[3]) const;
  /// Returns the same of a cell of an unstructured grid, by its number.
  int FindRank(vtkIdType cell) const;

  /// Takes the data of this process, which are at least those of GetHeld, without the marks of what
  /// is beyond its own cells. Points are counted as far as it matters: whether they are more than
  /// \a few. \a isOfBlocks: the data are merged blocks, an unstructured grid that nobody else has,
  /// and get the first process's values where several have a point. Collective. Returns an
  /// error if the data of any process cannot be used, the same in all processes.
  Error SetData(vtkDataSet* data, vtkIdType few, bool isOfBlocks = false);

  ///@{
  /// The error if the data show that the field cannot be in parts. It is the same in all processes.
  const Error& GetPartitionError() const { return this->PartitionError; }
  void SetPartitionError(const Error& error) { this->PartitionError = error; }
  ///@}

  vtkDataSet* GetData() const { return this->Data; }
  /// Returns the whole grid, without arrays. That of a structured grid is a rectilinear one with
  /// its bounds, and as many points; that of an unstructured grid has two points, at the ends of
  /// its bounds.
  vtkDataSet* GetWhole() const { return this->Whole; }
  /// Returns the number of cells of the whole.
  vtkIdType GetNumberOfCells() const;
  /// Returns the number of points of the whole as SetData counts them, points that unstructured
  /// grids of several processes share once.
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  const FieldPart& GetPart() const { return this->Part; }
  RankExchange& GetExchange() { return this->Exchange; }

private:
  Error CheckData(vtkDataSet* data) const;
  Error MakeImage(vtkDataSet* data);
  void MakeRectilinearGrid(vtkDataSet* data);
  void MakeStructuredGrid(vtkDataSet* data);
  void MakeUnstructuredGrid(vtkIdType few);
  Error FindPartitionError();
  /// Returns an error if the blocks of processes cannot be one grid.
  Error UniteBlocks();
  /// Returns the bounds of the data of all processes.
  std::array<double, 6> FindBounds();

  RankExchange Exchange;
  Extent WholeExtent;
  /// The extents of points of the processes' own cells.
  std::vector<Extent> Own;
  /// The first cell of each process in an unstructured grid, and the number of all; else empty.
  std::vector<vtkIdType> FirstCells;
  vtkIdType NumberOfPoints = 0;
  Error PartitionError;
  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkDataSet> Whole;
  FieldPart Part;
};

}

#endif
