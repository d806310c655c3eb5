// SPDX-License-Identifier: BSD-3-Clause
// The sign of a cell's volume is the same in single and in double precision. Tests all shapes with
// cells of many sizes: stretched, far from the origin, and nearly or exactly degenerate.
#include "Grid/CellOrientation.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace
{

using namespace reference;
using Corner = std::array<double, 3>;

const std::vector<Corner>& CornersOf(vtkIsotable::Shapes shape)
{
  static const std::vector<Corner> corners[vtkIsotable::NUMBER_OF_SOLIDS] = {
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } },
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } }, { { 0.5, 0.5, 1 } } },
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } },
      { { 0, 1, 1 } } },
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } }, { { 0, 0, 1 } },
      { { 1, 0, 1 } }, { { 0, 1, 1 } }, { { 1, 1, 1 } } }
  };
  return corners[shape];
}

int FindSign(vtkIsotable::Shapes shape, const std::vector<std::array<float, 3>>& corners, int type)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner.data());
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  std::vector<vtkIdType> ids(corners.size());
  std::iota(ids.begin(), ids.end(), vtkIdType(0));
  return interlume::CellOrientation(grid).GetSign(shape, ids.data());
}

void CheckShape(vtkIsotable::Shapes shape, Check& check)
{
  std::mt19937 random(shape + 1);
  const auto power = [&random](double least, double most)
  { return std::pow(10.0, std::uniform_real_distribution<double>(least, most)(random)); };
  std::normal_distribution<double> normal;
  int found[3] = {};
  for (int cell = 0; cell < 30000; ++cell)
  {
    const double size = power(-12.0, 11.0);
    const double origin = cell % 2 == 0 ? 0.0 : size * power(-2.0, 7.0);
    const Corner stretch = { { size, size * power(-7.0, 0.0), -size * power(-7.0, 0.0) } };
    const double warp = power(-9.0, 0.5);
    const bool isFlat = cell % 3 == 0;
    std::vector<std::array<float, 3>> corners;
    for (const Corner& corner : CornersOf(shape))
    {
      corners.emplace_back();
      for (int axis = 0; axis < 3; ++axis)
      {
        const double position = isFlat && axis == 2 ? corner[0] + corner[1] : corner[axis];
        corners.back()[axis] =
          static_cast<float>(origin + stretch[axis] * (position + warp * normal(random)));
      }
    }
    const int sign = FindSign(shape, corners, VTK_FLOAT);
    check.Equal(sign, FindSign(shape, corners, VTK_DOUBLE), "sign of cell " + std::to_string(cell));
    ++found[sign + 1];
  }
  check.That(found[0] > 5000 && found[2] > 2000, "cells are left-handed and right-handed");
}

}

int TestCellOrientation(int, char*[])
{
  Check check;
  for (int shape = 0; shape < vtkIsotable::NUMBER_OF_SOLIDS; ++shape)
  {
    check.SetContext("shape " + std::to_string(shape));
    CheckShape(static_cast<vtkIsotable::Shapes>(shape), check);
  }
  return check.Result();
}
