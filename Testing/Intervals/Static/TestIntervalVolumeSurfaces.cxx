// SPDX-License-Identifier: BSD-3-Clause
// Two-dimensional cells: the triangles of adjacent intervals form one conforming mesh, also if
// values equal a bound; a polygon that is a face of a three-dimensional cell has the triangles of
// the faces of its tetrahedra; mixed datasets; skipped cells; arrays; repeated executions; threads.
#include "Common/DataDigest.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

namespace
{

using namespace reference;
using Edge = std::array<vtkIdType, 2>;

vtkIdType GetInteger(vtkUnstructuredGrid* grid, const char* array, vtkIdType cell)
{
  return static_cast<vtkIdType>(grid->GetCellData()->GetArray(array)->GetComponent(cell, 0));
}

std::vector<vtkIdType> GetIds(vtkDataSet* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(cell, ids);
  return { ids->begin(), ids->end() };
}

/// A plane of squares with side 1, each of which is a quadrilateral, two triangles, or part of a
/// hexagon of two squares. The cells have random first points, and the points random numbers.
vtkSmartPointer<vtkUnstructuredGrid> MakePlane(int size, unsigned int seed)
{
  std::mt19937 random(seed);
  MeshBuilder builder;
  const auto add = [&](int type, std::vector<std::array<int, 2>> corners)
  {
    std::rotate(corners.begin(), corners.begin() + random() % corners.size(), corners.end());
    std::vector<vtkIdType> ids;
    for (const auto& corner : corners)
    {
      ids.push_back(builder.FindOrAddPoint({ corner[0], corner[1], 0 }, { 1, 1, 1 }));
    }
    builder.AddCell(type, ids);
  };
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const int kind = static_cast<int>(random() % 3);
      if (kind == 2 && i + 1 < size)
      {
        add(VTK_POLYGON,
          { { i, j }, { i + 1, j }, { i + 2, j }, { i + 2, j + 1 }, { i + 1, j + 1 },
            { i, j + 1 } });
        ++i;
      }
      else if (kind == 1)
      {
        add(VTK_TRIANGLE, { { i, j }, { i + 1, j }, { i, j + 1 } });
        add(VTK_TRIANGLE, { { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } });
      }
      else
      {
        add(VTK_QUAD, { { i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } });
      }
    }
  }
  return RenumberPoints(builder.GetMesh(), seed);
}

double GetArea(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const std::vector<vtkIdType> ids = GetIds(grid, cell);
  double x[3][3];
  for (int v = 0; v < 3; ++v)
  {
    grid->GetPoint(ids[v], x[v]);
  }
  return ((x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0])) /
    2;
}

double SumAreas(vtkUnstructuredGrid* grid)
{
  double sum = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    sum += GetArea(grid, cell);
  }
  return sum;
}

constexpr int PlaneSize = 12;

/// Checks the output of a square of \a PlaneSize in the plane z = 0. \a isComplete is true if the
/// intervals contain all values.
void CheckMesh(const Extraction& extraction, int intervals, bool isComplete, Check& check)
{
  vtkUnstructuredGrid* triangles = extraction.Volume;
  vtkUnstructuredGrid* lines = extraction.Surface;
  std::vector<std::map<Edge, int>> edges(intervals);
  std::map<Edge, int> all;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    const std::vector<vtkIdType> ids = GetIds(triangles, cell);
    const auto interval = GetInteger(triangles, "IntervalId", cell);
    for (int v = 0; v < 3; ++v)
    {
      const Edge edge{ ids[v], ids[(v + 1) % 3] };
      for (std::map<Edge, int>* list : { &edges[interval], &all })
      {
        ++(*list)[edge];
        --(*list)[{ edge[1], edge[0] }];
      }
    }
    check.That(GetArea(triangles, cell) > 0, "a triangle has the orientation of its cell");
  }
  std::set<std::pair<vtkIdType, Edge>> boundary;
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    const std::vector<vtkIdType> ids = GetIds(lines, line);
    const auto interval = GetInteger(lines, "IntervalId", line);
    check.That(boundary.insert({ interval, { ids[0], ids[1] } }).second, "a line occurs once");
    check.That(edges[interval][{ ids[0], ids[1] }] == 1, "a line is an edge of a triangle");
  }
  const auto isOnBorder = [&](const Edge& edge)
  {
    double a[3];
    double b[3];
    triangles->GetPoint(edge[0], a);
    triangles->GetPoint(edge[1], b);
    bool isFound = false;
    for (const double border : { 0, PlaneSize })
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        isFound =
          isFound || (std::abs(a[axis] - border) < 1e-9 && std::abs(b[axis] - border) < 1e-9);
      }
    }
    return isFound;
  };
  for (int interval = 0; interval < intervals; ++interval)
  {
    for (const auto& edge : edges[interval])
    {
      check.That(std::abs(edge.second) <= 1, "an edge has at most one net triangle");
      check.That(
        edge.second < 1 || boundary.count({ interval, edge.first }) == 1 || isOnBorder(edge.first),
        "an edge without a neighbor is on a bound or on the border");
    }
  }
  if (isComplete)
  {
    for (const auto& edge : all)
    {
      check.That(edge.second == 0 || isOnBorder(edge.first), "adjacent intervals match");
    }
    check.Near(SumAreas(triangles), PlaneSize * PlaneSize, 1e-13, "area of all intervals");
  }
}

void CheckTiling(Check& check)
{
  for (unsigned int seed = 1; seed <= 6; ++seed)
  {
    check.SetContext("seed " + std::to_string(seed));
    auto plane = MakePlane(PlaneSize, seed);
    AddRandomField(plane, seed);
    CheckMesh(ExtractIntervals(plane, { { -1, 0.2 }, { 0.2, 0.21 }, { 0.21, 0.6 }, { 0.6, 2 } }), 4,
      true, check);
    // Values that equal a bound, including constant edges and cells.
    for (const int values : { 2, 3, 5 })
    {
      check.SetContext("seed " + std::to_string(seed) + ", " + std::to_string(values) + " values");
      AddIntegerField(plane, values, seed);
      CheckMesh(
        ExtractIntervals(plane, { { -1, 0 }, { 0, 1 }, { 1, 2 }, { 2, 9 } }), 4, true, check);
      CheckMesh(ExtractIntervals(plane, { { 1, 1 } }), 1, false, check);
      CheckMesh(ExtractIntervals(plane, { { 1, 9 } }), 1, false, check);
      CheckMesh(ExtractIntervals(plane, { { 0, 1 } }), 1, false, check);
    }
  }
}

/// The rules for values equal to a bound, on one square with the values 0, 0, 1, 1.
void CheckTies(Check& check)
{
  const auto measure =
    [&](const std::vector<Interval>& intervals, double area, int lines, const std::string& what)
  {
    vtkNew<vtkImageData> square;
    square->SetDimensions(2, 2, 1);
    AddLinearField(square, { 0, { 0, 1, 0 } });
    const Extraction extraction = ExtractIntervals(square, intervals);
    check.Near(SumAreas(extraction.Volume), area, 1e-15, what + ": area");
    check.Equal(extraction.Surface->GetNumberOfCells(), lines, what + ": lines");
  };
  check.SetContext("values equal to a bound");
  measure({ { 0, 1 } }, 1, 0, "both bounds are inside");
  measure({ { 0, 1 }, { 1, 2 } }, 1, 1, "the upper bound is outside");
  measure({ { -1, 0 } }, 0, 0, "an interval that ends at the lowest value");
  measure({ { 1, 2 } }, 0, 0, "an interval that starts at the highest value");
  measure({ { 0, 0 } }, 0, 0, "an interval of no width");
  measure({ { 0.25, 0.5 }, { 0.5, 0.75 } }, 0.5, 4, "no value equals a bound");
}

using Triangle = std::array<std::array<double, 3>, 3>;

Triangle GetTriangle(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& ids)
{
  Triangle triangle;
  for (int v = 0; v < 3; ++v)
  {
    grid->GetPoint(ids[v], triangle[v].data());
  }
  // The first point is the lowest one; the orientation is preserved.
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/// The faces of tetrahedra that have no neighbor of the same interval and are no boundary
/// triangles, by interval.
std::set<std::pair<vtkIdType, Triangle>> GetOuterFaces(const Extraction& extraction)
{
  constexpr int faces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  std::map<std::pair<vtkIdType, Triangle>, int> net;
  const auto count =
    [&net](vtkUnstructuredGrid* grid, vtkIdType interval, std::vector<vtkIdType> ids, int sign)
  {
    net[{ interval, GetTriangle(grid, ids) }] += sign;
    std::swap(ids[0], ids[1]);
    net[{ interval, GetTriangle(grid, ids) }] -= sign;
  };
  for (vtkIdType cell = 0; cell < extraction.Volume->GetNumberOfCells(); ++cell)
  {
    const std::vector<vtkIdType> ids = GetIds(extraction.Volume, cell);
    for (const auto& face : faces)
    {
      count(extraction.Volume, GetInteger(extraction.Volume, "IntervalId", cell),
        { ids[face[0]], ids[face[1]], ids[face[2]] }, 1);
    }
  }
  for (vtkIdType cell = 0; cell < extraction.Surface->GetNumberOfCells(); ++cell)
  {
    count(extraction.Surface, GetInteger(extraction.Surface, "IntervalId", cell),
      GetIds(extraction.Surface, cell), -1);
  }
  std::set<std::pair<vtkIdType, Triangle>> outer;
  for (const auto& face : net)
  {
    if (face.second > 0)
    {
      outer.insert(face.first);
    }
  }
  return outer;
}

/// Returns the triangles and quadrilaterals on the border of a mesh. They have all points of the
/// mesh.
vtkSmartPointer<vtkUnstructuredGrid> GetBorder(vtkUnstructuredGrid* mesh)
{
  std::map<std::vector<vtkIdType>, std::pair<int, std::vector<vtkIdType>>> faces;
  vtkNew<vtkGenericCell> generic;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCell(cell, generic);
    for (int f = 0; f < generic->GetNumberOfFaces(); ++f)
    {
      vtkIdList* ids = generic->GetFace(f)->GetPointIds();
      std::vector<vtkIdType> key(ids->begin(), ids->end());
      std::sort(key.begin(), key.end());
      auto& face = faces[key];
      ++face.first;
      face.second.assign(ids->begin(), ids->end());
      if (generic->GetFace(f)->GetCellType() == VTK_PIXEL)
      {
        std::swap(face.second[2], face.second[3]);
      }
    }
  }
  auto border = vtkSmartPointer<vtkUnstructuredGrid>::New();
  border->SetPoints(mesh->GetPoints());
  border->Allocate(static_cast<vtkIdType>(faces.size()));
  for (const auto& face : faces)
  {
    const auto number = static_cast<vtkIdType>(face.second.second.size());
    if (face.second.first == 1)
    {
      border->InsertNextCell(
        number == 3 ? VTK_TRIANGLE : VTK_QUAD, number, face.second.second.data());
    }
  }
  return border;
}

/// A polygon that is a face of a cell has the triangles of the tetrahedra in that cell.
void CheckFaces(Check& check)
{
  const std::vector<Interval> intervals = { { 0.2, 0.5 }, { 0.5, 0.8 } };
  for (const MeshKind kind : { MeshKind::Hexahedra, MeshKind::Wedges, MeshKind::Pyramids,
         MeshKind::Tetrahedra6, MeshKind::Voxels })
  {
    for (unsigned int seed = 1; seed <= 2; ++seed)
    {
      check.SetContext(GetName(kind) + ", seed " + std::to_string(seed));
      auto mesh =
        RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 3 }, seed), seed), seed);
      AddRandomField(mesh, seed);
      auto border = GetBorder(mesh);
      border->GetPointData()->ShallowCopy(mesh->GetPointData());
      const auto outer = GetOuterFaces(ExtractIntervals(mesh, intervals));
      auto triangles = ExtractIntervals(border, intervals).Volume;
      std::set<std::pair<vtkIdType, Triangle>> found;
      // VTK does not orient the faces of all cell types outward.
      const auto sort = [](Triangle triangle)
      {
        std::sort(triangle.begin(), triangle.end());
        return triangle;
      };
      for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
      {
        found.insert({ GetInteger(triangles, "IntervalId", cell),
          sort(GetTriangle(triangles, GetIds(triangles, cell))) });
      }
      std::set<std::pair<vtkIdType, Triangle>> expected;
      for (const auto& face : outer)
      {
        expected.insert({ face.first, sort(face.second) });
      }
      check.Equal(static_cast<long long>(found.size()), triangles->GetNumberOfCells(),
        "each triangle occurs once");
      check.That(found == expected, "the triangles are the faces of the tetrahedra");
      check.That(expected.size() > 100, "there are many faces");
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> Combine(vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* more)
{
  auto mixed = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mixed->SetPoints(mesh->GetPoints());
  mixed->GetPointData()->ShallowCopy(mesh->GetPointData());
  mixed->Allocate(1);
  // Alternate between both grids as far as possible.
  for (vtkIdType cell = 0; cell < std::max(mesh->GetNumberOfCells(), more->GetNumberOfCells());
       ++cell)
  {
    for (vtkUnstructuredGrid* grid : { more, mesh })
    {
      if (cell < grid->GetNumberOfCells())
      {
        const std::vector<vtkIdType> ids = GetIds(grid, cell);
        mixed->InsertNextCell(
          grid->GetCellType(cell), static_cast<vtkIdType>(ids.size()), ids.data());
      }
    }
  }
  return mixed;
}

void Configure(vtkIntervalVolume* filter, vtkDataSet* input)
{
  filter->SetInputData(input);
  filter->GenerateBoundariesOn();
  filter->SetInterval(0, 0.2, 0.5);
  filter->SetInterval(1, 0.5, 0.8);
  filter->SetSurfaceCells(vtkIntervalVolume::ALWAYS);
}

vtkUnstructuredGrid* GetPort(vtkIntervalVolume* filter, int port)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port));
}

std::string GetDigest(vtkUnstructuredGrid* grid)
{
  interlume::DataDigest digest;
  digest.AddGrid(grid);
  digest.Add(grid->GetPointData()->GetArray("f"));
  digest.Add(grid->GetCellData()->GetArray("IntervalId"));
  return digest.Take();
}

/// Checks that the cells of \a all from \a first on, with their arrays, are the cells of \a part.
void CheckPart(vtkUnstructuredGrid* all, vtkIdType first, vtkUnstructuredGrid* part, Check& check)
{
  check.That(part->GetNumberOfCells() > 0, "there are cells of each dimension");
  for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
  {
    const std::vector<vtkIdType> ids = GetIds(part, cell);
    const std::vector<vtkIdType> found = GetIds(all, first + cell);
    bool areEqual = all->GetCellType(first + cell) == part->GetCellType(cell) &&
      found.size() == ids.size() &&
      GetInteger(all, "IntervalId", first + cell) == GetInteger(part, "IntervalId", cell);
    for (std::size_t v = 0; areEqual && v < ids.size(); ++v)
    {
      double a[3];
      double b[3];
      all->GetPoint(found[v], a);
      part->GetPoint(ids[v], b);
      areEqual = std::equal(a, a + 3, b) &&
        all->GetPointData()->GetArray("f")->GetComponent(found[v], 0) ==
          part->GetPointData()->GetArray("f")->GetComponent(ids[v], 0);
    }
    check.That(areEqual, "cell " + std::to_string(cell));
  }
}

void CheckMixed(Check& check)
{
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 5, 5, 5 });
  AddRandomField(mesh, 4);
  AddRandomField(mesh, 9, "g");
  mesh->GetPointData()->SetActiveScalars("f");
  auto border = GetBorder(mesh);
  border->GetPointData()->ShallowCopy(mesh->GetPointData());
  auto mixed = Combine(mesh, border);
  for (const bool hasCriterion : { false, true })
  {
    for (const bool keepsInterior : { false, true })
    {
      check.SetContext(std::string("mixed cells") + (hasCriterion ? ", criterion" : "") +
        (keepsInterior ? ", interior cells" : ""));
      vtkNew<vtkIntervalVolume> filters[4];
      for (vtkIntervalVolume* filter :
        { filters[0].Get(), filters[1].Get(), filters[2].Get(), filters[3].Get() })
      {
        Configure(filter,
          filter == filters[1].Get()     ? mesh.Get()
            : filter == filters[2].Get() ? border.Get()
                                         : mixed.Get());
        filter->SetKeepInteriorCells(keepsInterior);
        if (hasCriterion)
        {
          filter->AddCriterion("g", 0.3, 0.6);
        }
      }
      filters[3]->SetSurfaceCells(
        hasCriterion ? vtkIntervalVolume::NEVER : vtkIntervalVolume::WITHOUT_SOLIDS);
      for (vtkIntervalVolume* filter :
        { filters[0].Get(), filters[1].Get(), filters[2].Get(), filters[3].Get() })
      {
        filter->Update();
      }
      for (int port = 0; port < 2; ++port)
      {
        vtkUnstructuredGrid* all = GetPort(filters[0], port);
        vtkUnstructuredGrid* solids = GetPort(filters[1], port);
        vtkUnstructuredGrid* surfaces = GetPort(filters[2], port);
        check.Equal(all->GetNumberOfCells(),
          solids->GetNumberOfCells() + surfaces->GetNumberOfCells(), "number of cells");
        CheckPart(all, 0, solids, check);
        CheckPart(all, solids->GetNumberOfCells(), surfaces, check);
        CheckPart(GetPort(filters[3], port), 0, solids, check);
        check.Equal(GetPort(filters[3], port)->GetNumberOfCells(), solids->GetNumberOfCells(),
          "number of cells without surfaces");
      }
      check.That(GetPort(filters[0], 0)->GetPoints() == GetPort(filters[0], 1)->GetPoints(),
        "both ports share points");
      vtkInterlumeReport* report = filters[0]->GetReport();
      check.Equal(report->GetCount("Cells"), mixed->GetNumberOfCells(), "cells");
      check.Equal(report->GetCount("LowerDimensionalCells"), 0, "no cell is skipped");
      check.Equal(report->GetCount("CellsWithOutput"),
        filters[1]->GetReport()->GetCount("CellsWithOutput") +
          filters[2]->GetReport()->GetCount("CellsWithOutput"),
        "cells with output");
      check.Equal(filters[3]->GetReport()->GetCount("LowerDimensionalCells"),
        border->GetNumberOfCells(), "skipped cells");
    }
  }
}

/// Only one dimension has output, so that the other part is empty.
void CheckMixedParts(Check& check)
{
  for (const bool isSolid : { false, true })
  {
    check.SetContext(isSolid ? "only tetrahedra" : "only triangles");
    MeshBuilder builder;
    for (int i = 0; i < 4; ++i)
    {
      builder.AddPoint(i == 1, i == 2, i == 3);
    }
    for (int i = 0; i < 3; ++i)
    {
      builder.AddPoint(5 + (i == 1), 5 + (i == 2), 0);
    }
    builder.AddCell(VTK_TRIANGLE, { 4, 5, 6 });
    builder.AddCell(VTK_TETRA, { 0, 1, 2, 3 });
    auto mesh = builder.GetMesh();
    vtkNew<vtkDoubleArray> values;
    values->SetName("f");
    for (const double value : { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 })
    {
      values->InsertNextValue(value);
    }
    mesh->GetPointData()->SetScalars(values);
    const Extraction extraction = ExtractIntervals(
      mesh, { isSolid ? Interval{ -1, 1.5 } : Interval{ 4.5, 9 } }, vtkIntervalVolume::ALWAYS);
    check.That(extraction.Volume->GetNumberOfCells() > 0, "there is output");
    for (vtkIdType cell = 0; cell < extraction.Volume->GetNumberOfCells(); ++cell)
    {
      check.Equal(extraction.Volume->GetCellType(cell), isSolid ? VTK_TETRA : VTK_TRIANGLE, "type");
    }
    check.Equal(extraction.Surface->GetNumberOfCells(), isSolid ? 2 : 1, "boundary cells");
    check.Equal(extraction.Surface->GetCellType(0), isSolid ? VTK_TRIANGLE : VTK_LINE, "type");
  }
  // Boundary lines next to tetrahedra without a boundary.
  check.SetContext("boundary lines next to interior tetrahedra");
  MeshBuilder builder;
  for (int i = 0; i < 4; ++i)
  {
    builder.AddPoint(i == 1, i == 2, i == 3);
  }
  builder.AddPoint(5, 5, 5);
  builder.AddCell(VTK_TRIANGLE, { 0, 1, 4 });
  builder.AddCell(VTK_TETRA, { 0, 1, 2, 3 });
  auto mesh = builder.GetMesh();
  AddLinearField(mesh, { 0, { 1, 1, 1 } });
  const Extraction extraction = ExtractIntervals(mesh, { { -1, 2 } }, vtkIntervalVolume::ALWAYS);
  check.Equal(extraction.Volume->GetNumberOfCells(), 3, "a tetrahedron and two triangles");
  check.Equal(extraction.Surface->GetNumberOfCells(), 1, "one line");
  vtkDataArray* values = extraction.Surface->GetPointData()->GetArray("f");
  for (const vtkIdType id : GetIds(extraction.Surface, 0))
  {
    check.Near(values->GetComponent(id, 0), 2, 1e-15, "value at a point of the line");
  }
}

/// Hidden, ghost and blanked cells, and cells with NaN, are skipped and counted.
void CheckSkipped(Check& check)
{
  constexpr int size = 5;
  const auto make = [](int form) -> vtkSmartPointer<vtkDataSet>
  {
    vtkNew<vtkUniformGrid> image;
    image->SetDimensions(size + 1, size + 1, 1);
    AddRandomField(image, 3);
    if (form == 0)
    {
      return image.Get();
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
    {
      points->InsertNextPoint(image->GetPoint(p));
    }
    vtkSmartPointer<vtkPointSet> set;
    if (form == 1)
    {
      vtkNew<vtkStructuredGrid> grid;
      grid->SetDimensions(size + 1, size + 1, 1);
      set = grid.Get();
    }
    else
    {
      vtkNew<vtkCellArray> quads;
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
      {
        image->GetCellPoints(cell, ids);
        const vtkIdType corners[] = { ids->GetId(0), ids->GetId(1), ids->GetId(3), ids->GetId(2) };
        quads->InsertNextCell(4, corners);
      }
      vtkNew<vtkPolyData> data;
      data->SetPolys(quads);
      set = data.Get();
    }
    set->SetPoints(points);
    set->GetPointData()->ShallowCopy(image->GetPointData());
    return set;
  };
  const auto run = [&](vtkDataSet* data, int skipped, const char* counter)
  {
    const Extraction extraction = ExtractIntervals(data, { { -1, 0.5 }, { 0.5, 2 } });
    check.Near(SumAreas(extraction.Volume), size * size - skipped, 1e-13, "area");
    check.Equal(extraction.Report->GetCount(counter), skipped, counter);
    check.Equal(extraction.Report->GetCount("Cells"), size * size, "cells");
    check.Equal(
      extraction.Report->GetCount("CellsWithOutput"), size * size - skipped, "with output");
  };
  const vtkIdType inner = 2 * (size + 1) + 2;
  for (int form = 0; form < 3; ++form)
  {
    const std::string name = form == 0 ? "image" : form == 1 ? "structured grid" : "polygons";
    for (const unsigned char type : { vtkDataSetAttributes::HIDDENCELL,
           vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::REFINEDCELL })
    {
      check.SetContext(name + ", ghost type " + std::to_string(type));
      auto data = make(form);
      SetGhost(data->GetCellData(), size * size, 7, type);
      run(data, 1, "BlankedCells");
    }
    check.SetContext(name + ", hidden point");
    auto data = make(form);
    SetGhost(
      data->GetPointData(), data->GetNumberOfPoints(), inner, vtkDataSetAttributes::HIDDENPOINT);
    run(data, 4, "BlankedCells");
    for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
    {
      check.SetContext(name + ", a value of " + std::to_string(bad));
      auto other = make(form);
      other->GetPointData()->GetScalars()->SetComponent(inner, 0, bad);
      run(other, 4, "NonFiniteCells");
    }
  }
  check.SetContext("a coordinate is NaN");
  auto data = make(2);
  vtkPointSet::SafeDownCast(data)->GetPoints()->SetPoint(inner, 0, std::nan(""), 0);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(data);
  filter->SetInterval(0, -1, 2);
  check.Contains(WarningsOf(filter), "4 cells are skipped because a corner has a NaN");
  check.Near(SumAreas(filter->GetOutput()), size * size - 4, 1e-13, "area");
  check.Equal(filter->GetReport()->GetCount("NonFiniteCells"), 4, "cells");
}

void CheckArrays(Check& check)
{
  check.SetContext("arrays");
  auto plane = MakePlane(6, 2);
  AddLinearField(plane, { 0, { 0.1, 0.2, 0 } }, "g");
  AddRandomField(plane, 3);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("number");
  for (vtkIdType cell = 0; cell < plane->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(100 + cell);
  }
  plane->GetCellData()->AddArray(numbers);
  vtkNew<vtkIntervalVolume> filter;
  Configure(filter, plane);
  filter->GenerateOriginArraysOn();
  filter->Update();
  for (int port = 0; port < 2; ++port)
  {
    vtkUnstructuredGrid* output = GetPort(filter, port);
    check.That(output->GetNumberOfCells() > 0, "there are cells");
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      const vtkIdType origin = GetInteger(output, "OriginCell", cell);
      check.Equal(GetInteger(output, "number", cell), 100 + origin, "array of the input cell");
      double bounds[6];
      plane->GetCellBounds(origin, bounds);
      for (const vtkIdType id : GetIds(output, cell))
      {
        const double* x = output->GetPoint(id);
        for (int axis = 0; axis < 2; ++axis)
        {
          check.That(x[axis] >= bounds[2 * axis] - 1e-12 && x[axis] <= bounds[2 * axis + 1] + 1e-12,
            "the input cell contains the output cell");
        }
        check.Near(output->GetPointData()->GetArray("g")->GetComponent(id, 0),
          0.1 * x[0] + 0.2 * x[1], 1e-14, "interpolated array", 1);
      }
    }
  }
  check.That(filter->GetOutput()->GetPointData()->GetScalars() ==
      filter->GetOutput()->GetPointData()->GetArray("f"),
    "active scalars");
  check.SetContext("precision");
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  AddRandomField(image, 1);
  for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION,
         vtkAlgorithm::DEFAULT_PRECISION })
  {
    vtkNew<vtkIntervalVolume> other;
    Configure(other, image);
    other->SetOutputPointsPrecision(precision);
    other->Update();
    check.Equal(other->GetOutput()->GetPoints()->GetDataType(),
      precision == vtkAlgorithm::DOUBLE_PRECISION ? VTK_DOUBLE : VTK_FLOAT, "type of the points");
  }
}

/// Repeated executions use an index and a converted grid, and equal the first one.
void CheckUpdates(Check& check)
{
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 12, 12, 12 });
  AddLinearField(mesh, { 0, { 0.01, 0.02, 0.05 } });
  auto border = GetBorder(mesh);
  border->GetPointData()->ShallowCopy(mesh->GetPointData());
  vtkNew<vtkImageData> image;
  image->SetDimensions(60, 50, 1);
  AddRandomField(image, 3);
  const std::vector<vtkSmartPointer<vtkDataSet>> inputs = { border, image.Get(), MakePlane(20, 1),
    Combine(mesh, border) };
  AddRandomField(inputs[2], 1);
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    check.SetContext("input " + std::to_string(i));
    vtkNew<vtkIntervalVolume> filter;
    Configure(filter, inputs[i]);
    for (const double lower : { 0.2, 0.35, 0.1, 0.4 })
    {
      filter->SetInterval(0, lower, 0.5);
      filter->Update();
      vtkNew<vtkIntervalVolume> fresh;
      Configure(fresh, inputs[i]);
      fresh->SetInterval(0, lower, 0.5);
      fresh->UseValueIndexOff();
      fresh->Update();
      for (int port = 0; port < 2; ++port)
      {
        check.That(
          GetDigest(GetPort(filter, port)) == GetDigest(GetPort(fresh, port)), "same output");
      }
      // Random fields have no cells to skip.
      const vtkIdType visited = filter->GetReport()->GetCount("CellsVisited");
      check.That(
        lower != 0.4 || i == 1 || i == 2 || visited < fresh->GetReport()->GetCount("CellsVisited"),
        "the index skips cells");
    }
  }
}

void CheckMessages(Check& check)
{
  check.SetContext("messages");
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  AddLinearField(sphere->GetOutput(), { 0, { 1, 0, 0 } });
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(sphere->GetOutput());
  filter->SetInterval(0, -9, 9);
  filter->SetSurfaceCells(vtkIntervalVolume::NEVER);
  check.Contains(WarningsOf(filter), "cells is three-dimensional");
  check.Equal(filter->GetReport()->GetCount("LowerDimensionalCells"),
    sphere->GetOutput()->GetNumberOfCells(), "skipped cells");
  filter->SetSurfaceCells(vtkIntervalVolume::WITHOUT_SOLIDS);
  check.That(WarningsOf(filter).empty(), "no warning");
  MeshBuilder builder;
  builder.AddPoint(0, 0, 0);
  builder.AddPoint(1, 0, 0);
  builder.AddCell(VTK_LINE, { 0, 1 });
  auto line = builder.GetMesh();
  AddLinearField(line, { 0, { 1, 0, 0 } });
  filter->SetInputData(line);
  check.Contains(WarningsOf(filter), "none of the input's 1 cells is two- or three-dimensional");
  check.Equal(filter->GetReport()->GetCount("LowerDimensionalCells"), 1, "skipped line");
  // The cells of a flat image are extracted as polygons, in the order of the global ids.
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 1);
  AddLinearField(image, { 0, { 1, 0, 0 } });
  vtkNew<vtkDoubleArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfTuples(9);
  ids->FillValue(1);
  image->GetPointData()->SetGlobalIds(ids);
  filter->SetInputData(image);
  check.Contains(CaptureErrors(filter, [&] { filter->Update(); }), "integers are needed");
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells after an error");
}

void CheckThreadsAndProgress(Check& check)
{
  auto border = GetBorder(MakeMesh(MeshKind::Hexahedra, { 20, 20, 20 }));
  AddRandomField(border, 5);
  vtkNew<vtkImageData> image;
  image->SetDimensions(1, 150, 100);
  AddIntegerField(image, 4, 5);
  const auto plane = MakePlane(60, 3);
  AddRandomField(plane, 1);
  auto boxes = MakeMesh(MeshKind::Hexahedra, { 12, 12, 12 });
  AddRandomField(boxes, 6);
  auto faces = GetBorder(boxes);
  const std::vector<vtkSmartPointer<vtkDataSet>> inputs = { border, image.Get(), plane,
    Combine(boxes, faces) };
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    CheckThreads(
      "input " + std::to_string(i),
      [&]
      {
        const Extraction extraction = ExtractIntervals(
          inputs[i], { { 0.2, 0.4 }, { 0.4, 1 }, { 1, 2 } }, vtkIntervalVolume::ALWAYS);
        return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ extraction.Volume,
          extraction.Surface };
      },
      check);
    check.SetContext("progress of input " + std::to_string(i));
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInterval(0, 0.2, 1.5);
    filter->SetSurfaceCells(vtkIntervalVolume::ALWAYS);
    if (i < 3)
    {
      CheckProgress(filter, inputs[i], VTK_TRIANGLE, check);
      continue;
    }
    ProgressWatch watch;
    filter->SetInputData(inputs[i]);
    const unsigned long tag = ObserveProgress(filter, watch);
    filter->Update();
    CheckMonotonicProgress(watch, 6, check);
    const vtkIdType all = filter->GetOutput()->GetNumberOfCells();
    check.That(all > 0, "output");
    // An abort at any time leaves no output, or a complete one.
    for (const double at : { 0.1, 0.6, 0.9 })
    {
      watch = ProgressWatch();
      watch.AbortAt = at;
      filter->Modified();
      filter->Update();
      const vtkIdType left = filter->GetOutput()->GetNumberOfCells();
      check.That(left == 0 || (at > 0.8 && left == all), "cells after an abort");
    }
    filter->RemoveObserver(tag);
  }
}

}

int TestIntervalVolumeSurfaces(int, char*[])
{
  return RunChecks({ CheckTiling, CheckTies, CheckFaces, CheckMixed, CheckMixedParts, CheckSkipped,
    CheckArrays, CheckUpdates, CheckMessages, CheckThreadsAndProgress });
}
