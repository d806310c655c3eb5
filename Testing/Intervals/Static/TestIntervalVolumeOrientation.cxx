// SPDX-License-Identifier: BSD-3-Clause
// Number and volume of inverted tetrahedra from cells that are not simplices. Random values are the
// worst case; a smooth field is tested too. The total volume is exact.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace reference;

struct Inversions
{
  double Fraction;
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

/// Expects that no tetrahedron is inverted and that the total volume equals \a expected, on every
/// type of grid.
void CheckReflection(vtkImageData* image, double expected, const std::string& name, Check& check)
{
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext(form.Name + ", " + name);
    const TetrahedraVolume volume =
      MeasureTetrahedra(ExtractIntervals(form.Data, { { 0.3, 0.6 } }).Volume);
    check.Equal(volume.Inverted, 0, "number of inverted tetrahedra");
    check.Near(static_cast<double>(volume.Sum), expected, 1e-12, "signed volume");
  }
}

/// Negative spacing and direction matrices with reflections do not change the volume and the
/// orientation of tetrahedra.
void CheckReflections(Check& check)
{
  const auto original = MakeImage({ 3, 4, 5 });
  AddLinearField(original, { -0.4, { 0.05, 0.11, 0.23 } });
  const double expected = static_cast<double>(ClippedVolume(original, { { "f", 0.3, 0.6 } }));
  check.That(expected > 0.0, "the volume is positive");
  for (int signs = 0; signs < 8; ++signs)
  {
    vtkNew<vtkImageData> image;
    image->DeepCopy(original);
    double spacing[3];
    image->GetSpacing(spacing);
    for (int axis = 0; axis < 3; ++axis)
    {
      spacing[axis] *= (signs >> axis & 1) != 0 ? -1.0 : 1.0;
    }
    image->SetSpacing(spacing);
    CheckReflection(image, expected, "signs of the spacing " + std::to_string(signs), check);
    image->SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, -0.48, -0.64, -0.6);
    CheckReflection(
      image, expected, "reflected, signs of the spacing " + std::to_string(signs), check);
  }
}

}

int TestIntervalVolumeOrientation(int, char*[])
{
  Check check;
  CheckReflections(check);
  const std::vector<Interval> intervals = { { 0, 0.35 }, { 0.35, 0.6 }, { 0.6, 1 } };
  for (MeshKind kind : AllMeshKinds())
  {
    check.SetContext(GetName(kind));
    auto mesh = MakeMesh(kind, { 8, 8, 8 });
    AddRandomField(mesh, 7);
    const Inversions random = Count(mesh, intervals);
    AddSmoothField(mesh);
    const Inversions smooth = Count(mesh, intervals);
    std::cout << GetName(kind) << ": inverted " << 100 * random.Fraction << " % with "
              << 100 * random.Volume << " % of the volume with random values, "
              << 100 * smooth.Fraction << " % with " << 100 * smooth.Volume
              << " % with a smooth field\n";
    check.That(random.Fraction < 0.005, "fewer than 0.5 % inverted with random values");
    check.That(smooth.Fraction < 0.005, "fewer than 0.5 % inverted with a smooth field");
    check.That(smooth.Volume < 1e-4, "less than 0.01 % of the volume with a smooth field");
  }
  return check.Result();
}
