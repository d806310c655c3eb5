// SPDX-License-Identifier: BSD-3-Clause
// Several intervals extracted in one pass equal the same intervals extracted separately. Tests
// overlaps, gaps, nested intervals and duplicate intervals. Values equal to a bound belong to the
// interval that the documentation states.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

std::vector<GeometricSimplex> Selected(
  vtkUnstructuredGrid* grid, int interval, const std::vector<std::string>& arrays)
{
  std::vector<std::string> names = { "IntervalId" };
  names.insert(names.end(), arrays.begin(), arrays.end());
  std::vector<GeometricSimplex> selected;
  for (GeometricSimplex& simplex : GeometricSet(grid, names))
  {
    const auto id = simplex.end() - static_cast<std::ptrdiff_t>(names.size());
    if (*id == interval)
    {
      *id = 0;
      selected.push_back(simplex);
    }
  }
  return selected;
}

void CheckSeparately(vtkUnstructuredGrid* mesh, Check& check)
{
  const std::vector<Interval> intervals = { { 0.1, 0.3 }, { 0.3, 0.5 }, { 0.45, 0.55 },
    { 0.7, 0.9 }, { 0.75, 0.8 }, { 0.7, 0.9 }, { -2, -1 }, { 0.05, 3 } };
  const Extraction together = ExtractIntervals(mesh, intervals);
  for (size_t i = 0; i < intervals.size(); ++i)
  {
    const Extraction alone = ExtractIntervals(mesh, { intervals[i] });
    const std::string name = "interval " + std::to_string(i);
    check.That(Selected(together.Volume, static_cast<int>(i), {}) == Selected(alone.Volume, 0, {}),
      "tetrahedra of " + name);
    check.That(Selected(together.Surface, static_cast<int>(i), { "BoundarySide" }) ==
        Selected(alone.Surface, 0, { "BoundarySide" }),
      "triangles of " + name);
  }
  check.Equal(static_cast<long long>(TetrahedraOf(together.Volume, 6).size()), 0,
    "tetrahedra below all values");
}

/// Returns a column of three cubes with values 0, 1, 1, 2 along z. The center cube has a constant
/// value.
vtkSmartPointer<vtkUnstructuredGrid> MakeColumn()
{
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 1, 1, 3 });
  vtkDoubleArray* field = AddIntegerField(mesh, 1, 1);
  constexpr double values[] = { 0, 1, 1, 2 };
  for (vtkIdType i = 0; i < 16; ++i)
  {
    field->SetValue(i, values[i / 4]);
  }
  return mesh;
}

void CheckBounds(Check& check)
{
  auto mesh = MakeColumn();
  auto volume = [&](const std::vector<Interval>& intervals, int i)
  { return static_cast<double>(MeasureInterval(ExtractIntervals(mesh, intervals).Volume, i).Sum); };
  check.Near(volume({ { 0, 1 } }, 0), 2, 1e-15, "only [0,1]: it contains the constant cell");
  check.Near(volume({ { 1, 2 } }, 0), 2, 1e-15, "only [1,2]: it contains the constant cell");
  check.Near(volume({ { 0, 1 }, { 1, 2 } }, 0), 1, 1e-15,
    "[0,1] does not contain the constant cell if [1,2] is set");
  check.Near(volume({ { 0, 1 }, { 1, 2 } }, 1), 2, 1e-15,
    "[1,2] contains the constant cell if [0,1] is set");
  check.Near(volume({ { 1, 2 }, { 0, 1 } }, 1), 1, 1e-15, "the order of intervals has no effect");
  check.Near(volume({ { 1, 1 } }, 0), 1, 1e-15, "[1,1] is the constant cell");
  check.Near(volume({ { 0, 1 }, { 1, 1 }, { 1, 2 } }, 0), 1, 1e-15, "[0,1] next to [1,1]");
  check.Near(volume({ { 2, 2 } }, 0), 0, 1e-15, "[2,2] is empty", 1);
  check.Near(volume({ { 0.5, 1.5 } }, 0), 2, 1e-15, "[0.5,1.5] extends across the constant cell");
}

void CheckSetters(Check& check)
{
  vtkNew<vtkIntervalVolume> filter;
  check.Equal(filter->GetNumberOfIntervals(), 0, "default number of intervals");
  filter->SetInterval(1, 3, 4);
  check.Equal(filter->GetNumberOfIntervals(), 2, "intervals after the second is set");
  double lower = 0;
  double upper = 0;
  filter->GetInterval(1, lower, upper);
  check.That(lower == 3 && upper == 4, "the interval is stored");
  const vtkMTimeType time = filter->GetMTime();
  filter->SetInterval(1, 3, 4);
  check.That(filter->GetMTime() == time, "setting the same interval does not modify the filter");
  filter->SetInterval(1, 3, 5);
  check.That(filter->GetMTime() > time, "setting another interval modifies the filter");
}

}

int TestIntervalVolumeIntervals(int, char*[])
{
  Check check;
  for (MeshKind kind : AllMeshKinds())
  {
    check.SetContext(GetName(kind));
    auto mesh = RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 2 }), 2), 2);
    AddRandomField(mesh, 11);
    CheckSeparately(mesh, check);
  }
  check.SetContext("cell with a constant value");
  CheckBounds(check);
  check.SetContext("setters");
  CheckSetters(check);
  return check.Result();
}
