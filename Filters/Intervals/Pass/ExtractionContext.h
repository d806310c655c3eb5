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
#include <memory>
#include <vector>

namespace interlume
{

class ExtractionIndex;
class PointArrays;
class WholeCells;

/**
 * The result of an extraction before arrays are interpolated.
 */
struct ExtractionMesh
{
  ExtractionBuffer<ExtractionPoint> Points;
  /// The tetrahedra of intervals or triangles of contours, in the order of the input's cells; then
  /// the cells that are passed on whole, in the same order.
  SimplexList Simplices;
  vtkNew<vtkIntArray> ItemIds;
  /// The input cell of each simplex and whole cell; empty unless the input has cell arrays.
  ExtractionBuffer<vtkIdType> CellIds;
  /// The type of each whole cell.
  ExtractionBuffer<unsigned char> WholeTypes;

  /// The boundary triangles of intervals, when asked for.
  std::vector<std::array<vtkIdType, 3>> Triangles;
  vtkNew<vtkIntArray> TriangleItemIds;
  vtkNew<vtkIntArray> TriangleSides;
  std::vector<vtkIdType> TriangleCellIds;
  /// The triangles of cells where values equal a bound, increasing: they may cancel each other, or
  /// be on a part that has no volume.
  std::vector<vtkIdType> TiedTriangles;
  /// The tetrahedra, or triangles of contours, that lie in one face of such a cell.
  std::vector<vtkIdType> TiedSimplices;
  /// For each triangle the whole cell that it is a face of, by its place after the simplices, or
  /// -1; empty where no triangle is one.
  std::vector<vtkIdType> TriangleWholes;

  /// Whether simplices differ in their item; with one item they are all noted at once.
  bool HasSeveralItems = false;

  /// Makes room for simplices of \a size of \a points points, for \a wholeCells cells with \a
  /// wholeIds points in all and, without boundaries, 0 triangles.
  void Allocate(vtkIdType points, vtkIdType simplices, int size, vtkIdType triangles,
    bool keepCellIds, vtkIdType wholeCells = 0, vtkIdType wholeIds = 0)
  {
    this->Simplices.Allocate(simplices, size, points, wholeCells, wholeIds);
    const vtkIdType cells = simplices + wholeCells;
    ExtractionMemory::SetNumberOfTuples(this->ItemIds, cells);
    if (!this->HasSeveralItems)
    {
      int* const items = this->ItemIds->GetPointer(0);
      vtkSMPTools::For(0, cells, ThreadGrain,
        [items](vtkIdType first, vtkIdType last) { std::fill(items + first, items + last, 0); });
    }
    if (wholeCells > 0)
    {
      this->WholeTypes.Allocate(wholeCells);
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

  /// Writes what all simplices of one case have in common.
  void NoteSimplices(vtkIdType first, std::size_t number, int item, vtkIdType cell)
  {
    this->NoteRun(first, number, 1, item, cell);
  }

  /// Writes what the simplices of each of \a cells cells from \a cell on have in common, \a number
  /// a cell.
  void NoteRun(vtkIdType first, std::size_t number, vtkIdType cells, int item, vtkIdType cell)
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

  /// Writes a whole cell, whose ids begin at \a place.
  void WriteWhole(vtkIdType whole, vtkIdType place, unsigned char type, const vtkIdType* ids,
    int number, int item, vtkIdType cell)
  {
    this->Simplices.WriteWhole(whole, place, ids, number);
    this->WholeTypes[whole] = type;
    this->NoteSimplices(this->Simplices.GetNumber() + whole, 1, item, cell);
  }

  /// Forgets all but the first \a number simplices; the whole cells follow these.
  void TruncateSimplices(vtkIdType number)
  {
    const vtkIdType before = this->Simplices.GetNumber();
    const vtkIdType whole = this->Simplices.GetNumberOfWhole();
    std::copy_n(
      this->ItemIds->GetPointer(0) + before, whole, this->ItemIds->GetPointer(0) + number);
    ExtractionMemory::Shorten(this->ItemIds, number + whole);
    if (this->CellIds.GetSize() > 0)
    {
      std::copy_n(this->CellIds.GetData() + before, whole, this->CellIds.GetData() + number);
      this->CellIds.Truncate(number + whole);
    }
    this->Simplices.Truncate(number);
  }

  /// Writes a boundary triangle; its ids are in the order for a right-handed cell.
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

  /// A mark for each point, set where a simplex uses it; only where there may be other points.
  /// Where there are marks before tied simplices have been compared, these have not set theirs.
  ExtractionBuffer<std::atomic<unsigned char>> Used;
};

/**
 * @class   ExtractionContext
 * @brief   the input and settings that every part of one extraction needs
 */
struct ExtractionContext : Blanking
{
  vtkAlgorithm* Owner = nullptr;
  const ExtractionValues* Values = nullptr;
  vtkDataSet* Input = nullptr;
  vtkDataArray* Scalars = nullptr;
  /// A mark for each point with a NaN or infinite coordinate; null if there is none.
  const unsigned char* NonFinitePoints = nullptr;
  ExtractionIndex* Index = nullptr;
  /// Which cells are passed on whole; null where none are.
  const WholeCells* Whole = nullptr;
  /// Takes the corners of triangles that share no points, in place of the mesh; null where points
  /// are shared.
  PointArrays* Unshared = nullptr;
  /// Takes the points of the mesh, where they can be written without a list of all; null where a
  /// list is needed.
  PointArrays* Arrays = nullptr;
  bool GenerateBoundaries = false;
  bool KeepCellIds = false;
  /// Whether tetrahedra are oriented as their corners are stored, not by their coordinates: those
  /// that an extraction has made may be inverted, and are then parts of sums that have to stay.
  bool KeepOrientation = false;
  /// Whether cells of other pieces are extracted too, see GhostCells.
  bool TakeDuplicates = false;
  ExtractionReport* Report = nullptr;

  /// Returns whether a cell is left out.
  bool IsCellLeftOut(vtkIdType cell) const
  {
    return this->TakeDuplicates ? this->IsCellHidden(cell) : this->IsCellBlanked(cell);
  }

  std::unique_ptr<ExtractionScalars> MakeScalars() const
  {
    return ExtractionScalars::Make(this->Scalars, *this->Values, this->NonFinitePoints);
  }

  int GetSimplexSize() const { return this->Values->GetKind() == vtkIsotable::INTERVAL ? 4 : 3; }

  /**
   * Runs \a work(first, last) over [0, number) on all threads, in a few batches between which
   * progress goes from \a from to \a to. Returns false when the user aborted.
   */
  template <typename Work>
  bool Run(vtkIdType number, double from, double to, Work&& work) const
  {
    // An extraction has many short passes over few rows. Each batch starts the threads anew: few
    // cells are done in less time than that takes.
    constexpr vtkIdType mostBatches = 8;
    constexpr vtkIdType cellsInBatch = 16384;
    const vtkIdType batches =
      this->Input ? this->Input->GetNumberOfCells() / cellsInBatch + 1 : mostBatches;
    return Batches::Run(number, this->Owner, from, to, work, std::min(batches, mostBatches));
  }

  /// Notes that \a bytes of working memory are held at this moment.
  void NoteWorkingBytes(std::size_t bytes) const
  {
    this->Report->WorkingBytes =
      std::max(this->Report->WorkingBytes, static_cast<vtkIdType>(bytes));
  }
};

}

#endif
