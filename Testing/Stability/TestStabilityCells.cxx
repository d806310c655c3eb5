// SPDX-License-Identifier: BSD-3-Clause
// Tests extreme geometry and topology: degenerate, inverted and single cells, repeated points, and
// huge, tiny or NaN coordinates.
#include "StabilityChecks.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

using namespace reference;

constexpr double VolumeBound = 1e-12;
const LinearFunction Function = { 0.1, { 0.3, 0.5, 0.7 } };
const std::vector<Interval> Halves = { { -9, 0.5 }, { 0.5, 9 } };

TetrahedraVolume Measured(vtkDataSet* data, const std::vector<Interval>& intervals)
{
  return MeasureTetrahedra(ExtractIntervals(data, intervals).Volume);
}

/// Applies \a move to all points of the mesh and returns the mesh.
vtkSmartPointer<vtkUnstructuredGrid> Moved(
  vtkUnstructuredGrid* mesh, const std::function<void(double*)>& move)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    move(x);
    mesh->GetPoints()->SetPoint(i, x);
  }
  return mesh;
}

void TestFlatCells(StabilityCatalogue& catalogue)
{
  for (MeshKind kind : AllMeshKinds())
  {
    auto flat = Moved(MakeMesh(kind, { 2, 2, 2 }), [](double* x) { x[2] = 0.5; });
    AddRandomField(flat, 1);
    const TetrahedraVolume volume = Measured(flat, Halves);
    catalogue.Measure("flat-" + GetName(kind), "cells flattened to a plane", "volume",
      static_cast<double>(volume.SumOfAbsolute), VolumeBound);
    auto point = Moved(MakeMesh(kind, { 2, 2, 2 }), [](double* x) { x[0] = x[1] = x[2] = 0.5; });
    AddRandomField(point, 1);
    catalogue.Measure("point-" + GetName(kind), "cells shrunk to one point", "volume",
      static_cast<double>(Measured(point, Halves).SumOfAbsolute), VolumeBound);
  }
}

void TestInvertedCells(StabilityCatalogue& catalogue)
{
  for (MeshKind kind : { MeshKind::Hexahedra, MeshKind::Wedges, MeshKind::Pyramids,
         MeshKind::Tetrahedra5, MeshKind::Tetrahedra6 })
  {
    auto mesh = InvertCells(MakeMesh(kind, { 3, 2, 2 }));
    AddRandomField(mesh, 2);
    const TetrahedraVolume volume = Measured(mesh, Halves);
    catalogue.Measure("inverted-" + GetName(kind), "cells with reversed point order",
      "error of the magnitude of the domain's volume",
      std::abs(static_cast<double>(volume.Sum)) / 12 - 1, VolumeBound);
  }
}

/// Returns a mesh whose cells share no point ids, although their point coordinates coincide.
vtkSmartPointer<vtkUnstructuredGrid> Separated(vtkUnstructuredGrid* mesh)
{
  MeshBuilder builder;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    mesh->GetCellPoints(cell, count, ids);
    std::vector<vtkIdType> own;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double* x = mesh->GetPoint(ids[i]);
      own.push_back(builder.AddPoint(x[0], x[1], x[2]));
    }
    builder.AddCell(mesh->GetCellType(cell), own);
  }
  return builder.GetMesh();
}

void TestRepeatedPoints(StabilityCatalogue& catalogue)
{
  for (MeshKind kind : { MeshKind::Hexahedra, MeshKind::Wedges, MeshKind::Tetrahedra6 })
  {
    auto mesh = Separated(MakeMesh(kind, { 3, 2, 2 }));
    AddLinearField(mesh, Function);
    const Range range = { "f", 0.5, 1.5 };
    catalogue.Measure("duplicate-points-" + GetName(kind),
      "coincident points that cells do not share", "error of the volume",
      static_cast<double>(Measured(mesh, { { 0.5, 1.5 } }).Sum - ClippedVolume(mesh, { range })),
      VolumeBound);
  }
  // Hexahedra with edges, a face, or all points collapsed to one point.
  struct
  {
    const char* Name;
    std::vector<vtkIdType> Ids;
    double Volume;
  } const cases[] = { { "edges", { 0, 1, 2, 2, 4, 5, 6, 6 }, 0.5 },
    { "face", { 0, 1, 2, 3, 4, 4, 4, 4 }, 1.0 / 3 },
    { "tetrahedron", { 0, 1, 2, 2, 4, 4, 4, 4 }, 1.0 / 6 },
    { "all", { 3, 3, 3, 3, 3, 3, 3, 3 }, 0 } };
  for (const auto& one : cases)
  {
    auto mesh = MakeMesh(MeshKind::Voxels, { 1, 1, 1 });
    MeshBuilder builder;
    for (const auto& corner : { 0, 1, 3, 2, 4, 5, 7, 6 })
    {
      const double* x = mesh->GetPoint(corner);
      builder.AddPoint(x[0], x[1], x[2]);
    }
    builder.AddCell(VTK_HEXAHEDRON, one.Ids);
    auto collapsed = builder.GetMesh();
    AddLinearField(collapsed, Function);
    catalogue.Measure(std::string("repeated-ids-") + one.Name,
      "a hexahedron with repeated point ids", "error of its volume",
      static_cast<double>(Measured(collapsed, Halves).Sum) - one.Volume, VolumeBound);
  }
}

void TestSingleCells(StabilityCatalogue& catalogue)
{
  for (MeshKind kind : AllMeshKinds())
  {
    auto mesh = MakeMesh(kind, { 1, 1, 1 });
    vtkNew<vtkUnstructuredGrid> single;
    single->SetPoints(mesh->GetPoints());
    if (mesh->GetCellType(0) == VTK_POLYHEDRON)
    {
      vtkNew<vtkIdList> faces;
      mesh->GetFaceStream(0, faces);
      single->InsertNextCell(VTK_POLYHEDRON, faces);
    }
    else
    {
      vtkNew<vtkIdList> ids;
      mesh->GetCellPoints(0, ids);
      single->InsertNextCell(mesh->GetCellType(0), ids);
    }
    AddLinearField(single, Function);
    catalogue.Measure("one-cell-" + GetName(kind), "a grid of one cell", "error of its volume",
      static_cast<double>(Measured(single, Halves).Sum - MeshVolume(single)), VolumeBound);
  }
  auto image = MakeImage({ 1, 1, 1 });
  AddLinearField(image, Function);
  for (const DataSetVariant& form : FormsOf(image))
  {
    catalogue.Measure("one-cell-lattice-" + form.Name, "a regular grid of one cell",
      "relative error of its volume",
      static_cast<double>(Measured(form.Data, { { -9, 9 } }).Sum) / (0.1 * 0.3 * 0.7) - 1,
      VolumeBound);
  }
}

void TestFlatLattices(StabilityCatalogue& catalogue)
{
  struct
  {
    const char* Name;
    std::array<int, 3> Cells;
    vtkIdType Count;
  } const cases[] = { { "line", { 0, 4, 0 }, 4 }, { "point", { 0, 0, 0 }, 1 } };
  for (const auto& one : cases)
  {
    auto image = MakeImage(one.Cells);
    AddLinearField(image, Function);
    const Extraction extraction = ExtractIntervals(image, Halves);
    const auto counted = extraction.Report->GetCount("LowerDimensionalCells");
    catalogue.Check(std::string("lattice-") + one.Name, "a lower-dimensional image",
      "an empty output, " + std::to_string(one.Count) + " cells reported",
      std::to_string(extraction.Volume->GetNumberOfCells()) + " tetrahedra, " +
        std::to_string(counted) + " cells reported",
      extraction.Volume->GetNumberOfCells() == 0 && counted == one.Count);
  }
}

void TestCoordinates(StabilityCatalogue& catalogue)
{
  for (int exponent : { -100, 100 })
  {
    auto mesh = MakeMesh(MeshKind::Mixed, { 3, 2, 2 });
    AddRandomField(mesh, 4);
    const double scale = std::ldexp(1, exponent);
    const TetrahedraVolume plain = Measured(mesh, { { 0.2, 0.6 } });
    const TetrahedraVolume scaled = Measured(Moved(mesh,
                                               [&](double* x)
                                               {
                                                 for (int a = 0; a < 3; ++a)
                                                 {
                                                   x[a] *= scale;
                                                 }
                                               }),
      { { 0.2, 0.6 } });
    catalogue.Measure("coordinates-2^" + std::to_string(exponent), "tiny or huge coordinates",
      "relative error of the volume",
      static_cast<double>(scaled.Sum / (plain.Sum * scale * scale * scale) - 1), VolumeBound);
  }
  auto far = MakeMesh(MeshKind::Hexahedra, { 3, 2, 2 });
  AddRandomField(far, 4);
  const TetrahedraVolume near = Measured(far, { { 0.2, 0.6 } });
  const TetrahedraVolume moved =
    Measured(Moved(far, [](double* x) { x[0] += 1048576; }), { { 0.2, 0.6 } });
  catalogue.Measure("coordinates-far", "cells of size 1 at 2^20", "relative error of the volume",
    static_cast<double>(moved.Sum / near.Sum - 1), 1e-8);

  auto mesh = MakeMesh(MeshKind::Hexahedra, { 4, 4, 4 });
  AddRandomField(mesh, 5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkUnstructuredGrid> withNaNValue;
  withNaNValue->DeepCopy(mesh);
  withNaNValue->GetPointData()->GetScalars()->SetComponent(62, 0, nan);
  const vtkIdType expected = ExtractIntervals(withNaNValue, Halves).Volume->GetNumberOfCells();
  mesh->GetPoints()->SetPoint(62, nan, nan, nan);
  mesh->GetPoints()->Modified();
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(mesh);
  filter->SetInterval(0, Halves[0][0], Halves[0][1]);
  filter->SetInterval(1, Halves[1][0], Halves[1][1]);
  const std::string warning = WarningsOf(filter);
  const vtkIdType found = filter->GetOutput()->GetNumberOfCells();
  catalogue.Check("coordinates-nan", "the coordinates of one point are NaN",
    "a warning, and the tetrahedra of all other cells",
    std::to_string(found) + " of " + std::to_string(expected) + " tetrahedra: " + warning,
    found > 0 && found == expected && warning.find("point 62") != std::string::npos);
}

}

int TestStabilityCells(int argc, char* argv[])
{
  return stability::RunCases(__func__, "vtkIntervalVolume", argc, argv,
    { TestFlatCells, TestInvertedCells, TestRepeatedPoints, TestSingleCells, TestFlatLattices,
      TestCoordinates });
}
