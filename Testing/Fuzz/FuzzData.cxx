// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzData.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fuzz
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Denormal = std::numeric_limits<double>::denorm_min();

const std::vector<double> ExtremeNumbers = { NaN, Infinity, -Infinity, Denormal, 1e300, -1e300,
  1e-300, 0.0, -0.0 };

std::array<int, 3> MakeDimensions(FuzzRandom& random)
{
  // If an axis has only one point, the grid is lower-dimensional.
  const int smallest = random.Chance(0.1) ? 1 : 2;
  return { { random.Integer(smallest, 7), random.Integer(smallest, 7),
    random.Integer(smallest, 7) } };
}

/// Returns increasing or decreasing coordinates. Unless \a isTame is true, some are equal, out of
/// order, or not finite.
vtkSmartPointer<vtkDoubleArray> MakeCoordinates(FuzzRandom& random, int count, bool isTame)
{
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  double x = random.Between(-2.0, 2.0);
  for (int i = 0; i < count; ++i)
  {
    coordinates->InsertNextValue(x);
    x +=
      isTame ? random.Between(0.1, 1.0) : random.Pick<double>({ 0.0, 1e-12, 0.3, 1.0, 1e6, -0.5 });
  }
  const double sign = random.Chance(0.2) ? -1.0 : 1.0;
  for (double& value : vtk::DataArrayValueRange<1>(coordinates.Get()))
  {
    value *= sign;
  }
  if (!isTame && random.Chance(0.05))
  {
    coordinates->SetValue(random.Integer(0, count - 1), random.Pick(ExtremeNumbers));
  }
  return coordinates;
}

vtkSmartPointer<vtkDataSet> MakeRectilinear(FuzzRandom& random, bool isTame)
{
  const auto dimensions = MakeDimensions(random);
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(dimensions.data());
  grid->SetXCoordinates(MakeCoordinates(random, dimensions[0], isTame));
  grid->SetYCoordinates(MakeCoordinates(random, dimensions[1], isTame));
  grid->SetZCoordinates(MakeCoordinates(random, dimensions[2], isTame));
  return grid;
}

vtkSmartPointer<vtkDataSet> MakeStructured(FuzzRandom& random, bool isTame)
{
  const auto dimensions = MakeDimensions(random);
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(dimensions.data());
  vtkNew<vtkPoints> points;
  points->SetDataType(random.Chance(0.5) ? VTK_FLOAT : VTK_DOUBLE);
  const bool isClosed = !isTame && random.Chance(0.3);
  const double jitter = isTame ? 0.0 : random.Pick<double>({ 0.0, 0.2, 1.0 });
  for (const auto& [k, j, i] : reference::AllIndices(dimensions[2], dimensions[1], dimensions[0]))
  {
    // The last column of a closed grid coincides with its first column.
    const double angle =
      6.283185307179586 * (i % std::max(dimensions[0] - 1, 1)) / std::max(dimensions[0] - 1, 1);
    double x[3] = { 1.0 * i, 1.0 * j, 1.0 * k };
    if (isClosed)
    {
      x[0] = (1.0 + j) * std::cos(angle);
      x[1] = (1.0 + j) * std::sin(angle);
    }
    for (double& value : x)
    {
      value += random.Between(-jitter, jitter);
    }
    points->InsertNextPoint(x);
  }
  grid->SetPoints(points);
  return grid;
}

/// Adds invalid cells: duplicates, cells with repeated points, lower-dimensional cells and inverted
/// or self-intersecting hexahedra. Also adds unused points.
void AddInvalidCells(FuzzRandom& random, vtkUnstructuredGrid* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType cells = mesh->GetNumberOfCells();
  if (points == 0 || cells == 0)
  {
    return;
  }
  const auto any = [&]() { return static_cast<vtkIdType>(random.Next() % points); };
  const int count = random.Integer(1, 6);
  for (int i = 0; i < count; ++i)
  {
    switch (random.Integer(0, 5))
    {
      case 0:
      {
        vtkNew<vtkIdList> ids;
        const vtkIdType cell = static_cast<vtkIdType>(random.Next() % cells);
        if (mesh->GetCellType(cell) != VTK_POLYHEDRON)
        {
          mesh->GetCellPoints(cell, ids);
          mesh->InsertNextCell(mesh->GetCellType(cell), ids);
        }
        break;
      }
      case 1:
      {
        const vtkIdType id = any();
        const vtkIdType tetrahedron[4] = { id, id, any(), any() };
        mesh->InsertNextCell(VTK_TETRA, 4, tetrahedron);
        break;
      }
      case 2:
      {
        const vtkIdType hexahedron[8] = { any(), any(), any(), any(), any(), any(), any(), any() };
        mesh->InsertNextCell(VTK_HEXAHEDRON, 8, hexahedron);
        break;
      }
      case 3:
      {
        const vtkIdType triangle[3] = { any(), any(), any() };
        mesh->InsertNextCell(VTK_TRIANGLE, 3, triangle);
        break;
      }
      case 4:
      {
        const vtkIdType vertex = any();
        mesh->InsertNextCell(VTK_VERTEX, 1, &vertex);
        break;
      }
      default:
        mesh->GetPoints()->InsertNextPoint(random.Unit(), random.Unit(), random.Unit());
    }
  }
}

vtkSmartPointer<vtkDataSet> MakeUnstructured(
  FuzzRandom& random, const std::vector<reference::MeshKind>& kinds, bool isTame)
{
  if (!isTame && random.Chance(0.05))
  {
    auto empty = vtkSmartPointer<vtkUnstructuredGrid>::New();
    empty->SetPoints(vtkNew<vtkPoints>());
    return empty;
  }
  const unsigned seed = static_cast<unsigned>(random.Next());
  vtkSmartPointer<vtkUnstructuredGrid> mesh = reference::MakeMesh(random.Pick(kinds),
    { { random.Integer(1, 4), random.Integer(1, 4), random.Integer(1, 3) } }, seed);
  if (random.Chance(0.3))
  {
    mesh = reference::RotateCellPointOrder(mesh, seed);
  }
  if (random.Chance(0.3))
  {
    mesh = reference::RenumberPoints(mesh, seed);
  }
  if (!isTame && random.Chance(0.2))
  {
    mesh = reference::InvertCells(mesh);
  }
  if (!isTame && random.Chance(0.5))
  {
    AddInvalidCells(random, mesh);
  }
  return mesh;
}

/// Moves, scales and flattens the points of a dataset, and in some cases makes a coordinate
/// extreme.
void Distort(FuzzRandom& random, FuzzData& data)
{
  auto* grid = vtkPointSet::SafeDownCast(data.Data);
  if (!grid || !grid->GetPoints() || grid->GetNumberOfPoints() == 0)
  {
    return;
  }
  const double scale = random.Pick<double>({ 1.0, 1e-30, 1e-6, 1e6, 1e30 });
  const double offset = random.Pick<double>({ 0.0, 1.0, 1e5, -1e8 }) * scale;
  const double squeeze = random.Pick<double>({ 1.0, 1.0, 1e-9, 0.0 });
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    grid->GetPoints()->SetPoint(
      i, offset + scale * x[0], offset + scale * x[1], offset + scale * squeeze * x[2]);
  }
  if (random.Chance(0.1))
  {
    const vtkIdType point = static_cast<vtkIdType>(random.Next() % grid->GetNumberOfPoints());
    grid->GetPoints()->SetPoint(point, random.Pick(ExtremeNumbers), 0.0, 0.0);
  }
  grid->GetPoints()->Modified();
  data.Text += ", distorted";
}

void AddValues(FuzzRandom& random, FuzzData& data)
{
  static const std::vector<int> types = { VTK_FLOAT, VTK_DOUBLE, VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR,
    VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_ID_TYPE };
  const int type = random.Chance(0.5) ? VTK_DOUBLE : random.Pick(types);
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("f");
  array->SetNumberOfTuples(data.Data->GetNumberOfPoints());
  const int kind = random.Integer(0, 3);
  const double scale = isReal && random.Chance(0.2) ? random.Pick<double>({ 1e-30, 1e20 }) : 1.0;
  double gradient[3] = { random.Between(-1.0, 1.0), random.Between(-1.0, 1.0), 0.3 };
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double x[3];
    data.Data->GetPoint(i, x);
    double value = 0.5;
    if (kind == 0)
    {
      value = isReal ? random.Unit() : random.Integer(0, 100);
    }
    else if (kind == 1)
    {
      value = random.Integer(0, 3);
    }
    else if (kind == 2 && std::abs(x[0]) < 1e6)
    {
      value = gradient[0] * x[0] + gradient[1] * x[1] + gradient[2] * x[2];
    }
    array->SetTuple1(i, isReal ? scale * value : std::clamp(value, 0.0, 100.0));
  }
  if (isReal && !data.IsTame && random.Chance(0.3) && array->GetNumberOfTuples() > 0)
  {
    const int count = random.Integer(1, 3);
    for (int i = 0; i < count; ++i)
    {
      array->SetTuple1(static_cast<vtkIdType>(random.Next() % array->GetNumberOfTuples()),
        random.Pick(ExtremeNumbers));
    }
    data.Text += ", extreme values";
  }
  data.Text +=
    ", " + std::string(array->GetDataTypeAsString()) + " of kind " + std::to_string(kind);
  data.Data->GetPointData()->SetScalars(array);
}

void AddFlags(FuzzRandom& random, FuzzData& data)
{
  const bool isCellArray = random.Chance(0.7);
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  const vtkIdType count =
    isCellArray ? data.Data->GetNumberOfCells() : data.Data->GetNumberOfPoints();
  int hidden = vtkDataSetAttributes::HIDDENPOINT;
  int duplicate = vtkDataSetAttributes::DUPLICATEPOINT;
  if (isCellArray)
  {
    hidden = vtkDataSetAttributes::HIDDENCELL;
    duplicate = vtkDataSetAttributes::DUPLICATECELL;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    flags->InsertNextValue(static_cast<unsigned char>(
      random.Chance(0.8) ? 0 : random.Pick<int>({ hidden, duplicate, hidden | duplicate })));
  }
  data.Data->GetAttributes(isCellArray ? vtkDataObject::CELL : vtkDataObject::POINT)
    ->AddArray(flags);
  data.Text += isCellArray ? ", flags of cells" : ", flags of points";
}

void AddCellArray(FuzzData& data)
{
  vtkNew<vtkIntArray> array;
  array->SetName("c");
  for (vtkIdType i = 0; i < data.Data->GetNumberOfCells(); ++i)
  {
    array->InsertNextValue(static_cast<int>(i));
  }
  data.Data->GetCellData()->AddArray(array);
}

/// Adds global ids of a random type, in reverse order. Unless the data are tame, the array may be
/// too short or a floating-point array, which is an error.
void AddGlobalIds(FuzzRandom& random, FuzzData& data)
{
  static const std::vector<int> types = { VTK_ID_TYPE, VTK_INT, VTK_LONG_LONG, VTK_UNSIGNED_INT,
    VTK_UNSIGNED_LONG_LONG, VTK_SHORT };
  const int type = !data.IsTame && random.Chance(0.1) ? VTK_DOUBLE : random.Pick(types);
  const auto ids = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  ids->SetName("global ids");
  const vtkIdType points = data.Data->GetNumberOfPoints();
  const bool isShort = !data.IsTame && points > 0 && random.Chance(0.1);
  ids->SetNumberOfTuples(isShort ? points - 1 : points);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ids->SetTuple1(i, static_cast<double>(points - 1 - i));
  }
  data.Data->GetPointData()->SetGlobalIds(ids);
  data.Text += std::string(", ") + (isShort ? "too few " : "") + "global ids of type " +
    ids->GetDataTypeAsString();
}

/// Removes the name of the scalars in half of the cases, and adds unnamed arrays.
void AddUnnamedArrays(FuzzRandom& random, FuzzData& data)
{
  if (random.Chance(0.5))
  {
    data.Data->GetPointData()->GetScalars()->SetName(nullptr);
  }
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetNumberOfComponents(random.Integer(1, 3));
    array->SetNumberOfTuples(data.Data->GetNumberOfElements(association));
    array->Fill(random.Unit());
    data.Data->GetAttributes(association)->AddArray(array);
  }
  data.Text += ", unnamed arrays";
}

/// Adds values, flags and arrays to a dataset that has coordinates.
FuzzData Finish(FuzzRandom& random, FuzzData data)
{
  if (!data.IsTame && random.Chance(0.4))
  {
    Distort(random, data);
  }
  AddValues(random, data);
  if (!data.IsTame && random.Chance(0.3))
  {
    AddFlags(random, data);
  }
  if (random.Chance(0.5))
  {
    AddCellArray(data);
  }
  if (random.Chance(0.2))
  {
    AddGlobalIds(random, data);
  }
  if (random.Chance(0.2))
  {
    AddUnnamedArrays(random, data);
  }
  data.Text += data.IsTame ? ", tame" : "";
  return data;
}

}

FuzzData MakeImage(FuzzRandom& random)
{
  FuzzData data;
  data.IsTame = random.Chance(0.5);
  const auto dimensions = MakeDimensions(random);
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int first[3] = { random.Integer(-5, 5), random.Integer(0, 3), random.Integer(-3, 0) };
  image->SetExtent(first[0], first[0] + dimensions[0] - 1, first[1], first[1] + dimensions[1] - 1,
    first[2], first[2] + dimensions[2] - 1);
  image->SetOrigin(
    random.Between(-3.0, 3.0), 0.0, data.IsTame ? 1.0 : random.Pick<double>({ 0.0, 1e7 }));
  const auto sign = [&random]() { return random.Chance(0.15) ? -1.0 : 1.0; };
  image->SetSpacing(sign() * random.Between(0.1, 2.0),
    sign() * (data.IsTame ? 1.0 : random.Pick<double>({ 1.0, 1e-9, 1e9 })),
    sign() * random.Between(0.1, 2.0));
  if (random.Chance(0.2))
  {
    const double a = random.Between(0.0, 3.0);
    image->SetDirectionMatrix(
      std::cos(a), -std::sin(a), 0.0, std::sin(a), std::cos(a), 0.0, 0.0, 0.0, sign());
  }
  if (!data.IsTame && random.Chance(0.05))
  {
    image->SetOrigin(random.Pick(ExtremeNumbers), 0.0, 0.0);
  }
  data.Data = image;
  data.Text = "image";
  return Finish(random, data);
}

FuzzData MakeTetrahedra(FuzzRandom& random)
{
  FuzzData data;
  data.IsTame = random.Chance(0.5);
  data.Data = MakeUnstructured(random, reference::TetrahedralMeshKinds(), data.IsTame);
  data.Text = "tetrahedra";
  return Finish(random, data);
}

FuzzData MakeData(FuzzRandom& random)
{
  FuzzData data;
  data.IsTame = random.Chance(0.4);
  switch (random.Integer(0, 4))
  {
    case 0:
      return MakeImage(random);
    case 1:
      data.Data = MakeRectilinear(random, data.IsTame);
      data.Text = "rectilinear grid";
      break;
    case 2:
      data.Data = MakeStructured(random, data.IsTame);
      data.Text = "structured grid";
      break;
    default:
      data.Data = MakeUnstructured(random, reference::AllMeshKinds(), data.IsTame);
      data.Text = "unstructured grid";
  }
  return Finish(random, data);
}

void AddVectors(FuzzRandom& random, FuzzData& data)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  const int kind = random.Integer(0, 3);
  // Points without data have one fill value in all components.
  const double fill = random.Pick<double>({ 1e20, 9.96921e36, -9999.0, -30000.0 });
  const double fillFraction = !data.IsTame && random.Chance(0.2) ? random.Between(0.0, 0.5) : 0.0;
  data.Text += fillFraction > 0.0 ? ", fill values " + std::to_string(fill) : "";
  for (vtkIdType i = 0; i < data.Data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data.Data->GetPoint(i, x);
    double v[3] = { 1.0, 0.2, 0.1 };
    if (random.Chance(fillFraction))
    {
      std::fill_n(v, 3, fill);
    }
    else if (kind == 0)
    {
      v[0] = -x[1] + 0.3;
      v[1] = x[0];
      v[2] = 0.2;
    }
    else if (kind == 1)
    {
      for (double& component : v)
      {
        component = random.Between(-1.0, 1.0);
      }
    }
    else if (kind == 2)
    {
      std::fill_n(v, 3, 0.0);
    }
    vectors->InsertNextTuple(v);
  }
  if (!data.IsTame && random.Chance(0.3) && vectors->GetNumberOfTuples() > 0)
  {
    vectors->SetComponent(static_cast<vtkIdType>(random.Next() % vectors->GetNumberOfTuples()),
      random.Integer(0, 2), random.Pick(ExtremeNumbers));
    data.Text += ", an extreme vector";
  }
  data.Data->GetPointData()->SetVectors(vectors);
  data.Text += ", vectors of kind " + std::to_string(kind);
}

double MakeBound(FuzzRandom& random, vtkDataArray* values)
{
  const vtkIdType count = values ? values->GetNumberOfTuples() : 0;
  if (count == 0 || random.Chance(0.03))
  {
    return random.Pick(ExtremeNumbers);
  }
  const double at = values->GetTuple1(static_cast<vtkIdType>(random.Next() % count));
  const double other = values->GetTuple1(static_cast<vtkIdType>(random.Next() % count));
  switch (random.Integer(0, 3))
  {
    case 0:
      return at;
    case 1:
      return std::nextafter(at, Infinity);
    default:
      return at + random.Between(-0.2, 1.2) * (other - at);
  }
}

}
