// SPDX-License-Identifier: BSD-3-Clause
// Point arrays at new points: linear functions are reproduced up to rounding error, values remain
// within the input range, and input points retain their values.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkTetrahedralMesher.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

namespace
{

using namespace reference;

const LinearFunction Function = { 17.5, { 0.3, -250.0, 0.007 } };

vtkSmartPointer<vtkPolyData> MakeShells()
{
  auto surface = MakeTorus(24, 12);
  AppendBox(surface, { -3, -3, -2 }, { 3, 3, 2 });
  AppendBox(surface, { 5, 0, 0 }, { 6, 1, 1 });
  return surface;
}

vtkSmartPointer<vtkUnstructuredGrid> Refined(vtkDataSet* input, vtkIdType* added = nullptr)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(input);
  mesher->SetQualityBound(1.4);
  mesher->SetMaximumVolume(0.05);
  mesher->Update();
  if (added)
  {
    *added = mesher->GetReport()->GetCount("AddedPoints");
  }
  return mesher->GetOutput();
}

void CheckLinear(Check& check)
{
  check.SetContext("linear field");
  auto surface = MakeShells();
  AddLinearField(surface, Function);
  vtkIdType added = 0;
  auto mesh = Refined(surface, &added);
  check.That(added > 1000, "more than the input points are used");
  const double error = LinearError(mesh, "f", Function);
  std::cout << "linear field at " << mesh->GetNumberOfPoints() << " points, " << added
            << " of them new: relative error " << error << "\n";
  check.That(error < 1e-12, "a linear field is reproduced: " + std::to_string(error));
}

/// x^2 - y^2 is harmonic. Values interpolated from a fine boundary approximate it in the interior.
void CheckHarmonic(Check& check)
{
  check.SetContext("harmonic field");
  auto torus = MakeTorus(80, 40);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType p = 0; p < torus->GetNumberOfPoints(); ++p)
  {
    double x[3];
    torus->GetPoint(p, x);
    values->InsertNextValue(x[0] * x[0] - x[1] * x[1]);
  }
  torus->GetPointData()->SetScalars(values);
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(torus);
  mesher->SetQualityBound(1.4);
  mesher->SetMaximumVolume(2e-4);
  mesher->Update();
  vtkUnstructuredGrid* mesh = mesher->GetOutput();
  double error = 0.0;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    error = std::max(error,
      std::abs(mesh->GetPointData()->GetScalars()->GetComponent(p, 0) - x[0] * x[0] + x[1] * x[1]));
  }
  std::cout << "x^2 - y^2 on " << mesh->GetNumberOfPoints() << " points: error " << error
            << " of 1.96\n";
  check.That(error < 0.02, "a harmonic function is approximated: " + std::to_string(error));
}

template <typename Array>
void AddArray(vtkDataSet* data, const char* name, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  std::mt19937 random(7);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetComponent(i / components, static_cast<int>(i % components), random() % 1000);
  }
  data->GetPointData()->AddArray(array);
}

void CheckTypes(Check& check)
{
  check.SetContext("types");
  auto surface = MakeShells();
  AddArray<vtkDoubleArray>(surface, "double");
  AddArray<vtkFloatArray>(surface, "vectors", 3);
  AddArray<vtkIntArray>(surface, "int");
  AddArray<vtkShortArray>(surface, "short");
  surface->GetPointData()->SetActiveVectors("vectors");
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  text->SetNumberOfValues(surface->GetNumberOfPoints());
  surface->GetPointData()->AddArray(text);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfValues(surface->GetNumberOfPoints());
  ids->FillValue(3);
  surface->GetPointData()->SetGlobalIds(ids);
  auto mesh = Refined(surface);
  vtkPointData* out = mesh->GetPointData();
  const std::pair<const char*, int> expected[] = { { "double", VTK_DOUBLE },
    { "vectors", VTK_FLOAT }, { "int", VTK_DOUBLE }, { "short", VTK_FLOAT } };
  for (const auto& one : expected)
  {
    vtkDataArray* array = out->GetArray(one.first);
    vtkDataArray* given = surface->GetPointData()->GetArray(one.first);
    check.That(array && array->GetDataType() == one.second, std::string("type of ") + one.first);
    for (int c = 0; array && c < given->GetNumberOfComponents(); ++c)
    {
      double range[2];
      double givenRange[2];
      array->GetRange(range, c);
      given->GetRange(givenRange, c);
      check.That(range[0] >= givenRange[0] - 1e-9 && range[1] <= givenRange[1] + 1e-9,
        std::string("range of ") + one.first);
    }
  }
  check.Equal(out->GetNumberOfArrays(), 4, "string arrays and global ids are not passed");
  check.That(out->GetVectors() == out->GetArray("vectors"), "the active vectors remain active");
  // The input points in use come first and retain their values.
  vtkDataArray* values = out->GetArray("double");
  vtkIdType at = 0;
  for (vtkIdType p = 0; values && p < surface->GetNumberOfPoints(); ++p)
  {
    double x[3];
    double y[3];
    surface->GetPoint(p, x);
    mesh->GetPoint(at, y);
    if (x[0] == y[0] && x[1] == y[1] && x[2] == y[2])
    {
      check.Near(values->GetComponent(at, 0),
        surface->GetPointData()->GetArray("double")->GetComponent(p, 0), 0.0,
        "value at an input point");
      ++at;
    }
  }
  check.Equal(at, surface->GetNumberOfPoints(), "the input points retain their order");
}

void CheckExtreme(Check& check)
{
  for (double bad : { std::numeric_limits<double>::quiet_NaN(), 1e300 })
  {
    check.SetContext("value " + std::to_string(bad));
    auto surface = MakeShells();
    AddLinearField(surface, Function)->SetValue(5, bad);
    auto mesh = Refined(surface);
    vtkDataArray* values = mesh->GetPointData()->GetArray("f");
    vtkIdType notFinite = 0;
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      notFinite += !std::isfinite(values->GetComponent(p, 0));
    }
    // Values at point 5 itself and at new points on adjacent triangles may be non-finite.
    check.That(notFinite <= (std::isfinite(bad) ? 0 : 100), "the other values remain finite");
  }
}

}

int TestTetrahedralMesherArrays(int, char*[])
{
  return RunChecks({ CheckLinear, CheckHarmonic, CheckTypes, CheckExtreme });
}
