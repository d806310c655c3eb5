// SPDX-License-Identifier: BSD-3-Clause
// Adjacent intervals tile the domain where many values equal a bound: edges, faces and whole cells
// are flat, and simplices collapse.
#include "Reference/Intervals/ReferenceTilingCheck.h"
#include "Reference/Meshes/ReferenceField.h"
#include "Reference/Meshes/ReferenceMesh.h"
#include "Reference/Meshes/ReferenceTransform.h"

#include "vtkUnstructuredGrid.h"

int TestIntervalVolumeTies(int, char*[])
{
  using namespace reference;
  Check check;
  struct Values
  {
    int Number;
    std::vector<double> Bounds;
  };
  const std::vector<Values> cases = { { 2, { 0, 1 } }, { 3, { 0, 1, 2 } }, { 3, { 0, 0.5, 1, 2 } },
    { 5, { 0, 1, 2, 3, 4 } }, { 5, { -1, 1, 3, 3.5, 9 } }, { 12, { 0, 3, 4, 7, 11 } } };
  for (MeshKind kind : AllMeshKinds())
  {
    TilingCounts counts;
    for (const Values& values : cases)
    {
      for (unsigned int seed = 1; seed <= 3; ++seed)
      {
        check.SetContext(GetName(kind) + ", " + std::to_string(values.Number) + " values, bound " +
          std::to_string(values.Bounds[1]) + ", seed " + std::to_string(seed));
        auto mesh = RenumberPoints(TurnCells(MakeMesh(kind, { 3, 3, 3 }, seed), seed), seed);
        if (kind != MeshKind::Voxels && seed > 1)
        {
          mesh = MapProjectively(mesh, seed);
        }
        AddIntegerField(mesh, values.Number, seed);
        CheckTiling(mesh, values.Bounds, false, check, counts);
      }
    }
    Print(counts, GetName(kind));
  }
  return check.Result();
}
