// SPDX-License-Identifier: BSD-3-Clause
// Volumes of linear functions: compared with the formula for a box, and with clipping in long
// double for other meshes. Intervals are inside, across and outside the range.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

const LinearFunction Function = { 0.3, { 0.8, -0.37, 0.21 } };

std::vector<Interval> IntervalsWithin(vtkUnstructuredGrid* mesh)
{
  double range[2];
  mesh->GetPointData()->GetScalars()->GetRange(range);
  auto at = [&](double fraction) { return range[0] + fraction * (range[1] - range[0]); };
  return { { at(0.3), at(0.31) }, { at(0.15), at(0.8) }, { at(-1), at(0.5) }, { at(0.5), at(2) },
    { at(-1), at(2) }, { at(1.5), at(2) }, { at(0.7), at(0.9) } };
}

void CheckVolumes(vtkUnstructuredGrid* mesh, Check& check)
{
  AddLinearField(mesh, Function);
  const std::vector<Interval> intervals = IntervalsWithin(mesh);
  const Extraction extraction = ExtractIntervals(mesh, intervals);
  const double scale = static_cast<double>(MeshVolume(mesh));
  for (size_t i = 0; i < intervals.size(); ++i)
  {
    const TetrahedraVolume measured = MeasureInterval(extraction.Volume, static_cast<int>(i));
    const Range range = { "f", intervals[i][0], intervals[i][1] };
    const double expected = static_cast<double>(ClippedVolume(mesh, { range }));
    const std::string name = "volume of interval " + std::to_string(i);
    check.Near(static_cast<double>(measured.Sum), expected, 1e-12, name, scale);
    // No tetrahedron is inverted because the field is linear.
    check.Near(
      static_cast<double>(measured.SumOfAbsolute), expected, 1e-12, "unsigned " + name, scale);
  }
}

void CheckBox(MeshKind kind, Check& check)
{
  check.SetContext(GetName(kind) + ", box");
  const std::array<int, 3> cells = { 4, 3, 2 };
  const std::array<double, 3> size = { 4, 3, 2 };
  auto mesh = MakeMesh(kind, cells);
  AddLinearField(mesh, Function);
  const std::vector<Interval> intervals = IntervalsWithin(mesh);
  const Extraction extraction = ExtractIntervals(mesh, intervals);
  for (size_t i = 0; i < intervals.size(); ++i)
  {
    const long double expected = BoxVolumeBelow(size, Function, intervals[i][1]) -
      BoxVolumeBelow(size, Function, intervals[i][0]);
    const TetrahedraVolume measured = MeasureInterval(extraction.Volume, static_cast<int>(i));
    check.Near(static_cast<double>(measured.Sum), static_cast<double>(expected), 1e-12,
      "volume of interval " + std::to_string(i), 24);
  }
}

}

int TestIntervalVolumeLinear(int, char*[])
{
  Check check;
  for (MeshKind kind : AllMeshKinds())
  {
    if (kind != MeshKind::Honeycomb && kind != MeshKind::Kelvin)
    {
      CheckBox(kind, check);
    }
    for (unsigned int seed = 1; seed <= 3; ++seed)
    {
      check.SetContext(GetName(kind) + ", seed " + std::to_string(seed));
      auto mesh =
        RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 2 }, seed), seed), seed);
      CheckVolumes(mesh, check);
      if (kind != MeshKind::Voxels)
      {
        CheckVolumes(MapProjectively(mesh, seed), check);
      }
    }
  }
  return check.Result();
}
