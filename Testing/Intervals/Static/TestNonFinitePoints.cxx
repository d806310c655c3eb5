// SPDX-License-Identifier: BSD-3-Clause
// Cells with a NaN or infinite coordinate are skipped, counted and reported in one warning. The
// output is bit-identical to the output for a grid with NaN scalars at these points.
#include "Common/DataDigest.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkStructuredGrid.h"
#include "vtkTimeSlabWriter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Storage types of point coordinates.
enum class Storage
{
  Double,
  Float,
  Components
};

vtkSmartPointer<vtkPoints> MakePoints(vtkPointSet* set, Storage storage)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  if (storage == Storage::Components)
  {
    vtkNew<vtkSOADataArrayTemplate<double>> array;
    array->SetNumberOfComponents(3);
    points->SetData(array);
  }
  else
  {
    points->SetDataType(storage == Storage::Float ? VTK_FLOAT : VTK_DOUBLE);
  }
  points->SetNumberOfPoints(set->GetNumberOfPoints());
  for (vtkIdType p = 0; p < set->GetNumberOfPoints(); ++p)
  {
    points->SetPoint(p, set->GetPoint(p));
  }
  return points;
}

vtkSmartPointer<vtkDataSet> Copy(vtkDataSet* data)
{
  const auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

/// Sets random integers from 0 to 12 as the active scalars, in an array of the given type.
template <typename Array>
void SetScalars(vtkDataSet* data, unsigned int seed)
{
  std::minstd_rand random(seed);
  vtkNew<Array> values;
  values->SetName("f");
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    values->InsertNextValue(static_cast<typename Array::ValueType>(random() % 13));
  }
  data->GetPointData()->AddArray(values);
  data->GetPointData()->SetActiveScalars("f");
}

/// Replaces the active scalars with floating-point values that are NaN at the points \a lost.
void InvalidateScalars(vtkDataSet* data, const std::set<vtkIdType>& lost)
{
  vtkDataArray* const before = data->GetPointData()->GetScalars();
  const bool isSmall = before->GetDataType() == VTK_SHORT || before->GetDataType() == VTK_FLOAT;
  const auto values = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(isSmall ? VTK_FLOAT : VTK_DOUBLE));
  values->DeepCopy(before);
  for (const vtkIdType p : lost)
  {
    values->SetComponent(p, 0, NaN);
  }
  data->GetPointData()->AddArray(values);
  data->GetPointData()->SetActiveScalars("f");
}

/// Sets one coordinate of each point in \a lost to NaN or infinity.
void InvalidatePoints(vtkDataSet* data, const std::set<vtkIdType>& lost)
{
  const double values[] = { NaN, Infinity, -Infinity };
  for (const vtkIdType p : lost)
  {
    double x[3];
    data->GetPoint(p, x);
    x[p % 3] = values[(p / 3) % 3];
    vtkPointSet::SafeDownCast(data)->GetPoints()->SetPoint(p, x);
  }
}

std::set<vtkIdType> ChoosePoints(vtkDataSet* data, unsigned int seed)
{
  std::minstd_rand random(seed);
  std::set<vtkIdType> chosen;
  while (chosen.size() * 25 < static_cast<std::size_t>(data->GetNumberOfPoints()))
  {
    chosen.insert(static_cast<vtkIdType>(random() % data->GetNumberOfPoints()));
  }
  return chosen;
}

/// Appends the numbers of cells and of non-finite points, and a hash of the grid and its arrays.
void AddDigest(vtkDataObject* output, std::ostream& text)
{
  auto* grid = vtkDataSet::SafeDownCast(output);
  interlume::DataDigest digest;
  digest.AddGrid(grid);
  for (vtkDataSetAttributes* attributes :
    { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
      static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      digest.Add(attributes->GetArray(i));
    }
  }
  vtkIdType nonFinite = 0;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    const double* x = grid->GetPoint(p);
    nonFinite += !std::isfinite(x[0] + x[1] + x[2]);
  }
  text << grid->GetNumberOfCells() << " cells, " << nonFinite << " points not finite, "
       << digest.Take() << "; ";
}

void AddReport(vtkInterlumeReport* report, std::ostream& text)
{
  for (const char* name : { "CellsVisited", "CellsByBits", "CellsWithOutput", "NonFiniteCells",
         "BlankedCells", "CollapsedSimplices", "InteriorCells", "ConcavePolyhedra" })
  {
    text << name << " " << report->GetCount(name) << "\n";
  }
}

/// Updates a filter and appends its outputs and its report. Expects one warning about non-finite
/// coordinates if \a warns is true, otherwise none.
template <typename Filter>
void AddOutput(Filter* filter, bool warns, std::ostream& text, Check& check)
{
  const std::string warnings = WarningsOf(filter);
  const std::string about = "NaN or infinite coordinate";
  const std::size_t at = warnings.find(about);
  check.That((at != std::string::npos) == warns &&
      (!warns || warnings.find(about, at + 1) == std::string::npos),
    "warnings: " + warnings);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    AddDigest(filter->GetOutputDataObject(port), text);
  }
  AddReport(filter->GetReport(), text);
}

/// Extracts contours and interval volumes of a grid with several settings. Returns a summary as
/// text.
std::string Extract(vtkDataSet* data, bool warns, Check& check)
{
  std::ostringstream text;
  for (const bool fractions : { false, true })
  {
    for (const int number : { 1, 3 })
    {
      vtkNew<vtkIsotableContour> contour;
      contour->SetInputData(data);
      contour->SetMergePoints(fractions);
      contour->SetNumberOfContours(number);
      // The second execution uses a value index.
      for (const double first : { 3.5, 8.0 })
      {
        for (int i = 0; i < number; ++i)
        {
          contour->SetValue(i, first + 1.5 * i);
        }
        AddOutput(contour.Get(), warns, text, check);
      }
    }
  }
  for (const bool keepsInterior : { false, true })
  {
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(data);
    filter->GenerateBoundariesOn();
    filter->SetKeepInteriorCells(keepsInterior);
    filter->SetInterval(0, 2.0, 6.5);
    filter->SetInterval(1, 6.5, 12.0);
    AddOutput(filter.Get(), warns, text, check);
    filter->AddCriterion("other", 0.25, 1.0);
    AddOutput(filter.Get(), warns, text, check);
  }
  return text.str();
}

using Invalidate = std::function<void(vtkDataSet*)>;

/// Compares the results for non-finite coordinates at the points \a lost with the results for NaN
/// scalars at these points.
void Compare(vtkDataSet* data, const std::set<vtkIdType>& lost, const Invalidate& invalidate,
  const std::string& name, Check& check)
{
  check.SetContext(name);
  const auto broken = Copy(data);
  invalidate(broken);
  const auto expected = Copy(data);
  InvalidateScalars(expected, lost);
  const std::string found = Extract(broken, true, check);
  const std::string required = Extract(expected, false, check);
  check.That(found == required, "found\n" + found + "for\n" + required);
  check.That(found.find(", with output 0,") == std::string::npos, "there are cells");
}

/// Calls Compare() for scalars of several types.
void CompareTypes(vtkDataSet* data, const std::set<vtkIdType>& lost, const Invalidate& invalidate,
  const std::string& name, Check& check)
{
  AddRandomField(data, 5, "other");
  SetScalars<vtkDoubleArray>(data, 1);
  Compare(data, lost, invalidate, name + ", double", check);
  SetScalars<vtkFloatArray>(data, 2);
  Compare(data, lost, invalidate, name + ", float", check);
  SetScalars<vtkShortArray>(data, 3);
  Compare(data, lost, invalidate, name + ", short", check);
  SetScalars<vtkLongLongArray>(data, 4);
  Compare(data, lost, invalidate, name + ", long long", check);
}

void ComparePoints(vtkPointSet* data, const std::string& name, Check& check)
{
  const auto lost = ChoosePoints(data, 7);
  CompareTypes(
    data, lost, [&lost](vtkDataSet* copy) { InvalidatePoints(copy, lost); }, name, check);
}

void CheckPointSets(Check& check)
{
  for (const Storage storage : { Storage::Double, Storage::Float, Storage::Components })
  {
    const DataSetVariant form = FormsOf(MakeImage({ 40, 5, 6 }))[1];
    auto* grid = vtkPointSet::SafeDownCast(form.Data);
    grid->SetPoints(MakePoints(grid, storage));
    ComparePoints(grid, form.Name + " " + std::to_string(static_cast<int>(storage)), check);
  }
  for (const MeshKind kind : AllMeshKinds())
  {
    ComparePoints(MakeMesh(kind, { 4, 4, 4 }), GetName(kind), check);
  }
}

/// A non-finite coordinate of a rectilinear grid invalidates a plane of points. Descending
/// coordinates are valid.
void CheckRectilinear(Check& check)
{
  for (const bool falls : { false, true })
  {
    for (const int lostAt : { 0, 2, 5 })
    {
      vtkNew<vtkRectilinearGrid> grid;
      grid->SetDimensions(6, 6, 6);
      vtkNew<vtkDoubleArray> axis;
      vtkNew<vtkDoubleArray> other;
      for (int i = 0; i < 6; ++i)
      {
        axis->InsertNextValue((falls ? -1.0 : 1.0) * (0.25 + i));
        other->InsertNextValue(0.5 * i);
      }
      grid->SetXCoordinates(axis);
      grid->SetYCoordinates(other);
      grid->SetZCoordinates(other);
      std::set<vtkIdType> lost;
      for (vtkIdType p = lostAt; p < grid->GetNumberOfPoints(); p += 6)
      {
        lost.insert(p);
      }
      CompareTypes(
        grid, lost,
        [lostAt](vtkDataSet* copy) {
          vtkRectilinearGrid::SafeDownCast(copy)->GetXCoordinates()->SetComponent(lostAt, 0, NaN);
        },
        "rectilinear, " + std::to_string(falls) + ", " + std::to_string(lostAt), check);
    }
  }
}

/// An image with a non-finite origin or spacing has no valid cell.
void CheckImages(Check& check)
{
  for (const double value : { NaN, Infinity })
  {
    for (const bool isOrigin : { false, true })
    {
      check.SetContext("image " + std::to_string(value) + (isOrigin ? ", origin" : ", spacing"));
      auto image = MakeImage({ 4, 4, 4 });
      AddRandomField(image, 1);
      isOrigin ? image->SetOrigin(0, value, 0) : image->SetSpacing(1, 1, value);
      vtkNew<vtkIntervalVolume> filter;
      filter->SetInputData(image);
      filter->SetInterval(0, 0.25, 0.75);
      filter->WarnOnEmptyOutputOff();
      const std::string warnings = WarningsOf(filter);
      check.That(warnings.find("64 cells are skipped") != std::string::npos &&
          warnings.find("cell 0, with point 0 at (") != std::string::npos,
        "warning: " + warnings);
      check.That(
        warnings.find("single precision") == std::string::npos, "no other warning: " + warnings);
      check.Equal(filter->GetReport()->GetCount("NonFiniteCells"), 64, "cells");
      check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "tetrahedra");
    }
  }
}

/// Blanked cells and unused points cause no warning.
void CheckQuiet(Check& check)
{
  check.SetContext("quiet");
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 4, 4, 4 });
  mesh->GetPoints()->InsertNextPoint(NaN, 0, 0);
  AddRandomField(mesh, 1);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(mesh);
  filter->SetInterval(0, 0.25, 0.75);
  std::string warnings = WarningsOf(filter);
  check.That(warnings.empty(), "no warning for an unused point: " + warnings);
  // Only cell 0 uses point 0.
  mesh->GetPoints()->SetPoint(0, 0, Infinity, 0);
  mesh->GetPoints()->Modified();
  warnings = WarningsOf(filter);
  check.That(warnings.find("1 cells are skipped") != std::string::npos &&
      warnings.find("cell 0, with point 0 at (0, inf, 0)") != std::string::npos,
    "a warning for a point of one cell: " + warnings);
  check.Equal(filter->GetReport()->GetCount("NonFiniteCells"), 1, "cells");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(64);
  ghosts->FillValue(0);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  mesh->GetCellData()->AddArray(ghosts);
  warnings = WarningsOf(filter);
  check.That(warnings.empty(), "no warning for a blanked cell: " + warnings);
  check.Equal(filter->GetReport()->GetCount("NonFiniteCells"), 0, "cells");
  check.Equal(filter->GetReport()->GetCount("BlankedCells"), 1, "blanked cells");
}

/// Tests a grid with ghost cells and non-finite points.
void CheckGhosts(Check& check)
{
  std::minstd_rand random(3);
  const DataSetVariant form = FormsOf(MakeImage({ 12, 6, 6 }))[1];
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < form.Data->GetNumberOfCells(); ++cell)
  {
    const bool isLayer = cell % 12 == 0;
    ghosts->InsertNextValue(isLayer ? vtkDataSetAttributes::DUPLICATECELL
        : random() % 20 == 0        ? vtkDataSetAttributes::HIDDENCELL
                                    : 0);
  }
  form.Data->GetCellData()->AddArray(ghosts);
  ComparePoints(vtkPointSet::SafeDownCast(form.Data), "ghosts", check);
}

/// Tests a grid with points that are non-finite at all time steps, or at one step only. In the
/// latter case, the cells at these points are skipped in both adjacent slabs.
void CheckTime(Check& check)
{
  for (const NamedGrid& grid : MakeAllGridTypes({ 4, 4, 4 }, 5))
  {
    if (!vtkPointSet::SafeDownCast(grid.Data))
    {
      continue;
    }
    const auto lost = ChoosePoints(grid.Data, 9);
    const auto extract = [&](bool invalidatesPoints, const std::set<int>& at)
    {
      TimeSteps steps = RepeatGrid(grid.Data, { 0, 1, 3 });
      AddIntegerTimeField(steps, 13, 5);
      for (const int step : at)
      {
        vtkDataSet* data = GetDataSet(steps[static_cast<std::size_t>(step)]);
        invalidatesPoints ? InvalidatePoints(data, lost) : InvalidateScalars(data, lost);
      }
      const TimeVaryingPipeline pipeline(steps, { { { 2.0, 6.5 }, { 6.5, 12.0 } } });
      std::ostringstream text;
      AddOutput(pipeline.Filter.Get(), invalidatesPoints, text, check);
      return text.str();
    };
    check.SetContext(grid.Name + " in time");
    const std::string found = extract(true, { 0, 1, 2 });
    const std::string required = extract(false, { 0, 1, 2 });
    check.That(found == required, "found\n" + found + "for\n" + required);
    // If points differ between steps, the grid is treated as moving, which changes the tetrahedra.
    // Only the 4-simplices and the report are the same.
    const std::string atOne = extract(true, { 1 });
    const std::string atAll = required.substr(required.find("not finite, "));
    check.That(atOne.substr(atOne.rfind("not finite")) == atAll.substr(atAll.rfind("not finite")),
      "at one step " + atOne + "for " + required);
  }
}

/// The slabs that vtkTimeSlabWriter writes have no non-finite points.
void CheckWriter(Check& check)
{
  check.SetContext("writer of slabs");
  const auto folder = std::filesystem::temp_directory_path() / "TestNonFinitePoints";
  TimeSteps steps = RepeatGrid(FormsOf(MakeImage({ 4, 4, 4 }))[1].Data, { 0, 1, 3 });
  AddIntegerTimeField(steps, 13, 5);
  for (const TimeStep& step : steps)
  {
    // Eight cells use this interior point.
    InvalidatePoints(GetDataSet(step), { 62 });
  }
  vtkNew<TimeStepSource> source;
  source->SetSteps(steps);
  vtkNew<vtkTimeSlabWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetInterval(0, 2.0, 6.5);
  writer->SetFileName((folder / "slabs.vtm").string().c_str());
  AllowWarnings(writer);
  check.That(writer->Write(), "written");
  check.Equal(writer->GetReport()->GetCount("NonFiniteCells"), 8, "cells of the last slab");
  for (const char* name : { "slabs_0.vtu", "slabs_1.vtu" })
  {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName((folder / "slabs" / name).string().c_str());
    reader->Update();
    std::ostringstream text;
    AddDigest(reader->GetOutput(), text);
    check.That(reader->GetOutput()->GetNumberOfCells() > 0 &&
        text.str().find(" 0 points not finite") != std::string::npos,
      name + (": " + text.str()));
  }
  std::filesystem::remove_all(folder);
}

/// 4-simplices with non-finite points are skipped like those with non-finite times.
void CheckSimplices(Check& check)
{
  check.SetContext("4-simplices");
  const auto slice = [&](bool invalidatesPoints, vtkIdType& skipped)
  {
    KuhnOptions options;
    options.Cells = { { 4, 4, 4, 2 } };
    const auto grid = MakeKuhnGrid(options);
    for (const vtkIdType p : ChoosePoints(grid, 3))
    {
      invalidatesPoints ? grid->GetPoints()->SetPoint(p, 0, NaN, 0)
                        : grid->GetPointData()->GetArray("Time")->SetComponent(p, 0, NaN);
    }
    vtkNew<vtkSimplexTimeSlice> filter;
    filter->SetInputData(grid);
    filter->SetTime(1.25);
    std::ostringstream text;
    const std::string warnings = WarningsOf(filter);
    check.That(warnings.empty() != invalidatesPoints, "warning: " + warnings);
    skipped = filter->GetReport()->GetCount("NonFiniteSimplices");
    check.That(!invalidatesPoints ||
        warnings.find(std::to_string(skipped) + " cells are skipped") != std::string::npos,
      std::to_string(skipped) + " cells: " + warnings);
    AddDigest(filter->GetOutputDataObject(0), text);
    return text.str();
  };
  vtkIdType skipped = 0;
  vtkIdType expected = 0;
  const std::string found = slice(true, skipped);
  const std::string required = slice(false, expected);
  check.That(found == required, found + "for " + required);
  check.That(skipped > 0, "cells are skipped");
  check.Equal(skipped, expected, "cells");
}

}

int TestNonFinitePoints(int, char*[])
{
  Check check;
  CheckPointSets(check);
  CheckRectilinear(check);
  CheckImages(check);
  CheckQuiet(check);
  CheckGhosts(check);
  CheckTime(check);
  CheckWriter(check);
  CheckSimplices(check);
  return check.Result();
}
