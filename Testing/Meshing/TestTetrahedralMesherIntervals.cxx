// SPDX-License-Identifier: BSD-3-Clause
// vtkIntervalVolume accepts meshes from the mesher, of surfaces and of concave polyhedra. Adjacent
// intervals tile the mesh, and each volume equals the volume of the linear field's slab.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceTilingCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMeshing.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTetrahedralMesher.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

const LinearFunction Function = { 0.1, { 0.3, 0.5, 0.7 } };

/// Checks the interval volumes of a box. The input is a mesh of concave cells or the surface of the
/// box.
void CheckBox(vtkDataSet* input, const std::array<double, 3>& size, Check& check)
{
  AddLinearField(input, Function);
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(input);
  mesher->SetQualityBound(1.4);
  vtkNew<vtkIntervalVolume> intervals;
  intervals->SetInputConnection(mesher->GetOutputPort());
  const double bounds[] = { 0.0, 0.8, 1.7, 2.6, 100.0 };
  for (int i = 0; i < 4; ++i)
  {
    intervals->SetInterval(i, bounds[i], bounds[i + 1]);
  }
  intervals->Update();
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const auto slab = static_cast<double>(
      BoxVolumeBelow(size, Function, bounds[i + 1]) - BoxVolumeBelow(size, Function, bounds[i]));
    const auto found = static_cast<double>(MeasureInterval(intervals->GetOutput(), i).Sum);
    check.Near(found, slab, 1e-12, "volume of interval " + std::to_string(i));
    sum += found;
  }
  check.Near(sum, size[0] * size[1] * size[2], 1e-12, "total volume");
  check.Equal(intervals->GetReport()->GetCount("UnsupportedCells"), 0, "cells skipped");
}

void CheckTiles(vtkDataSet* input, Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(input);
  mesher->Update();
  AddRandomField(mesher->GetOutput(), 5);
  TilingCounts counts;
  CheckTiling(mesher->GetOutput(), { -1.0, 0.3, 0.6, 2.0 }, true, check, counts);
  check.Equal(counts.Inverted, 0, "inverted tetrahedra");
}

}

int TestTetrahedralMesherIntervals(int, char*[])
{
  Check check;
  check.SetContext("concave cells");
  CheckBox(MakeConcaveMesh({ 2, 2, 3 }, 0.15), { 4, 4, 3 }, check);
  CheckTiles(MakeConcaveMesh({ 3, 3, 3 }, 0.15), check);
  check.SetContext("surface");
  auto box = MakeEmptySurface();
  AppendBox(box, { 0, 0, 0 }, { 1, 2, 3 });
  CheckBox(box, { 1, 2, 3 }, check);
  CheckTiles(MakeTorus(24, 12), check);
  return check.Result();
}
