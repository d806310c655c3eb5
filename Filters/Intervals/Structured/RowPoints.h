// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowPoints_h
#define interlume_RowPoints_h

#include "Grid/GridCellRange.h"
#include "Grid/RowIndex.h"
#include "Pass/ExtractionContext.h"
#include "Scalars/CodeRow.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace interlume
{

/**
 * @class   RowPoints
 * @brief   codes of the grid points, row by row, and the output points that each row owns
 *
 * A grid point owns these output points, in this order: itself, if its value equals an isovalue,
 * and the crossings of its edges along +i, +j and +k. A row owns the points of its grid points, in
 * their order. Therefore the id of an output point is the start position of its row plus its index
 * in the row. The caller computes the start positions from the counts.
 */
class RowPoints
{
public:
  using Code = ExtractionValues::Code;

  /// The columns [First, Last) of a row.
  struct ColumnRange
  {
    std::int64_t First;
    std::int64_t Last;
  };

  /// Indices of the output points owned by each grid point, relative to the first one of the row.
  /// Starts holds the index of the first point owned by a grid point. Adding Offsets[0], [1] or [2]
  /// yields the index of the first point on its edge along i, j or k.
  struct Owners
  {
    vtkIdType Row = -1;
    /// The columns that own points. The arrays are undefined elsewhere.
    ColumnRange Range = { 0, 0 };
    std::vector<std::uint32_t> Starts;
    std::array<std::vector<Code>, 3> Offsets;
    std::vector<Code> Counts;
  };

  /// The buffers of a thread.
  class Local
  {
    friend class RowPoints;

    struct OwnCodeRow : CodeRow
    {
      std::vector<Code> Memory;
    };
    std::array<std::array<OwnCodeRow, 3>, 3> Codes;
    // All rows of two layers if they fit in the CPU cache, otherwise only two rows per layer.
    std::array<std::vector<Owners>, 2> Layers;
    std::vector<ExtractionPoint> Points;
  };

  /// \a context and \a rows must outlive this object. \a rows are the rows of \a window.
  RowPoints(ExtractionContext& context, const RowIndex& rows, const GridCellRange& window);

  /// Computes and caches the codes of all rows. If they need too much memory or few rows are used,
  /// codes are computed on demand instead. Returns false if the user aborted.
  bool MakeCodes();

  /// Returns the codes of the row (j, k) of grid points. The reference remains valid until the
  /// thread requests a row that is three rows away along j or k.
  const CodeRow& GetCodes(Local& local, vtkIdType j, vtkIdType k) const;

  /// Returns the columns of grid points that contain all output of \a rows. On each side of this
  /// range, all codes are equal.
  template <std::size_t Number>
  ColumnRange GetRange(const std::array<const CodeRow*, Number>& rows) const
  {
    const Code front = rows[0]->Codes[0];
    const Code back = rows[0]->Codes[this->Nx - 1];
    bool isFrontEmpty = !this->Values.IsOutputPoint(front);
    bool isBackEmpty = !this->Values.IsOutputPoint(back);
    ColumnRange range{ this->Nx, -1 };
    for (const CodeRow* row : rows)
    {
      isFrontEmpty &= row->Codes[0] == front;
      isBackEmpty &= row->Codes[this->Nx - 1] == back;
      range.First = std::min(range.First, row->First);
      range.Last = std::max(range.Last, row->Last);
    }
    range.First = isFrontEmpty ? range.First - 1 : 0;
    range.Last = isBackEmpty ? std::min<std::int64_t>(range.Last + 2, this->Nx) : this->Nx;
    return range.First < range.Last ? range : ColumnRange{ 0, 0 };
  }

  /// Returns the indices of the points that a row owns.
  const Owners& GetOwners(Local& local, vtkIdType j, vtkIdType k) const;

  /// Returns the number of points that a row owns.
  vtkIdType Count(Local& local, vtkIdType j, vtkIdType k) const;

  /// Writes the \a number points that a row owns, beginning at \a position.
  void Write(
    Local& local, vtkIdType row, vtkIdType position, vtkIdType number, ExtractionMesh& mesh) const;

  /// Returns the size of the data shared by all threads, in bytes.
  std::size_t GetBytes() const;

  /// Returns the size of the buffers of a thread, in bytes.
  std::size_t GetBytes(const Local& local) const;

private:
  std::array<const CodeRow*, 3> GetOwnerCodes(Local& local, vtkIdType j, vtkIdType k) const;
  vtkIdType CountGridPoints(const CodeRow& row, const Code* codes, vtkIdType number) const;
  int CountPointCodes(const CodeRow& row) const;
  void CountOwnedPoints(const std::array<const CodeRow*, 3>& rows, Owners& owners) const;
  void FindPoints(const CodeRow& row, const Code* codes, vtkIdType number, Code* arePoints) const;

  ExtractionContext& Context;
  const ExtractionValues& Values;
  std::unique_ptr<ExtractionScalars> Scalars;
  const RowIndex& Rows;
  vtkIdType Nx;
  vtkIdType Ny;
  vtkIdType Nz;
  // Number of rows per layer whose owners a thread caches.
  vtkIdType CachedRows;
  // For each code, the number of smaller codes that make a grid point an output point.
  std::vector<int> PointsBelow;
  // The codes of all rows, if they are cached.
  ExtractionBuffer<Code> AllCodes;
  std::vector<CodeRow> CodeRows;
};

}

#endif
