// SPDX-License-Identifier: BSD-3-Clause
// Documented guarantees for values equal to bounds: faces match with opposite orientation, port 1
// has the boundary of the tetrahedra, [a, a] consists of the cells with constant value a, adjacent
// intervals tile the domain, and criteria preserve signed volumes. Tested with all 8-bit data files
// and with small integers in every cell type.
#include "Support/Inputs/DataFiles.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Intervals/ReferenceMatching.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

void CheckVolume(const std::string& file, Check& check)
{
  check.SetContext(file);
  const auto crop = CropVolume(*interlume::ReadData(file), 16, 0);
  const std::vector<double> bounds = GetQuantiles(*crop);
  CheckMatchingTiling(crop, bounds, check);
  const double low = bounds[0];
  const double midpoint = bounds[1];
  const double high = bounds.back();
  CheckMatching(crop,
    { { low, low }, { midpoint, midpoint }, { low, midpoint }, { midpoint, high },
      { low + 0.5, high } },
    check);
  CheckMatching(crop, { { low, midpoint }, { midpoint, high }, { midpoint, midpoint } }, check,
    { { crop->GetPointData()->GetScalars()->GetName(), midpoint, high } });
}

void CheckKind(MeshKind kind, Check& check)
{
  for (int values : { 2, 3, 5 })
  {
    for (unsigned int seed = 3; seed <= 6; ++seed)
    {
      check.SetContext(
        GetName(kind) + ", " + std::to_string(values) + " values, seed " + std::to_string(seed));
      auto mesh =
        RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 3 }, seed), seed), seed);
      AddIntegerField(mesh, values, seed + 100, "g");
      AddIntegerField(mesh, values, seed);
      std::vector<double> bounds;
      for (int value = 0; value < values; ++value)
      {
        bounds.push_back(value);
      }
      CheckMatchingTiling(mesh, bounds, check);
      const double high = values - 1.0;
      CheckMatching(
        mesh, { { 0, 0 }, { 1, 1 }, { 0, 1 }, { 1, high }, { 0.5, 1 }, { 0.5, 1.5 } }, check);
      for (int operation : { vtkIntervalVolume::INTERSECTION, vtkIntervalVolume::UNION,
             vtkIntervalVolume::DIFFERENCE })
      {
        CheckMatching(mesh, { { 0, 1 }, { 1, high } }, check, { { "g", 0.5, 1 } }, operation);
        CheckMatching(
          mesh, { { 0, 1 } }, check, { { "g", 1, 2 }, { "f", 1, 1.5 }, { "g", 0, 0 } }, operation);
      }
      // No other interval begins at an upper bound of these intervals.
      CheckMatching(mesh, { { 0, 1 }, { 0.5, 2 } }, check);
    }
  }
}

/// A single tetrahedron with the values 1, 1, 1, 0. Its face of value 1 is an upper boundary
/// triangle of [0, 1] only if another interval begins at 1.
void CheckTetrahedron(Check& check)
{
  check.SetContext("tetrahedron 1 1 1 0");
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, 1);
  grid->SetPoints(points);
  constexpr vtkIdType corners[] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, corners);
  vtkDoubleArray* f = AddIntegerField(grid, 1, 1);
  for (vtkIdType p = 0; p < 4; ++p)
  {
    f->SetValue(p, p < 3 ? 1 : 0);
  }
  const Extraction found = ExtractIntervals(grid, { { 0, 1 }, { 1, 2 } });
  check.Equal(found.Volume->GetNumberOfCells(), 1, "tetrahedra");
  check.Equal(static_cast<long long>(BoundaryOf(found.Surface, 0, 1).size()), 1,
    "upper triangles of [0,1]: 1 does not belong to the interval");
  check.Equal(found.Surface->GetNumberOfCells(), 1, "total number of triangles");
  const Extraction alone = ExtractIntervals(grid, { { 0, 1 } });
  check.Equal(
    alone.Surface->GetNumberOfCells(), 0, "triangles of only [0,1]: 1 belongs to the interval");
}

/// A criterion that all values satisfy preserves the signed volume, also of inverted tetrahedra.
void CheckCriterion(Check& check)
{
  check.SetContext("criterion that all values satisfy");
  for (bool isInteger : { false, true })
  {
    auto mesh = RotateCellPointOrder(MakeMesh(MeshKind::Hexahedra, { 8, 8, 8 }), 2);
    isInteger ? AddIntegerField(mesh, 4, 5) : AddRandomField(mesh, 5);
    const double upper = isInteger ? 2 : 0.5;
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(mesh);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->SetInterval(0, 0, upper);
    filter->Update();
    const TetrahedraVolume before = MeasureTetrahedra(filter->GetOutput());
    check.That(before.Inverted > 0, "there are inverted tetrahedra");
    filter->AddCriterion("f", -1, upper + 1);
    filter->Update();
    const TetrahedraVolume after = MeasureTetrahedra(filter->GetOutput());
    check.Equal(after.Inverted, before.Inverted, "inverted tetrahedra");
    check.Near(static_cast<double>(after.Sum), static_cast<double>(before.Sum), 1e-14,
      "sum of the signed volumes");
  }
}

}

int TestIntervalVolumeMatching(int, char*[])
{
  Check check;
  for (const std::string& file : GetTiedVolumeFileNames())
  {
    CheckVolume(file, check);
  }
  for (MeshKind kind : AllMeshKinds())
  {
    CheckKind(kind, check);
  }
  CheckTetrahedron(check);
  CheckCriterion(check);
  return check.Result();
}
