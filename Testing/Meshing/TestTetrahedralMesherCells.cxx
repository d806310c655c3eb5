// SPDX-License-Identifier: BSD-3-Clause
// Cells of grids: concave polyhedra with concave, nonplanar faces and all other cell types are
// split into positively oriented tetrahedra that match at their faces and fill the cells.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceBlocks.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceMeshing.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdTypeArray.h"
#include "vtkInterlumeReport.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkTetrahedralMesher.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

namespace
{

using namespace reference;

const LinearFunction Function = { 0.1, { 0.3, 0.5, 0.7 } };

vtkSmartPointer<vtkInterlumeReport> CheckMesh(vtkDataSet* input, long double volume, Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(input);
  mesher->Update();
  vtkUnstructuredGrid* output = mesher->GetOutput();
  const TetrahedraReport report = Inspect(output);
  check.That(report.Tetrahedra > 0, "there are tetrahedra");
  check.Equal(report.Tetrahedra, output->GetNumberOfCells(), "every cell is a tetrahedron");
  check.Equal(report.NotPositive, 0, "every tetrahedron is positive");
  check.Equal(report.FacesTooOften, 0, "no face belongs to more than two tetrahedra");
  check.Equal(report.FacesTurned, 0, "tetrahedra lie on opposite sides of their common face");
  check.Equal(report.UnusedPoints, 0, "every point is used");
  check.Near(report.Volume, volume, 1e-12, "volume");
  // Faces along an interior crack would count as outer faces and change this volume.
  check.Near(report.BoundaryVolume, volume, 1e-12, "volume within the outer faces");
  if (input->GetPointData()->GetArray("f"))
  {
    check.That(LinearError(output, "f", Function) < 1e-10, "a linear field is reproduced");
  }
  check.Equal(
    mesher->GetReport()->GetCount("Tetrahedra"), report.Tetrahedra, "tetrahedra reported");
  return mesher->GetReport();
}

vtkIdType OuterFaces(vtkDataSet* input)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(input);
  mesher->Update();
  return Inspect(mesher->GetOutput()).FacesOnce;
}

void CheckKinds(Check& check)
{
  for (MeshKind kind : AllMeshKinds())
  {
    check.SetContext(GetName(kind));
    auto mesh = MakeMesh(kind, { 3, 3, 3 });
    AddLinearField(mesh, Function);
    const auto report = CheckMesh(mesh, MeshVolume(mesh), check);
    check.Equal(report->GetCount("Cells"), mesh->GetNumberOfCells(), "cells decomposed");
    check.Equal(report->GetCount("AddedPoints"), 0, "convex cells require no new point");
  }
  // Each side of the box has 3 x 3 squares of two triangles. A crack would add more.
  check.SetContext("outer faces");
  check.Equal(OuterFaces(MakeMesh(MeshKind::Mixed, { 3, 3, 3 })), 6 * 9 * 2, "of a mixed mesh");
}

void CheckConcave(Check& check)
{
  for (double shift : { 0.0, 1e-9, 0.02, 0.15 })
  {
    for (unsigned int seed = 1; seed <= 4; ++seed)
    {
      check.SetContext("concave, shift " + std::to_string(shift));
      const std::array<int, 3> blocks = { 3, 3, 4 };
      auto mesh = MakeConcaveMesh(blocks, shift, seed);
      AddLinearField(mesh, Function);
      const auto report = CheckMesh(mesh, 4.0L * blocks[0] * blocks[1] * blocks[2], check);
      check.Equal(report->GetCount("Cells"), mesh->GetNumberOfCells(), "cells decomposed");
      // The four sides perpendicular to x and y have 6 x 4 squares each, top and bottom 6 x 6
      // squares each. Each square has two triangles.
      check.Equal(OuterFaces(mesh), 2 * (2 * (6 * 4) + 2 * (6 * 4) + 2 * 36), "outer faces");
      if (seed == 1)
      {
        std::cout << "shift " << shift << ": " << report->GetNumber("Cells") << " cells, "
                  << report->GetNumber("CellsByTetGen") << " by TetGen, "
                  << report->GetNumber("CellsConed") << " coned, "
                  << report->GetNumber("Tetrahedra") << " tetrahedra, smallest "
                  << report->GetNumber("SmallestVolume") << "\n";
      }
    }
  }
}

/// Returns whether the points \a a and \a b are connected by an edge of \a mesh.
bool HasEdge(vtkUnstructuredGrid* mesh, vtkIdType a, vtkIdType b)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    mesh->GetCellPoints(t, ids);
    if (ids->IsId(a) >= 0 && ids->IsId(b) >= 0)
    {
      return true;
    }
  }
  return false;
}

/// The diagonal of each face starts at the point with the smallest global id, not at the smallest
/// point id.
void CheckGlobalIds(Check& check)
{
  const int faces[6][4] = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  std::array<vtkIdType, 8> order = { 7, 5, 3, 1, 6, 4, 2, 0 };
  for (unsigned int seed = 1; seed <= 8; ++seed)
  {
    check.SetContext("global ids " + std::to_string(seed));
    MeshBuilder builder;
    for (int i = 0; i < 8; ++i)
    {
      builder.AddPoint(i % 4 == 1 || i % 4 == 2, i % 4 > 1, i / 4);
    }
    builder.AddCell(VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 });
    auto mesh = builder.GetMesh();
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("ids");
    for (vtkIdType id : order)
    {
      ids->InsertNextValue(1000 + 7 * id);
    }
    mesh->GetPointData()->SetGlobalIds(ids);
    CheckMesh(mesh, 1.0L, check);
    vtkNew<vtkTetrahedralMesher> mesher;
    mesher->SetInputData(mesh);
    mesher->Update();
    for (const auto& face : faces)
    {
      const int smallest = static_cast<int>(
        std::min_element(face, face + 4, [&](int a, int b) { return order[a] < order[b]; }) - face);
      check.That(HasEdge(mesher->GetOutput(), face[smallest], face[(smallest + 2) % 4]),
        "the face has the diagonal at the smallest global id");
      check.That(!HasEdge(mesher->GetOutput(), face[(smallest + 1) % 4], face[(smallest + 3) % 4]),
        "the face does not have the other diagonal");
    }
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  }
}

/// Hidden and duplicate cells are skipped and counted. Other ghost flags have no effect.
void CheckGhosts(Check& check)
{
  check.SetContext("ghosts");
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 2, 2, 1 });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (unsigned char mark : { 0, static_cast<int>(vtkDataSetAttributes::HIDDENCELL),
         static_cast<int>(vtkDataSetAttributes::DUPLICATECELL),
         static_cast<int>(vtkDataSetAttributes::HIGHCONNECTIVITYCELL) })
  {
    ghosts->InsertNextValue(mark);
  }
  const long double whole = MeshVolume(mesh);
  mesh->GetCellData()->AddArray(ghosts);
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(mesh);
  mesher->Update();
  check.Equal(mesher->GetReport()->GetCount("Cells"), 2, "cells decomposed");
  check.Equal(mesher->GetReport()->GetCount("SkippedCells"), 2, "cells skipped");
  check.Near(
    Inspect(mesher->GetOutput()).Volume, whole / 2, 1e-12, "volume of the remaining cells");
  check.Equal(mesher->GetOutput()->GetNumberOfCells(), 12, "tetrahedra");
}

/// Two blocks with different point orders split their common faces in the same way if they have
/// global ids of any integer type.
void CheckBlocks(Check& check)
{
  std::vector<IdStorage> storages = AllIdStorages();
  storages.push_back({ VTK_VOID, false });
  for (const IdStorage& ids : storages)
  {
    check.SetContext("blocks with ids of type " + std::to_string(ids.Type));
    int different = 0;
    for (unsigned int seed = 1; seed <= 6; ++seed)
    {
      std::multiset<std::vector<std::array<double, 4>>> faces[2];
      const auto blocks = MakeBlocks(MeshKind::Hexahedra, 0, seed, ids);
      for (int side = 0; side < 2; ++side)
      {
        vtkNew<vtkTetrahedralMesher> mesher;
        mesher->SetInputDataObject(blocks[side]);
        mesher->Update();
        faces[side] = FacesBetweenBlocks(mesher->GetOutput(), 0);
      }
      check.That(!faces[0].empty(), "there are common faces");
      different += faces[0] != faces[1];
    }
    check.That((different > 0) == (ids.Type == VTK_VOID),
      "point orders for which common faces differ: " + std::to_string(different));
  }
  check.SetContext("array of global ids with an invalid length");
  const auto block = MakeBlocks(MeshKind::Hexahedra, 0, 1, { VTK_INT, false })[0];
  block->GetPointData()->GetGlobalIds()->SetNumberOfTuples(17);
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(block);
  const std::string message = UpdateAndGetErrors(mesher);
  check.Contains(message, "\"ids\" has 17 tuples; 18 are needed");
}

/// Returns a prism over a polygon, whose points are in counterclockwise order. The top of the prism
/// is rotated by \a twist.
vtkSmartPointer<vtkUnstructuredGrid> MakePrism(
  const std::vector<std::array<double, 2>>& polygon, double twist = 0.0)
{
  MeshBuilder builder;
  const int n = static_cast<int>(polygon.size());
  for (int k = 0; k < 2; ++k)
  {
    for (const auto& x : polygon)
    {
      const double c = std::cos(k * twist);
      const double s = std::sin(k * twist);
      builder.AddPoint(c * x[0] - s * x[1], s * x[0] + c * x[1], k);
    }
  }
  std::vector<std::vector<vtkIdType>> faces(2);
  for (int i = 0; i < n; ++i)
  {
    faces[0].push_back(n - 1 - i);
    faces[1].push_back(n + i);
    faces.push_back({ i, (i + 1) % n, n + (i + 1) % n, n + i });
  }
  builder.AddPolyhedron(faces);
  auto mesh = builder.GetMesh();
  AddLinearField(mesh, Function);
  return mesh;
}

void CheckSingle(Check& check)
{
  // No point of a U-shaped cell sees the entire cell.
  check.SetContext("U");
  CheckMesh(MakePrism({ { { 0, 0 } }, { { 3, 0 } }, { { 3, 3 } }, { { 2, 3 } }, { { 2, 1 } },
              { { 1, 1 } }, { { 1, 3 } }, { { 0, 3 } } }),
    7.0L, check);
  check.SetContext("comb");
  std::vector<std::array<double, 2>> comb = { { { 0, 0 } }, { { 9, 0 } } };
  for (int tooth = 4; tooth >= 0; --tooth)
  {
    comb.push_back({ { 2.0 * tooth + 1, 3 } });
    comb.push_back({ { 2.0 * tooth, 3 } });
    if (tooth > 0)
    {
      comb.push_back({ { 2.0 * tooth, 1 } });
      comb.push_back({ { 2.0 * tooth - 1, 1 } });
    }
  }
  CheckMesh(MakePrism(comb), 9.0L + 5 * 2.0L, check);
  // Schoenhardt's polyhedron cannot be tetrahedralized without a new point. It is a twisted prism
  // whose sides are split along the concave diagonals.
  check.SetContext("Schoenhardt");
  MeshBuilder builder;
  const double pi = std::acos(-1.0);
  for (const auto& [k, i] : AllIndices(2, 3))
  {
    const double angle = 2 * pi * i / 3 + k * pi / 6;
    builder.AddPoint(std::cos(angle), std::sin(angle), k);
  }
  builder.AddPolyhedron({ { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 },
    { 1, 5, 4 }, { 2, 0, 3 }, { 2, 3, 5 } });
  auto mesh = builder.GetMesh();
  AddLinearField(mesh, Function);
  long double volume = 0;
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(mesh);
  mesher->Update();
  volume = Inspect(mesher->GetOutput()).BoundaryVolume;
  const auto report = CheckMesh(mesh, volume, check);
  check.That(volume > 0.5L && report->GetNumber("AddedPoints") > 0, "a new point inside");
}

void CheckArrays(Check& check)
{
  check.SetContext("cell arrays");
  auto mesh = MakeConcaveMesh({ 2, 2, 2 }, 0.1);
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(mesh);
  mesher->Update();
  vtkDataArray* kinds = mesher->GetOutput()->GetCellData()->GetArray("kind");
  check.That(
    kinds && kinds->GetDataType() == VTK_INT, "the cell array exists and retains its type");
  check.Equal(
    kinds ? kinds->GetNumberOfTuples() : 0, mesher->GetOutput()->GetNumberOfCells(), "values");
  long double polyhedra = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; kinds && t < kinds->GetNumberOfTuples(); ++t)
  {
    polyhedra += kinds->GetComponent(t, 0) == 0;
  }
  check.That(polyhedra > 0 && polyhedra < mesher->GetOutput()->GetNumberOfCells(),
    "tetrahedra of polyhedra and of other cells");
}

/// The error names a cell with too few points, whether it is the last cell or not.
void CheckTooFew(Check& check)
{
  for (const int type :
    { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_VOXEL, VTK_PENTAGONAL_PRISM })
  {
    const auto whole = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    const vtkIdType needed = whole->GetNumberOfPoints();
    for (const vtkIdType has : { vtkIdType(0), vtkIdType(1), needed - 1 })
    {
      for (const bool isLast : { false, true })
      {
        auto mesh = MakeMesh(MeshKind::Hexahedra, { 2, 2, 2 });
        const vtkIdType ids[] = { 0, 1, 2, 3, 4, 5, 6, 7, 8 };
        mesh->InsertNextCell(type, has, ids);
        if (!isLast)
        {
          mesh->InsertNextCell(VTK_TETRA, 4, ids);
        }
        check.SetContext("type " + std::to_string(type) + ", " + std::to_string(has) + " points");
        vtkNew<vtkTetrahedralMesher> mesher;
        mesher->SetInputData(mesh);
        const std::string message = UpdateAndGetErrors(mesher);
        check.That(message.find("Cell 8 (") != std::string::npos &&
            message.find("; " + std::to_string(needed) + " are needed") != std::string::npos,
          "error: " + message);
        check.Equal(mesher->GetOutput()->GetNumberOfCells(), 0, "cells");
      }
    }
  }
}

/// Hexahedra around an axis, whose inner points coincide.
void CheckCollapsed(Check& check)
{
  constexpr int size = 4;
  constexpr double angle = 0.3;
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(size, size, size);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        points->InsertNextPoint(i * std::cos(angle * j), i * std::sin(angle * j), k);
      }
    }
  }
  grid->SetPoints(points);
  vtkObject::GlobalWarningDisplayOff(); // the warning is checked below
  const auto report = CheckMesh(grid, 3.0 * 3.0 * 0.5 * 9.0 * std::sin(angle), check);
  vtkObject::GlobalWarningDisplayOn();
  check.Equal(report->GetCount("MergedPoints"), size * (size - 1), "merged points");
  // Of each of the nine cells at the axis, two faces become triangles and one a line.
  check.Equal(report->GetCount("FoldedFaces"), 27, "faces that meet themselves");
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(grid);
  check.Contains(WarningsOf(mesher), "27 faces meet themselves");
}

/// Coincident points of different cells, as at a crack, are not merged.
void CheckCrack(Check& check)
{
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 2, 2, 2 });
  vtkNew<vtkUnstructuredGrid> cracked;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  cracked->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ids->SetId(i, points->InsertNextPoint(mesh->GetPoint(ids->GetId(i))));
    }
    cracked->InsertNextCell(mesh->GetCellType(cell), ids);
  }
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(cracked);
  mesher->Update();
  check.Equal(mesher->GetReport()->GetCount("MergedPoints"), 0, "merged points at cracks");
  check.Equal(
    mesher->GetOutput()->GetNumberOfPoints(), points->GetNumberOfPoints(), "points at cracks");
}

}

int TestTetrahedralMesherCells(int, char*[])
{
  return RunChecks({ CheckKinds, CheckConcave, CheckGlobalIds, CheckBlocks, CheckGhosts,
    CheckSingle, CheckArrays, CheckTooFew, CheckCollapsed, CheckCrack });
}
