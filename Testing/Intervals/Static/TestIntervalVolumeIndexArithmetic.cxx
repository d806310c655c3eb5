// SPDX-License-Identifier: BSD-3-Clause
// Index arithmetic on grids with more than 2^31 points, where 32-bit indices overflow.

#include "Output/CrossingKey.h"
#include "vtkIdList.h"
#include "Grid/RowIndex.h"
#include "Output/SimplexList.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>

namespace
{
bool Expect(bool holds, const char* what)
{
  if (!holds)
  {
    std::cerr << "Failed: " << what << "\n";
  }
  return holds;
}

// Tests point and row indices for row lengths whose reciprocals are rounded down or up.
bool TestRows()
{
  bool holds = true;
  for (int n = 2; n < 200; ++n)
  {
    const int dimensions[3] = { n, n + 1, 2000000000 };
    const interlume::RowIndex rows(dimensions);
    for (std::int64_t row : { std::int64_t(n), std::int64_t(49) * n, (std::int64_t(1) << 32) + n })
    {
      for (std::int64_t i : { 0, n - 1 })
      {
        const auto ijk = rows.GetIjk(row * n + i);
        holds &=
          ijk[0] == i && ijk[1] == row % (n + 1) && ijk[2] == static_cast<int>(row / (n + 1));
      }
    }
  }
  return Expect(holds, "rows of any length");
}

// The id width of the list depends on the largest id, and ids are stored without truncation.
bool TestSimplexList()
{
  constexpr vtkIdType most = (vtkIdType(1) << 31) - 1;
  bool passed =
    Expect(interlume::SimplexList::CanUse32BitStorage(most, most), "the largest 32-bit ids");
  passed &=
    Expect(!interlume::SimplexList::CanUse32BitStorage(most + 1, 4), "a point id above 32 bits");
  passed &=
    Expect(!interlume::SimplexList::CanUse32BitStorage(4, most + 1), "an offset above 32 bits");
  for (const vtkIdType points : { vtkIdType(100), vtkIdType(1) << 40 })
  {
    interlume::SimplexList list;
    list.Allocate(2, 4, points);
    const vtkIdType ids[5] = { points - 1, points - 2, points - 3, points - 4, points - 5 };
    const vtkIsotable::Simplex simplices[2] = { { { 0, 1, 2, 3 } }, { { 4, 3, 2, 1 } } };
    list.Write(0, simplices, 1, ids, false);
    list.Write(1, simplices + 1, 1, ids, true);
    const vtkSmartPointer<vtkCellArray> cells = list.MakeCells();
    passed &= Expect(cells->IsStorage64Bit() == (points > most), "the id width of the cells");
    vtkNew<vtkIdList> cell;
    cells->GetCellAtId(0, cell);
    passed &= Expect(
      cell->GetNumberOfIds() == 4 && cell->GetId(0) == points - 1 && cell->GetId(3) == points - 4,
      "the ids of a cell");
    cells->GetCellAtId(1, cell);
    passed &= Expect(cell->GetNumberOfIds() == 4 && cell->GetId(0) == points - 4 &&
        cell->GetId(1) == points - 5 && cell->GetId(2) == points - 3,
      "the ids of an inverted cell");
  }
  return passed;
}
}

int TestIntervalVolumeIndexArithmetic(int, char*[])
{
  const int dimensions[3] = { 2500, 2600, 2700 };
  const interlume::RowIndex rows(dimensions);
  const vtkIdType i = 2498;
  const vtkIdType j = 2598;
  const vtkIdType k = 2698;
  const vtkIdType row = rows.GetRow(j, k);
  const std::int64_t point = i + 2500LL * (j + 2600LL * k);
  bool passed = Expect(point > (std::int64_t(1) << 33), "the point id exceeds 32 bits");
  passed &= Expect(rows.GetNumberOfRows() == 2600LL * 2700, "number of rows");
  passed &= Expect(rows.GetJ(row) == j && rows.GetK(row) == k, "row to j and k");
  passed &= Expect(rows.GetFirstPoint(row) + i == point, "first point of a row");
  passed &= Expect(rows.GetFirstCell(j, k) == 2499LL * (j + 2599LL * k), "first cell of a row");
  passed &= Expect(rows.GetCellRow(2599, 2699) == rows.GetCellRow(j, k), "the last row of points");
  passed &= Expect(
    rows.GetVertex(point, 7) == point + 1 + 2500 + 2500LL * 2600, "the last vertex of a cell");
  const auto ijk = rows.GetIjk(point);
  passed &= Expect(ijk[0] == i && ijk[1] == j && ijk[2] == k, "point to i, j, k");
  for (int axis = 0; axis < 3; ++axis)
  {
    passed &= Expect(rows.GetAxis(point, point + rows.GetStep(axis)) == axis &&
        rows.GetAxis(point + rows.GetStep(axis), point) == axis,
      "the axis of an edge");
  }
  const interlume::CrossingKey key(point, 54321);
  passed &= Expect(key.GetFar() == point && key.GetValue() == 54321, "crossing key");
  passed &= Expect(
    interlume::CrossingKey(point, 65535) < interlume::CrossingKey(point + 1, 0), "order of keys");
  const int thin[3] = { 5, 1, 3 };
  passed &= Expect(interlume::RowIndex(thin).GetAxis(5, 10) == 2, "an axis with one point");
  passed &= TestRows();
  passed &= TestSimplexList();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
