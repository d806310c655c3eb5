// SPDX-License-Identifier: BSD-3-Clause
// Adjacent intervals tile the domain, for independent random values that do not equal a bound.
#include "Support/Intervals/ReferenceTilingCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkUnstructuredGrid.h"

int TestIntervalVolumeTiling(int, char*[])
{
  using namespace reference;
  Check check;
  const std::vector<double> bounds = { 0.0, 0.2, 0.21, 0.5, 0.9, 1.0 };
  for (MeshKind kind : AllMeshKinds())
  {
    TilingCounts counts;
    auto tile = [&](vtkUnstructuredGrid* mesh, unsigned int seed, const std::string& how)
    {
      check.SetContext(GetName(kind) + ", " + how + ", seed " + std::to_string(seed));
      AddRandomField(mesh, seed);
      CheckTiling(mesh, bounds, true, check, counts);
    };
    for (unsigned int seed = 1; seed <= 3; ++seed)
    {
      auto mesh = MakeMesh(kind, { 3, 3, 3 }, seed);
      tile(mesh, seed, "original");
      tile(RotateCellPointOrder(mesh, seed), seed, "turned");
      tile(RenumberPoints(mesh, seed), seed, "renumbered");
      if (kind != MeshKind::Voxels)
      {
        tile(MapProjectively(RenumberPoints(RotateCellPointOrder(mesh, seed), seed), seed), seed,
          "rotated, renumbered and mapped");
      }
    }
    Print(counts, GetName(kind));
  }
  return check.Result();
}
