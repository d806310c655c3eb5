// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionContext_h
#define interlume_ExtractionContext_h

#include "Output/ExtractionReport.h"
#include "Common/Batches.h"
#include "Common/Blanking.h"
#include "Output/ExtractionBuffer.h"
#include "Output/ExtractionPoint.h"
#include "Output/SimplexList.h"
#include "Output/ThreadGrain.h"
#include "Scalars/ExtractionScalars.h"
#include "Scalars/ExtractionValues.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace interlume
{

class ExtractionIndex;
class PointArrays;
class InteriorCellFilter;

/**
 * Result of an extraction before arrays are interpolated.
 */
struct ExtractionMesh
{
  ExtractionBuffer<ExtractionPoint> Points;
  /// Tetrahedra or triangles, in the order of the input cells, followed by the interior cells in
  /// the same order.
  SimplexList Simplices;
  vtkNew<vtkIntArray> ItemIds;
  /// Input cell of each simplex and interior cell; empty unless the input has cell arrays.
  ExtractionBuffer<vtkIdType> CellIds;
  /// Cell type of each interior cell.
  ExtractionBuffer<unsigned char> InteriorCellTypes;

  /// Boundary triangles of intervals, if requested. If the simplices are triangles, these are
  /// lines, whose third point is one of the first two.
  std::vector<std::array<vtkIdType, 3>> Triangles;
  vtkNew<vtkIntArray> TriangleItemIds;
  vtkNew<vtkIntArray> TriangleSides;
  std::vector<vtkIdType> TriangleCellIds;
  /// Indices, in increasing order, of the boundary triangles of cells where values equal a bound.
  /// These triangles may cancel each other, or bound a region of zero volume.
  std::vector<vtkIdType> TiedTriangles;
  /// Indices of flat tetrahedra, or of contour triangles, in a face of an input cell where values
  /// equal a bound.
  std::vector<vtkIdType> TiedSimplices;
  /// For each boundary triangle, the interior cell that has it as a face, or -1. Interior cells are
  /// numbered after the simplices. Empty if no triangle is a face of an interior cell.
  std::vector<vtkIdType> TriangleInteriorCells;

  /// If true, there are several items. If false, Allocate() sets all item ids to 0.
  bool HasSeveralItems = false;

  /// Allocates simplices with \a size points each, \a points points, and \a interiorCells interior
  /// cells with \a interiorIds point ids in total. \a triangles is 0 if no boundary is requested.
  void Allocate(vtkIdType points, vtkIdType simplices, int size, vtkIdType triangles,
    bool keepCellIds, vtkIdType interiorCells = 0, vtkIdType interiorIds = 0)
  {
    if (this->BeforeAllocation)
    {
      this->BeforeAllocation(points, simplices, interiorCells);
    }
    this->Simplices.Allocate(simplices, size, points, interiorCells, interiorIds);
    const vtkIdType cells = simplices + interiorCells;
    OutputAllocation::SetNumberOfTuples(this->ItemIds, cells);
    if (!this->HasSeveralItems)
    {
      int* const items = this->ItemIds->GetPointer(0);
      vtkSMPTools::For(0, cells, ThreadGrain,
        [items](vtkIdType first, vtkIdType last) { std::fill(items + first, items + last, 0); });
    }
    if (interiorCells > 0)
    {
      this->InteriorCellTypes.Allocate(interiorCells);
    }
    this->Triangles.resize(triangles);
    this->TriangleItemIds->SetNumberOfValues(triangles);
    this->TriangleSides->SetNumberOfValues(triangles);
    if (keepCellIds)
    {
      this->CellIds.Allocate(cells);
      this->TriangleCellIds.resize(triangles);
    }
  }

  /// Records the item and the input cell of \a number simplices, starting at index \a first.
  void SetSimplexOrigins(vtkIdType first, std::size_t number, int item, vtkIdType cell)
  {
    this->SetRunOrigins(first, number, 1, item, cell);
  }

  /// Same as SetSimplexOrigins(), but for \a cells successive input cells, starting at \a cell,
  /// with \a number simplices each.
  void SetRunOrigins(vtkIdType first, std::size_t number, vtkIdType cells, int item, vtkIdType cell)
  {
    const vtkIdType step = static_cast<vtkIdType>(number);
    if (this->HasSeveralItems)
    {
      std::fill_n(this->ItemIds->GetPointer(first), step * cells, item);
    }
    for (vtkIdType c = 0; this->CellIds.GetSize() > 0 && c < cells; ++c)
    {
      std::fill_n(this->CellIds.GetData() + first + step * c, step, cell + c);
    }
  }

  /// Writes an interior cell, with index \a whole among the interior cells. Its point ids start at
  /// \a position in the ids of all interior cells.
  void WriteInteriorCell(vtkIdType whole, vtkIdType position, unsigned char type,
    const vtkIdType* ids, int number, int item, vtkIdType cell)
  {
    this->Simplices.WriteInteriorCell(whole, position, ids, number);
    this->InteriorCellTypes[whole] = type;
    this->SetSimplexOrigins(this->Simplices.GetNumber() + whole, 1, item, cell);
  }

  /// Removes all but the first \a number simplices and moves the interior cells after them.
  void TruncateSimplices(vtkIdType number)
  {
    const vtkIdType before = this->Simplices.GetNumber();
    const vtkIdType whole = this->Simplices.GetNumberOfInteriorCells();
    std::copy_n(
      this->ItemIds->GetPointer(0) + before, whole, this->ItemIds->GetPointer(0) + number);
    OutputAllocation::Shorten(this->ItemIds, number + whole);
    if (this->CellIds.GetSize() > 0)
    {
      std::copy_n(this->CellIds.GetData() + before, whole, this->CellIds.GetData() + number);
      this->CellIds.Truncate(number + whole);
    }
    this->Simplices.Truncate(number);
  }

  /// Writes a boundary triangle. \a ids are ordered outward if the input cell is right-handed;
  /// \a isInverted is true if it is left-handed.
  void WriteTriangle(vtkIdType triangle, const std::array<vtkIdType, 3>& ids, bool isInverted,
    int item, int side, vtkIdType cell)
  {
    this->Triangles[triangle] =
      isInverted ? std::array<vtkIdType, 3>{ { ids[1], ids[0], ids[2] } } : ids;
    this->TriangleItemIds->SetValue(triangle, item);
    this->TriangleSides->SetValue(triangle, side);
    if (!this->TriangleCellIds.empty())
    {
      this->TriangleCellIds[triangle] = cell;
    }
  }

  /// A mark per point, set if an output cell uses it; empty if all points are used. The points of
  /// tied simplices are marked after opposite pairs have been found.
  ExtractionBuffer<std::atomic<unsigned char>> Used;

  /// Receives the number of points, simplices and interior cells before they are allocated. May be
  /// empty.
  std::function<void(vtkIdType points, vtkIdType simplices, vtkIdType interiorCells)>
    BeforeAllocation;
};

/**
 * @class   ExtractionContext
 * @brief   input and settings shared by all parts of one extraction
 */
struct ExtractionContext : Blanking
{
  vtkAlgorithm* Owner = nullptr;
  const ExtractionValues* Values = nullptr;
  vtkDataSet* Input = nullptr;
  vtkDataArray* Scalars = nullptr;
  /// A mark per point, set if a coordinate is NaN or infinite; null if all coordinates are finite.
  const unsigned char* NonFinitePoints = nullptr;
  ExtractionIndex* Index = nullptr;
  /// Selects interior cells; null if interior cells are cut too.
  const InteriorCellFilter* InteriorFilter = nullptr;
  /// If triangles share no points, their corners are stored here instead of in the mesh; otherwise
  /// null.
  PointArrays* Unshared = nullptr;
  /// If ExtractionMesh::Points is not needed, the points are stored here instead; otherwise null.
  PointArrays* Arrays = nullptr;
  /// Dimension of the cells that are extracted, 2 or 3. Other cells are skipped.
  int Dimension = 3;
  /// If true, another extraction processes the two- or three-dimensional cells.
  bool IsMixed = false;
  bool GenerateBoundaries = false;
  bool KeepCellIds = false;
  /// If true, cells keep their stored orientation. Otherwise the orientation is computed from the
  /// coordinates. A previous extraction may produce inverted tetrahedra, and sums of signed volumes
  /// are correct only if these remain inverted. Two-dimensional cells have no other orientation.
  bool KeepOrientation = false;
  /// If true, ghost cells are extracted too (see GhostCells).
  bool IncludeGhostCells = false;
  ExtractionReport* Report = nullptr;

  /// Returns true if a cell is skipped because of its ghost flags.
  bool IsCellSkipped(vtkIdType cell) const
  {
    return this->IncludeGhostCells ? this->IsCellHidden(cell) : this->IsCellBlanked(cell);
  }

  std::unique_ptr<ExtractionScalars> MakeScalars() const
  {
    return ExtractionScalars::Make(this->Scalars, *this->Values, this->NonFinitePoints);
  }

  int GetSimplexSize() const
  {
    return this->Dimension + (this->Values->GetKind() == vtkIsotable::INTERVAL ? 1 : 0);
  }

  /**
   * Runs \a work(first, last) over [0, number) in parallel, in a few batches. Updates the progress,
   * from \a from to \a to, after each batch. Returns false if the user aborted.
   */
  template <typename Work>
  bool Run(vtkIdType number, double from, double to, Work&& work) const
  {
    // An extraction has many short passes over few rows. Each batch starts the threads again, which
    // takes longer than processing a few cells.
    constexpr vtkIdType maximumBatches = 8;
    constexpr vtkIdType cellsInBatch = 16384;
    const vtkIdType batches =
      this->Input ? this->Input->GetNumberOfCells() / cellsInBatch + 1 : maximumBatches;
    return Batches::Run(number, this->Owner, from, to, work, std::min(batches, maximumBatches));
  }

  /// Raises the reported peak of the working memory to \a bytes, unless it is already higher.
  void UpdatePeakWorkingBytes(std::size_t bytes) const
  {
    this->Report->WorkingBytes =
      std::max(this->Report->WorkingBytes, static_cast<vtkIdType>(bytes));
  }
};

}

#endif
