// SPDX-License-Identifier: BSD-3-Clause
// What is said of grids whose cells contradict their arrays, with ids of 32 and of 64 bits: the
// first cell that is wrong, and nothing of a grid that is whole.
#include "Reference/Checks/ReferenceCheck.h"

#include "Common/GridCheck.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace reference;

// A thousand tetrahedra and as many polygons of 0, 3 or 5 points, in turn, of ten points.
constexpr int Pairs = 1000;
constexpr vtkIdType Points = 10;

struct Damage
{
  // Which offset, id or type is set, -1 for none, and to what.
  vtkIdType Offset = -1;
  vtkIdType Id = -1;
  vtkIdType Type = -1;
  vtkIdType Value = 0;
};

template <typename Array>
vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(const Damage& damage)
{
  using Id = typename Array::ValueType;
  vtkNew<Array> offsets;
  vtkNew<Array> ids;
  vtkNew<vtkUnsignedCharArray> types;
  offsets->InsertNextValue(0);
  const int sizes[] = { 0, 3, 5 };
  for (int pair = 0; pair < Pairs; ++pair)
  {
    for (const int number : { 4, sizes[pair % 3] })
    {
      for (int i = 0; i < number; ++i)
      {
        ids->InsertNextValue(static_cast<Id>((pair + i) % Points));
      }
      offsets->InsertNextValue(static_cast<Id>(ids->GetNumberOfValues()));
    }
    types->InsertNextValue(VTK_TETRA);
    types->InsertNextValue(VTK_POLYGON);
  }
  if (damage.Offset >= 0)
  {
    offsets->SetValue(damage.Offset, static_cast<Id>(damage.Value));
  }
  if (damage.Id >= 0)
  {
    ids->SetValue(damage.Id, static_cast<Id>(damage.Value));
  }
  if (damage.Type >= 0)
  {
    types->SetValue(damage.Type, static_cast<unsigned char>(damage.Value));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(Points);
  grid->SetPoints(points);
  grid->SetCells(types, cells);
  return grid;
}

template <typename Array>
void CheckAll(const std::string& name, Check& check)
{
  constexpr vtkIdType most = std::numeric_limits<typename Array::ValueType>::max();
  const auto expect = [&](const std::string& what, const Damage& damage, const std::string& said)
  {
    const std::string found = interlume::GridCheck::Find(MakeGrid<Array>(damage));
    check.That(found == said, name + ", " + what + ": \"" + found + "\"");
  };
  expect("whole", {}, "");
  // Cell 4 is the third tetrahedron, with the entries 11 to 15; there are 6,664 in all.
  const std::string tetra = "cell 4 (vtkTetra) has ";
  for (const vtkIdType id : { vtkIdType(-1), Points, most, -most })
  {
    expect("a point", { -1, 12, -1, id },
      tetra + "the point " + std::to_string(id) + "; the grid has 10 points");
  }
  expect("the last point of all", { -1, 6663, -1, Points },
    "cell 1998 (vtkTetra) has the point 10; the grid has 10 points");
  expect("decreasing", { 5, -1, -1, 10 }, tetra + "the entries 11 to 10 of 6664 point ids");
  expect("negative", { 4, -1, -1, -1 },
    "cell 3 (vtkPolygon) has the entries 8 to -1 of 6664 "
    "point ids");
  expect("far", { 5, -1, -1, most },
    tetra + "the entries 11 to " + std::to_string(most) + " of 6664 point ids");
  expect("few", { 5, -1, -1, 14 }, tetra + "3 points; 4 are needed");
  expect("another type", { -1, -1, 4, VTK_HEXAHEDRON },
    "cell 4 (vtkHexahedron) has 4 points; 8 are needed");
  expect("a type of any size", { -1, -1, 4, VTK_POLY_VERTEX }, "");
}

}

int TestGridCheck(int, char*[])
{
  Check check;
  CheckAll<vtkTypeInt32Array>("32 bits", check);
  CheckAll<vtkTypeInt64Array>("64 bits", check);
  return check.Result();
}
