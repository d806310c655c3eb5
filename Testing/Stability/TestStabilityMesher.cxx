// SPDX-License-Identifier: BSD-3-Clause
// Tests invalid and extreme input of the mesher. Invalid input must give an error and an empty
// output without ending the process, even if TetGen throws, crashes or does not return. Valid input
// must give positive tetrahedra that fill the volume.
#include "StabilityChecks.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTetrahedralMesher.h"
#include "vtkUnstructuredGrid.h"

#include <chrono>
#include <cmath>
#include <random>

namespace
{

using namespace reference;
using namespace stability;

vtkSmartPointer<vtkPolyData> MakeCube()
{
  auto box = MakeEmptySurface();
  AppendBox(box, { 0, 0, 0 }, { 1, 1, 1 });
  return box;
}

/// Reports whether the mesher rejects \a input with an error that contains \a named, and then
/// meshes a cube.
void Refuse(StabilityCatalogue& catalogue, const std::string& name, const std::string& extreme,
  const std::string& named, vtkDataSet* input)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(input);
  ReportRejection(catalogue, mesher, "mesher-" + name, extreme, named.c_str(),
    [&]() { mesher->SetInputDataObject(MakeCube()); });
}

/// Reports whether the mesher meshes \a input with tetrahedra of positive volume, \a volume in
/// total.
void Accept(StabilityCatalogue& catalogue, const std::string& name, const std::string& extreme,
  double volume, double bound, vtkDataSet* input, double quality = 0.0)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetQualityBound(quality);
  mesher->SetInputDataObject(input);
  const std::string errors = UpdateFilter(mesher).Errors;
  const TetrahedraReport report = Inspect(mesher->GetOutput());
  const bool isGood = errors.empty() && report.Tetrahedra > 0 && report.NotPositive == 0 &&
    report.FacesTooOften + report.FacesTurned == 0;
  catalogue.Measure("mesher-" + name, extreme, "positive tetrahedra that fill the volume" + errors,
    isGood ? static_cast<double>(report.Volume / volume - 1) : NaN, bound);
}

void TestSurfaces(StabilityCatalogue& catalogue)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    auto cube = MakeCube();
    double x[3] = { 1, 1, 0 };
    x[axis] = axis == 1 ? Infinity : NaN;
    cube->GetPoints()->SetPoint(3, x);
    Refuse(catalogue, "surface-not-finite-" + std::to_string(axis),
      "a surface with a non-finite coordinate", "Point 3", cube);
  }
  auto open = MakeEmptySurface();
  open->SetPoints(MakeCube()->GetPoints());
  open->GetPolys()->InsertNextCell({ 0, 2, 3, 1 });
  open->GetPolys()->InsertNextCell({ 4, 5, 7, 6 });
  Refuse(catalogue, "surface-open", "two squares of a cube", "open: the edge from point 0", open);

  auto line = MakeCube();
  line->GetPoints()->InsertNextPoint(0.5, 0, 0);
  line->GetPolys()->InsertNextCell({ 0, 8, 1 });
  Accept(catalogue, "surface-line", "a triangle on a line", 1.0, 1e-12, line);

  auto bow = MakeCube();
  bow->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  Refuse(catalogue, "surface-bow", "a self-intersecting polygon", "Cell 6", bow);

  auto crossing = MakeCube();
  AppendBox(crossing, { 0.37, 0.41, 0.43 }, { 1.37, 1.41, 1.43 });
  Refuse(catalogue, "surface-crossing", "two intersecting cubes", "intersects itself", crossing);

  std::mt19937 random(11);
  auto soup = MakeEmptySurface();
  for (vtkIdType t = 0; t < 40; ++t)
  {
    for (int i = 0; i < 4; ++i)
    {
      soup->GetPoints()->InsertNextPoint(random() % 1000, random() % 1000, random() % 1000);
    }
    const vtkIdType p = 4 * t;
    soup->GetPolys()->InsertNextCell({ p, p + 1, p + 2 });
    soup->GetPolys()->InsertNextCell({ p, p + 3, p + 1 });
    soup->GetPolys()->InsertNextCell({ p + 1, p + 3, p + 2 });
    soup->GetPolys()->InsertNextCell({ p + 2, p + 3, p });
  }
  Refuse(catalogue, "surface-soup", "forty random intersecting tetrahedra", "intersects", soup);

  auto missing = MakeCube();
  missing->GetPolys()->InsertNextCell({ 0, 1, 99 });
  Refuse(catalogue, "surface-missing-point", "a triangle with an invalid point id",
    "Cell 6 refers to point 99", missing);

  auto sheet = MakeEmptySurface();
  sheet->SetPoints(MakeCube()->GetPoints());
  sheet->GetPolys()->InsertNextCell({ 0, 2, 3, 1 });
  sheet->GetPolys()->InsertNextCell({ 0, 1, 3, 2 });
  Refuse(catalogue, "surface-sheet", "a square with both orientations", "open", sheet);
}

void TestScales(StabilityCatalogue& catalogue)
{
  for (double scale : { 1e-30, 1e-6, 1e6, 1e30 })
  {
    auto box = MakeEmptySurface();
    AppendBox(box, { 0, 0, 0 }, { scale, 2 * scale, 3 * scale });
    std::ostringstream name;
    name << "scale-" << scale;
    Accept(catalogue, name.str(), "a tiny or huge box", 6 * std::pow(scale, 3), 1e-12, box);
  }
  for (double thin : { 1e-3, 1e-6, 1e-9 })
  {
    auto box = MakeEmptySurface();
    AppendBox(box, { 0, 0, 0 }, { 1, 1, thin });
    std::ostringstream name;
    name << "thin-" << thin;
    Accept(catalogue, name.str(), "a thin plate", thin, 1e-12, box);
  }
  auto far = MakeEmptySurface();
  AppendBox(far, { 1e8, 1e8, 1e8 }, { 1e8 + 1, 1e8 + 1, 1e8 + 1 });
  Accept(catalogue, "far", "a unit cube at 1e8", 1.0, 1e-12, far);
  auto close = MakeCube();
  AppendBox(close, { 1 + 1e-9, 0, 0 }, { 2, 1, 1 });
  Accept(catalogue, "close", "two cubes 1e-9 apart", 2 - 1e-9, 1e-12, close);
  auto corner = MakeCube();
  AppendBox(corner, { 1, 1, 1 }, { 2, 2, 2 });
  Accept(catalogue, "corner", "two cubes that share a corner", 2.0, 1e-12, corner);
  auto edge = MakeCube();
  AppendBox(edge, { 1, 1, 0 }, { 2, 2, 1 });
  Accept(catalogue, "edge", "two cubes that share an edge", 2.0, 1e-12, edge);
}

void TestPoints(StabilityCatalogue& catalogue)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  data->SetPoints(points);
  points->InsertNextPoint(1, 2, 3);
  Refuse(catalogue, "points-one", "one point", "plane", data);
  for (const auto& [j, i] : AllIndices(4, 5))
  {
    points->InsertNextPoint(1 + i, 2 + j, 3);
  }
  Refuse(catalogue, "points-plane", "coplanar points", "plane", data);
  points->InsertNextPoint(1, NaN, 1);
  Refuse(catalogue, "points-nan", "a point with a NaN coordinate", "Point 21", data);
  points->SetPoint(21, 1, 2, 4);
  Accept(catalogue, "points-one-above", "one point above a plane", 12.0 / 3, 1e-12, data);
  vtkNew<vtkPolyData> same;
  vtkNew<vtkPoints> samePoints;
  same->SetPoints(samePoints);
  for (int i = 0; i < 100; ++i)
  {
    samePoints->InsertNextPoint(1, 2, 3);
  }
  Refuse(catalogue, "points-same", "a hundred coincident points", "plane", same);
}

void TestCells(StabilityCatalogue& catalogue)
{
  const std::vector<std::vector<vtkIdType>> cube = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
    { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  const auto make = [](const std::vector<std::vector<vtkIdType>>& faces, double height)
  {
    MeshBuilder builder;
    for (int i = 0; i < 8; ++i)
    {
      builder.AddPoint(i & 1, i >> 1 & 1, height * (i >> 2 & 1));
    }
    builder.AddPolyhedron(faces);
    return builder.GetMesh();
  };
  Accept(catalogue, "cell-cube", "a cube as a polyhedron", 1.0, 1e-12, make(cube, 1));
  auto reversed = cube;
  for (std::size_t f = 0; f < reversed.size(); f += 2)
  {
    std::reverse(reversed[f].begin(), reversed[f].end());
  }
  Accept(catalogue, "cell-turned", "half of the faces reversed", 1.0, 1e-12, make(reversed, 1));
  auto open = cube;
  open.pop_back();
  Refuse(catalogue, "cell-open", "a polyhedron with a missing face", "Cell 0", make(open, 1));
  vtkNew<vtkTetrahedralMesher> flatMesher;
  flatMesher->SetInputDataObject(make(cube, 0));
  ReportEmpty(catalogue, flatMesher, "mesher-cell-flat", "a polyhedron without volume", "no area");
  auto nan = make(cube, 1);
  nan->GetPoints()->SetPoint(5, 0, NaN, 0);
  Refuse(catalogue, "cell-nan", "a cell with a NaN coordinate", "point 5", nan);
  auto crossing = make(cube, 1);
  crossing->GetPoints()->SetPoint(7, -2, -2, -3);
  Refuse(catalogue, "cell-crossing", "a self-intersecting polyhedron", "Cell 0", crossing);

  MeshBuilder inverted;
  for (int i = 0; i < 8; ++i)
  {
    inverted.AddPoint(i & 1, i >> 1 & 1, -(i >> 2 & 1));
  }
  inverted.AddCell(VTK_HEXAHEDRON, { 0, 1, 3, 2, 4, 5, 7, 6 });
  Accept(catalogue, "cell-inverted", "an inverted hexahedron", 1.0, 1e-12, inverted.GetMesh());
  MeshBuilder collapsed;
  for (int i = 0; i < 8; ++i)
  {
    collapsed.AddPoint(i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  collapsed.AddCell(VTK_HEXAHEDRON, { 0, 1, 3, 2, 4, 5, 5, 4 });
  Accept(catalogue, "cell-collapsed", "a hexahedron with a face collapsed to an edge", 0.5, 1e-12,
    collapsed.GetMesh());
  MeshBuilder degenerate;
  degenerate.AddPoint(0, 0, 0);
  degenerate.AddCell(VTK_TETRA, { 0, 0, 0, 0 });
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(degenerate.GetMesh());
  const std::string errors = UpdateFilter(mesher).Errors;
  catalogue.Check("mesher-cell-point", "a tetrahedron collapsed to a point", "an empty output",
    errors.empty() ? "no error" : errors,
    errors.empty() && mesher->GetOutput()->GetNumberOfCells() == 0);
}

/// Tests invalid worker programs: a missing one, one that exits at once, and one that never
/// responds.
void TestWorkers(StabilityCatalogue& catalogue)
{
  struct Worker
  {
    const char *Name, *Extreme, *Program, *Named;
  };
  const Worker workers[] = { { "worker-missing", "a program that does not exist", "/nowhere/tetgen",
                               "cannot start" },
    { "worker-ends", "a program that exits at once", "/bin/false", "exit code 1" },
    { "worker-silent", "a program that never responds", "/bin/cat", "not done after 0.5 s" } };
  for (const Worker& worker : workers)
  {
    vtkNew<vtkTetrahedralMesher> mesher;
    mesher->SetWorkerFileName(worker.Program);
    mesher->SetTimeLimit(0.5);
    mesher->SetInputDataObject(MakeCube());
    const auto start = std::chrono::steady_clock::now();
    std::chrono::duration<double> time{};
    ReportRejection(catalogue, mesher, std::string("mesher-") + worker.Name, worker.Extreme,
      worker.Named,
      [&]()
      {
        time = std::chrono::steady_clock::now() - start;
        mesher->SetWorkerFileName("");
        mesher->SetTimeLimit(0);
      });
    catalogue.Measure(std::string("mesher-") + worker.Name + "-time", worker.Extreme,
      "seconds until the error", time.count(), 30.0);
  }
}

}

int TestStabilityMesher(int argc, char* argv[])
{
  return RunCases(__func__, "vtkTetrahedralMesher", argc, argv,
    { TestSurfaces, TestScales, TestPoints, TestCells, TestWorkers });
}
