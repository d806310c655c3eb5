// SPDX-License-Identifier: BSD-3-Clause
// An execution that gives nothing says why, with what the data have: once for a whole composite
// input, and not for one dataset or piece of several. The scalar is the active one on what is made.
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

/// Random values f, and p = 10 f, which is active.
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

void CheckSaid(vtkAlgorithm* filter, const std::vector<std::string>& parts, Check& check)
{
  const std::string said = WarningsOf(filter);
  check.Equal(Count(said, "The output is empty: "), parts.empty() ? 0 : 1, "warnings: " + said);
  for (const std::string& part : parts)
  {
    check.That(said.find(part) != std::string::npos, "it says \"" + part + "\": " + said);
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
      { "the interval [1.5, 2]", "\"f\" goes from 0.0592432 to 0.999041" } },
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
    { "a surface", surface, [](vtkIntervalVolume* filter) { filter->SetInterval(0, 0, 1); },
      { "none of the input's 1 cells is three-dimensional" } },
    { "hidden", hidden, [](vtkIntervalVolume* filter) { filter->SetInterval(0, 0, 1); },
      { "no cell that counts", "hidden" } },
    { "a criterion", MakeInput(),
      [](vtkIntervalVolume* filter)
      {
        filter->SetInterval(0, 0.5, 1);
        filter->AddCriterion("p", 0, 2);
      },
      { "the criterion on \"p\" from 0 to 2", "goes from 5 to 9." } },
    { "enough", MakeInput(), [](vtkIntervalVolume* filter) { filter->SetInterval(0, 0.5, 1); },
      {} },
    { "quiet", MakeInput(), [](vtkIntervalVolume* filter) { filter->WarnOnEmptyOutputOff(); }, {} },
  };
  for (const auto& one : cases)
  {
    check.SetContext(one.Name);
    auto filter = MakeFilter<vtkIntervalVolume>(one.Input);
    one.Set(filter);
    CheckSaid(filter, one.Parts, check);
  }
  check.SetContext("contour");
  auto contour = MakeFilter<vtkIsotableContour>(MakeInput());
  CheckSaid(contour, { "no value is set" }, check);
  contour->SetValue(0, 3);
  CheckSaid(contour, { "the value 3", "\"f\" goes from 0.0592432 to 0.999041" }, check);
  contour->SetValue(0, 0.5);
  CheckSaid(contour, {}, check);
}

/// A bound that is a word is an error with that word; one that is a number is taken.
void CheckWords(Check& check)
{
  auto filter = MakeFilter<vtkIntervalVolume>(MakeInput());
  filter->SetInterval(0, 0, 1);
  for (const char* word : { "high", "1e", "2 3", "" })
  {
    check.SetContext(std::string("bound ") + word);
    filter->RemoveAllCriteria();
    filter->AddCriterionAsText("p", "0", word);
    const std::string said = MessagesOf(filter);
    check.That(said.find(*word ? std::string("\"") + word + "\"" : "nothing") != std::string::npos,
      "the error has it: " + said);
    check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells");
  }
  check.SetContext("numbers as text");
  filter->RemoveAllCriteria();
  filter->AddCriterionAsText("p", " 1.5", "4e0 ");
  double lower = 0;
  double upper = 0;
  filter->GetCriterionRange(0, lower, upper);
  check.That(lower == 1.5 && upper == 4, "the bounds are those written");
  filter->Update();
  check.That(filter->GetOutput()->GetNumberOfCells() > 0, "there is output");
}

/// It is said of the whole, not of a part.
void CheckParts(Check& check)
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
    check.SetContext("one block has it, from " + std::to_string(lower));
    filter->SetInterval(0, lower, lower + 0.25);
    CheckSaid(filter, {}, check);
  }
  check.SetContext("no block has it");
  filter->SetInterval(0, 2, 3);
  CheckSaid(filter, { "from 0.0592432 to 5.99904" }, check);
  check.SetContext("no block");
  CheckSaid(
    MakeFilter<vtkIntervalVolume>(vtkNew<vtkMultiBlockDataSet>()), { "no interval" }, check);
  check.SetContext("one piece of two");
  auto piece = MakeFilter<vtkIntervalVolume>(MakeInput());
  piece->SetInterval(0, 2, 3);
  const std::string said = [&piece]()
  {
    vtkNew<vtkTest::ErrorObserver> watch;
    piece->AddObserver(vtkCommand::WarningEvent, watch);
    piece->UpdatePiece(1, 2, 0);
    return watch->GetWarningMessage();
  }();
  check.That(said.empty(), "nothing is said: " + said);
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
    check.That(active && std::string(active->GetName()) == "f", "the scalar chosen is active");
  }
}

}

int TestIntervalEmptyResult(int, char*[])
{
  Check check;
  CheckReasons(check);
  CheckWords(check);
  CheckParts(check);
  CheckActive(check);
  return check.Result();
}
