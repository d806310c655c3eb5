// SPDX-License-Identifier: BSD-3-Clause
// An execution with an empty result warns with the reason and the range of the data. A composite
// input causes one warning if all results are empty. An empty piece among several causes no
// warning. The extracted scalar is the active array of the output.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace
{

using namespace reference;

/// Returns a mesh with random values f and with p = 10 f as the active scalars.
vtkSmartPointer<vtkUnstructuredGrid> MakeInput()
{
  auto mesh = MakeMesh(MeshKind::Mixed, { 2, 2, 2 });
  vtkDoubleArray* f = AddRandomField(mesh, 1);
  vtkNew<vtkDoubleArray> p;
  p->SetName("p");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    p->InsertNextValue(10 * f->GetValue(i));
  }
  mesh->GetPointData()->AddArray(p);
  mesh->GetPointData()->SetActiveScalars("p");
  return mesh;
}

template <typename Filter>
vtkSmartPointer<Filter> MakeFilter(vtkDataObject* input)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputDataObject(input);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f");
  return filter;
}

int Count(const std::string& text, const std::string& part)
{
  int number = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++number;
  }
  return number;
}

void CheckWarnings(vtkAlgorithm* filter, const std::vector<std::string>& parts, Check& check)
{
  const std::string warnings = WarningsOf(filter);
  check.Equal(
    Count(warnings, "The output is empty: "), parts.empty() ? 0 : 1, "warnings: " + warnings);
  for (const std::string& part : parts)
  {
    check.That(warnings.find(part) != std::string::npos,
      "the warning contains \"" + part + "\": " + warnings);
  }
}

void CheckReasons(Check& check)
{
  vtkNew<vtkUnstructuredGrid> surface;
  surface->SetPoints(MakeInput()->GetPoints());
  surface->GetPointData()->ShallowCopy(MakeInput()->GetPointData());
  const vtkIdType corners[] = { 0, 1, 2 };
  surface->InsertNextCell(VTK_TRIANGLE, 3, corners);
  auto hidden = MakeInput();
  vtkUnsignedCharArray* ghosts = hidden->AllocateCellGhostArray();
  ghosts->FillValue(vtkDataSetAttributes::HIDDENCELL);
  const struct
  {
    const char* Name;
    vtkSmartPointer<vtkDataSet> Input;
    std::function<void(vtkIntervalVolume*)> Set;
    std::vector<std::string> Parts;
  } cases[] = {
    { "outside", MakeInput(), [](vtkIntervalVolume* filter) { filter->SetInterval(0, 1.5, 2); },
      { "the interval [1.5, 2]", "\"f\" ranges from 0.0592432 to 0.999041" } },
    { "several", MakeInput(),
      [](vtkIntervalVolume* filter)
      {
        for (int i = 0; i < 5; ++i)
        {
          filter->SetInterval(i, 2 + i, 2.5 + i);
        }
      },
      { "the intervals [2, 2.5], [3, 3.5], [4, 4.5], and 2 more" } },
    { "none", MakeInput(), [](vtkIntervalVolume*) {}, { "no interval is set" } },
    { "a surface", surface,
      [](vtkIntervalVolume* filter)
      {
        filter->SetSurfaceCells(vtkIntervalVolume::NEVER);
        filter->SetInterval(0, 0, 1);
      },
      { "none of the input's 1 cells is three-dimensional" } },
    { "hidden", hidden, [](vtkIntervalVolume* filter) { filter->SetInterval(0, 0, 1); },
      { "no cell intersects", "hidden" } },
    { "a criterion", MakeInput(),
      [](vtkIntervalVolume* filter)
      {
        filter->SetInterval(0, 0.5, 1);
        filter->AddCriterion("p", 0, 2);
      },
      { "the criterion on \"p\" from 0 to 2", "ranges from 5 to 9." } },
    { "a criterion without values", MakeInput(),
      [](vtkIntervalVolume* filter)
      {
        vtkNew<vtkDoubleArray> empty;
        empty->SetName("NaN");
        empty->SetNumberOfTuples(vtkDataSet::SafeDownCast(filter->GetInput())->GetNumberOfPoints());
        empty->Fill(std::nan(""));
        vtkDataSet::SafeDownCast(filter->GetInput())->GetPointData()->AddArray(empty);
        filter->SetInterval(0, 0.5, 1);
        filter->AddCriterion("NaN", 0, 2);
      },
      { "the criterion on \"NaN\" from 0 to 2", "has no finite value." } },
    { "a union", MakeInput(),
      [](vtkIntervalVolume* filter)
      {
        filter->SetInterval(0, 20, 21);
        filter->AddCriterion("p", -2, -1);
        filter->SetCriteriaOperation(vtkIntervalVolume::UNION);
      },
      { "[20, 21] or satisfies a criterion" } },
    { "enough", MakeInput(), [](vtkIntervalVolume* filter) { filter->SetInterval(0, 0.5, 1); },
      {} },
    { "quiet", MakeInput(), [](vtkIntervalVolume* filter) { filter->WarnOnEmptyOutputOff(); }, {} },
  };
  for (const auto& one : cases)
  {
    check.SetContext(one.Name);
    auto filter = MakeFilter<vtkIntervalVolume>(one.Input);
    one.Set(filter);
    CheckWarnings(filter, one.Parts, check);
  }
  check.SetContext("contour");
  auto contour = MakeFilter<vtkIsotableContour>(MakeInput());
  CheckWarnings(contour, { "no value is set" }, check);
  contour->SetValue(0, 3);
  CheckWarnings(contour, { "the value 3", "\"f\" ranges from 0.0592432 to 0.999041" }, check);
  contour->SetValue(0, 0.5);
  CheckWarnings(contour, {}, check);
}

/// A bound given as text that is not a number causes an error that quotes the text. Text that is a
/// number is accepted.
void CheckTextBounds(Check& check)
{
  auto filter = MakeFilter<vtkIntervalVolume>(MakeInput());
  filter->SetInterval(0, 0, 1);
  for (const char* word : { "high", "1e", "2 3", "" })
  {
    check.SetContext(std::string("bound ") + word);
    filter->RemoveAllCriteria();
    filter->AddCriterionAsText("p", "0", word);
    const std::string warnings = UpdateAndGetErrors(filter);
    check.That(
      warnings.find(*word ? std::string("\"") + word + "\"" : "(empty)") != std::string::npos,
      "the error quotes the text: " + warnings);
    check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells");
  }
  check.SetContext("numbers as text");
  filter->RemoveAllCriteria();
  filter->AddCriterionAsText("p", " 1.5", "4e0 ");
  double lower = 0;
  double upper = 0;
  filter->GetCriterionRange(0, lower, upper);
  check.That(lower == 1.5 && upper == 4, "the bounds equal the parsed numbers");
  filter->Update();
  check.That(filter->GetOutput()->GetNumberOfCells() > 0, "the output is not empty");
}

/// The warning about empty output refers to the entire input, not to a block or a piece.
void CheckBlocksAndPieces(Check& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  auto low = MakeInput();
  auto high = MakeInput();
  auto* values = vtkDoubleArray::SafeDownCast(high->GetPointData()->GetArray("f"));
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, values->GetValue(i) + 5);
  }
  blocks->SetBlock(0, low);
  blocks->SetBlock(1, vtkNew<vtkUnstructuredGrid>());
  blocks->SetBlock(2, high);
  auto filter = MakeFilter<vtkIntervalVolume>(blocks);
  for (const double lower : { 0.25, 5.25 })
  {
    check.SetContext("one block has output, from " + std::to_string(lower));
    filter->SetInterval(0, lower, lower + 0.25);
    CheckWarnings(filter, {}, check);
  }
  check.SetContext("no block has output");
  filter->SetInterval(0, 2, 3);
  CheckWarnings(filter, { "from 0.0592432 to 5.99904" }, check);
  check.SetContext("composite input without blocks");
  CheckWarnings(
    MakeFilter<vtkIntervalVolume>(vtkNew<vtkMultiBlockDataSet>()), { "no interval" }, check);
  check.SetContext("one piece of two");
  auto piece = MakeFilter<vtkIntervalVolume>(MakeInput());
  piece->SetInterval(0, 2, 3);
  const std::string warnings = [&piece]()
  {
    vtkNew<vtkTest::ErrorObserver> watch;
    piece->AddObserver(vtkCommand::WarningEvent, watch);
    piece->UpdatePiece(1, 2, 0);
    return watch->GetWarningMessage();
  }();
  check.That(warnings.empty(), "no warning for a piece: " + warnings);
}

void CheckActive(Check& check)
{
  check.SetContext("active scalars");
  auto volume = MakeFilter<vtkIntervalVolume>(MakeInput());
  volume->SetInterval(0, 0.25, 0.75);
  volume->GenerateBoundariesOn();
  volume->AddCriterion("p", 2, 8);
  volume->Update();
  auto contour = MakeFilter<vtkIsotableContour>(MakeInput());
  contour->SetValue(0, 0.5);
  contour->Update();
  for (vtkDataObject* output : { volume->GetOutputDataObject(0), volume->GetOutputDataObject(1),
         contour->GetOutputDataObject(0) })
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(output);
    check.That(grid->GetNumberOfCells() > 0, "there are cells");
    vtkDataArray* active = grid->GetPointData()->GetScalars();
    check.That(active && std::string(active->GetName()) == "f", "the extracted scalar is active");
  }
}

}

int TestIntervalEmptyResult(int, char*[])
{
  Check check;
  CheckReasons(check);
  CheckTextBounds(check);
  CheckBlocksAndPieces(check);
  CheckActive(check);
  return check.Result();
}
