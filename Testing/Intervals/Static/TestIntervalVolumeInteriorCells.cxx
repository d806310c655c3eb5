// SPDX-License-Identifier: BSD-3-Clause
// KeepInteriorCells does not change the region: volumes, boundary faces and boundary triangles
// equal the results with tetrahedra only, also if scalars equal bounds. Exactly the cells inside an
// interval are passed, unmodified.
#include "Support/Inputs/DataFiles.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Intervals/ReferenceMatching.h"
#include "Support/Meshes/ReferenceChain.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace
{

using namespace reference;
using Position = std::array<double, 3>;
using Net = std::map<Triangle, int>;
using CellOfInterval = std::pair<vtkIdType, int>;

struct Settings
{
  std::vector<Interval> Intervals;
  std::vector<MatchingCriterion> Criteria;
};

vtkSmartPointer<vtkIntervalVolume> Execute(
  vtkDataObject* data, const Settings& settings, bool keepInteriorCells)
{
  auto filter = vtkSmartPointer<vtkIntervalVolume>::New();
  filter->SetInputDataObject(data);
  for (size_t i = 0; i < settings.Intervals.size(); ++i)
  {
    filter->SetInterval(static_cast<int>(i), settings.Intervals[i][0], settings.Intervals[i][1]);
  }
  for (const MatchingCriterion& one : settings.Criteria)
  {
    filter->AddCriterion(one.Array.c_str(), one.Lower, one.Upper);
  }
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->GenerateBoundariesOn();
  filter->GenerateOriginArraysOn();
  filter->WarnOnEmptyOutputOff();
  filter->SetKeepInteriorCells(keepInteriorCells);
  filter->Update();
  return filter;
}

Extraction Run(vtkDataSet* data, const Settings& settings, bool keepInteriorCells)
{
  const auto filter = Execute(data, settings, keepInteriorCells);
  return { filter->GetOutput(), vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1)),
    filter->GetReport() };
}

vtkIdType CellArray(vtkUnstructuredGrid* grid, const char* name, vtkIdType cell)
{
  return static_cast<vtkIdType>(grid->GetCellData()->GetArray(name)->GetComponent(cell, 0));
}

/// Returns the faces of a cell as rings of point ids, either all oriented outward or all inward.
std::vector<std::vector<vtkIdType>> RingsOf(vtkCell* cell)
{
  std::vector<std::vector<vtkIdType>> faces;
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
  {
    vtkCell* face = cell->GetFace(f);
    std::vector<vtkIdType> ring(face->GetPointIds()->begin(), face->GetPointIds()->end());
    if (face->GetCellType() == VTK_PIXEL)
    {
      std::swap(ring[2], ring[3]);
    }
    faces.push_back(ring);
  }
  return faces;
}

/// The boundary faces and the volume of each interval of an output. Faces shared by two cells of an
/// interval cancel out. Points are identified by their coordinates, so that two outputs can be
/// compared.
class Region
{
public:
  Region(const Extraction& extraction, int intervals, vtkDataSet* input,
    std::map<Position, vtkIdType>& positions)
    : Grid(extraction.Volume)
    , Faces(intervals)
    , Volumes(intervals, 0.0L)
  {
    vtkDataArray* global = input->GetPointData()->GetGlobalIds();
    vtkDataArray* origins = this->Grid->GetPointData()->GetArray("OriginPoints");
    for (vtkIdType p = 0; p < this->Grid->GetNumberOfPoints(); ++p)
    {
      Position position;
      this->Grid->GetPoint(p, position.data());
      this->Names.push_back(
        positions.emplace(position, static_cast<vtkIdType>(positions.size())).first->second);
      this->Order.push_back(global && origins
          ? global->GetComponent(static_cast<vtkIdType>(origins->GetComponent(p, 0)), 0)
          : static_cast<double>(p));
    }
    for (vtkIdType cell = 0; cell < this->Grid->GetNumberOfCells(); ++cell)
    {
      this->Add(cell, static_cast<int>(CellArray(this->Grid, "IntervalId", cell)));
    }
  }

  const Net& GetFaces(int interval) const { return this->Faces[interval]; }
  double GetVolume(int interval) const { return static_cast<double>(this->Volumes[interval]); }

private:
  std::array<long double, 3> GetPoint(vtkIdType p) const
  {
    const double* x = this->Grid->GetPoint(p);
    return { { x[0], x[1], x[2] } };
  }

  void Add(vtkIdType cell, int interval)
  {
    if (this->Grid->GetCellType(cell) == VTK_TETRA)
    {
      vtkNew<vtkIdList> p;
      this->Grid->GetCellPoints(cell, p);
      const Tetrahedron ids{ { p->GetId(0), p->GetId(1), p->GetId(2), p->GetId(3) } };
      for (const auto& face : FacesOf({ ids }))
      {
        this->AddFace(interval, face.Key, face.Sign);
      }
      this->Volumes[interval] += this->SixthOf({ { ids[0], ids[1], ids[2] } }, ids[3]);
      return;
    }
    const std::vector<Triangle> triangles = this->CutFaces(this->Grid->GetCell(cell));
    const vtkIdType apex = triangles[0][0];
    long double volume = 0;
    for (const Triangle& triangle : triangles)
    {
      volume += this->SixthOf(triangle, apex);
    }
    // An outward triangle is clockwise as seen from the inside.
    for (const Triangle& triangle : triangles)
    {
      this->AddFace(interval, triangle, volume < 0 ? 1 : -1);
    }
    this->Volumes[interval] += std::abs(volume);
  }

  long double SixthOf(const Triangle& t, vtkIdType apex) const
  {
    return Determinant(this->GetPoint(t[0]), this->GetPoint(t[1]), this->GetPoint(t[2]),
             this->GetPoint(apex)) /
      6;
  }

  /// Triangulates each face as a fan from its first point in the global order.
  std::vector<Triangle> CutFaces(vtkCell* cell) const
  {
    std::vector<Triangle> triangles;
    for (const std::vector<vtkIdType>& ring : RingsOf(cell))
    {
      const size_t first =
        std::min_element(ring.begin(), ring.end(),
          [this](vtkIdType a, vtkIdType b) { return this->Order[a] < this->Order[b]; }) -
        ring.begin();
      const size_t n = ring.size();
      for (size_t i = 1; i + 1 < n; ++i)
      {
        triangles.push_back({ { ring[first], ring[(first + i) % n], ring[(first + i + 1) % n] } });
      }
    }
    return triangles;
  }

  void AddFace(int interval, const Triangle& ids, int sign)
  {
    const OrientedSimplex<3> face(
      Triangle{ { this->Names[ids[0]], this->Names[ids[1]], this->Names[ids[2]] } });
    int& net = this->Faces[interval][face.Key];
    net += sign * face.Sign;
    if (net == 0)
    {
      this->Faces[interval].erase(face.Key);
    }
  }

  vtkUnstructuredGrid* Grid;
  std::vector<vtkIdType> Names;
  std::vector<double> Order;
  std::vector<Net> Faces;
  std::vector<long double> Volumes;
};

/// Returns the cells that are entirely inside an interval and are not tetrahedra.
std::set<CellOfInterval> CellsInside(vtkDataSet* data, const std::vector<Interval>& intervals)
{
  std::set<CellOfInterval> inside;
  vtkDataArray* values = data->GetPointData()->GetScalars();
  vtkUnsignedCharArray* ghosts = data->GetCellGhostArray();
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (data->GetCellType(cell) == VTK_TETRA || (ghosts && ghosts->GetValue(cell)))
    {
      continue;
    }
    data->GetCellPoints(cell, ids);
    for (size_t i = 0; i < intervals.size(); ++i)
    {
      const Interval& bounds = intervals[i];
      const bool isOpen = bounds[0] < bounds[1] &&
        std::any_of(intervals.begin(), intervals.end(),
          [&](const Interval& other) { return other[0] == bounds[1] && other[0] < other[1]; });
      if (std::all_of(ids->begin(), ids->end(),
            [&](vtkIdType id)
            {
              const double value = values->GetComponent(id, 0);
              return value >= bounds[0] && (isOpen ? value < bounds[1] : value <= bounds[1]);
            }))
      {
        inside.emplace(cell, static_cast<int>(i));
      }
    }
  }
  return inside;
}

/// The types of all interior cells that were checked.
std::set<int>& CheckedTypes()
{
  static std::set<int> types;
  return types;
}

/// Checks that interior cells have the points, the point order and the type of the input cells.
void CheckCells(vtkDataSet* data, const Extraction& on, const Settings& settings, Check& check)
{
  vtkUnstructuredGrid* grid = on.Volume;
  vtkDataArray* origins = grid->GetPointData()->GetArray("OriginPoints");
  std::set<CellOfInterval> interior;
  long long changed = 0;
  long long numberOfInterior = 0;
  vtkNew<vtkIdList> before;
  vtkNew<vtkIdList> after;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_TETRA)
    {
      continue;
    }
    ++numberOfInterior;
    CheckedTypes().insert(grid->GetCellType(cell));
    const vtkIdType origin = CellArray(grid, "OriginCell", cell);
    interior.emplace(origin, static_cast<int>(CellArray(grid, "IntervalId", cell)));
    data->GetCellPoints(origin, before);
    grid->GetCellPoints(cell, after);
    for (vtkIdType& id : *after)
    {
      id = static_cast<vtkIdType>(origins->GetComponent(id, 0));
    }
    std::vector<vtkIdType> ids(before->begin(), before->end());
    std::vector<vtkIdType> found(after->begin(), after->end());
    if (grid->GetCellType(cell) == VTK_POLYHEDRON)
    {
      std::sort(ids.begin(), ids.end());
      std::sort(found.begin(), found.end());
      changed +=
        data->GetCell(origin)->GetNumberOfFaces() != grid->GetCell(cell)->GetNumberOfFaces();
    }
    changed += ids != found || data->GetCellType(origin) != grid->GetCellType(cell) ||
      CellArray(grid, "tag", cell) != origin;
  }
  check.Equal(changed, 0, "interior cells that differ from the input");
  check.Equal(on.Report->GetCount("InteriorCells"), numberOfInterior, "interior cells reported");
  const std::set<CellOfInterval> inside = CellsInside(data, settings.Intervals);
  check.Equal(
    static_cast<long long>(interior.size()), numberOfInterior, "no interior cell is repeated");
  check.That(interior == inside,
    "the interior cells are the cells inside: " + std::to_string(interior.size()) + ", expected " +
      std::to_string(inside.size()));
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_TETRA &&
      interior.count({ CellArray(grid, "OriginCell", cell),
        static_cast<int>(CellArray(grid, "IntervalId", cell)) }))
    {
      check.That(false, "an interior cell is not split into tetrahedra too");
      return;
    }
  }
}

/// Counts nonplanar quadrilaterals of interior cells that have a triangle in common with a
/// tetrahedron of the same interval.
long long CountNonPlanar(vtkUnstructuredGrid* grid)
{
  std::set<std::pair<vtkIdType, Triangle>> cut;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_TETRA)
    {
      grid->GetCellPoints(cell, ids);
      for (const auto& face :
        FacesOf({ { { ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) } } }))
      {
        cut.emplace(CellArray(grid, "IntervalId", cell), face.Key);
      }
    }
  }
  long long number = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_TETRA)
    {
      continue;
    }
    for (const std::vector<vtkIdType>& ring : RingsOf(grid->GetCell(cell)))
    {
      std::array<std::array<long double, 3>, 4> x{};
      for (size_t v = 0; v < 4 && ring.size() == 4; ++v)
      {
        const double* point = grid->GetPoint(ring[v]);
        std::copy_n(point, 3, x[v].begin());
      }
      bool isCut = false;
      for (size_t out = 0; out < 4 && ring.size() == 4; ++out)
      {
        const OrientedSimplex<3> triangle(
          Triangle{ { ring[(out + 1) % 4], ring[(out + 2) % 4], ring[(out + 3) % 4] } });
        isCut |= cut.count({ CellArray(grid, "IntervalId", cell), triangle.Key }) > 0;
      }
      number += isCut && std::abs(Determinant(x[0], x[1], x[2], x[3])) > 1e-9;
    }
  }
  return number;
}

void Compare(vtkDataSet* data, const Settings& settings, Check& check)
{
  vtkNew<vtkIdTypeArray> tags;
  tags->SetName("tag");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    tags->InsertNextValue(cell);
  }
  data->GetCellData()->AddArray(tags);
  const Extraction off = Run(data, settings, false);
  const Extraction on = Run(data, settings, true);
  check.Equal(off.Report->GetCount("InteriorCells"), 0, "interior cells without the option");
  if (off.Volume->GetNumberOfCells() == 0)
  {
    check.Equal(on.Volume->GetNumberOfCells(), 0, "cells of an empty region");
    return;
  }
  std::map<Position, vtkIdType> positions;
  const int intervals = static_cast<int>(settings.Intervals.size());
  const Region tetrahedra(off, intervals, data, positions);
  const size_t known = positions.size();
  const Region interior(on, intervals, data, positions);
  check.Equal(static_cast<long long>(positions.size() - known), 0, "new points");
  const double scale = static_cast<double>(MeshVolume(data));
  for (int i = 0; i < intervals; ++i)
  {
    const std::string name = "interval " + std::to_string(i) + ": ";
    check.That(tetrahedra.GetFaces(i) == interior.GetFaces(i), name + "the same net faces");
    check.Near(interior.GetVolume(i), tetrahedra.GetVolume(i), 1e-12, name + "volume", scale);
  }
  check.That(GeometricSet(off.Surface, { "IntervalId", "BoundarySide", "tag" }) ==
      GeometricSet(on.Surface, { "IntervalId", "BoundarySide", "tag" }),
    "the same boundary triangles");
  if (settings.Criteria.empty())
  {
    CheckCells(data, on, settings, check);
  }
  check.Equal(on.Report->GetCount("NonPlanarFaces"), CountNonPlanar(on.Volume), "nonplanar faces");
}

const std::vector<std::vector<Interval>>& TiedIntervals()
{
  static const std::vector<std::vector<Interval>> all = { { { 1, 2 } }, { { 0, 1 }, { 1, 2 } },
    { { 1, 1 }, { 1, 3 } }, { { 0, 0 }, { 0, 0.5 }, { 0.5, 4 } }, { { 0, 3 }, { 1, 2 } } };
  return all;
}

void CheckMeshes(Check& check)
{
  for (MeshKind kind : AllMeshKinds())
  {
    for (unsigned int seed = 1; seed <= 2; ++seed)
    {
      for (int values : { 2, 3, 5 })
      {
        auto mesh =
          RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 4, 3, 3 }, seed), seed), seed);
        AddIntegerField(mesh, values, seed);
        for (const std::vector<Interval>& intervals : TiedIntervals())
        {
          check.SetContext(GetName(kind) + ", " + std::to_string(values) + " values, seed " +
            std::to_string(seed) + ", " + std::to_string(intervals.size()) + " intervals from " +
            std::to_string(intervals[0][0]));
          Compare(mesh, { intervals, {} }, check);
        }
      }
    }
  }
}

/// Tests wide intervals, which contain most cells entirely. Criteria cut some of these cells.
void CheckCriteria(Check& check)
{
  for (MeshKind kind : { MeshKind::Hexahedra, MeshKind::Voxels, MeshKind::Wedges, MeshKind::Mixed,
         MeshKind::Honeycomb })
  {
    for (unsigned int seed = 1; seed <= 2; ++seed)
    {
      check.SetContext("criteria on " + GetName(kind));
      auto mesh = RenumberPoints(MakeMesh(kind, { 4, 4, 4 }, seed), seed);
      AddIntegerField(mesh, 3, seed + 7, "g");
      AddLinearField(mesh, { 0.1, { 0.3, 0.21, 0.4 } }, "h");
      AddIntegerField(mesh, 3, seed);
      Compare(mesh, { { { 0, 1 }, { 1, 2 } }, { { "h", 0.35, 2.9 } } }, check);
      Compare(mesh, { { { 0, 2 } }, { { "g", 0, 1 }, { "h", 0.35, 2.9 } } }, check);
      Compare(mesh, { { { 1, 2 } }, { { "g", 1, 1 } } }, check);
    }
  }
}

void CheckForms(Check& check)
{
  auto image = MakeImage({ 9, 8, 7 });
  AddLinearField(image, { 0.1, { 0.3, 0.21, 0.4 } }, "h");
  AddIntegerField(image, 3, 4);
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext(form.Name);
    for (const std::vector<Interval>& intervals : TiedIntervals())
    {
      Compare(form.Data, { intervals, {} }, check);
    }
    check.SetContext("a criterion on " + form.Name);
    Compare(form.Data, { { { 0, 1 }, { 1, 2 } }, { { "h", 0.35, 2.9 } } }, check);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(form.Data->GetNumberOfCells());
    ghosts->FillValue(0);
    for (vtkIdType cell : { 3, 77, 78, 200, 301 })
    {
      ghosts->SetValue(cell, vtkDataSetAttributes::DUPLICATECELL);
    }
    form.Data->GetCellData()->AddArray(ghosts);
    check.SetContext(form.Name + " with ghosts");
    Compare(form.Data, { { { 0, 1 }, { 1, 2 } }, {} }, check);
  }
}

void CheckRealData(Check& check)
{
  for (const std::string& name : GetTiedVolumeFileNames())
  {
    auto image = CropVolume(*interlume::ReadData(name), 20, 0);
    const std::vector<double> values = GetQuantiles(*image);
    for (size_t i = 0; i + 1 < values.size(); ++i)
    {
      check.SetContext(name + ", from " + std::to_string(values[i]));
      Compare(
        image, { { { values[i], values[i + 1] }, { values[i + 1], values.back() } }, {} }, check);
    }
    check.SetContext(name + ", one value");
    Compare(image, { { { values[0], values[0] } }, {} }, check);
  }
}

/// Moves all points slightly, so that almost no face remains planar.
void MovePoints(vtkUnstructuredGrid* mesh, std::mt19937& random)
{
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    for (double& coordinate : x)
    {
      coordinate += 0.02 * std::generate_canonical<double, 32>(random);
    }
    mesh->GetPoints()->SetPoint(p, x);
  }
  mesh->GetPoints()->Modified();
}

/// Global ids determine the order of points, with planar and with nonplanar faces.
void CheckOrder(Check& check)
{
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    auto mesh = RenumberPoints(MakeMesh(MeshKind::Mixed, { 4, 4, 4 }, seed), seed);
    AddIntegerField(mesh, 3, seed);
    std::mt19937 random(seed);
    std::vector<vtkIdType> order(mesh->GetNumberOfPoints());
    for (size_t p = 0; p < order.size(); ++p)
    {
      order[p] = 5 * static_cast<vtkIdType>(p) + 3;
    }
    std::shuffle(order.begin(), order.end(), random);
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("ids");
    for (vtkIdType id : order)
    {
      ids->InsertNextValue(id);
    }
    mesh->GetPointData()->SetGlobalIds(ids);
    check.SetContext("global ids");
    Compare(mesh, { { { 0, 1 }, { 1, 2 } }, {} }, check);
    MovePoints(mesh, random);
    check.SetContext("nonplanar faces");
    Compare(mesh, { { { 0, 1 }, { 1, 2 } }, {} }, check);
  }
}

/// Two hexahedra share a nonplanar face. The face is counted if one hexahedron is interior and the
/// other is cut.
void CheckNonPlanarFaces(Check& check)
{
  MeshBuilder builder;
  for (int p = 0; p < 12; ++p)
  {
    builder.AddPoint(p / 4 + (p == 6 ? 0.1 : 0.0), p % 4 == 1 || p % 4 == 2, p % 4 >= 2);
  }
  builder.AddCell(VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
  builder.AddCell(VTK_HEXAHEDRON, { 4, 5, 6, 7, 8, 9, 10, 11 });
  auto mesh = builder.GetMesh();
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (int p = 0; p < 12; ++p)
  {
    values->InsertNextValue(p / 4);
  }
  mesh->GetPointData()->SetScalars(values);
  check.SetContext("two hexahedra");
  check.Near(Run(mesh, { { { 0, 1.5 } }, {} }, true).Report->GetNumber("NonPlanarFaces"), 1, 0.0,
    "nonplanar faces");
  check.Equal(Run(mesh, { { { 0, 2 } }, {} }, true).Report->GetCount("NonPlanarFaces"), 0,
    "between interior cells");
  check.Near(Run(mesh, { { { 0, 1 }, { 1, 1.5 } }, {} }, true).Report->GetNumber("NonPlanarFaces"),
    0, 0.0, "between cut cells");
  // In the cut cell, every triangle of the common face that contains the raised point belongs to a
  // tetrahedron.
  for (int raised = 4; raised < 8; ++raised)
  {
    for (int p = 0; p < 12; ++p)
    {
      values->SetValue(p, p < 4 || p == raised ? 2 : p < 8 ? 1 : 0);
    }
    values->Modified();
    check.Equal(Run(mesh, { { { 1, 2 } }, {} }, true).Report->GetCount("NonPlanarFaces"), 1,
      "nonplanar faces, all points tied except corner " + std::to_string(raised));
  }
}

/// Tests meshes with nonplanar faces. Faces between interior cells are not counted, but faces
/// between an interior cell and a cut cell are.
void CheckNonPlanarMeshes(Check& check)
{
  std::mt19937 random(5);
  for (MeshKind kind :
    { MeshKind::Hexahedra, MeshKind::Wedges, MeshKind::Pyramids, MeshKind::Boxes, MeshKind::Mixed })
  {
    auto mesh = MakeMesh(kind, { 6, 6, 6 }, 1);
    AddLinearField(mesh, { 0.0, { 0.1, 0.07, 0.03 } });
    MovePoints(mesh, random);
    double nonPlanar = 0.0;
    for (const Settings& settings :
      { Settings{ { { 0.4, 1.0 } }, {} }, Settings{ { { 0.2, 0.7 }, { 0.7, 1.1 } }, {} } })
    {
      check.SetContext("nonplanar " + GetName(kind));
      Compare(mesh, settings, check);
      nonPlanar += Run(mesh, settings, true).Report->GetNumber("NonPlanarFaces");
    }
    check.That(nonPlanar > 0, "there are nonplanar faces");
  }
}

/// The blocks of a composite input yield the same results as separate inputs.
void CheckComposite(Check& check)
{
  auto image = MakeImage({ 5, 4, 4 });
  AddIntegerField(image, 3, 1);
  auto mixed = MakeMesh(MeshKind::Mixed, { 4, 3, 3 }, 1);
  AddIntegerField(mixed, 3, 2);
  auto honeycomb = MakeMesh(MeshKind::Honeycomb, { 4, 3, 3 }, 1);
  AddLinearField(honeycomb, { 0.1, { 0.1, 0.07, 0.1 } });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, mixed);
  blocks->SetBlock(3, honeycomb);
  const Settings settings = { { { 0, 1 }, { 1, 2 } }, {} };
  const auto filter = Execute(blocks, settings, true);
  long long interior = 0;
  for (unsigned int block : { 0U, 1U, 3U })
  {
    check.SetContext("block " + std::to_string(block));
    const Extraction expected =
      Run(vtkDataSet::SafeDownCast(blocks->GetBlock(block)), settings, true);
    vtkUnstructuredGrid* const ports[] = { expected.Volume, expected.Surface };
    for (int port = 0; port < 2; ++port)
    {
      auto* found = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
      const std::string difference =
        FindDifference(vtkUnstructuredGrid::SafeDownCast(found->GetBlock(block)), ports[port]);
      check.That(difference.empty(), difference);
    }
    check.That(expected.Report->GetNumber("InteriorCells") > 0, "some cells are interior");
    interior += expected.Report->GetCount("InteriorCells");
  }
  check.Equal(
    filter->GetReport()->GetCount("InteriorCells"), interior, "interior cells of all blocks");
}

void CheckManyThreads(Check& check)
{
  auto image = MakeImage({ 40, 40, 40 });
  AddLinearField(image, { 0.0, { 0.1, 0.07, 0.03 } });
  auto mesh = MakeMesh(MeshKind::Mixed, { 16, 16, 16 });
  AddLinearField(mesh, { 0.0, { 0.1, 0.07, 0.03 } });
  vtkDataSet* const inputs[] = { image, mesh };
  for (vtkDataSet* data : inputs)
  {
    double range[2];
    data->GetPointData()->GetScalars()->GetRange(range);
    const double width = range[1] - range[0];
    const Settings settings = { { { range[0] + 0.2 * width, range[0] + 0.5 * width },
                                  { range[0] + 0.5 * width, range[0] + 0.9 * width } },
      {} };
    CheckThreads(
      std::string("interior cells of ") + data->GetClassName(),
      [&]
      {
        const Extraction on = Run(data, settings, true);
        return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ on.Volume, on.Surface };
      },
      check);
  }
}

}

int TestIntervalVolumeInteriorCells(int, char*[])
{
  Check check;
  CheckNonPlanarFaces(check);
  CheckMeshes(check);
  CheckForms(check);
  CheckCriteria(check);
  CheckOrder(check);
  CheckNonPlanarMeshes(check);
  CheckRealData(check);
  CheckComposite(check);
  CheckManyThreads(check);
  check.SetContext("all");
  check.That(CheckedTypes() ==
      std::set<int>{ VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID, VTK_POLYHEDRON },
    "every cell type occurs as an interior cell");
  return check.Result();
}
