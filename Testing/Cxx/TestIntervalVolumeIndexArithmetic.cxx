// The index arithmetic of the extraction on grids with more than 2^31 points, where 32 bits would wrap.

#include "vtkCrossingKey.h"
#include "vtkRowIndex.h"

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
}

int TestIntervalVolumeIndexArithmetic(int, char*[])
{
  const int dimensions[3] = { 2500, 2600, 2700 };
  const vtkRowIndex rows(dimensions);
  const vtkIdType i = 2498;
  const vtkIdType j = 2598;
  const vtkIdType k = 2698;
  const vtkIdType row = rows.GetRow(j, k);
  const std::int64_t point = i + 2500LL * (j + 2600LL * k);
  bool passed = Expect(point > (std::int64_t(1) << 33), "the point is beyond 32 bits");
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
  const vtkCrossingKey key(point, 54321);
  passed &= Expect(key.GetFar() == point && key.GetValue() == 54321, "crossing key");
  passed &= Expect(vtkCrossingKey(point, 65535) < vtkCrossingKey(point + 1, 0), "order of keys");
  const int thin[3] = { 5, 1, 3 };
  passed &= Expect(vtkRowIndex(thin).GetAxis(5, 10) == 2, "an axis with one point");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
