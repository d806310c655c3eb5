// SPDX-License-Identifier: BSD-3-Clause
// With MergePoints off, the triangles equal the triangles of the merged contour, in the same order,
// but each triangle has its own points. Coordinates and arrays are bit-identical. Tests every grid
// and cell type, ties, NaN, ghost cells, several values, arrays of any type, and any number of
// threads.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace
{

using namespace reference;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid Contour(vtkDataSet* data, const std::vector<double>& values, bool mergePoints,
  int precision = vtkAlgorithm::DEFAULT_PRECISION)
{
  vtkNew<vtkIsotableContour> filter;
  filter->SetInputData(data);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    filter->SetValue(static_cast<int>(i), values[i]);
  }
  filter->SetMergePoints(mergePoints);
  filter->SetOutputPointsPrecision(precision);
  filter->WarnOnEmptyOutputOff();
  filter->Update();
  return filter->GetOutput();
}

/// Returns whether tuples of two arrays are bit-identical. NaNs with the same bits are equal.
bool IsSame(vtkAbstractArray* a, vtkIdType inA, vtkAbstractArray* b, vtkIdType inB)
{
  if (vtkStringArray* strings = vtkStringArray::SafeDownCast(a))
  {
    return strings->GetValue(inA) == vtkStringArray::SafeDownCast(b)->GetValue(inB);
  }
  for (int c = 0; c < a->GetNumberOfComponents(); ++c)
  {
    const double values[2] = { vtkDataArray::SafeDownCast(a)->GetComponent(inA, c),
      vtkDataArray::SafeDownCast(b)->GetComponent(inB, c) };
    if (std::memcmp(&values[0], &values[1], sizeof(double)) != 0)
    {
      return false;
    }
  }
  return true;
}

/// Compares all values of two arrays. at(i) is the index in \a shared for index i in \a own.
template <typename IndexFunction>
void CompareArray(vtkAbstractArray* own, vtkAbstractArray* shared, vtkIdType number,
  IndexFunction&& at, const std::string& name, Check& check)
{
  if (!check.That(own && shared, "array " + name) ||
    !check.Equal(own->GetDataType(), shared->GetDataType(), "type of " + name) ||
    !check.Equal(own->GetNumberOfTuples(), number, "values of " + name))
  {
    return;
  }
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < number; ++i)
  {
    different += !IsSame(own, i, shared, at(i));
  }
  check.Equal(different, 0, "values of " + name + " that differ");
}

/// Compares the contours with MergePoints off and on. Returns the number of triangles.
vtkIdType CompareSoup(vtkDataSet* data, const std::vector<double>& values, Check& check,
  int precision = vtkAlgorithm::DEFAULT_PRECISION)
{
  const Grid shared = Contour(data, values, true, precision);
  const Grid own = Contour(data, values, false, precision);
  const vtkIdType triangles = shared->GetNumberOfCells();
  check.Equal(own->GetNumberOfCells(), triangles, "triangles");
  check.Equal(own->GetNumberOfPoints(), 3 * triangles, "points");
  std::vector<vtkIdType> corners;
  for (vtkIdType t = 0; t < triangles && own->GetNumberOfCells() == triangles; ++t)
  {
    vtkIdType number;
    const vtkIdType* points;
    own->GetCellPoints(t, number, points);
    check.That(own->GetCellType(t) == VTK_TRIANGLE && number == 3 && points[0] == 3 * t &&
        points[1] == 3 * t + 1 && points[2] == 3 * t + 2,
      "ids of triangle " + std::to_string(t));
    shared->GetCellPoints(t, number, points);
    corners.insert(corners.end(), points, points + number);
  }
  if (corners.size() != static_cast<std::size_t>(own->GetNumberOfPoints()))
  {
    return triangles;
  }
  const auto ofCorner = [&](vtkIdType corner) { return corners[corner]; };
  const vtkIdType number = 3 * triangles;
  if (triangles > 0)
  {
    CompareArray(own->GetPoints()->GetData(), shared->GetPoints()->GetData(), number, ofCorner,
      "coordinates", check);
  }
  check.Equal(own->GetPointData()->GetNumberOfArrays(), shared->GetPointData()->GetNumberOfArrays(),
    "point arrays");
  for (int a = 0; a < shared->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = shared->GetPointData()->GetAbstractArray(a);
    CompareArray(own->GetPointData()->GetAbstractArray(array->GetName()), array, number, ofCorner,
      array->GetName(), check);
  }
  for (int a = 0; a < shared->GetCellData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = shared->GetCellData()->GetAbstractArray(a);
    CompareArray(
      own->GetCellData()->GetAbstractArray(array->GetName()), array, triangles,
      [](vtkIdType t) { return t; }, array->GetName(), check);
  }
  vtkDataArray* scalars[2] = { own->GetPointData()->GetScalars(),
    shared->GetPointData()->GetScalars() };
  check.That(
    !scalars[1] || (scalars[0] && !std::strcmp(scalars[0]->GetName(), scalars[1]->GetName())),
    "active scalars");
  return triangles;
}

/// Adds point arrays of several types, numbers of components and memory layouts, and a cell array.
void AddArrays(vtkDataSet* data, unsigned int seed)
{
  std::minstd_rand random(seed);
  const vtkIdType points = data->GetNumberOfPoints();
  const auto add = [&](vtkDataArray* array, const char* name, int components)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(points);
    for (vtkIdType p = 0; p < points; ++p)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponent(p, c, static_cast<double>(random() % 1000) - 500.0);
      }
    }
    data->GetPointData()->AddArray(array);
  };
  add(vtkNew<vtkFloatArray>(), "floats", 3);
  add(vtkNew<vtkDoubleArray>(), "doubles", 2);
  add(vtkNew<vtkShortArray>(), "shorts", 1);
  add(vtkNew<vtkIntArray>(), "integers", 1);
  add(vtkNew<vtkSOADataArrayTemplate<double>>(), "columns", 3);
  vtkNew<vtkStringArray> strings;
  strings->SetName("strings");
  for (vtkIdType p = 0; p < points; ++p)
  {
    strings->InsertNextValue("point " + std::to_string(p));
  }
  data->GetPointData()->AddArray(strings);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("cell ids");
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    ids->InsertNextValue(7 * c);
  }
  data->GetCellData()->AddArray(ids);
}

void CheckGrids(Check& check)
{
  auto image = MakeImage({ 9, 8, 7 });
  AddRandomField(image, 5);
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext(form.Name);
    AddArrays(form.Data, 3);
    check.That(CompareSoup(form.Data, { 0.5 }, check) > 500, "there are triangles");
    CompareSoup(form.Data, { 0.3, 0.8 }, check, vtkAlgorithm::DOUBLE_PRECISION);
  }
}

/// Tests random values in all cell types, then small integers, many of which equal an isovalue.
void CheckCells(Check& check)
{
  for (MeshKind kind : AllMeshKinds())
  {
    for (unsigned int seed = 1; seed <= 5; ++seed)
    {
      auto mesh =
        RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 4, 4, 4 }, seed), seed), seed);
      AddArrays(mesh, seed);
      check.SetContext(GetName(kind) + ", seed " + std::to_string(seed));
      AddRandomField(mesh, seed);
      check.That(CompareSoup(mesh, { 0.4, 0.7, 0.1 }, check) > 50, "there are triangles");
      CompareSoup(mesh, { 0.5 }, check, vtkAlgorithm::SINGLE_PRECISION);
      for (int values : { 2, 3, 7 })
      {
        check.SetContext(GetName(kind) + ", seed " + std::to_string(seed) + ", integers " +
          std::to_string(values));
        AddIntegerField(mesh, values, seed);
        CompareSoup(mesh, { 1.0 }, check);
        CompareSoup(mesh, { 1.0, 0.5, 2.0 }, check);
      }
    }
  }
}

/// Tests a mesh with global ids. Interpolation along an edge starts at the point with the smaller
/// global id.
void CheckGlobalIds(Check& check)
{
  check.SetContext("global ids");
  auto mesh = RenumberPoints(MakeMesh(MeshKind::Mixed, { 4, 4, 4 }, 2), 2);
  AddArrays(mesh, 2);
  AddIntegerField(mesh, 2, 4);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("global");
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    ids->InsertNextValue(3 * (mesh->GetNumberOfPoints() - p));
  }
  mesh->GetPointData()->SetGlobalIds(ids);
  check.That(CompareSoup(mesh, { 0.5 }, check) > 50, "there are triangles");
}

void CheckLeftOut(Check& check)
{
  for (MeshKind kind : { MeshKind::Hexahedra, MeshKind::Mixed })
  {
    for (unsigned char ghost :
      { vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL })
    {
      check.SetContext(GetName(kind) + ", ghost " + std::to_string(ghost));
      auto mesh = MakeMesh(kind, { 5, 5, 5 }, 3);
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      std::minstd_rand random(5);
      for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
      {
        ghosts->InsertNextValue(random() % 3 == 0 ? ghost : 0);
      }
      mesh->GetCellData()->AddArray(ghosts);
      AddRandomField(mesh, 3);
      check.That(CompareSoup(mesh, { 0.5 }, check) > 100, "there are triangles");
      vtkDoubleArray* values = AddIntegerField(mesh, 3, 3);
      CompareSoup(mesh, { 1.0 }, check);
      for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); p += 17)
      {
        values->SetValue(p, p % 2 == 0 ? std::nan("") : std::numeric_limits<double>::infinity());
      }
      CompareSoup(mesh, { 0.5 }, check);
    }
  }
}

void CheckNothing(Check& check)
{
  check.SetContext("nothing");
  auto mesh = MakeMesh(MeshKind::Mixed, { 2, 2, 2 }, 3);
  AddArrays(mesh, 3);
  AddRandomField(mesh, 3);
  check.Equal(CompareSoup(mesh, { 5.0 }, check), 0, "triangles for values outside the range");
  vtkNew<vtkUnstructuredGrid> empty;
  check.Equal(Contour(empty, { 0.5 }, false)->GetNumberOfCells(), 0, "triangles without points");
  vtkNew<vtkUnstructuredGrid> points;
  points->SetPoints(mesh->GetPoints());
  points->GetPointData()->ShallowCopy(mesh->GetPointData());
  check.Equal(CompareSoup(points, { 0.5 }, check), 0, "triangles without cells");
}

void CheckRuns(Check& check)
{
  auto mixed = MakeMesh(MeshKind::Mixed, { 14, 14, 14 });
  AddArrays(mixed, 5);
  AddRandomField(mixed, 5);
  CheckThreads(
    "random",
    [&] {
      return std::vector<Grid>{ Contour(mixed, { 0.3, 0.6 }, false) };
    },
    check);
  auto tied = MakeMesh(MeshKind::Hexahedra, { 24, 24, 24 });
  AddIntegerField(tied, 3, 5);
  CheckThreads(
    "ties", [&] { return std::vector<Grid>{ Contour(tied, { 1.0 }, false) }; }, check);
  for (vtkUnstructuredGrid* data : { mixed.Get(), tied.Get() })
  {
    check.SetContext("progress");
    vtkNew<vtkIsotableContour> contour;
    contour->SetValue(0, data == tied ? 1.0 : 0.4);
    contour->MergePointsOff();
    CheckProgress(contour, data, VTK_TRIANGLE, check);
  }
  vtkNew<vtkIsotableContour> contour;
  check.That(contour->GetMergePoints(), "points are merged by default");
  CheckPrinted(Print(contour), { "MergePoints: 1" }, check);
}

}

int TestIsotableContourSoup(int, char*[])
{
  Check check;
  CheckGrids(check);
  CheckCells(check);
  CheckGlobalIds(check);
  CheckLeftOut(check);
  CheckNothing(check);
  CheckRuns(check);
  return check.Result();
}
