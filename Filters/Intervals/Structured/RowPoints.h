// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowPoints_h
#define interlume_RowPoints_h

#include "Grid/GridWindow.h"
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
 * @brief   the codes of rows of grid points, and the points of the output that these rows own
 *
 * A grid point owns itself, where its value equals an isovalue, and the crossings of its edges
 * along i, j and k, in this order; a row owns what its grid points own, in theirs. So the id of a
 * point of the output is the place where those of its row begin, which the caller sums up, and a
 * place in the row.
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

  /// The places where the points that a row owns begin, relative to the row's first: those of a
  /// grid point at Starts, those of its edge along i, j, k by Offsets[0], [1], [2] further on.
  struct Owners
  {
    vtkIdType Row = -1;
    /// Only these columns own points; elsewhere the arrays mean nothing.
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
    // Of two layers of rows, where they are kept whole, or else of two rows of each.
    std::array<std::vector<Owners>, 2> Layers;
    std::vector<ExtractionPoint> Points;
  };

  /// \a context and \a rows, which are those of \a window, must outlive this.
  RowPoints(ExtractionContext& context, const RowIndex& rows, const GridWindow& window);

  /// Makes the codes of all rows, where they are kept. Returns false when the user aborted.
  bool MakeCodes();

  /// Returns the codes of a row; a row of cells goes by the number of its first row of grid points.
  /// What a thread gets stays in place until it asks for a row three further on along j or k.
  const CodeRow& GetCodes(Local& local, vtkIdType j, vtkIdType k) const;

  /// Returns the columns of points between which all that differs lies: outside of them the codes
  /// of all rows are one and the same, and no output.
  template <std::size_t Number>
  ColumnRange GetRange(const std::array<const CodeRow*, Number>& rows) const
  {
    const Code front = rows[0]->Codes[0];
    const Code back = rows[0]->Codes[this->Nx - 1];
    bool isFrontEmpty = !this->Values.IsPoint(front);
    bool isBackEmpty = !this->Values.IsPoint(back);
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

  /// Returns where the points begin that a row owns.
  const Owners& GetOwners(Local& local, vtkIdType j, vtkIdType k) const;

  /// Returns how many points a row owns.
  vtkIdType Count(Local& local, vtkIdType j, vtkIdType k) const;

  /// Writes the \a number points that a row owns from \a place on.
  void Write(
    Local& local, vtkIdType row, vtkIdType place, vtkIdType number, ExtractionMesh& mesh) const;

  /// Returns the bytes of what is kept for all threads.
  std::size_t GetBytes() const;

  /// Returns the bytes of what a thread keeps.
  std::size_t GetBytes(const Local& local) const;

private:
  std::array<const CodeRow*, 3> GetOwnerCodes(Local& local, vtkIdType j, vtkIdType k) const;
  vtkIdType CountOwnPoints(const CodeRow& row, const Code* codes, vtkIdType number) const;
  int CountCodesOfPoints(const CodeRow& row) const;
  void CountOwned(const std::array<const CodeRow*, 3>& rows, Owners& owners) const;
  void FindPoints(const CodeRow& row, const Code* codes, vtkIdType number, Code* arePoints) const;

  ExtractionContext& Context;
  const ExtractionValues& Values;
  std::unique_ptr<ExtractionScalars> Scalars;
  const RowIndex& Rows;
  vtkIdType Nx;
  vtkIdType Ny;
  vtkIdType Nz;
  // How many rows of owners a thread keeps of a layer.
  vtkIdType KeptRows;
  // For each code the number of smaller ones of which grid points are points of the output.
  std::vector<int> PointsBelow;
  // All rows of codes, where they are kept.
  ExtractionBuffer<Code> AllCodes;
  std::vector<CodeRow> CodeRows;
};

}

#endif
