// SPDX-License-Identifier: BSD-3-Clause
// Adjacent intervals tile the domain if many values equal a bound: edges, faces and entire cells
// have constant values, and simplices are degenerate.
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Intervals/ReferenceTilingCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <string>

namespace
{
using namespace reference;

/// The lower boundary of the interval [1, 1] of a step function faces the smaller values.
void CheckSidesOfZeroWidth(Check& check)
{
  for (const bool isRising : { true, false })
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(4, 2, 2);
    vtkDoubleArray* field = AddLinearField(image, { 0.0, { 1.0, 0.0, 0.0 } });
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double step = field->GetValue(i) == 0.0 ? 0.0 : field->GetValue(i) == 3.0 ? 2.0 : 1.0;
      field->SetValue(i, isRising ? step : 2.0 - step);
    }
    for (const DataSetVariant& form : FormsOf(image))
    {
      check.SetContext(form.Name + (isRising ? ", rising" : ", falling"));
      // An interval that ends at 1 contains the constant cell of value 1, and so does the interval
      // [1, 1].
      check.Near(static_cast<double>(MeasureTetrahedra(
                   ExtractIntervals(form.Data, { { 0.0, 1.0 }, { 1.0, 1.0 } }).Volume)
                                       .Sum),
        3.0, 1e-14, "total volume with an interval that ends at 1");
      const Extraction extraction = ExtractIntervals(form.Data, { { 1.0, 1.0 } });
      check.Near(
        static_cast<double>(MeasureTetrahedra(extraction.Volume).Sum), 1.0, 1e-14, "volume");
      vtkDataArray* sides = extraction.Surface->GetCellData()->GetArray("BoundarySide");
      check.Equal(sides->GetNumberOfTuples(), 4, "triangles at both sides");
      for (vtkIdType cell = 0; cell < sides->GetNumberOfTuples(); ++cell)
      {
        const double* bounds = extraction.Surface->GetCell(cell)->GetBounds();
        const double lower = isRising ? 1.0 : 2.0;
        check.Equal(bounds[0] == bounds[1], 1, "triangle in a plane of the grid");
        check.Equal(sides->GetComponent(cell, 0) == 0.0, bounds[0] == lower, "side of a triangle");
      }
    }
  }
}

/// An output point at a grid point has exactly the values of the grid point, regardless of the
/// values outside the interval. The scalars 0, 1, 2 along x are shifted from row to row, so that
/// cells are cut at points that equal the bound 1. The other array is NaN where the scalar is 0,
/// and infinite at some other points.
void CheckValuesAtBounds(Check& check)
{
  check.SetContext("values at grid points");
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("f");
  vtkNew<vtkDoubleArray> other;
  other->SetName("a");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double value = static_cast<double>((i % 3 + i / 3 + 2 * (i / 9)) % 3);
    scalars->InsertNextValue(value);
    other->InsertNextValue(value == 0.0 ? std::numeric_limits<double>::quiet_NaN()
        : i % 4 == 0                    ? std::numeric_limits<double>::infinity()
                                        : 10.0 + static_cast<double>(i));
  }
  image->GetPointData()->SetScalars(scalars);
  image->GetPointData()->AddArray(other);
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInputData(image);
  volume->SetInterval(0, 1.0, 2.0);
  volume->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(volume->GetOutputDataObject(0));
  vtkDataArray* found = output->GetPointData()->GetArray("a");
  int atGridPoints = 0;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const vtkIdType i = image->FindPoint(output->GetPoint(p));
    double position[3];
    image->GetPoint(i, position);
    if (vtkMath::Distance2BetweenPoints(position, output->GetPoint(p)) == 0.0)
    {
      ++atGridPoints;
      check.That(scalars->GetValue(i) >= 1.0 && found->GetComponent(p, 0) == other->GetValue(i),
        "value of point " + std::to_string(i));
    }
  }
  check.That(atGridPoints > 10, "there are output points at grid points");
}
}

int TestIntervalVolumeTies(int, char*[])
{
  Check check;
  CheckSidesOfZeroWidth(check);
  CheckValuesAtBounds(check);
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
        auto mesh =
          RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 3 }, seed), seed), seed);
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
