// SPDX-License-Identifier: BSD-3-Clause
// Criteria on additional arrays: the volume where all criteria hold, for linear functions and for
// arbitrary values on tetrahedra. The order of criteria has no effect, and several intervals still
// tile the domain.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

/// Returns the volume extracted with ranges[0] as the interval and the other ranges as criteria.
double ExtractedVolume(vtkUnstructuredGrid* mesh, const std::vector<Range>& ranges, Check& check)
{
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(mesh);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, ranges[0].Array);
  filter->SetInterval(0, ranges[0].Lower, ranges[0].Upper);
  for (size_t i = 1; i < ranges.size(); ++i)
  {
    filter->AddCriterion(ranges[i].Array, ranges[i].Lower, ranges[i].Upper);
  }
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  check.Equal(
    filter->GetReport()->GetCount("Passes"), static_cast<long long>(ranges.size()), "passes");
  vtkUnstructuredGrid* output = filter->GetOutput();
  check.That(IsValid(output, VTK_TETRA), "the output consists of tetrahedra");
  if (output->GetNumberOfCells() > 0)
  {
    check.That(output->GetCellData()->HasArray("IntervalId"), "IntervalId is passed");
    for (const Range& range : ranges)
    {
      vtkDataArray* array = output->GetPointData()->GetArray(range.Array);
      double found[2];
      array->GetRange(found);
      check.That(found[0] >= range.Lower - 1e-14 && found[1] <= range.Upper + 1e-14,
        std::string("values of ") + range.Array + " are in range");
    }
  }
  return static_cast<double>(MeasureTetrahedra(output).Sum);
}

void CheckLinear(MeshKind kind, Check& check)
{
  check.SetContext(GetName(kind) + ", linear");
  auto mesh = RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 2 }), 5), 5);
  AddLinearField(mesh, { 0.1, { -0.2, 0.9, 0.4 } }, "g");
  AddLinearField(mesh, { 0.3, { 0.5, 0.1, -0.6 } }, "h");
  AddLinearField(mesh, { 0.3, { 0.8, -0.37, 0.21 } });
  const double scale = static_cast<double>(MeshVolume(mesh));
  const Range f = { "f", 0.2, 1.3 };
  const Range g = { "g", 0.5, 2.2 };
  const Range h = { "h", 0.1, 0.7 };
  for (const std::vector<Range>& ranges :
    { std::vector<Range>{ f, g }, { g, f }, { f, g, h }, { h, g, f }, { f, f } })
  {
    check.Near(ExtractedVolume(mesh, ranges, check),
      static_cast<double>(ClippedVolume(mesh, ranges)), 1e-12, "volume", scale);
  }
}

void CheckTetrahedra(MeshKind kind, Check& check)
{
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    check.SetContext(GetName(kind) + ", random, seed " + std::to_string(seed));
    auto mesh = MapProjectively(RenumberPoints(MakeMesh(kind, { 4, 3, 3 }), seed), seed);
    AddRandomField(mesh, seed + 10, "g");
    AddRandomField(mesh, seed + 20, "h");
    AddRandomField(mesh, seed);
    const std::vector<Range> ranges = { { "f", 0.2, 0.7 }, { "g", 0.3, 0.9 }, { "h", -1, 0.6 } };
    check.Near(ExtractedVolume(mesh, ranges, check),
      static_cast<double>(ClippedVolume(mesh, ranges)), 1e-12, "volume",
      static_cast<double>(MeshVolume(mesh)));
  }
}

/// For every kind of mesh, the volumes for disjoint ranges of a criterion add up to the volume
/// without the criterion.
void CheckSum(MeshKind kind, Check& check)
{
  check.SetContext(GetName(kind) + ", sum");
  auto mesh = MakeMesh(kind, { 3, 3, 2 });
  AddRandomField(mesh, 9, "g");
  AddRandomField(mesh, 8);
  const Range f = { "f", 0.25, 0.75 };
  double sum = 0;
  for (const Range& g : { Range{ "g", -1, 0.4 }, { "g", 0.4, 0.6 }, { "g", 0.6, 2 } })
  {
    sum += ExtractedVolume(mesh, { f, g }, check);
  }
  check.Near(sum, ExtractedVolume(mesh, { f }, check), 1e-12, "sum of the volumes",
    static_cast<double>(MeshVolume(mesh)));
}

}

int TestIntervalVolumeCriteria(int, char*[])
{
  Check check;
  for (MeshKind kind : AllMeshKinds())
  {
    CheckLinear(kind, check);
    CheckSum(kind, check);
  }
  for (MeshKind kind : TetrahedralMeshKinds())
  {
    CheckTetrahedra(kind, check);
  }
  return check.Result();
}
