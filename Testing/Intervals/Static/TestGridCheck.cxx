// SPDX-License-Identifier: BSD-3-Clause
// Errors for grids whose cells contradict their connectivity arrays, with 32-bit and 64-bit ids.
// The error names the first invalid cell; valid grids have no error. Every filter reports the
// error, also for grids from files.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "Common/DataDigest.h"
#include "Common/GridCheck.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTestErrorObserver.h"
#include "vtkTimeSlabWriter.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

// A thousand tetrahedra that share ten points, alternating with empty cells or polygons of 3 or 5
// points.
constexpr int Pairs = 1000;
constexpr vtkIdType Points = 10;

struct Damage
{
  // Index of the offset, id or type to overwrite (-1 for none) and its new value.
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
    types->InsertNextValue(pair % 3 == 0 ? VTK_EMPTY_CELL : VTK_POLYGON);
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
  const auto expect = [&](const std::string& what, const Damage& damage, const std::string& message)
  {
    const std::string found = interlume::GridCheck::FindError(MakeGrid<Array>(damage)).GetMessage();
    check.That(found == message, name + ", " + what + ": \"" + found + "\"");
  };
  expect("whole", {}, "");
  // Cell 4 is the third tetrahedron, with the entries 11 to 14 of the 6,664 point ids.
  const std::string tetra = "cell 4 (vtkTetra) has ";
  for (const vtkIdType id : { vtkIdType(-1), Points, most, -most })
  {
    expect("an invalid point id", { -1, 12, -1, id },
      tetra + "the point " + std::to_string(id) + "; the grid has 10 points");
  }
  expect("an invalid id in the last cell", { -1, 6663, -1, Points },
    "cell 1998 (vtkTetra) has the point 10; the grid has 10 points");
  expect("decreasing", { 5, -1, -1, 10 }, tetra + "the entries 11 to 10 of 6664 point ids");
  expect("negative", { 4, -1, -1, -1 },
    "cell 3 (vtkPolygon) has the entries 8 to -1 of 6664 "
    "point ids");
  expect("far", { 5, -1, -1, most },
    tetra + "the entries 11 to " + std::to_string(most) + " of 6664 point ids");
  expect("few", { 5, -1, -1, 14 }, tetra + "3 points; 4 are needed");
  expect("an invalid cell type", { -1, -1, 4, VTK_HEXAHEDRON },
    "cell 4 (vtkHexahedron) has 4 points; 8 are needed");
  expect("an unknown cell type of any size", { -1, -1, 4, VTK_POLY_VERTEX }, "");
}

/// A cell type and its minimum number of points.
struct SizedType
{
  int Type;
  int Minimum;
  std::string Name;
};

std::vector<SizedType> GetSizedTypes()
{
  const std::string unknown = "cell of unknown type";
  return {
    { VTK_POLY_VERTEX, 1, "vtkPolyVertex" },
    { VTK_POLY_LINE, 2, "vtkPolyLine" },
    { VTK_TRIANGLE_STRIP, 3, "vtkTriangleStrip" },
    { VTK_POLYGON, 3, "vtkPolygon" },
    { VTK_QUADRATIC_POLYGON, 6, "vtkQuadraticPolygon" },
    { VTK_CONVEX_POINT_SET, 4, "vtkConvexPointSet" },
    { VTK_HIGHER_ORDER_EDGE, 2, unknown },
    { VTK_HIGHER_ORDER_TRIANGLE, 3, unknown },
    { VTK_HIGHER_ORDER_QUAD, 4, unknown },
    { VTK_HIGHER_ORDER_POLYGON, 3, unknown },
    { VTK_HIGHER_ORDER_TETRAHEDRON, 4, unknown },
    { VTK_HIGHER_ORDER_WEDGE, 6, unknown },
    { VTK_HIGHER_ORDER_PYRAMID, 5, unknown },
    { VTK_HIGHER_ORDER_HEXAHEDRON, 8, unknown },
    { VTK_LAGRANGE_CURVE, 2, "vtkLagrangeCurve" },
    { VTK_LAGRANGE_TRIANGLE, 3, "vtkLagrangeTriangle" },
    { VTK_LAGRANGE_QUADRILATERAL, 4, "vtkLagrangeQuadrilateral" },
    { VTK_LAGRANGE_TETRAHEDRON, 4, "vtkLagrangeTetra" },
    { VTK_LAGRANGE_HEXAHEDRON, 8, "vtkLagrangeHexahedron" },
    { VTK_LAGRANGE_WEDGE, 6, "vtkLagrangeWedge" },
    { VTK_LAGRANGE_PYRAMID, 5, unknown },
    { VTK_BEZIER_CURVE, 2, "vtkBezierCurve" },
    { VTK_BEZIER_TRIANGLE, 3, "vtkBezierTriangle" },
    { VTK_BEZIER_QUADRILATERAL, 4, "vtkBezierQuadrilateral" },
    { VTK_BEZIER_TETRAHEDRON, 4, "vtkBezierTetra" },
    { VTK_BEZIER_HEXAHEDRON, 8, "vtkBezierHexahedron" },
    { VTK_BEZIER_WEDGE, 6, "vtkBezierWedge" },
    { VTK_BEZIER_PYRAMID, 5, unknown },
    // Cell types of fixed size, and polyhedra.
    { VTK_VERTEX, 1, "vtkVertex" },
    { VTK_TRIANGLE, 3, "vtkTriangle" },
    { VTK_QUADRATIC_HEXAHEDRON, 20, "vtkQuadraticHexahedron" },
    { VTK_HEXAHEDRON, 8, "vtkHexahedron" },
    { VTK_PENTAGONAL_PRISM, 10, "vtkPentagonalPrism" },
    { VTK_POLYHEDRON, 4, "vtkPolyhedron" },
  };
}

/// Returns a grid of two cells on the corners of a cube: a hexahedron, and a cell of type \a type
/// with \a size points.
template <typename Array>
vtkSmartPointer<vtkUnstructuredGrid> MakePair(int type, int size)
{
  vtkNew<Array> offsets;
  vtkNew<Array> ids;
  vtkNew<vtkUnsignedCharArray> types;
  for (int i = 0; i < 8 + size; ++i)
  {
    ids->InsertNextValue(i < 8 ? i : (i - 8) % 8);
  }
  for (const int offset : { 0, 8, 8 + size })
  {
    offsets->InsertNextValue(offset);
  }
  types->InsertNextValue(VTK_HEXAHEDRON);
  types->InsertNextValue(static_cast<unsigned char>(type));
  vtkNew<vtkPoints> points;
  for (int p = 0; p < 8; ++p)
  {
    points->InsertNextPoint((p ^ (p >> 1)) & 1, (p >> 1) & 1, p >> 2);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(types, cells, nullptr, nullptr);
  AddRandomField(grid, 1);
  return grid;
}

/// Returns the messages of the interval and contour filters, whose outputs must be empty.
std::vector<std::string> CollectMessages(vtkUnstructuredGrid* grid, Check& check)
{
  vtkNew<vtkIntervalVolume> intervals;
  intervals->SetInputData(grid);
  intervals->SetInterval(0, 0.25, 0.75);
  vtkNew<vtkIsotableContour> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, 0.5);
  const TimeVaryingPipeline pipeline(RepeatGrid(grid, { 0, 1 }), { { { 0.25, 0.75 } } });
  std::vector<std::string> messages;
  for (vtkAlgorithm* filter :
    { static_cast<vtkAlgorithm*>(intervals.Get()), static_cast<vtkAlgorithm*>(contour.Get()),
      static_cast<vtkAlgorithm*>(pipeline.Filter.Get()) })
  {
    messages.push_back(UpdateAndGetErrors(filter));
    check.Equal(
      vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells(), 0, "cells");
  }
  return messages;
}

template <typename Array>
void CheckSizes(const std::string& name, Check& check)
{
  for (const SizedType& type : GetSizedTypes())
  {
    for (const int size : std::vector<int>{ 0, 1, type.Minimum - 1 })
    {
      if (size >= type.Minimum)
      {
        continue;
      }
      check.SetContext(name + ", " + std::to_string(type.Type) + ", " + std::to_string(size));
      const auto grid = MakePair<Array>(type.Type, size);
      const std::string expected = "ell 1 (" + type.Name + ") has " + std::to_string(size) +
        (size == 1 ? " point; " : " points; ") + std::to_string(type.Minimum) +
        (type.Minimum == 1 ? " is needed" : " are needed");
      const std::string found = interlume::GridCheck::FindError(grid).GetMessage();
      check.That(found == "c" + expected, found);
      for (const std::string& message : CollectMessages(grid, check))
      {
        check.That(message.find("C" + expected) != std::string::npos ||
            message.find("c" + expected) != std::string::npos,
          "error: " + message);
      }
    }
    if (type.Type != VTK_POLYHEDRON)
    {
      const interlume::Error error =
        interlume::GridCheck::FindError(MakePair<Array>(type.Type, type.Minimum));
      check.That(!error, "no error for the minimum number of points: " + error.GetMessage());
    }
  }
}

/// vtkTimeSlabWriter must report the error, and writing must fail.
void CheckWriter(Check& check)
{
  check.SetContext("writer of slabs");
  const auto folder = std::filesystem::temp_directory_path() / "TestGridCheck";
  vtkNew<TimeStepSource> source;
  source->SetSteps(RepeatGrid(MakePair<vtkTypeInt64Array>(VTK_LAGRANGE_HEXAHEDRON, 7), { 0, 1 }));
  vtkNew<vtkTimeSlabWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetInterval(0, 0.25, 0.75);
  writer->SetFileName((folder / "slabs.vtm").string().c_str());
  vtkNew<vtkTest::ErrorObserver> watch;
  writer->AddObserver(vtkCommand::ErrorEvent, watch);
  check.That(!writer->Write(), "writing fails");
  const std::string message = watch->GetErrorMessage();
  check.That(message.find("has 7 points; 8 are needed") != std::string::npos, "error: " + message);
  std::filesystem::remove_all(folder);
}

/// Reads a grid of a tetrahedron and a cell of type \a type with \a size points from a string.
vtkSmartPointer<vtkUnstructuredGrid> Read(int type, int size, const std::string& more)
{
  std::ostringstream text;
  text << "<VTKFile type='UnstructuredGrid' version='1.0' header_type='UInt64'>"
       << "<UnstructuredGrid><Piece NumberOfPoints='8' NumberOfCells='2'>"
       << "<Points><DataArray type='Float64' NumberOfComponents='3' format='ascii'>"
       << "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1</DataArray></Points>"
       << "<Cells><DataArray type='Int64' Name='connectivity' format='ascii'>0 1 2 4";
  for (int i = 0; i < size; ++i)
  {
    text << " " << i;
  }
  text << "</DataArray><DataArray type='Int64' Name='offsets' format='ascii'>4 " << 4 + size
       << "</DataArray><DataArray type='UInt8' Name='types' format='ascii'>10 " << type
       << "</DataArray>" << more << "</Cells></Piece></UnstructuredGrid></VTKFile>";
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text.str());
  reader->Update();
  vtkSmartPointer<vtkUnstructuredGrid> grid = reader->GetOutput();
  AddRandomField(grid, 2);
  return grid;
}

void CheckFiles(Check& check)
{
  const struct
  {
    std::string Name;
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    std::string Messages;
  } cases[] = {
    { "Lagrange", Read(VTK_LAGRANGE_HEXAHEDRON, 3, ""),
      "ell 1 (vtkLagrangeHexahedron) has 3 points; 8 are needed" },
    { "polygon", Read(VTK_POLYGON, 2, ""), "ell 1 (vtkPolygon) has 2 points; 3 are needed" },
    { "polyhedron without faces", Read(VTK_POLYHEDRON, 4, ""),
      "ell 1 (vtkPolyhedron) has no faces" },
  };
  for (const auto& one : cases)
  {
    check.SetContext("file, " + one.Name);
    for (const std::string& message : CollectMessages(one.Grid, check))
    {
      check.That(message.find(one.Messages) != std::string::npos, "error: " + message);
    }
  }
}

/// A polyhedron has at least four faces. The digest of a grid depends on them.
void CheckFaces(Check& check)
{
  const vtkIdType ids[] = { 0, 1, 2, 4 };
  const vtkIdType faces[] = { 3, 0, 1, 2, 3, 0, 1, 4, 3, 1, 2, 4, 3, 2, 0, 4 };
  std::set<std::string> digests;
  for (vtkIdType number = 0; number <= 4; ++number)
  {
    check.SetContext(std::to_string(number) + " faces");
    auto grid = MakePair<vtkTypeInt64Array>(VTK_TETRA, 4);
    grid->InsertNextCell(VTK_POLYHEDRON, 4, ids, number, faces);
    const std::string found = interlume::GridCheck::FindError(grid).GetMessage();
    check.That(number == 4 ? found.empty()
                           : found ==
          "cell 2 (vtkPolyhedron) has " + interlume::ArrayCheck::Count(number, "face") +
            "; 4 are needed",
      found);
    interlume::DataDigest digest;
    digest.AddGrid(grid);
    check.That(digests.insert(digest.Take()).second, "a digest that other faces do not have");
  }
}

}

int TestGridCheck(int, char*[])
{
  Check check;
  CheckAll<vtkTypeInt32Array>("32 bits", check);
  CheckAll<vtkTypeInt64Array>("64 bits", check);
  CheckSizes<vtkTypeInt32Array>("32 bits", check);
  CheckSizes<vtkTypeInt64Array>("64 bits", check);
  CheckWriter(check);
  CheckFiles(check);
  CheckFaces(check);
  return check.Result();
}
