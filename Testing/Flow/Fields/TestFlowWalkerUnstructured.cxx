// SPDX-License-Identifier: BSD-3-Clause
// The walker of unstructured grids, compared with VTK's cells, finite differences, linear fields
// and straight lines, for all supported cell types. Also tests rotated and mirrored cells, blocks,
// mismatched faces and errors.
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Flow/ReferenceWalker.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "Fields/FieldDispatch.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace
{

using namespace reference;

const std::array<int, 3> Cells = { { 3, 4, 3 } };

void CheckMesh(
  const std::string& name, vtkUnstructuredGrid* mesh, double unit, double tolerance, Check& check)
{
  check.SetContext(name);
  auto vectors = AddRandomVectors(mesh, 3);
  CallWithWalker(mesh, vectors, check,
    [&](const auto& walker)
    {
      CheckLocations(walker, mesh, vectors, 3, tolerance, check, unit >= 1.0);
      CheckDerivatives(walker, mesh, vectors, 1e-5, check);
      CheckPoints(walker, mesh, check);
      CheckLines(walker, mesh, 12, unit, check);
    });
  CheckLinearField(mesh, unit, tolerance, check);
}

void CheckMeshes(Check& check)
{
  for (const MeshKind kind : FlowMeshKinds())
  {
    const std::string name = GetName(kind);
    CheckMesh(name, MakeFlowMesh(kind, Cells), 1.0, 1e-12, check);
    auto curved = MakeFlowMesh(kind, Cells, false);
    MovePoints(curved, MakeDisplacement(Cells, 0.25));
    CheckMesh(name + ", curved", curved, 1.0, 1e-10, check);
    CheckMesh(name + ", rotated", RotateCellPointOrder(curved, 5), 1.0, 1e-10, check);
    CheckMesh(name + ", mirrored", InvertCells(curved), 1.0, 1e-10, check);
    for (const double unit : { 1e-9, 1e9 })
    {
      auto flat = MakeFlowMesh(kind, Cells, false);
      MovePoints(flat, MakeDisplacement(Cells, 0.25));
      MovePoints(flat,
        [unit](const Vector& x) {
          return Vector{ { unit * x[0], unit * x[1], 1e-4 * unit * x[2] } };
        });
      CheckMesh(name + ", planar of " + std::to_string(unit), flat, unit, 1e-9, check);
    }
  }
}

// Walks through points, edges and apexes, and along faces.
void CheckCorners(Check& check)
{
  for (const MeshKind kind : FlowMeshKinds())
  {
    CheckCornerLines(GetName(kind) + ", ", MakeFlowMesh(kind, { { 4, 4, 4 } }), check);
  }
}

// At the apex of a pyramid, velocity and Jacobian in cell coordinates are finite, and the velocity
// equals the vector at the apex.
void CheckApex(Check& check)
{
  check.SetContext("apex");
  auto mesh = MakeFlowMesh(MeshKind::Pyramids, { { 2, 2, 2 } });
  MovePoints(mesh, MakeDisplacement({ { 2, 2, 2 } }, 0.3));
  auto vectors = AddRandomVectors(mesh, 31);
  CallWithWalker(mesh, vectors, check,
    [&](auto walker)
    {
      for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
      {
        vtkNew<vtkIdList> ids;
        mesh->GetCellPoints(cell, ids);
        Vector x;
        Vector expected;
        Vector p;
        mesh->GetPoint(ids->GetId(4), x.data());
        vectors->GetTuple(ids->GetId(4), expected.data());
        check.That(walker.Locate(x.data(), p.data()), "the apex is found");
        check.Near(p[2], 1.0, 1e-12, "at z = 1");
        check.Near(
          GetNorm(VelocityOf(walker, p) - expected), 0.0, 1e-12, "vector at the apex", 1.0);
        Vector rate;
        std::array<double, 9> jacobian;
        walker.GetVelocity(p.data(), rate.data());
        walker.GetJacobian(p.data(), jacobian.data());
        check.That(GetNorm(rate) < 100.0, "the rate is bounded");
        // Positions slightly beside, below and above the apex.
        for (const double z : { 1.0 - 1e-13, 1.0, 1.0 + 1e-13, 1.0 + 1e-3 })
        {
          const double beside[3] = { 1e-13, -1e-13, z };
          walker.GetVelocity(beside, rate.data());
          check.That(GetNorm(rate) < 1000.0, "the rate close to the apex is bounded");
        }
      }
    });
}

// Two blocks without shared points are connected, except where quadrilaterals of one block meet
// triangles of the other.
void CheckBlocks(Check& check)
{
  check.SetContext("blocks");
  const std::array<int, 3> cells = { { 2, 2, 2 } };
  const auto append = [&](MeshKind second)
  {
    auto mesh = MakeFlowMesh(MeshKind::Hexahedra, cells);
    auto other = MakeFlowMesh(second, cells);
    const vtkIdType first = mesh->GetNumberOfPoints();
    for (vtkIdType point = 0; point < other->GetNumberOfPoints(); ++point)
    {
      double x[3];
      other->GetPoint(point, x);
      mesh->GetPoints()->InsertNextPoint(x[0] + cells[0], x[1], x[2]);
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < other->GetNumberOfCells(); ++cell)
    {
      other->GetCellPoints(cell, ids);
      for (vtkIdType v = 0; v < ids->GetNumberOfIds(); ++v)
      {
        ids->SetId(v, ids->GetId(v) + first);
      }
      mesh->InsertNextCell(other->GetCellType(cell), ids);
    }
    return mesh;
  };
  for (const MeshKind kind : { MeshKind::Hexahedra, MeshKind::Pyramids, MeshKind::Voxels })
  {
    auto mesh = append(kind);
    auto vectors = AddRandomVectors(mesh, 3);
    CallWithWalker(
      mesh, vectors, check, [&](const auto& walker) { CheckLines(walker, mesh, 20, 1.0, check); });
  }
  auto mesh = append(MeshKind::Tetrahedra6);
  auto vectors = AddRandomVectors(mesh, 3);
  CallWithWalker(mesh, vectors, check,
    [&](const auto& walker)
    {
      LineWalk<std::decay_t<decltype(walker)>> walk(walker, { { 0.5, 0.6, 0.7 } }, { { 1, 0, 0 } });
      check.That(walk.Run(10.0) && walk.HasEnded, "the walk ends between blocks");
      check.Near(walk.Time, 1.5, 1e-12, "at the quadrilaterals");
      check.Equal(walk.Stand.GetDomainFace(walk.EndFace), -1, "not a side of a structured grid");
    });
}

void CheckBlanking(Check& check)
{
  check.SetContext("blanking");
  auto mesh = MakeFlowMesh(MeshKind::Hexahedra, { { 4, 3, 3 } });
  // A point that no cell uses is ignored.
  mesh->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  auto vectors = AddVectors(mesh, [](const Vector&) { return Vector{ { 1.0, 2.0, 2.0 } }; });
  const double infinite[3] = { 0.0, std::numeric_limits<double>::infinity(), 0.0 };
  vectors->SetTuple(mesh->GetNumberOfPoints() - 1, infinite);
  mesh->AllocateCellGhostArray();
  HideLayer(mesh->GetCellGhostArray());
  CallWithWalker(mesh, vectors, check,
    [&](const auto& walker)
    {
      check.Equal(walker.GetField().GetNumberOfNonFiniteVectors(), 0, "vectors at unused points");
      check.Near(walker.GetField().GetMaximumSpeed(), 3.0, 1e-15, "maximum speed");
      CheckHiddenLayer(walker, check);
    });
}

// A hidden cell at the origin is not found. Its bounding box must be empty, not all zeros.
void CheckHiddenAtOrigin(Check& check)
{
  check.SetContext("hidden at the origin");
  auto mesh = MakeFlowMesh(MeshKind::Hexahedra, { { 2, 1, 1 } });
  auto vectors = AddVectors(mesh, [](const Vector&) { return Vector{ { 1.0, 0.0, 0.0 } }; });
  mesh->AllocateCellGhostArray();
  mesh->GetCellGhostArray()->FillValue(0);
  mesh->GetCellGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  CallWithWalker(mesh, vectors, check,
    [&](auto walker)
    {
      Vector p;
      const Vector origin = { { 0.0, 0.0, 0.0 } };
      check.That(!walker.Locate(origin.data(), p.data()), "the hidden cell is not found");
      const Vector other = { { 1.5, 0.5, 0.5 } };
      check.That(
        walker.Locate(other.data(), p.data()) && walker.GetCell() == 1, "the other cell is found");
    });
}

void CheckNonFinite(Check& check)
{
  check.SetContext("not finite");
  auto mesh = MakeFlowMesh(MeshKind::Mixed, Cells);
  auto vectors = AddRandomVectors(mesh, 3);
  const double wrong[3] = { 0.0, 0.0, std::nan("") };
  vectors->SetTuple(20, wrong);
  vtkNew<vtkIdList> ids;
  Random random(29);
  CallWithWalker(mesh, vectors, check,
    [&](auto walker)
    {
      check.Equal(walker.GetField().GetNumberOfNonFiniteVectors(), 1, "vectors");
      int infinite = 0;
      for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
      {
        mesh->GetCellPoints(cell, ids);
        const bool isFinite = ids->IsId(20) < 0;
        infinite += !isFinite;
        const CellSample sample = SampleCell(mesh, vectors, cell, random);
        Vector p;
        check.That(walker.Locate(sample.Position.data(), p.data()), "the cell is found");
        check.Equal(walker.IsFinite(), isFinite, "the cell is recognized as finite or non-finite");
      }
      check.That(infinite > 0, "the field has such cells");
    });
}

// Scalar arrays are interpolated in the same way as vectors.
void CheckArrays(Check& check)
{
  for (const MeshKind kind : FlowMeshKinds())
  {
    check.SetContext(GetName(kind) + ", arrays");
    auto mesh = MakeFlowMesh(kind, Cells, false);
    MovePoints(mesh, MakeDisplacement(Cells, 0.25));
    auto vectors = AddRandomVectors(mesh, 3, VTK_FLOAT);
    vtkNew<vtkDoubleArray> parts[3];
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      for (int i = 0; i < 3; ++i)
      {
        parts[i]->InsertNextValue(vectors->GetComponent(point, i));
      }
    }
    Random random(37);
    const interlume::Error error =
      interlume::FieldDispatch::Execute(mesh, vectors, { parts[0], parts[1], parts[2] },
        [&](auto walker)
        {
          for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
          {
            const CellSample sample = SampleCell(mesh, vectors, cell, random);
            Vector p;
            walker.Locate(sample.Position.data(), p.data());
            for (int i = 0; i < 3; ++i)
            {
              check.Near(walker.Interpolate(i, p.data()), sample.Velocity[i], 1e-11, "value", 1.0);
            }
          }
        });
    check.That(!error, error.GetMessage());
  }
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  const auto find = [](vtkUnstructuredGrid* mesh)
  {
    auto vectors = AddRandomVectors(mesh, 1);
    return interlume::FieldDispatch::Execute(mesh, vectors, {}, [](const auto&) {}).GetMessage();
  };
  auto boxes = MakeMesh(MeshKind::Boxes, { { 2, 2, 2 } });
  check.That(find(boxes) ==
      "cell 0 is a vtkPolyhedron (type 42); only tetrahedra, voxels, hexahedra, wedges and "
      "pyramids are supported",
    find(boxes));
  auto mesh = MakeFlowMesh(MeshKind::Tetrahedra5, { { 2, 2, 2 } });
  const vtkIdType triangle[3] = { 0, 1, 2 };
  mesh->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  check.That(find(mesh).empty(), "lower-dimensional cells are skipped: " + find(mesh));
  auto short4 = MakeFlowMesh(MeshKind::Hexahedra, { { 1, 1, 1 } });
  short4->InsertNextCell(VTK_HEXAHEDRON, 3, triangle);
  check.That(find(short4) == "cell 1 is a vtkHexahedron (type 12) with 3 points", find(short4));
  auto broken = MakeFlowMesh(MeshKind::Hexahedra, { { 2, 2, 2 } });
  broken->GetPoints()->SetPoint(26, 0.0, 0.0, std::nan(""));
  check.That(find(broken) == "point 26 is not finite", find(broken));
  vtkNew<vtkUnstructuredGrid> empty;
  check.That(find(empty).find("the field has no three-dimensional cells. ") == 0, find(empty));
}

// Returns cell coordinates, cells and times of walks along lines. The field is built in parallel.
std::vector<double> WalkAll(vtkUnstructuredGrid* mesh, vtkDataArray* vectors, Check& check)
{
  std::vector<double> all;
  CallWithWalker(mesh, vectors, check,
    [&](const auto& walker)
    {
      Random random(41);
      for (int line = 0; line < 30; ++line)
      {
        const Vector start = { { random.Get(0.0, 3.0), random.Get(0.0, 4.0),
          random.Get(0.0, 3.0) } };
        LineWalk<std::decay_t<decltype(walker)>> walk(walker, start, random.GetDirection());
        walk.Run(20.0);
        all.insert(all.end(), walk.P.begin(), walk.P.end());
        all.insert(all.end(), walk.Cells.begin(), walk.Cells.end());
        all.push_back(walk.Time);
      }
    });
  return all;
}

void CheckThreads(Check& check)
{
  auto mesh = MakeFlowMesh(MeshKind::Mixed, Cells, false);
  MovePoints(mesh, MakeDisplacement(Cells, 0.25));
  auto vectors = AddRandomVectors(mesh, 3);
  check.That(WalkAll(mesh, vectors, check).size() > 200, "the lines cross cells");
  CheckSame(
    "walks", [&]() { return WalkAll(mesh, vectors, check); }, check);
}

}

int TestFlowWalkerUnstructured(int, char*[])
{
  return RunChecks({ CheckMeshes, CheckCorners, CheckApex, CheckBlocks, CheckBlanking,
    CheckHiddenAtOrigin, CheckNonFinite, CheckArrays, CheckErrors, CheckThreads });
}
