// SPDX-License-Identifier: BSD-3-Clause
// On tetrahedral meshes the region is piecewise linear. Clipping in long double yields the exact
// volume for any values, and no tetrahedron may be inverted.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkUnstructuredGrid.h"

#include <iostream>

int TestIntervalVolumeTetrahedra(int, char*[])
{
  using namespace reference;
  Check check;
  long long tetrahedra = 0;
  auto compare = [&](vtkUnstructuredGrid* mesh, const std::vector<Interval>& intervals)
  {
    const Extraction extraction = ExtractIntervals(mesh, intervals);
    const double scale = static_cast<double>(MeshVolume(mesh));
    for (size_t i = 0; i < intervals.size(); ++i)
    {
      const TetrahedraVolume measured = MeasureInterval(extraction.Volume, static_cast<int>(i));
      const Range range = { "f", intervals[i][0], intervals[i][1] };
      check.Near(static_cast<double>(measured.Sum),
        static_cast<double>(ClippedVolume(mesh, { range })), 1e-12,
        "volume of interval " + std::to_string(i), scale);
      check.Equal(measured.Inverted, 0, "inverted tetrahedra of interval " + std::to_string(i));
      tetrahedra += measured.Count;
    }
  };
  for (MeshKind kind : TetrahedralMeshKinds())
  {
    for (unsigned int seed = 1; seed <= 5; ++seed)
    {
      auto mesh = MakeMesh(kind, { 4, 4, 4 });
      if (seed > 1)
      {
        mesh = MapProjectively(RenumberPoints(RotateCellPointOrder(mesh, seed), seed), seed);
      }
      check.SetContext(GetName(kind) + ", seed " + std::to_string(seed));
      AddRandomField(mesh, seed);
      compare(mesh, { { 0.4, 0.6 }, { 0.1, 0.101 }, { 0.5, 7 }, { -3, 0.3 }, { -1, 2 } });
      AddIntegerField(mesh, 5, seed);
      compare(mesh, { { 1, 2 }, { 2.5, 3.25 }, { 3, 10 }, { -1, 2.5 } });
    }
  }
  std::cout << tetrahedra << " tetrahedra on tetrahedral meshes\n";
  return check.Result();
}
