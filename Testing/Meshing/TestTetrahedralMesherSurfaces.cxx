// SPDX-License-Identifier: BSD-3-Clause
// Closed surfaces: the tetrahedra fill the enclosed space up to rounding error, also for nested
// shells.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkInterlumeReport.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTetrahedralMesher.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <numeric>

namespace
{

using namespace reference;

vtkSmartPointer<vtkUnstructuredGrid> MeshOf(vtkDataSet* surface, bool fill = false)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(surface);
  mesher->SetFillNestedShells(fill);
  mesher->Update();
  return mesher->GetOutput();
}

void CheckVolume(vtkUnstructuredGrid* mesh, long double volume, Check& check)
{
  const TetrahedraReport report = Inspect(mesh);
  check.That(report.Tetrahedra > 0, "there are tetrahedra");
  check.Equal(report.NotPositive, 0, "every tetrahedron is positive");
  check.Equal(report.FacesTooOften + report.FacesTurned, 0, "tetrahedra match at their faces");
  check.Equal(report.UnusedPoints, 0, "every point is used");
  check.Near(report.Volume, volume, 1e-12, "volume");
  check.Near(report.BoundaryVolume, volume, 1e-12, "volume within the outer faces");
}

/// Returns the volume per value of RegionId.
std::map<int, long double> RegionVolumes(vtkUnstructuredGrid* mesh)
{
  std::map<int, long double> volumes;
  vtkDataArray* regions = mesh->GetCellData()->GetArray("RegionId");
  for (vtkIdType t = 0; regions && t < mesh->GetNumberOfCells(); ++t)
  {
    vtkNew<vtkUnstructuredGrid> one;
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(t, ids);
    double x[4][3];
    for (int i = 0; i < 4; ++i)
    {
      mesh->GetPoint(ids->GetId(i), x[i]);
    }
    double e[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(x[i + 1], x[0], e[i]);
    }
    volumes[static_cast<int>(regions->GetComponent(t, 0))] +=
      vtkMath::Determinant3x3(e[0], e[1], e[2]) / 6;
  }
  return volumes;
}

void CheckRegions(vtkUnstructuredGrid* mesh, const std::vector<double>& expected, Check& check)
{
  const auto volumes = RegionVolumes(mesh);
  check.Equal(
    static_cast<long long>(volumes.size()), static_cast<long long>(expected.size()), "regions");
  for (std::size_t r = 0; r < expected.size(); ++r)
  {
    const auto found = volumes.find(static_cast<int>(r));
    check.Near(found == volumes.end() ? 0.0 : static_cast<double>(found->second), expected[r],
      1e-12, "volume of region " + std::to_string(r));
  }
}

void CheckSources(Check& check)
{
  check.SetContext("cube source, each corner three times");
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2.0);
  cube->Update();
  CheckVolume(MeshOf(cube->GetOutput()), 2.0L, check);

  check.SetContext("sphere");
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  sphere->Update();
  CheckVolume(MeshOf(sphere->GetOutput()), EnclosedVolume(sphere->GetOutput()), check);

  check.SetContext("sphere far from the origin");
  sphere->SetCenter(1e4, -2e4, 3e4);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  CheckVolume(MeshOf(sphere->GetOutput()), EnclosedVolume(sphere->GetOutput()), check);

  check.SetContext("torus");
  auto torus = MakeTorus(30, 16);
  const long double volume = EnclosedVolume(torus);
  check.That(volume > 0, "the torus faces outward");
  CheckVolume(MeshOf(torus), volume, check);

  check.SetContext("strips");
  vtkNew<vtkStripper> strips;
  strips->SetInputData(torus);
  strips->Update();
  check.That(strips->GetOutput()->GetNumberOfStrips() > 0, "there are strips");
  CheckVolume(MeshOf(strips->GetOutput()), volume, check);
}

void CheckConcavePolygons(Check& check)
{
  check.SetContext("an L of concave polygons");
  auto surface = MakeEmptySurface();
  const double ring[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  for (int k = 0; k < 2; ++k)
  {
    for (const auto& x : ring)
    {
      surface->GetPoints()->InsertNextPoint(x[0], x[1], k);
    }
  }
  surface->GetPolys()->InsertNextCell({ 5, 4, 3, 2, 1, 0 });
  surface->GetPolys()->InsertNextCell({ 6, 7, 8, 9, 10, 11 });
  for (vtkIdType i = 0; i < 6; ++i)
  {
    const vtkIdType j = (i + 1) % 6;
    surface->GetPolys()->InsertNextCell({ i, j, 6 + j, 6 + i });
  }
  CheckVolume(MeshOf(surface), 3.0L, check);
}

void CheckShells(Check& check)
{
  for (bool inward : { false, true })
  {
    check.SetContext(inward ? "shells facing in and out" : "shells facing out");
    auto boxes = MakeEmptySurface();
    AppendBox(boxes, { 1, 1, 1 }, { 9, 9, 9 }, inward);
    AppendBox(boxes, { 0, 0, 0 }, { 10, 10, 10 });
    AppendBox(boxes, { 20, 0, 0 }, { 21, 1, 1 });
    AppendBox(boxes, { 2, 2, 2 }, { 4, 4, 4 });
    AppendBox(boxes, { 6, 6, 6 }, { 7, 7, 7 }, inward);
    auto cavities = MeshOf(boxes);
    // Regions are numbered by the first polygon on their boundary, outer regions first. The space
    // of volume 512 - 8 - 1 is a cavity unless nested shells are filled.
    CheckRegions(cavities, { 1000 - 512, 1, 8, 1 }, check);
    CheckVolume(cavities, 1000 - 512 + 1 + 8 + 1, check);
    auto filled = MeshOf(boxes, true);
    CheckRegions(filled, { 1000 - 512, 512 - 8 - 1, 1, 8, 1 }, check);
    CheckVolume(filled, 1001.0L, check);
  }
}

void CheckWalls(Check& check)
{
  check.SetContext("boxes that share a wall");
  auto boxes = MakeEmptySurface();
  AppendBox(boxes, { 0, 0, 0 }, { 1, 1, 1 });
  AppendBox(boxes, { 1, 0, 0 }, { 3, 1, 1 });
  auto mesh = MeshOf(boxes);
  CheckRegions(mesh, { 1, 2 }, check);
  CheckVolume(mesh, 3.0L, check);
}

using Corner = std::array<double, 3>;

/// Boxes that touch, with the expected numbers of split triangles and added points.
struct Contact
{
  const char* Name;
  std::vector<std::array<Corner, 2>> Boxes;
  vtkIdType SplitTriangles;
  vtkIdType AddedPoints;
};

/// Rotates \a surface. Its coordinates become inexact, so that coincident planes of two parts
/// differ by rounding errors.
void Rotate(vtkPolyData* surface)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(0.1, 0.2, 0.3);
  transform->RotateWXYZ(33.0, 1.0, 2.0, 3.0);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  transform->TransformPoints(surface->GetPoints(), points);
  surface->SetPoints(points);
}

/// Touching parts that share no points or edges are split where they touch. Each part retains its
/// region and its volume.
void CheckContacts(Check& check)
{
  std::vector<std::array<Corner, 2>> blocks;
  for (int i = 0; i < 27; ++i)
  {
    const Corner low{ { 1.0 * (i % 3), 1.0 * (i / 3 % 3), 1.0 * (i / 9) } };
    blocks.push_back({ { low, { { low[0] + 1, low[1] + 1, low[2] + 1 } } } });
  }
  const Contact contacts[] = {
    { "a cube on a face",
      { { { { 0, 0, 0 }, { 1, 1, 1 } } }, { { { .25, .25, 1 }, { .75, .75, 2 } } } }, 4, 0 },
    { "faces that overlap",
      { { { { 0, 0, 0 }, { 1, 1, 1 } } }, { { { .3, .4, 1 }, { 1.3, 1.4, 2 } } } }, 8, 4 },
    { "faces that cross", { { { { 0, 0, 0 }, { 3, 1, 1 } } }, { { { 1, -1, 1 }, { 2, 2, 2 } } } },
      8, 9 },
    { "half a side", { { { { 0, 0, 0 }, { 1, 1, 1 } } }, { { { 1, 0, 0 }, { 2, .5, 1 } } } }, 7,
      1 },
    { "a section of an edge",
      { { { { 0, 0, 0 }, { 1, 1, 1 } } }, { { { 1, 1, .5 }, { 2, 2, 1.5 } } } }, 4, 0 },
    { "three along an edge",
      { { { { 0, 0, 0 }, { 1, 1, 1 } } }, { { { 1, 0, 0 }, { 2, 1, .7 } } },
        { { { 0, 0, 1 }, { 2, 1, 2 } } } },
      13, 2 },
    { "a block between others", blocks, 0, 0 },
    { "rounding",
      { { { { 0, 0, 0 }, { .3, .3, .3 } } }, { { { .05, .05, .1 + .2 }, { .2, .2, .5 } } } }, 4,
      0 },
  };
  for (const Contact& contact : contacts)
  {
    for (bool isTurned : { false, true })
    {
      check.SetContext(contact.Name + std::string(isTurned ? ", rotated" : ""));
      auto surface = MakeEmptySurface();
      std::vector<double> volumes;
      for (const auto& box : contact.Boxes)
      {
        AppendBox(surface, box[0], box[1]);
        volumes.push_back(
          (box[1][0] - box[0][0]) * (box[1][1] - box[0][1]) * (box[1][2] - box[0][2]));
      }
      if (isTurned)
      {
        Rotate(surface);
      }
      AddLinearField(surface, { 0.5, { 1.0, -2.0, 3.0 } });
      vtkNew<vtkTetrahedralMesher> mesher;
      mesher->SetInputData(surface);
      mesher->Update();
      CheckRegions(mesher->GetOutput(), volumes, check);
      CheckVolume(mesher->GetOutput(), std::accumulate(volumes.begin(), volumes.end(), 0.0), check);
      check.That(LinearError(mesher->GetOutput(), "f", { 0.5, { 1.0, -2.0, 3.0 } }) < 1e-12,
        "a linear field is reproduced");
      if (!isTurned)
      {
        check.Equal(mesher->GetReport()->GetCount("SplitTriangles"), contact.SplitTriangles,
          "triangles split");
        check.Equal(
          mesher->GetReport()->GetCount("AddedPoints"), contact.AddedPoints, "points added");
      }
    }
  }
}

/// A cavity filled by another part.
void CheckFilledCavity(Check& check)
{
  check.SetContext("a filled cavity");
  auto boxes = MakeEmptySurface();
  AppendBox(boxes, { -2, -2, -2 }, { 2, 2, 2 });
  AppendBox(boxes, { -1, -1, -1 }, { 1, 1, 1 }, true);
  AppendBox(boxes, { -1, -1, -1 }, { 1, 1, 1 });
  CheckRegions(MeshOf(boxes), { 56, 8 }, check);
  CheckRegions(MeshOf(boxes, true), { 56, 8 }, check);
}

/// A point or an edge of a pyramid lies on the top of a cube.
void CheckPointContacts(Check& check)
{
  for (bool isEdge : { false, true })
  {
    check.SetContext(isEdge ? "an edge on a face" : "a point on a face");
    auto surface = MakeEmptySurface();
    AppendBox(surface, { 0, 0, 0 }, { 1, 1, 1 });
    vtkPoints* points = surface->GetPoints();
    const vtkIdType a = points->InsertNextPoint(0.2, 0.3, 1);
    const vtkIdType b = points->InsertNextPoint(0.8, 0.6, isEdge ? 1 : 2);
    const vtkIdType c = points->InsertNextPoint(0.2, 0.6, 2);
    const vtkIdType d = points->InsertNextPoint(0.9, 0.2, 2);
    surface->GetPolys()->InsertNextCell({ a, b, c });
    surface->GetPolys()->InsertNextCell({ a, d, b });
    surface->GetPolys()->InsertNextCell({ a, c, d });
    surface->GetPolys()->InsertNextCell({ b, d, c });
    const double volume = isEdge ? 0.075 : 0.04;
    CheckRegions(MeshOf(surface), { 1, volume }, check);
    CheckVolume(MeshOf(surface), 1 + volume, check);
  }
}

/// Two coincident walls are triangulated along different diagonals.
void CheckDiagonals(Check& check)
{
  check.SetContext("a wall with other diagonals");
  auto surface = MakeEmptySurface();
  AppendBox(surface, { 0, 0, 0 }, { 1, 1, 1 });
  AppendBox(surface, { 1, 0, 0 }, { 2, 1, 1 });
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < 12; ++cell)
  {
    vtkNew<vtkIdList> quad;
    surface->GetCellPoints(cell, quad);
    const vtkIdType* p = quad->GetPointer(0);
    const int turn = cell == 4 || cell == 11;
    triangles->InsertNextCell({ p[turn], p[turn + 1], p[turn + 2] });
    triangles->InsertNextCell({ p[turn], p[turn + 2], p[(turn + 3) % 4] });
  }
  surface->SetPolys(triangles);
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(surface);
  mesher->Update();
  CheckRegions(mesher->GetOutput(), { 1, 1 }, check);
  CheckVolume(mesher->GetOutput(), 2.0L, check);
}

/// Without SplitContacts, the error names the touching cells: the top of the first cube and the
/// bottom of the second cube.
/// Returns a cube with a triangle without area between two edges (cell 6). \a top is a polygon of
/// the points 4 to 7.
vtkSmartPointer<vtkPolyData> MakeFoldedCube(const std::vector<vtkIdType>& top)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int p = 0; p < 8; ++p)
  {
    points->InsertNextPoint(p & 1, (p >> 1) & 1, p >> 2);
  }
  points->InsertNextPoint(0.5, 0.0, 0.0);
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 2, 3, 1 });
  polygons->InsertNextCell(static_cast<vtkIdType>(top.size()), top.data());
  polygons->InsertNextCell({ 0, 8, 1, 5, 4 });
  polygons->InsertNextCell({ 2, 6, 7, 3 });
  polygons->InsertNextCell({ 0, 4, 6, 2 });
  polygons->InsertNextCell({ 1, 3, 7, 5 });
  polygons->InsertNextCell({ 0, 1, 8 });
  surface->SetPolys(polygons);
  return surface;
}

void CheckFoldedPolygons(Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(MakeFoldedCube({ 4, 5, 7, 5, 7, 6 })); // returns from 7 to 5
  check.Contains(WarningsOf(mesher), "2 faces meet themselves");
  CheckVolume(mesher->GetOutput(), 1.0L, check);
  check.Equal(mesher->GetReport()->GetCount("FoldedFaces"), 2, "faces that meet themselves");
  mesher->SetInputData(MakeFoldedCube({ 4, 5, 7, 6 }));
  mesher->SetSplitContacts(false);
  check.Contains(UpdateAndGetErrors(mesher), "Cell 6 has a triangle without area");
  mesher->SetInputData(MakeFoldedCube({ 4, 5, 6, 7 }));
  check.Contains(
    UpdateAndGetErrors(mesher), "Cell 1 has a polygon that intersects itself (1 in all)");
}

void CheckContactError(Check& check)
{
  check.SetContext("SplitContacts off");
  auto surface = MakeEmptySurface();
  AppendBox(surface, { 0, 0, 0 }, { 1, 1, 1 });
  AppendBox(surface, { 0.25, 0.25, 1 }, { 0.75, 0.75, 2 });
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(surface);
  mesher->SplitContactsOff();
  check.Contains(UpdateAndGetErrors(mesher), "Cells 1 and 6 touch");
  check.Equal(mesher->GetOutput()->GetNumberOfCells(), 0, "cells");
}

void CheckPlanarGrid(Check& check)
{
  check.SetContext("triangles in an unstructured grid");
  auto boxes = MakeEmptySurface();
  AppendBox(boxes, { 0, 0, 0 }, { 1, 2, 3 });
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(boxes->GetPoints());
  grid->SetCells(VTK_QUAD, boxes->GetPolys());
  CheckVolume(MeshOf(grid), 6.0L, check);
}

}

int TestTetrahedralMesherSurfaces(int, char*[])
{
  return RunChecks({ CheckSources, CheckConcavePolygons, CheckShells, CheckWalls, CheckContacts,
    CheckFilledCavity, CheckPointContacts, CheckDiagonals, CheckFoldedPolygons, CheckContactError,
    CheckPlanarGrid });
}
