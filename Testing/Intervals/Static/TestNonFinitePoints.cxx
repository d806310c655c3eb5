// SPDX-License-Identifier: BSD-3-Clause
// Cells with a NaN or infinite coordinate are skipped, counted and named in one warning. A grid of
// which some points have such a coordinate gives the same bytes as one that has NaN in the scalar
// there.
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

/// The points of a grid in the arrays that it may have them in.
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

/// The grid with scalars of a type, whole numbers up to 12.
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

/// Replaces the active scalars by such that are NaN at some points.
void LoseScalars(vtkDataSet* data, const std::set<vtkIdType>& lost)
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

/// Puts NaN and infinities into the coordinates of some points.
void LosePoints(vtkDataSet* data, const std::set<vtkIdType>& lost)
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

/// A digest of a grid and its arrays, and whether its points are finite.
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
    text << name << " " << static_cast<vtkIdType>(report->GetNumber(name)) << "\n";
  }
}

/// Updates a filter, and adds what it gives. Where cells are skipped because of points, one warning
/// says so.
template <typename Filter>
void AddOutput(Filter* filter, bool warns, std::ostream& text, Check& check)
{
  const std::string said = WarningsOf(filter);
  const std::string about = "NaN or infinite coordinate";
  const std::size_t at = said.find(about);
  check.That(
    (at != std::string::npos) == warns && (!warns || said.find(about, at + 1) == std::string::npos),
    "warnings: " + said);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    AddDigest(filter->GetOutputDataObject(port), text);
  }
  AddReport(filter->GetReport(), text);
}

/// Everything that contours and interval volumes of a grid give, in words.
std::string Extract(vtkDataSet* data, bool warns, Check& check)
{
  std::ostringstream text;
  for (const bool shares : { false, true })
  {
    for (const int number : { 1, 3 })
    {
      vtkNew<vtkIsotableContour> contour;
      contour->SetInputData(data);
      contour->SetMergePoints(shares);
      contour->SetNumberOfContours(number);
      // The second time there is an index of values.
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
  for (const bool keepsWhole : { false, true })
  {
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(data);
    filter->GenerateBoundariesOn();
    filter->SetKeepWholeCells(keepsWhole);
    filter->SetInterval(0, 2.0, 6.5);
    filter->SetInterval(1, 6.5, 12.0);
    AddOutput(filter.Get(), warns, text, check);
    filter->AddCriterion("other", 0.25, 1.0);
    AddOutput(filter.Get(), warns, text, check);
  }
  return text.str();
}

using LosePlaces = std::function<void(vtkDataSet*)>;

/// Compares a grid whose \a lost points were lost with one whose scalars were.
void Compare(vtkDataSet* data, const std::set<vtkIdType>& lost, const LosePlaces& losePlaces,
  const std::string& name, Check& check)
{
  check.SetContext(name);
  const auto broken = Copy(data);
  losePlaces(broken);
  const auto expected = Copy(data);
  LoseScalars(expected, lost);
  const std::string found = Extract(broken, true, check);
  const std::string wanted = Extract(expected, false, check);
  check.That(found == wanted, "found\n" + found + "for\n" + wanted);
  check.That(found.find(", with output 0,") == std::string::npos, "there are cells");
}

/// Compares it with scalars of several types.
void CompareTypes(vtkDataSet* data, const std::set<vtkIdType>& lost, const LosePlaces& losePlaces,
  const std::string& name, Check& check)
{
  AddRandomField(data, 5, "other");
  SetScalars<vtkDoubleArray>(data, 1);
  Compare(data, lost, losePlaces, name + ", double", check);
  SetScalars<vtkFloatArray>(data, 2);
  Compare(data, lost, losePlaces, name + ", float", check);
  SetScalars<vtkShortArray>(data, 3);
  Compare(data, lost, losePlaces, name + ", short", check);
  SetScalars<vtkLongLongArray>(data, 4);
  Compare(data, lost, losePlaces, name + ", long long", check);
}

void ComparePoints(vtkPointSet* data, const std::string& name, Check& check)
{
  const auto lost = ChoosePoints(data, 7);
  CompareTypes(
    data, lost, [&lost](vtkDataSet* copy) { LosePoints(copy, lost); }, name, check);
}

void CheckPointSets(Check& check)
{
  for (const Storage storage : { Storage::Double, Storage::Float, Storage::Components })
  {
    const LatticeForm form = FormsOf(MakeImage({ 40, 5, 6 }))[1];
    auto* grid = vtkPointSet::SafeDownCast(form.Data);
    grid->SetPoints(MakePoints(grid, storage));
    ComparePoints(grid, form.Name + " " + std::to_string(static_cast<int>(storage)), check);
  }
  for (const MeshKind kind : AllMeshKinds())
  {
    ComparePoints(MakeMesh(kind, { 4, 4, 4 }), GetName(kind), check);
  }
}

/// A coordinate of a rectilinear grid takes a plane of points along; a falling axis stays one.
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

/// An image without an origin or a spacing has no cell left.
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
      const std::string said = WarningsOf(filter);
      check.That(said.find("64 cells are skipped") != std::string::npos &&
          said.find("cell 0, with point 0 at (") != std::string::npos,
        "warning: " + said);
      check.That(said.find("single precision") == std::string::npos, "no other warning: " + said);
      check.Near(filter->GetReport()->GetNumber("NonFiniteCells"), 64, 0.0, "cells");
      check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "tetrahedra");
    }
  }
}

/// Cells that are blanked, and points that no cell has, are not told of.
void CheckQuiet(Check& check)
{
  check.SetContext("quiet");
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 4, 4, 4 });
  mesh->GetPoints()->InsertNextPoint(NaN, 0, 0);
  AddRandomField(mesh, 1);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(mesh);
  filter->SetInterval(0, 0.25, 0.75);
  std::string said = WarningsOf(filter);
  check.That(said.empty(), "a point that no cell has: " + said);
  // Point 0 is in cell 0 alone.
  mesh->GetPoints()->SetPoint(0, 0, Infinity, 0);
  mesh->GetPoints()->Modified();
  said = WarningsOf(filter);
  check.That(said.find("1 cells are skipped") != std::string::npos &&
      said.find("cell 0, with point 0 at (0, inf, 0)") != std::string::npos,
    "a point of one: " + said);
  check.Near(filter->GetReport()->GetNumber("NonFiniteCells"), 1, 0.0, "cells");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(64);
  ghosts->FillValue(0);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  mesh->GetCellData()->AddArray(ghosts);
  said = WarningsOf(filter);
  check.That(said.empty(), "the cell is blanked: " + said);
  check.Near(filter->GetReport()->GetNumber("NonFiniteCells"), 0, 0.0, "cells");
  check.Near(filter->GetReport()->GetNumber("BlankedCells"), 1, 0.0, "blanked cells");
}

/// Ghost cells and lost points together: as with lost scalars.
void CheckGhosts(Check& check)
{
  std::minstd_rand random(3);
  const LatticeForm form = FormsOf(MakeImage({ 12, 6, 6 }))[1];
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

/// Time steps of a grid with lost points, at all steps, or at one: there the cells of the slabs
/// beside it are skipped.
void CheckTime(Check& check)
{
  for (const SpaceTimeGrid& grid : AllSpaceTimeGrids({ 4, 4, 4 }, 5))
  {
    if (!vtkPointSet::SafeDownCast(grid.Data))
    {
      continue;
    }
    const auto lost = ChoosePoints(grid.Data, 9);
    const auto extract = [&](bool losesPlaces, const std::set<int>& at)
    {
      TimeSteps steps = RepeatGrid(grid.Data, { 0, 1, 3 });
      AddIntegerTimeField(steps, 13, 5);
      for (const int step : at)
      {
        vtkDataSet* data = GetDataSet(steps[static_cast<std::size_t>(step)]);
        losesPlaces ? LosePoints(data, lost) : LoseScalars(data, lost);
      }
      const TimeVaryingPipeline pipeline(steps, { { { 2.0, 6.5 }, { 6.5, 12.0 } } });
      std::ostringstream text;
      AddOutput(pipeline.Filter.Get(), losesPlaces, text, check);
      return text.str();
    };
    check.SetContext(grid.Name + " in time");
    const std::string found = extract(true, { 0, 1, 2 });
    const std::string wanted = extract(false, { 0, 1, 2 });
    check.That(found == wanted, "found\n" + found + "for\n" + wanted);
    // Where points differ the grid moves, and is cut otherwise.
    const std::string atOne = extract(true, { 1 });
    const std::string atAll = wanted.substr(wanted.find("not finite, "));
    check.That(atOne.substr(atOne.rfind("not finite")) == atAll.substr(atAll.rfind("not finite")),
      "at one step " + atOne + "for " + wanted);
  }
}

/// Slabs in files have no such points either.
void CheckWriter(Check& check)
{
  check.SetContext("writer of slabs");
  const auto folder = std::filesystem::temp_directory_path() / "TestNonFinitePoints";
  TimeSteps steps = RepeatGrid(FormsOf(MakeImage({ 4, 4, 4 }))[1].Data, { 0, 1, 3 });
  AddIntegerTimeField(steps, 13, 5);
  for (const TimeStep& step : steps)
  {
    // It is in the middle: eight cells have it.
    LosePoints(GetDataSet(step), { 62 });
  }
  vtkNew<TemporalGrids> source;
  source->SetSteps(steps);
  vtkNew<vtkTimeSlabWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetInterval(0, 2.0, 6.5);
  writer->SetFileName((folder / "slabs.vtm").string().c_str());
  ExpectWarnings(writer);
  check.That(writer->Write(), "written");
  check.Near(writer->GetReport()->GetNumber("NonFiniteCells"), 8, 0.0, "cells of the last slab");
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

/// 4-simplices with lost points: as with lost times.
void CheckSimplices(Check& check)
{
  check.SetContext("4-simplices");
  const auto slice = [&](bool losesPlaces, vtkIdType& skipped)
  {
    KuhnOptions options;
    options.Cells = { { 4, 4, 4, 2 } };
    const auto grid = MakeKuhnGrid(options);
    for (const vtkIdType p : ChoosePoints(grid, 3))
    {
      losesPlaces ? grid->GetPoints()->SetPoint(p, 0, NaN, 0)
                  : grid->GetPointData()->GetArray("Time")->SetComponent(p, 0, NaN);
    }
    vtkNew<vtkSimplexTimeSlice> filter;
    filter->SetInputData(grid);
    filter->SetTime(1.25);
    std::ostringstream text;
    const std::string said = WarningsOf(filter);
    check.That(said.empty() != losesPlaces, "warning: " + said);
    skipped = static_cast<vtkIdType>(filter->GetReport()->GetNumber("NonFiniteSimplices"));
    check.That(!losesPlaces ||
        said.find(std::to_string(skipped) + " cells are skipped") != std::string::npos,
      std::to_string(skipped) + " cells: " + said);
    AddDigest(filter->GetOutputDataObject(0), text);
    return text.str();
  };
  vtkIdType skipped = 0;
  vtkIdType expected = 0;
  const std::string found = slice(true, skipped);
  const std::string wanted = slice(false, expected);
  check.That(found == wanted, found + "for " + wanted);
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
