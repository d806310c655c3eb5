// SPDX-License-Identifier: BSD-3-Clause
// The output for a cell array equals, byte for byte, the output for the point array that
// vtkCellDataToPointData makes of it. Tests every filter that selects an array, on every kind of
// grid, with blanked cells, ghost cells, NaN, blocks with different associations, and inputs and
// selections that change.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferencePieceSource.h"
#include "Support/TimeVarying/ReferenceTemporal.h"

#include "vtkFlowBoundary.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFlowLIC.h"
#include "vtkImplicitFlowField.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkTimeSlabWriter.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkVortexAxis.h"

#include "vtkAMRBox.h"
#include "vtkAppendFilter.h"
#include "vtkBitArray.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkTerminationPlane.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int Cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
constexpr int Both = vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;

/// A swirl around a vertical line with a critical point in the middle, and a wavy scalar.
Vector GetVelocity(const Vector& x)
{
  return { { 1.7 - x[1] + 0.1 * (x[0] - 2.2), x[0] - 2.2 + 0.1 * (x[1] - 1.7), x[2] - 1.9 } };
}

double GetScalar(const Vector& x)
{
  return std::sin(1.3 * x[0]) + std::cos(0.9 * x[1]) + 0.4 * x[2];
}

using Field = std::function<std::vector<double>(const Vector&)>;

vtkSmartPointer<vtkDoubleArray> MakeArray(
  vtkDataSet* data, int association, const char* name, const Field& field)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(field({}).size()));
  for (vtkIdType i = 0; i < data->GetNumberOfElements(association); ++i)
  {
    Vector x;
    if (association == Points)
    {
      data->GetPoint(i, x.data());
    }
    else
    {
      double bounds[6];
      data->GetCellBounds(i, bounds);
      x = { { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
        0.5 * (bounds[4] + bounds[5]) } };
    }
    array->InsertNextTuple(field(x).data());
  }
  return array;
}

std::vector<double> ScalarField(const Vector& x)
{
  return { GetScalar(x) };
}

std::vector<double> VectorsField(const Vector& x)
{
  const Vector v = GetVelocity(x);
  return { v[0], v[1], v[2] };
}

/// Adds the cell arrays "s" (active scalars) and "w" (active vectors), and other arrays that must
/// be passed.
void AddArrays(vtkDataSet* data)
{
  data->GetPointData()->Initialize();
  vtkCellData* cells = data->GetCellData();
  cells->SetScalars(MakeArray(data, Cells, "s", ScalarField));
  cells->SetVectors(MakeArray(data, Cells, "w", VectorsField));
  cells->AddArray(MakeArray(data, Cells, "other cells", ScalarField));
  data->GetPointData()->AddArray(MakeArray(
    data, Points, "other points", [](const Vector& x) { return std::vector<double>{ x[0] }; }));
}

/// Returns the output of vtkCellDataToPointData for one array, with all other data. With several
/// threads, the order of the cells at a point, and so the rounding of averages, would vary.
vtkSmartPointer<vtkDataSet> ConvertByVTK(vtkDataSet* data, const char* name)
{
  vtkNew<vtkCellDataToPointData> filter;
  filter->SetInputData(data);
  filter->PassCellDataOn();
  filter->ProcessAllArraysOff();
  filter->AddCellDataArray(name);
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config(std::string("Sequential")), [&filter] { filter->Update(); });
  return filter->GetOutput();
}

void AppendBytes(std::string& text, vtkAbstractArray* array)
{
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(array);
  text += std::string(array->GetClassName()) + " " + std::to_string(array->GetNumberOfComponents());
  if (numbers && array->GetNumberOfValues() > 0)
  {
    text.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  }
}

void AppendArrays(std::string& text, vtkFieldData* arrays)
{
  std::map<std::string, std::string> byName;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    AppendBytes(byName[array->GetName() ? array->GetName() : ""], array);
  }
  for (const auto& one : byName)
  {
    text += "\n" + one.first + ": " + one.second;
  }
}

void AppendDataSet(std::string& text, vtkDataSet* data)
{
  text += std::string("\n") + data->GetClassName();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    text.append(reinterpret_cast<const char*>(data->GetPoint(i)), 3 * sizeof(double));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    data->GetCellPoints(i, ids);
    text += "\n" + std::to_string(data->GetCellType(i));
    for (const vtkIdType id : *ids)
    {
      text += " " + std::to_string(id);
    }
  }
  for (const int association : { Points, Cells })
  {
    AppendArrays(text, data->GetAttributesAsFieldData(association));
  }
}

/// Returns all data of all outputs of a filter.
std::string GetOutputs(vtkAlgorithm* filter)
{
  std::string text;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    if (auto* composite = vtkCompositeDataSet::SafeDownCast(output))
    {
      const auto at = vtk::TakeSmartPointer(composite->NewIterator());
      for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
      {
        AppendDataSet(text, vtkDataSet::SafeDownCast(at->GetCurrentDataObject()));
      }
    }
    else
    {
      AppendDataSet(text, vtkDataSet::SafeDownCast(output));
    }
  }
  return text;
}

struct FilterCase
{
  std::string Name;
  const char* Array;
  std::function<vtkSmartPointer<vtkAlgorithm>()> Make;
};

template <typename Filter>
vtkSmartPointer<Filter> MakeFilter()
{
  auto filter = vtkSmartPointer<Filter>::New();
  AllowWarnings(filter);
  return filter;
}

std::vector<FilterCase> MakeFilters()
{
  return {
    { "interval volume", "s",
      []() -> vtkSmartPointer<vtkAlgorithm>
      {
        auto filter = MakeFilter<vtkIntervalVolume>();
        filter->SetInterval(0, 0.2, 0.7);
        filter->SetInterval(1, 1.0, 1.5);
        filter->GenerateBoundariesOn();
        return filter;
      } },
    { "contour", "s",
      []() -> vtkSmartPointer<vtkAlgorithm>
      {
        auto filter = MakeFilter<vtkIsotableContour>();
        filter->SetValue(0, 0.7);
        return filter;
      } },
    { "implicit flow field", "w",
      []() -> vtkSmartPointer<vtkAlgorithm>
      {
        auto filter = MakeFilter<vtkImplicitFlowField>();
        filter->AddTerminationSurface(MakeFlowPlane(1.0));
        filter->DomainFacesOn();
        filter->CriticalPointSpheresOn();
        filter->AddMeanArray("s");
        return filter;
      } },
    { "LIC", "w", []() -> vtkSmartPointer<vtkAlgorithm> { return MakeFilter<vtkFlowLIC>(); } },
    { "critical points", "w",
      []() -> vtkSmartPointer<vtkAlgorithm> { return MakeFilter<vtkFlowCriticalPoints>(); } },
    { "boundary", "w",
      []() -> vtkSmartPointer<vtkAlgorithm> { return MakeFilter<vtkFlowBoundary>(); } },
    { "vortex axis", "w",
      []() -> vtkSmartPointer<vtkAlgorithm> { return MakeFilter<vtkVortexAxis>(); } },
  };
}

/// Returns whether outputs are as long as those of a filter that finds something.
bool HasResult(const FilterCase& one, const std::string& outputs)
{
  const bool isSmall = one.Name == "critical points" || one.Name == "vortex axis";
  return outputs.size() > (isSmall ? 200 : 2000);
}

/// Runs a filter and returns its outputs. \a name is null for the default selection.
std::string Run(const FilterCase& one, vtkDataObject* input, int association, const char* name,
  std::string* errors = nullptr)
{
  const auto filter = one.Make();
  filter->SetInputDataObject(input);
  if (name)
  {
    filter->SetInputArrayToProcess(0, 0, 0, association, name);
  }
  const std::string messages = UpdateAndGetErrors(filter);
  if (errors)
  {
    *errors += messages;
  }
  return GetOutputs(filter);
}

/// Returns the input of vtkImplicitFlowField with its mean array converted too.
vtkSmartPointer<vtkDataSet> MakeReference(const FilterCase& one, vtkDataSet* data)
{
  vtkSmartPointer<vtkDataSet> converted = ConvertByVTK(data, one.Array);
  return one.Name == "implicit flow field" ? ConvertByVTK(converted, "s") : converted;
}

void Hide(vtkDataSet* data, unsigned char type)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    ghosts->InsertNextValue(i % 11 == 3 ? type : 0);
  }
  data->GetCellData()->AddArray(ghosts);
}

/// Returns grids with the arrays of AddArrays().
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> MakeGrids()
{
  auto grids = MakeFlowGrids();
  vtkNew<vtkUniformGrid> uniform;
  uniform->SetDimensions(5, 5, 5);
  grids.emplace_back("uniform grid", uniform);
  const std::size_t number = grids.size();
  for (std::size_t i = 0; i < number; ++i)
  {
    AddArrays(grids[i].second);
    for (const unsigned char type :
      { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::DUPLICATECELL })
    {
      const auto copy = vtk::TakeSmartPointer(grids[i].second->NewInstance());
      copy->DeepCopy(grids[i].second);
      Hide(copy, type);
      grids.emplace_back(grids[i].first + ", ghost type " + std::to_string(type), copy);
    }
    const auto copy = vtk::TakeSmartPointer(grids[i].second->NewInstance());
    copy->DeepCopy(grids[i].second);
    for (const char* name : { "s", "w" })
    {
      copy->GetCellData()->GetArray(name)->SetComponent(
        copy->GetNumberOfCells() / 2, 0, std::numeric_limits<double>::quiet_NaN());
    }
    grids.emplace_back(grids[i].first + " with NaN", copy);
  }
  return grids;
}

void TestAllGrids(Check& check)
{
  for (const auto& grid : MakeGrids())
  {
    for (const FilterCase& one : MakeFilters())
    {
      check.SetContext(one.Name + " of " + grid.first);
      std::string errors;
      const auto reference = MakeReference(one, grid.second);
      const std::string expected = Run(one, reference, Points, one.Array, &errors);
      const std::string found = Run(one, grid.second, Cells, one.Array, &errors);
      check.That(errors.empty(), "no error: " + errors);
      check.That(found == expected, "the output for a cell array");
      const bool isHidden = grid.first.find("ghost") != std::string::npos;
      check.That(isHidden || HasResult(one, expected), "the output is not empty");
    }
  }
}

/// The association of the selection is a preference, and the active attributes are the default.
void TestSelections(Check& check)
{
  const auto image = MakeFlowImage(5, GetVelocity);
  AddArrays(image);
  for (const FilterCase& one : MakeFilters())
  {
    check.SetContext("selections of " + one.Name);
    const std::string expected = Run(one, MakeReference(one, image), Points, one.Array);
    std::string errors;
    check.That(Run(one, image, Points, one.Array, &errors) == expected, "points");
    check.That(Run(one, image, Both, one.Array, &errors) == expected, "points, then cells");
    check.That(Run(one, image, Points, nullptr, &errors) == expected, "default");
    const auto filter = one.Make();
    filter->SetInputDataObject(image);
    const int type =
      *one.Array == 's' ? vtkDataSetAttributes::SCALARS : vtkDataSetAttributes::VECTORS;
    filter->SetInputArrayToProcess(0, 0, 0, Cells, type);
    errors += UpdateAndGetErrors(filter);
    check.That(GetOutputs(filter) == expected, "active cell attribute");
    check.That(errors.empty(), "no error: " + errors);
    const auto points = MakeReference(one, image);
    points->GetCellData()->RemoveArray(one.Array);
    check.That(Run(one, points, Cells, one.Array) == Run(one, points, Points, one.Array),
      "a point array selected as a cell array");
  }
}

vtkInterlumeReport* GetReport(vtkAlgorithm* filter)
{
  if (auto* volume = vtkIntervalVolume::SafeDownCast(filter))
  {
    return volume->GetReport();
  }
  if (auto* contour = vtkIsotableContour::SafeDownCast(filter))
  {
    return contour->GetReport();
  }
  if (auto* field = vtkImplicitFlowField::SafeDownCast(filter))
  {
    return field->GetReport();
  }
  if (auto* lic = vtkFlowLIC::SafeDownCast(filter))
  {
    return lic->GetReport();
  }
  if (auto* boundary = vtkFlowBoundary::SafeDownCast(filter))
  {
    return boundary->GetReport();
  }
  auto* points = vtkFlowCriticalPoints::SafeDownCast(filter);
  return points ? points->GetReport() : vtkVortexAxis::SafeDownCast(filter)->GetReport();
}

/// The report names the converted arrays, and the input is unchanged.
void TestReport(Check& check)
{
  const auto image = MakeFlowImage(5, GetVelocity);
  AddArrays(image);
  std::string before;
  AppendDataSet(before, image);
  for (const FilterCase& one : MakeFilters())
  {
    check.SetContext("report of " + one.Name);
    const auto filter = one.Make();
    filter->SetInputDataObject(image);
    filter->Update();
    vtkInterlumeReport* report = GetReport(filter);
    const bool hasMean = one.Name == "implicit flow field";
    check.Equal(report->GetSize("ConvertedCellArrays"), hasMean ? 2 : 1, "number of arrays");
    check.That(report->GetText("ConvertedCellArrays") == one.Array, "name");
    filter->SetInputDataObject(MakeReference(one, image));
    filter->SetInputArrayToProcess(0, 0, 0, Points, one.Array);
    filter->Update();
    check.Equal(report->GetSize("ConvertedCellArrays"), 0, "nothing to convert");
  }
  std::string after;
  AppendDataSet(after, image);
  check.That(before == after, "the input is unchanged");
}

/// Blocks with the array at the points, in the cells, and in both.
void TestBlocks(Check& check)
{
  for (const FilterCase& one : MakeFilters())
  {
    if (one.Name == "LIC" || one.Name == "critical points" || one.Name == "vortex axis")
    {
      continue;
    }
    vtkNew<vtkMultiBlockDataSet> blocks;
    vtkNew<vtkMultiBlockDataSet> converted;
    for (unsigned int i = 0; i < 4; ++i)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(3, 5, 5);
      image->SetOrigin(2.0 * i, 0.0, 0.0);
      AddArrays(image);
      const auto points = MakeReference(one, image);
      if (i == 1)
      {
        image->GetPointData()->AddArray(points->GetPointData()->GetArray(one.Array));
        image->GetPointData()->AddArray(points->GetPointData()->GetArray("s"));
        image->GetCellData()->RemoveArray(one.Array);
        points->GetCellData()->RemoveArray(one.Array);
      }
      blocks->SetBlock(i == 3 ? 4 : i, image);
      converted->SetBlock(i == 3 ? 4 : i, points);
    }
    check.SetContext("blocks of " + one.Name);
    std::string errors;
    const std::string expected = Run(one, converted, Points, one.Array, &errors);
    check.That(expected.size() > 2000, "the output is not empty");
    for (const int association : { Points, Cells, Both })
    {
      check.That(Run(one, blocks, association, one.Array, &errors) == expected,
        "association " + std::to_string(association));
    }
    check.That(errors.empty(), "no error: " + errors);
  }
}

vtkSmartPointer<vtkOverlappingAMR> MakeLevels(bool isConverted)
{
  auto levels = vtkSmartPointer<vtkOverlappingAMR>::New();
  const int blocks[] = { 1, 1 };
  const double origin[] = { 0.0, 0.0, 0.0 };
  levels->Initialize(2, blocks);
  levels->SetOrigin(origin);
  levels->SetGridDescription(VTK_XYZ_GRID);
  for (int level = 0; level < 2; ++level)
  {
    const double size = level == 0 ? 1.0 : 0.5;
    const double spacing[] = { size, size, size };
    vtkNew<vtkUniformGrid> grid;
    grid->SetDimensions(5, 5, 5);
    grid->SetSpacing(spacing);
    AddArrays(grid);
    if (level == 0)
    {
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      for (int i = 0; i < 64; ++i)
      {
        const bool isCovered = i % 4 < 2 && i / 4 % 4 < 2 && i / 16 < 2;
        ghosts->InsertNextValue(isCovered ? vtkDataSetAttributes::REFINEDCELL : 0);
      }
      grid->GetCellData()->AddArray(ghosts);
    }
    const vtkAMRBox box(origin, grid->GetDimensions(), spacing, origin, VTK_XYZ_GRID);
    levels->SetSpacing(static_cast<unsigned int>(level), spacing);
    levels->SetAMRBox(static_cast<unsigned int>(level), 0, box);
    vtkSmartPointer<vtkDataSet> data = grid;
    data = isConverted ? ConvertByVTK(grid, "s") : data;
    levels->SetDataSet(static_cast<unsigned int>(level), 0, vtkUniformGrid::SafeDownCast(data));
  }
  return levels;
}

/// Levels of an AMR dataset are converted separately. The report counts their common faces.
void TestLevels(Check& check)
{
  check.SetContext("AMR");
  std::string outputs[2];
  vtkIdType faces[2];
  for (const bool isConverted : { false, true })
  {
    const auto filter = MakeFilter<vtkIsotableContour>();
    filter->SetInputDataObject(MakeLevels(isConverted));
    filter->SetInputArrayToProcess(0, 0, 0, isConverted ? Points : Cells, "s");
    filter->SetValue(0, 1.4);
    filter->Update();
    outputs[isConverted] = GetOutputs(filter);
    faces[isConverted] = filter->GetReport()->GetCount("LevelFaces");
  }
  check.That(outputs[0] == outputs[1], "the outputs are equal");
  check.That(outputs[1].size() > 2000 && faces[1] > 0, "the levels meet at the isosurface");
  check.Equal(faces[0], faces[1], "faces between levels");
}

/// Criteria use cell arrays, and the criterion and the scalars may be the same array.
void TestCriteria(Check& check)
{
  check.SetContext("criteria");
  const auto image = MakeFlowImage(6, GetVelocity);
  AddArrays(image);
  const auto extract = [](vtkDataSet* data, int association, bool keepsCells)
  {
    const auto filter = MakeFilter<vtkIntervalVolume>();
    filter->SetInputData(data);
    filter->SetInputArrayToProcess(0, 0, 0, association, "s");
    filter->SetInterval(0, 0.2, 1.5);
    filter->AddCriterion("other cells", 0.4, 1.2);
    filter->AddCriterion("s", 0.5, 3.0);
    filter->AddCriterion("other points", 1.0, 3.5);
    filter->SetKeepInteriorCells(keepsCells);
    filter->SetGenerateBoundaries(true);
    const std::string errors = UpdateAndGetErrors(filter);
    return errors + GetOutputs(filter);
  };
  const auto converted = ConvertByVTK(ConvertByVTK(image, "s"), "other cells");
  for (const bool keepsCells : { false, true })
  {
    const std::string expected = extract(converted, Points, keepsCells);
    check.That(expected.size() > 2000, "the output is not empty");
    check.That(extract(image, Cells, keepsCells) == expected, "the output");
  }
}

/// Arrays of ids and bits, and arrays with the layout of structures of arrays, are averaged like
/// arrays of doubles with the same values.
void TestTypes(Check& check)
{
  const auto image = MakeFlowImage(5, GetVelocity);
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(image);
  append->Update();
  for (vtkDataSet* data :
    { static_cast<vtkDataSet*>(image), static_cast<vtkDataSet*>(append->GetOutput()) })
  {
    std::string expected;
    const std::vector<vtkSmartPointer<vtkDataArray>> arrays = {
      vtkSmartPointer<vtkDoubleArray>::New(), vtkSmartPointer<vtkIdTypeArray>::New(),
      vtkSmartPointer<vtkBitArray>::New(), vtkSmartPointer<vtkSOADataArrayTemplate<double>>::New()
    };
    for (vtkDataArray* array : arrays)
    {
      check.SetContext(std::string(data->GetClassName()) + ", " + array->GetClassName());
      array->SetName("marks");
      array->SetNumberOfComponents(1);
      array->SetNumberOfTuples(data->GetNumberOfCells());
      for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
      {
        array->SetComponent(cell, 0, cell % 5 == 0 ? 1 : 0);
      }
      data->GetPointData()->Initialize();
      data->GetCellData()->Initialize();
      data->GetCellData()->AddArray(array);
      const auto filter = MakeFilter<vtkIntervalVolume>();
      filter->SetInputData(data);
      filter->SetInputArrayToProcess(0, 0, 0, Cells, "marks");
      filter->SetInterval(0, 0.15, 0.4);
      filter->Update();
      std::string text;
      AppendBytes(text, filter->GetOutput()->GetPoints()->GetData());
      expected = expected.empty() ? text : expected;
      check.That(text.size() > 2000, "the output is not empty");
      check.That(text == expected, "the same points");
    }
  }
}

/// Returns three time steps. \a isConverted selects the reference.
TimeSteps MakeSteps(vtkDataSet* grid, bool isConverted, bool isComposite)
{
  TimeSteps steps;
  for (int step = 0; step < 3; ++step)
  {
    const auto copy = vtk::TakeSmartPointer(grid->NewInstance());
    copy->DeepCopy(grid);
    vtkDataArray* scalars = copy->GetCellData()->GetArray("s");
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      scalars->SetComponent(i, 0, scalars->GetComponent(i, 0) + 0.3 * step * std::sin(double(i)));
    }
    vtkSmartPointer<vtkDataObject> data = copy;
    if (isConverted)
    {
      data = ConvertByVTK(copy, "s");
    }
    if (isComposite)
    {
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, data);
      blocks->SetBlock(1, ConvertByVTK(copy, "s"));
      data = blocks;
    }
    steps.push_back({ 0.5 * step, data });
  }
  return steps;
}

void TestTimeSteps(Check& check)
{
  for (const auto& grid : MakeFlowGrids())
  {
    AddArrays(grid.second);
    for (const bool isComposite : { false, true })
    {
      check.SetContext("time steps of " + grid.first + (isComposite ? ", composite" : ""));
      std::string outputs[2];
      for (const bool isConverted : { false, true })
      {
        vtkNew<TimeStepSource> source;
        source->SetSteps(MakeSteps(grid.second, isConverted, isComposite));
        const auto filter = MakeFilter<vtkTimeVaryingIntervalVolume>();
        filter->SetInputConnection(source->GetOutputPort());
        filter->SetInputArrayToProcess(0, 0, 0, isConverted ? Points : Cells, "s");
        filter->SetInterval(0, 0.2, 0.7);
        filter->GenerateSimplicesOn();
        filter->SetGenerateBoundaries(true);
        const std::string errors = UpdateAndGetErrors(filter);
        check.That(errors.empty(), "no error: " + errors);
        outputs[isConverted] = GetOutputs(filter);
        check.Equal(filter->GetReport()->GetSize("ConvertedCellArrays"), isConverted ? 0 : 1,
          "converted arrays");
        check.That(isComposite || source->GetMaximumStepsInMemory() <= 2, "two steps in memory");
      }
      check.That(outputs[0] == outputs[1], "the outputs are equal");
      check.That(outputs[1].size() > 2000, "the output is not empty");
    }
  }
}

/// Returns the slabs of a writer and the numbers of written and resumed slabs.
std::string WriteSlabs(const TimeSteps& steps, int association, const std::filesystem::path& folder)
{
  vtkNew<TimeStepSource> source;
  source->SetSteps(steps);
  const auto writer = MakeFilter<vtkTimeSlabWriter>();
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetInputArrayToProcess(0, 0, 0, association, "s");
  writer->SetInterval(0, 0.2, 0.7);
  writer->SetFileName((folder / "cells.vtm").string().c_str());
  writer->Write();
  std::string text = std::to_string(writer->GetNumberOfWrittenSlabs()) + " written, " +
    std::to_string(writer->GetNumberOfResumedSlabs()) + " resumed";
  for (int slab = 0; slab < 2; ++slab)
  {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(
      (folder / "cells" / ("cells_" + std::to_string(slab) + ".vtu")).string().c_str());
    reader->Update();
    AppendDataSet(text, reader->GetOutput());
  }
  return text;
}

/// Slabs are resumed only if the selected array and the cell values are those of the files.
void TestSlabs(Check& check)
{
  check.SetContext("slabs");
  const std::filesystem::path folder = "TestCellArraysSlabs";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const auto image = MakeFlowImage(6, GetVelocity);
  AddArrays(image);
  const TimeSteps steps = MakeSteps(image, false, false);
  const std::string cells = WriteSlabs(steps, Cells, folder);
  check.That(cells.find("2 written, 0 resumed") == 0 && cells.size() > 2000, "new slabs");
  check.That(WriteSlabs(steps, Cells, folder) == "0 written, 2 resumed" + cells.substr(20),
    "unchanged slabs");
  vtkDataSet* last = GetDataSet(steps[2]);
  last->GetCellData()->GetArray("s")->SetComponent(30, 0, 0.5);
  last->GetCellData()->GetArray("s")->Modified();
  check.That(WriteSlabs(steps, Cells, folder).find("1 written, 1 resumed") == 0, "a changed value");
  for (const TimeStep& step : steps)
  {
    GetDataSet(step)->GetPointData()->AddArray(MakeArray(image, Points, "s", ScalarField));
  }
  check.That(WriteSlabs(steps, Points, folder).find("2 written, 0 resumed") == 0, "a point array");
  check.That(WriteSlabs(steps, Cells, folder).find("2 written, 0 resumed") == 0, "the cell array");
  const TimeSteps converted = MakeSteps(image, true, false);
  check.That(WriteSlabs(converted, Points, folder).substr(20) == cells.substr(20),
    "the slabs of the converted array");
  std::filesystem::remove_all(folder);
}

/// One filter follows random changes of the values, the selection and the intervals.
void TestChanges(Check& check)
{
  check.SetContext("changes");
  Random random(5);
  const auto image = MakeFlowImage(7, GetVelocity);
  AddArrays(image);
  image->GetPointData()->AddArray(MakeArray(image, Points, "s",
    [](const Vector& x) { return std::vector<double>{ 0.5 * x[0] - 0.2 * x[1] }; }));
  const auto mesh = MakeMesh(MeshKind::Boxes, { { 5, 5, 5 } });
  AddArrays(mesh);
  const auto filter = MakeFilter<vtkIntervalVolume>();
  vtkSmartPointer<vtkDataSet> input = image;
  int association = Cells;
  double lower = 0.4;
  for (int i = 0; i < 60; ++i)
  {
    const int change = static_cast<int>(random.Get(0.0, 6.0));
    lower = random.Get(0.0, 1.0);
    if (change == 0)
    {
      vtkDataArray* array = input->GetCellData()->GetArray("s");
      array->SetComponent(static_cast<vtkIdType>(random.Get(0.0, 100.0)), 0, random.Get(0.0, 1.0));
      array->Modified();
    }
    association = change == 1 ? (association == Cells ? Points : Cells) : association;
    if (change == 2)
    {
      input = input == image.Get() ? static_cast<vtkDataSet*>(mesh.Get()) : image.Get();
    }
    if (change == 3)
    {
      filter->SetUseValueIndex(!filter->GetUseValueIndex());
    }
    const auto fresh = MakeFilter<vtkIntervalVolume>();
    for (vtkIntervalVolume* one : { filter.Get(), fresh.Get() })
    {
      one->SetInputData(input);
      one->SetInputArrayToProcess(0, 0, 0, association, "s");
      one->SetInterval(0, lower, lower + 0.3);
      one->Update();
    }
    check.That(GetOutputs(filter) == GetOutputs(fresh),
      "after change " + std::to_string(change) + " in step " + std::to_string(i));
  }
}

/// Counts the progress events of conversions.
void CountConversion(vtkObject* caller, unsigned long, void* number, void*)
{
  const char* text = static_cast<vtkAlgorithm*>(caller)->GetProgressText();
  *static_cast<int*>(number) += text && std::string(text).find("Averaging cell") == 0;
}

/// If only the intervals change, the array is not converted again. An abort stops a conversion, and
/// the next execution is complete.
void TestCache(Check& check)
{
  check.SetContext("cache");
  const auto image = MakeFlowImage(9, GetVelocity);
  AddArrays(image);
  int events = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&events);
  count->SetCallback(CountConversion);
  for (const bool usesIndex : { true, false })
  {
    const auto filter = MakeFilter<vtkIntervalVolume>();
    filter->SetUseValueIndex(usesIndex);
    filter->SetInputData(image);
    filter->AddObserver(vtkCommand::ProgressEvent, count);
    for (int i = 0; i < 3; ++i)
    {
      events = 0;
      filter->SetInterval(0, 0.1 * i, 0.5 + 0.1 * i);
      filter->Update();
      check.That((events > 0) == (i == 0 || !usesIndex), "update " + std::to_string(i));
    }
    image->GetCellData()->GetScalars()->Modified();
    events = 0;
    filter->Update();
    check.That(events > 0, "after the values changed");
  }
  const auto filter = MakeFilter<vtkIntervalVolume>();
  filter->SetInputData(image);
  filter->SetInterval(0, 0.2, 0.7);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "aborted");
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  const auto fresh = MakeFilter<vtkIntervalVolume>();
  fresh->SetInputData(image);
  fresh->SetInterval(0, 0.2, 0.7);
  fresh->Update();
  check.That(GetOutputs(filter) == GetOutputs(fresh), "after the abort");
}

/// The pieces of a grid together have the output of the full grid.
void TestPieces(Check& check)
{
  for (const auto& grid : MakeFlowGrids())
  {
    AddArrays(grid.second);
    // All values in the plane z = 2, where pieces meet, equal a bound. What is extracted there
    // depends on the values of ghost cells.
    grid.second->GetCellData()->SetScalars(MakeArray(grid.second, Cells, "s",
      [](const Vector& x) {
        return std::vector<double>{ x[2] < 1.0 ? 16.0 : x[2] < 3.0 ? 8.0 : 0.0 };
      }));
    vtkNew<PieceSource> source;
    source->SetFullData(grid.second);
    const auto collect = [&](int pieces)
    {
      std::vector<GeometricSimplex> all;
      const auto filter = MakeFilter<vtkIntervalVolume>();
      filter->SetInputConnection(source->GetOutputPort());
      filter->SetInputArrayToProcess(0, 0, 0, Cells, "s");
      filter->SetInterval(0, 7.0, 8.0);
      for (int piece = 0; piece < pieces; ++piece)
      {
        filter->UpdatePiece(piece, pieces, 0);
        const auto part = GeometricSet(filter->GetOutput(), { "IntervalId" });
        all.insert(all.end(), part.begin(), part.end());
      }
      std::sort(all.begin(), all.end());
      return all;
    };
    check.SetContext("pieces of " + grid.first);
    const auto all = collect(1);
    check.That(!all.empty(), "the output is not empty");
    for (const int pieces : { 2, 3 })
    {
      check.That(collect(pieces) == all, std::to_string(pieces) + " pieces");
    }
  }
}

/// Arrays that cannot be converted are errors, and points without cells have the value 0.
void TestErrors(Check& check)
{
  const auto image = MakeFlowImage(4, GetVelocity);
  const auto expect = [&](vtkAbstractArray* array, const std::string& message)
  {
    for (const FilterCase& one : MakeFilters())
    {
      AddArrays(image);
      array->SetName(one.Array);
      image->GetCellData()->AddArray(array);
      check.SetContext(one.Name + ", " + message);
      std::string errors;
      Run(one, image, Cells, one.Array, &errors);
      check.Contains(ToSingleLine(errors), message);
    }
  };
  vtkNew<vtkDoubleArray> few;
  few->SetNumberOfComponents(3);
  few->SetNumberOfTuples(26);
  few->Fill(1.0);
  for (const FilterCase& one : MakeFilters())
  {
    AddArrays(image);
    check.SetContext(one.Name);
    std::string errors;
    Run(one, image, Cells, "nowhere", &errors);
    check.Contains(ToSingleLine(errors), "no point or cell array \"nowhere\"");
  }
  vtkNew<vtkStringArray> text;
  text->SetNumberOfValues(27);
  expect(text, "is a vtkStringArray; numbers are needed");
  vtkNew<vtkDoubleArray> two;
  two->SetNumberOfComponents(2);
  two->SetNumberOfTuples(27);
  two->Fill(1.0);
  expect(two, "has 2 components;");
  check.SetContext("short array");
  const auto contour = MakeFilter<vtkFlowCriticalPoints>();
  AddArrays(image);
  few->SetName("w");
  image->GetCellData()->AddArray(few);
  contour->SetInputData(image);
  contour->SetInputArrayToProcess(0, 0, 0, Cells, "w");
  check.Contains(UpdateAndGetErrors(contour), "has 26 tuples; 27 are needed, one for each cell");
}

void TestUnusedPoints(Check& check)
{
  check.SetContext("points without cells");
  const auto mesh = MakeMesh(MeshKind::Tetrahedra6, { { 3, 3, 3 } });
  const vtkIdType used = mesh->GetNumberOfPoints();
  for (int i = 0; i < 50; ++i)
  {
    mesh->GetPoints()->InsertNextPoint(1.0, 1.0, 1.0);
  }
  AddArrays(mesh);
  const auto filter = MakeFilter<vtkFlowLIC>();
  filter->SetInputData(mesh);
  filter->Update();
  vtkDataArray* vectors = filter->GetOutput()->GetPointData()->GetArray("w");
  double sum = 0.0;
  for (vtkIdType i = used; i < mesh->GetNumberOfPoints(); ++i)
  {
    sum += std::abs(vectors->GetComponent(i, 0)) + std::abs(vectors->GetComponent(i, 2));
  }
  check.Near(sum, 0.0, 0.0, "their vectors");
}

}

int TestCellArrays(int, char*[])
{
  return RunChecks(
    { TestAllGrids, TestSelections, TestReport, TestBlocks, TestLevels, TestCriteria, TestTypes,
      TestTimeSteps, TestSlabs, TestChanges, TestCache, TestPieces, TestErrors, TestUnusedPoints });
}
