// SPDX-License-Identifier: BSD-3-Clause
// The walkers of images and rectilinear grids, compared with VTK's cells, finite differences,
// linear fields and straight lines. Also tests speeds, blanking, array types and errors.
#include "Support/Flow/ReferenceWalker.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "Fields/FieldDispatch.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUniformGrid.h"

#include <cmath>
#include <limits>

namespace
{

using namespace reference;

vtkSmartPointer<vtkImageData> MakeBox(int x, int y, int z)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x + 1, y + 1, z + 1);
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear(double ratio, double unit, bool isDescending)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(5, 4, 6);
  const int numbers[3] = { 5, 4, 6 };
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    double value = -0.3 * unit;
    double width = axis == 1 ? unit / ratio : unit;
    for (int i = 0; i < numbers[axis]; ++i, value += width, width *= 1.3)
    {
      coordinates[axis]->InsertNextValue(isDescending && axis == 2 ? -value : value);
    }
  }
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  return grid;
}

void CheckGrid(
  const std::string& name, vtkDataSet* data, double unit, Check& check, bool isTurned = false)
{
  check.SetContext(name);
  auto vectors = AddRandomVectors(data, 3);
  CallWithWalker(data, vectors, check,
    [&](const auto& walker)
    {
      CheckLocations(walker, data, vectors, 3, 1e-11, check, !isTurned && unit >= 1.0);
      CheckDerivatives(walker, data, vectors, unit == 1.0 ? 1e-8 : 1e-6, check);
      CheckPoints(walker, data, check);
      if (!isTurned)
      {
        CheckLines(walker, data, 20, unit, check);
      }
    });
  CheckLinearField(data, unit, isTurned ? 1e-11 : 1e-12, check);
}

void CheckGrids(Check& check)
{
  auto image = MakeImage({ 6, 5, 7 });
  CheckGrid("image", image, 1.0, check);
  auto shifted = MakeImage({ 6, 5, 7 });
  shifted->SetExtent(-3, 3, 2, 7, 10, 17);
  CheckGrid("shifted", shifted, 1.0, check);
  auto turned = MakeImage({ 6, 5, 7 });
  turned->SetExtent(-3, 3, 2, 7, 10, 17);
  turned->SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
  CheckGrid("turned", turned, 1.0, check, true);
  for (const double unit : { 1e-9, 1e9 })
  {
    auto scaled = MakeBox(4, 5, 3);
    scaled->SetSpacing(unit, 1e-4 * unit, 2.0 * unit);
    scaled->SetOrigin(-2.5 * unit, 1e-4 * unit, unit);
    CheckGrid("planar cells of " + std::to_string(unit), scaled, unit, check);
    CheckGrid("rectilinear, planar cells of " + std::to_string(unit),
      MakeRectilinear(1e4, unit, false), unit, check);
  }
  CheckGrid("rectilinear", MakeRectilinear(1.0, 1.0, false), 1.0, check);
  CheckGrid("descending", MakeRectilinear(1.0, 1.0, true), 1.0, check);
}

// Walks along the diagonal through points, along an edge, and within a face.
void CheckCorners(Check& check)
{
  auto image = MakeBox(4, 4, 4);
  CheckCornerLines("", image, check);
  CallWithWalker(image, image->GetPointData()->GetVectors(), check,
    [&](const auto& walker) {
      CheckLine(walker, image, { { 2, 2, 2 } }, { { -1, -1, 1 } }, 1.0, check);
    });
}

void CheckDomainFaces(Check& check)
{
  check.SetContext("domain faces");
  auto image = MakeBox(4, 2, 3);
  auto vectors = AddRandomVectors(image, 5);
  CallWithWalker(image, vectors, check,
    [&](auto walker)
    {
      const Vector x = { { 3.5, 0.25, 1.75 } };
      Vector p;
      walker.Locate(x.data(), p.data());
      const int expected[6] = { -1, 1, 2, -1, -1, -1 };
      for (int face = 0; face < 6; ++face)
      {
        check.Equal(walker.GetDomainFace(face), expected[face], "face " + std::to_string(face));
      }
      double uv[2];
      walker.GetDomainParameters(1, p.data(), uv);
      check.Near(uv[0], 0.125, 1e-15, "u of +i is along j");
      check.Near(uv[1], 1.75 / 3.0, 1e-15, "v of +i is along k");
      walker.GetDomainParameters(2, p.data(), uv);
      check.Near(uv[0], 0.875, 1e-15, "u of -j is along i");
      check.Near(uv[1], 1.75 / 3.0, 1e-15, "v of -j is along k");
      walker.GetDomainParameters(4, p.data(), uv);
      check.Near(uv[0], 0.875, 1e-15, "u of -k is along i");
      check.Near(uv[1], 0.125, 1e-15, "v of -k is along j");
    });
}

void CheckBlanking(Check& check)
{
  check.SetContext("blanking");
  auto image = vtkSmartPointer<vtkUniformGrid>::New();
  image->SetDimensions(5, 4, 4);
  image->AllocateCellGhostArray();
  HideLayer(image->GetCellGhostArray());
  auto vectors = AddRandomVectors(image, 5);
  CallWithWalker(image, vectors, check,
    [&](auto walker)
    {
      const auto stopped = CheckHiddenLayer(walker, check);
      check.Equal(stopped.Stand.GetDomainFace(stopped.EndFace), -1, "not a domain face");
      check.Equal(stopped.Stand.GetCell(), 1, "the walker is unchanged");
      Vector p;
      const Vector far = { { 3.0, 0.5, 0.5 } };
      check.That(walker.Locate(far.data(), p.data()) && walker.GetCell() == 3 && p[0] == 0.0,
        "a point on the opposite face is in that neighbor");
      const Vector corner = { { 2.0, 1.0, 1.0 } };
      check.That(walker.Locate(corner.data(), p.data()), "a grid point is in a cell of the field");
      check.Near(
        GetNorm(PositionOf(walker, p) - corner), 0.0, 1e-15, "position of the grid point", 1.0);
    });

  check.SetContext("hidden points");
  auto points = vtkSmartPointer<vtkUniformGrid>::New();
  points->SetDimensions(4, 4, 4);
  auto outlier = AddVectors(points,
    [](const Vector& x)
    {
      const bool isHidden = x[0] + x[1] + x[2] == 0.0;
      return Vector{ { isHidden ? std::nan("") : 3.0, 0.0, isHidden ? 7.0 : 4.0 } };
    });
  points->BlankPoint(0);
  CallWithWalker(points, outlier, check,
    [&](auto walker)
    {
      Vector p;
      const Vector x = { { 0.5, 0.5, 0.5 } };
      check.That(!walker.Locate(x.data(), p.data()), "a cell with a hidden point is not found");
      check.Equal(walker.GetField().GetNumberOfNonFiniteVectors(), 0, "hidden vectors");
      check.Near(walker.GetField().GetMaximumSpeed(), 5.0, 1e-15, "maximum speed");
    });
}

void CheckNonFinite(Check& check)
{
  check.SetContext("not finite");
  auto image = MakeBox(4, 4, 4);
  const double infinity = std::numeric_limits<double>::infinity();
  auto vectors = AddVectors(image,
    [&](const Vector& x)
    {
      return Vector{ { x[0] == 0.0 && x[1] == 0.0 && x[2] == 0.0 ? std::nan("") : 1e200,
        x[0] == 4.0 && x[1] == 4.0 && x[2] == 4.0 ? infinity : 1e200, 0.0 } };
    });
  CallWithWalker(image, vectors, check,
    [&](auto walker)
    {
      check.Equal(walker.GetField().GetNumberOfNonFiniteVectors(), 2, "vectors");
      check.Near(walker.GetField().GetMaximumSpeed(), std::sqrt(2.0) * 1e200, 1e-14, "speed");
      Vector p;
      for (int cell = 0; cell < 4; ++cell)
      {
        const double c = cell + 0.5;
        const Vector x = { { c, c, c } };
        check.That(walker.Locate(x.data(), p.data()), "the cell is found");
        check.Equal(walker.IsFinite(), cell == 1 || cell == 2,
          "the cell is recognized as finite or non-finite");
      }
      const Vector nowhere = { { std::nan(""), 1.0, 1.0 } };
      check.That(!walker.Locate(nowhere.data(), p.data()), "a NaN position is not found");
      const Vector outside = { { 4.0 + 1e-9, 1.0, 1.0 } };
      check.That(!walker.Locate(outside.data(), p.data()), "a point outside is not found");
    });
}

void CheckTypes(Check& check)
{
  const VectorField field = [](const Vector& x) {
    return Vector{ { x[0], 2.0 + x[1], 1.0 + x[2] } };
  };
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    auto image = MakeBox(3, 3, 3);
    auto vectors = AddVectors(image, field, type);
    check.SetContext(vectors->GetDataTypeAsString());
    vtkNew<vtkSOADataArrayTemplate<double>> columns;
    columns->DeepCopy(vectors);
    vtkSmartPointer<vtkDataArray> values;
    values.TakeReference(vtkDataArray::CreateDataArray(type));
    values->SetNumberOfTuples(image->GetNumberOfPoints());
    for (vtkIdType point = 0; point < image->GetNumberOfPoints(); ++point)
    {
      double x[3];
      image->GetPoint(point, x);
      values->SetTuple1(point, x[0] + 2.0 * x[1] + 3.0 * x[2]);
    }
    for (vtkDataArray* array : { vectors.Get(), static_cast<vtkDataArray*>(columns.Get()) })
    {
      const interlume::Error error = interlume::FieldDispatch::Execute(image, array, { values },
        [&](auto walker)
        {
          const Vector x = { { 0.25, 1.5, 2.75 } };
          Vector p;
          check.That(walker.Locate(x.data(), p.data()), "the position is found");
          check.Near(GetNorm(VelocityOf(walker, p) - field(x)), 0.0, 1e-14, "velocity", 1.0);
          check.Equal(walker.GetField().GetNumberOfArrays(), 1, "arrays");
          check.Near(walker.Interpolate(0, p.data()), 11.5, 1e-14, "an array's value");
          check.Near(walker.GetField().GetMaximumSpeed(), std::sqrt(9.0 + 25.0 + 16.0), 1e-15,
            "maximum speed");
          check.Near(walker.GetField().GetBounds()[3], 3.0, 0.0, "bounds");
        });
      check.That(!error, error.GetMessage());
    }
  }
}

// Tests vectors with integers that single precision cannot represent.
void CheckLargeIntegers(Check& check)
{
  check.SetContext("large integers");
  auto image = MakeBox(2, 2, 2);
  auto vectors = AddVectors(
    image,
    [](const Vector&) {
      return Vector{ { 16777217.0, 0.0, 0.0 } };
    },
    VTK_INT);
  CallWithWalker(image, vectors, check,
    [&](const auto& walker)
    { check.Equal(std::llround(walker.GetField().GetMaximumSpeed()), 16777217, "maximum speed"); });
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  const auto expect = [&](vtkDataSet* data, vtkDataArray* vectors,
                        const std::vector<vtkDataArray*>& arrays, const std::string& text)
  {
    bool isCalled = false;
    const interlume::Error error = interlume::FieldDispatch::Execute(
      data, vectors, arrays, [&](const auto&) { isCalled = true; });
    check.That(!isCalled && error.GetMessage() == text,
      "expected \"" + text + "\", found \"" + error.GetMessage() + "\"");
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    auto plane = MakeBox(axis == 0 ? 0 : 3, axis == 1 ? 0 : 3, axis == 2 ? 0 : 3);
    expect(plane, AddRandomVectors(plane, 1), {},
      "the field has no three-dimensional cells. Flow in a plane needs two layers of points: "
      "append an image to itself along the third axis, or extrude other grids");
  }
  auto image = MakeBox(2, 2, 2);
  auto vectors = AddRandomVectors(image, 1);
  expect(image, nullptr, {}, "there is no array of vectors");
  expect(image, vectors, { nullptr }, "there is no array of numbers");
  expect(image, vectors, { vectors }, "array \"velocity\" has 3 components; 1 is needed");
  vtkNew<vtkDoubleArray> wrong;
  wrong->SetName("wrong");
  wrong->SetNumberOfComponents(2);
  wrong->SetNumberOfTuples(27);
  expect(image, wrong, {}, "array \"wrong\" has 2 components; 3 are needed");
  vtkNew<vtkDoubleArray> shorter;
  shorter->SetNumberOfComponents(3);
  shorter->SetNumberOfTuples(26);
  expect(image, shorter, {},
    "the array without a name has 26 tuples; 27 are needed, one for each point");
  image->SetSpacing(1.0, 0.0, 1.0);
  expect(image, vectors, {}, "the image's spacing or direction matrix is singular or not finite");
  auto grid = MakeRectilinear(1.0, 1.0, false);
  auto gridVectors = AddRandomVectors(grid, 1);
  grid->GetYCoordinates()->SetTuple1(2, -5.0);
  expect(grid, gridVectors, {},
    "the y coordinates are not strictly monotonic at index 2 (-5 after 0.7)");
  grid->GetYCoordinates()->SetTuple1(2, std::nan(""));
  expect(grid, gridVectors, {}, "coordinate 2 along y is not finite");
  vtkNew<vtkPolyData> surface;
  expect(surface, vectors, {},
    "the field must be an image or a rectilinear, structured or unstructured grid, not a "
    "vtkPolyData");
  expect(nullptr, vectors, {}, "there is no dataset");
}

}

int TestFlowWalkerImage(int, char*[])
{
  return RunChecks({ CheckGrids, CheckCorners, CheckDomainFaces, CheckBlanking, CheckNonFinite,
    CheckTypes, CheckLargeIntegers, CheckErrors });
}
