// SPDX-License-Identifier: BSD-3-Clause
// Point arrays of every type are interpolated, never truncated; cell arrays are copied; the arrays
// the filters make have the documented names and values; the scalar may be of any type.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceTimeSteps.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkImageData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <set>

namespace
{

using namespace reference;

struct Type
{
  int Input;
  int Output; ///< of the interpolated array
  double Tolerance;
};

const Type Types[] = { { VTK_CHAR, VTK_FLOAT, 1e-6 }, { VTK_SIGNED_CHAR, VTK_FLOAT, 1e-6 },
  { VTK_UNSIGNED_CHAR, VTK_FLOAT, 1e-6 }, { VTK_SHORT, VTK_FLOAT, 1e-6 },
  { VTK_UNSIGNED_SHORT, VTK_FLOAT, 1e-6 }, { VTK_INT, VTK_DOUBLE, 1e-14 },
  { VTK_UNSIGNED_INT, VTK_DOUBLE, 1e-14 }, { VTK_LONG, VTK_DOUBLE, 1e-14 },
  { VTK_UNSIGNED_LONG, VTK_DOUBLE, 1e-14 }, { VTK_LONG_LONG, VTK_DOUBLE, 1e-14 },
  { VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE, 1e-14 }, { VTK_ID_TYPE, VTK_DOUBLE, 1e-14 },
  { VTK_FLOAT, VTK_FLOAT, 1e-6 }, { VTK_DOUBLE, VTK_DOUBLE, 1e-14 } };

/// Component c of the array of integers is an integer linear function on the integer lattice.
double Linear(const double* x, int c)
{
  return (c + 1) * x[0] + 2 * x[1] + 3 * x[2] + 5 * c;
}

std::string NameOf(int type)
{
  return "array-" + std::to_string(type);
}

vtkSmartPointer<vtkImageData> MakeInput(int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(6, 5, 4);
  for (const Type& type : Types)
  {
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type.Input));
    array->SetName(NameOf(type.Input).c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponent(i, c, Linear(image->GetPoint(i), c));
      }
    }
    image->GetPointData()->AddArray(array);
  }
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    number->InsertNextValue(static_cast<int>(i));
    text->InsertNextValue("cell " + std::to_string(i));
  }
  image->GetCellData()->AddArray(number);
  image->GetCellData()->AddArray(text);
  return image;
}

void CheckPointArrays(vtkUnstructuredGrid* grid, int components, Check& check)
{
  for (const Type& type : Types)
  {
    const std::string name = NameOf(type.Input);
    vtkDataArray* array = grid->GetPointData()->GetArray(name.c_str());
    if (!check.That(array != nullptr, name + " is carried"))
    {
      continue;
    }
    check.Equal(array->GetDataType(), type.Output, name + " has type");
    check.Equal(array->GetNumberOfComponents(), components, name + " has components");
    double error = 0;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      double x[3];
      grid->GetPoint(i, x);
      for (int c = 0; c < components; ++c)
      {
        error = std::max(error, std::abs(array->GetComponent(i, c) - Linear(x, c)));
      }
    }
    check.Near(error, 0, type.Tolerance, name + " is linear in position", 50);
  }
}

void CheckCellArrays(vtkUnstructuredGrid* grid, vtkImageData* image, Check& check)
{
  auto* number = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray("number"));
  auto* text = vtkStringArray::SafeDownCast(grid->GetCellData()->GetAbstractArray("text"));
  if (!check.That(number && text, "cell arrays are carried with their types"))
  {
    return;
  }
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    // The middle of a simplex lies in the cell it comes from.
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCellPoints(cell, count, ids);
    double bounds[6];
    image->GetCell(number->GetValue(cell))->GetBounds(bounds);
    bool inside = true;
    for (int a = 0; a < 3; ++a)
    {
      double middle = 0;
      for (vtkIdType i = 0; i < count; ++i)
      {
        middle += grid->GetPoint(ids[i])[a] / static_cast<double>(count);
      }
      inside = inside && middle >= bounds[2 * a] - 1e-12 && middle <= bounds[2 * a + 1] + 1e-12;
    }
    check.That(inside, "the cell number is that of the cell around the simplex");
    check.That(text->GetValue(cell) == "cell " + std::to_string(number->GetValue(cell)),
      "the cell text goes with the number");
  }
}

void CheckIds(vtkUnstructuredGrid* grid, const char* name, int values, Check& check)
{
  auto* ids = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray(name));
  if (check.That(ids != nullptr, std::string(name) + " is an int array"))
  {
    double range[2];
    ids->GetRange(range);
    check.That(range[0] == 0 && range[1] == values - 1, std::string(name) + " has its values");
  }
}

/// The scalar of another type gives the same geometry as doubles of the same values.
void CheckScalarTypes(Check& check)
{
  auto image = MakeInput(1);
  const std::vector<Interval> intervals = { { 7.5, 12 }, { 12, 20.25 } };
  vtkIdType tetrahedra = -1;
  for (auto type = std::rbegin(Types); type != std::rend(Types); ++type)
  {
    image->GetPointData()->SetActiveScalars(NameOf(type->Input).c_str());
    const Extraction extraction = ExtractIntervals(image, intervals);
    if (tetrahedra < 0)
    {
      tetrahedra = extraction.Volume->GetNumberOfCells();
      check.That(tetrahedra > 0, "there are tetrahedra");
    }
    check.Equal(extraction.Volume->GetNumberOfCells(), tetrahedra,
      "tetrahedra with scalar " + NameOf(type->Input));
  }
}

/// The output of one filter as the input of the next: the ids are the last one's.
void CheckCascade(Check& check)
{
  auto image = MakeInput(1);
  AddLinearField(image, { 0.1, { 1.01, 0.7, -0.35 } });
  const Extraction first = ExtractIntervals(image, { { 9, 10 }, { 0.7, 2.1 }, { 2.1, 4.05 } });
  first.Volume->GetPointData()->SetActiveScalars(NameOf(VTK_DOUBLE).c_str());
  const Extraction second = ExtractIntervals(first.Volume, { { 0, 13 } });
  const ContourExtraction contour = ExtractContours(first.Volume, { 13 });
  for (vtkUnstructuredGrid* grid :
    { second.Volume.Get(), second.Surface.Get(), contour.Surface.Get() })
  {
    check.That(grid->GetNumberOfCells() > 0, "there is output");
    std::set<std::string> names;
    for (int i = 0; i < grid->GetCellData()->GetNumberOfArrays(); ++i)
    {
      check.That(names.insert(grid->GetCellData()->GetArrayName(i)).second, "names are unique");
    }
  }
  CheckIds(second.Volume, "IntervalId", 1, check);
  CheckIds(second.Surface, "IntervalId", 1, check);
  CheckIds(contour.Surface, "ContourId", 1, check);
}

/// Ids and ghosts mean nothing for new points and cells: they must not come out under their roles.
void CheckRoles(Check& check)
{
  auto image = MakeInput(1);
  AddLinearField(image, { 0.1, { 1.01, 0.7, -0.35 } });
  vtkDataSetAttributes* const attributes[] = { image->GetPointData(), image->GetCellData() };
  const vtkIdType sizes[] = { image->GetNumberOfPoints(), image->GetNumberOfCells() };
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("ids");
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType id = 0; id < sizes[i]; ++id)
    {
      ids->InsertNextValue(id);
      ghosts->InsertNextValue(0);
    }
    attributes[i]->SetGlobalIds(ids);
    attributes[i]->AddArray(ghosts);
  }
  const Extraction extraction = ExtractIntervals(image, { { 0.7, 2.1 } });
  vtkUnstructuredGrid* grid = extraction.Volume;
  for (vtkDataSetAttributes* output : { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
         static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
  {
    check.That(output->GetGlobalIds() == nullptr, "no global ids");
    vtkAbstractArray* ghosts = output->GetAbstractArray(vtkDataSetAttributes::GhostArrayName());
    check.That(!ghosts || ghosts->GetDataType() == VTK_UNSIGNED_CHAR, "no ghosts of another type");
  }
}

/// An array without a name, and a string array, on lattices and meshes.
void CheckOddArrays(Check& check)
{
  for (const LatticeForm& form : FormsOf(MakeInput(1)))
  {
    vtkPointData* points = form.Data->GetPointData();
    points->Initialize();
    AddLinearField(form.Data, { 0.1, { 1.01, 0.7, -0.35 } });
    const double expected =
      ExtractIntervals(form.Data, { { 0.7, 2.1 } }).Report->GetNumber("CellsWithOutput");
    vtkNew<vtkStringArray> text;
    text->SetName("text");
    for (vtkIdType i = 0; i < form.Data->GetNumberOfPoints(); ++i)
    {
      text->InsertNextValue("point " + std::to_string(i));
    }
    points->AddArray(text);
    points->GetScalars()->SetName(nullptr);
    const Extraction extraction = ExtractIntervals(form.Data, { { 0.7, 2.1 } });
    check.That(expected > 0, "there is output");
    check.Near(extraction.Report->GetNumber("CellsWithOutput"), expected, 0.0,
      form.Name + ": unnamed scalars");
    check.That(extraction.Volume->GetPointData()->GetScalars() != nullptr,
      form.Name + ": unnamed scalars stay active");
  }
}

/// Arrays of an output without their names.
void CompareArrays(
  vtkPointData* found, vtkPointData* expected, const std::string& what, Check& check)
{
  if (!check.That(found->GetNumberOfArrays() == expected->GetNumberOfArrays(), what + ": arrays"))
  {
    return;
  }
  for (int a = 0; a < found->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* one = found->GetArray(a);
    vtkDataArray* other = expected->GetArray(a);
    const int components = other->GetNumberOfComponents();
    bool isSame = one->GetNumberOfTuples() == other->GetNumberOfTuples() &&
      one->GetNumberOfComponents() == components;
    for (vtkIdType i = 0; isSame && i < other->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        isSame = isSame && one->GetComponent(i, c) == other->GetComponent(i, c);
      }
    }
    check.That(isSame, what + ": values of array " + std::to_string(a));
  }
  for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role)
  {
    check.That(!found->GetAbstractAttribute(role) == !expected->GetAbstractAttribute(role),
      what + ": role " + std::to_string(role));
  }
}

/// The outputs of both filters, with further criteria or not.
std::vector<vtkSmartPointer<vtkUnstructuredGrid>> ExtractAll(vtkDataSet* data)
{
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> all;
  for (const bool keepsWhole : { false, true })
  {
    for (const bool hasCriterion : { false, true })
    {
      vtkNew<vtkIntervalVolume> filter;
      filter->SetInputData(data);
      filter->SetInterval(0, -1.0, 0.65);
      filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      filter->SetKeepWholeCells(keepsWhole);
      if (hasCriterion)
      {
        filter->AddCriterion("h", -1.0, 0.6);
      }
      filter->Update();
      all.emplace_back(filter->GetOutput());
    }
  }
  all.push_back(ExtractContours(data, { 0.65 }).Surface);
  return all;
}

/// Scalars, vectors and other arrays without a name come out as with one, on every kind of grid.
void CheckUnnamedArrays(Check& check)
{
  for (const SpaceTimeGrid& grid : AllSpaceTimeGrids({ 2, 2, 2 }, 3))
  {
    check.SetContext("arrays without a name, " + grid.Name);
    vtkPointData* points = grid.Data->GetPointData();
    AddLinearField(grid.Data, { 1.0, { 0.5, 2.0, 0.0 } }, "a");
    vtkNew<vtkDoubleArray> places;
    places->SetNumberOfComponents(3);
    places->SetName("places");
    for (vtkIdType i = 0; i < grid.Data->GetNumberOfPoints(); ++i)
    {
      places->InsertNextTuple(grid.Data->GetPoint(i));
    }
    points->SetVectors(places);
    double box[6];
    grid.Data->GetBounds(box);
    const double size[3] = { box[1] - box[0], box[3] - box[2], box[5] - box[4] };
    AddLinearField(grid.Data, { -box[0] / size[0], { 1.0 / size[0], 0.0, 0.0 } }, "h");
    AddLinearField(grid.Data, { -box[4] / size[2], { 0.0, 0.0, 1.0 / size[2] } });
    AddLinearField(grid.Data, { 7.0, { 0.0, -3.0, 1.0 } }, "b");
    points->SetActiveScalars("f");
    const double expected = static_cast<double>(ClippedVolume(grid.Data, { { "f", -1.0, 0.65 } }));
    const auto named = ExtractAll(grid.Data);
    for (const char* name : { "a", "b", "f", "places" })
    {
      points->GetAbstractArray(name)->SetName(nullptr);
    }
    const auto unnamed = ExtractAll(grid.Data);
    check.Near(static_cast<double>(MeasureTetrahedra(unnamed[0]).Sum), expected, 1e-12, "volume");
    for (std::size_t i = 0; i < named.size(); ++i)
    {
      const std::string what = "output " + std::to_string(i);
      check.That(named[i]->GetNumberOfCells() > 0, what + " has cells");
      CompareArrays(unnamed[i]->GetPointData(), named[i]->GetPointData(), what, check);
    }
  }
}

/// Arrays that end too soon are an error, with or without a name.
void CheckShortArrays(Check& check)
{
  check.SetContext("arrays that are too short");
  for (const bool isOfCells : { false, true })
  {
    for (const char* name : { "short", static_cast<const char*>(nullptr) })
    {
      const auto mesh = MakeMesh(MeshKind::Honeycomb, { 2, 2, 2 });
      AddLinearField(mesh, { 0.0, { 0.0, 0.0, 1.0 } });
      vtkNew<vtkIntArray> array;
      array->SetName(name);
      array->InsertNextValue(1);
      mesh->GetAttributes(isOfCells ? vtkDataObject::CELL : vtkDataObject::POINT)->AddArray(array);
      vtkNew<vtkIntervalVolume> filter;
      filter->SetInputData(mesh);
      filter->SetInterval(0, -1.0, 0.75);
      const std::string message = MessagesOf(filter);
      check.That(message.find(name ? "rray \"short\" has 1 tuple; "
                                   : "array without a name has 1") != std::string::npos &&
          message.find(isOfCells ? "for each cell" : "for each point") != std::string::npos,
        "it is reported: " + message);
    }
  }
}

/// Pedigree ids, which are not carried, may be the scalar of polyhedra that are coned.
void CheckPedigreeIds(Check& check)
{
  check.SetContext("pedigree ids");
  const auto mesh = MakeMesh(MeshKind::Honeycomb, { 2, 2, 2 });
  AddLinearField(mesh, { 0.0, { 0.0, 0.0, 1.0 } });
  const double expected = static_cast<double>(ClippedVolume(mesh, { { "f", -1.0, 0.75 } }));
  mesh->GetPointData()->SetPedigreeIds(mesh->GetPointData()->GetScalars());
  mesh->GetPointData()->SetActiveScalars(nullptr);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(mesh);
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::PEDIGREEIDS);
  filter->SetInterval(0, -1.0, 0.75);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  check.Near(
    static_cast<double>(MeasureTetrahedra(filter->GetOutput()).Sum), expected, 1e-12, "volume");
}
}

/// Values whose difference is not finite are interpolated, too.
void CheckHugeSteps(Check& check)
{
  constexpr double huge = 1.5e308;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  AddLinearField(image, { 0.0, { 1.0, 0.0, 0.0 } });
  vtkNew<vtkDoubleArray> values;
  values->SetName("huge");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(image->GetPoint(i)[0] > 0.5 ? huge : -huge);
  }
  image->GetPointData()->AddArray(values);
  for (const LatticeForm& form : FormsOf(image))
  {
    const auto grid = ExtractIntervals(form.Data, { { 0.25, 0.625 } }).Volume;
    vtkDataArray* found = grid->GetPointData()->GetArray("huge");
    check.Equal(grid->GetNumberOfPoints(), 8, form.Name + ": points");
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const double expected = huge * (2.0 * grid->GetPoint(i)[0] - 1.0);
      check.Near(found->GetComponent(i, 0), expected, 1e-14, form.Name + ": huge value");
    }
  }
}

/// Field data goes to both outputs, and to contours, once.
void CheckFieldData(Check& check)
{
  auto image = MakeInput(1);
  AddLinearField(image, { 0.1, { 1.01, 0.7, -0.35 } });
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  number->InsertNextValue(42);
  image->GetFieldData()->AddArray(number);
  image->GetFieldData()->AddArray(vtkNew<vtkIntArray>()); // Without a name.
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(image);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f");
  filter->SetInterval(0, 0.7, 2.1);
  filter->GenerateBoundariesOn();
  filter->Update();
  vtkNew<vtkIsotableContour> contour;
  contour->SetInputData(image);
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f");
  contour->SetValue(0, 0.7);
  contour->Update();
  for (vtkDataObject* output : { filter->GetOutputDataObject(0), filter->GetOutputDataObject(1),
         contour->GetOutputDataObject(0) })
  {
    vtkDataArray* found = output->GetFieldData()->GetArray("number");
    check.That(found && found->GetTuple1(0) == 42.0, "field data of an output");
    check.Equal(output->GetFieldData()->GetNumberOfArrays(), 2, "arrays of field data");
  }
}

int TestIntervalVolumeArrays(int, char*[])
{
  Check check;
  for (int components : { 1, 3, 9 })
  {
    check.SetContext(std::to_string(components) + " components");
    auto image = MakeInput(components);
    AddLinearField(image, { 0.1, { 1.01, 0.7, -0.35 } });
    const Extraction extraction = ExtractIntervals(image, { { 0.7, 2.1 }, { 2.1, 4.05 } });
    const ContourExtraction contours = ExtractContours(image, { 1.15, 3.3 });
    for (vtkUnstructuredGrid* grid :
      { extraction.Volume.Get(), extraction.Surface.Get(), contours.Surface.Get() })
    {
      check.That(grid->GetNumberOfCells() > 0, "there is output");
      CheckPointArrays(grid, components, check);
      CheckCellArrays(grid, image, check);
      check.That(grid->GetPointData()->GetScalars() != nullptr &&
          std::string(grid->GetPointData()->GetScalars()->GetName()) == "f",
        "the active scalars stay active");
    }
    CheckIds(extraction.Volume, "IntervalId", 2, check);
    CheckIds(extraction.Surface, "IntervalId", 2, check);
    CheckIds(extraction.Surface, "BoundarySide", 2, check);
    CheckIds(contours.Surface, "ContourId", 2, check);
    check.That(!extraction.Volume->GetCellData()->HasArray("BoundarySide"),
      "tetrahedra have no BoundarySide");
    check.Near(extraction.Report->GetNumber("ArraysInterpolated"),
      static_cast<int>(std::size(Types)) + 1, 0.0, "arrays interpolated");
    check.Near(extraction.Report->GetNumber("ArraysCopied"), 2, 0.0, "arrays copied");
  }
  check.SetContext("field data");
  CheckFieldData(check);
  check.SetContext("huge steps");
  CheckHugeSteps(check);
  check.SetContext("scalar types");
  CheckScalarTypes(check);
  check.SetContext("cascade");
  CheckCascade(check);
  check.SetContext("roles");
  CheckRoles(check);
  check.SetContext("odd arrays");
  CheckOddArrays(check);
  CheckUnnamedArrays(check);
  CheckPedigreeIds(check);
  CheckShortArrays(check);
  return check.Result();
}
