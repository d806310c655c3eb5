// SPDX-License-Identifier: BSD-3-Clause
// How many tetrahedra come out inverted on cells that are not simplices, and how much volume they
// hold: with random values, the worst case, and with a smooth field. Volumes stay exact.
#include "Reference/Checks/ReferenceCheck.h"
#include "Reference/Intervals/ReferenceExtraction.h"
#include "Reference/Meshes/ReferenceMesh.h"
#include "Reference/Meshes/ReferenceVolume.h"

#include "vtkDoubleArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

struct Inversions
{
  double Share;
  double Volume;
};

Inversions Count(vtkUnstructuredGrid* mesh, const std::vector<Interval>& intervals)
{
  const TetrahedraVolume volume = MeasureTetrahedra(ExtractIntervals(mesh, intervals).Volume);
  return { static_cast<double>(volume.Inverted) / static_cast<double>(volume.Count),
    static_cast<double>(volume.Negative / volume.SumOfAbsolute) };
}

void AddSmoothField(vtkUnstructuredGrid* mesh)
{
  vtkDoubleArray* field = AddRandomField(mesh, 1);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    field->SetValue(
      i, 0.5 + 0.2 * (std::sin(0.9 * x[0]) + std::cos(0.7 * x[1]) * std::sin(0.8 * x[2] + 1)));
  }
}

}

int TestIntervalVolumeOrientation(int, char*[])
{
  Check check;
  const std::vector<Interval> intervals = { { 0, 0.35 }, { 0.35, 0.6 }, { 0.6, 1 } };
  for (MeshKind kind : AllMeshKinds())
  {
    check.SetContext(GetName(kind));
    auto mesh = MakeMesh(kind, { 8, 8, 8 });
    AddRandomField(mesh, 7);
    const Inversions random = Count(mesh, intervals);
    AddSmoothField(mesh);
    const Inversions smooth = Count(mesh, intervals);
    std::cout << GetName(kind) << ": inverted " << 100 * random.Share << " % holding "
              << 100 * random.Volume << " % of the volume with random values, "
              << 100 * smooth.Share << " % holding " << 100 * smooth.Volume
              << " % with a smooth field\n";
    // The rate to be expected on cells that are not simplices is half a percent.
    check.That(random.Share < 0.05, "fewer than 5 % inverted with random values");
    check.That(smooth.Share < 0.005, "fewer than 0.5 % inverted with a smooth field");
    check.That(smooth.Volume < 1e-4, "less than 0.01 % of the volume with a smooth field");
  }
  return check.Result();
}
