// SPDX-License-Identifier: BSD-3-Clause
// A large output causes one warning per execution, before it is allocated, with its number of
// tetrahedra and its memory.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Checks/ReferenceSizeWarning.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

vtkIdType CountCells(vtkIntervalVolume* filter)
{
  filter->SetSizeWarningLimit(0);
  filter->Update();
  return filter->GetOutput()->GetNumberOfCells();
}

/// Checks the warning for one dataset, with and without a value index.
void CheckDataSet(vtkDataSet* data, Check& check)
{
  AddRandomField(data, 3);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(data);
  filter->SetInterval(0, 0.3, 0.6);
  const vtkIdType number = CountCells(filter);
  filter->SetSizeWarningLimit(number);
  check.That(WarningsOf(filter).empty(), "no warning at the limit");
  filter->SetSizeWarningLimit(number - 1);
  for (int update = 0; update < 3; ++update)
  {
    filter->Modified();
    const std::vector<ReportedSize> sizes = FindSizes(WarningsOf(filter));
    if (check.Equal(static_cast<long long>(sizes.size()), 1, "warnings above the limit"))
    {
      check.Equal(static_cast<long long>(sizes[0].Tetrahedra), number, "tetrahedra of the warning");
    }
  }
  filter->SetInterval(0, 0.3, 0.55);
  const vtkIdType fewer = CountCells(filter);
  filter->SetSizeWarningLimit(fewer - 1);
  filter->SetInterval(0, 0.3, 0.6);
  const std::vector<ReportedSize> sizes = FindSizes(WarningsOf(filter));
  check.That(sizes.size() == 1 && sizes[0].Tetrahedra == number, "a warning with the index");
  filter->SetSizeWarningLimit(0);
  check.That(WarningsOf(filter).empty(), "no warning if the limit is 0");
}

void CheckText(Check& check)
{
  check.SetContext("text");
  vtkNew<vtkIntervalVolume> filter;
  check.Equal(filter->GetSizeWarningLimit(), 5000000, "default limit");
  filter->SetSizeWarningLimit(-7);
  check.Equal(filter->GetSizeWarningLimit(), 0, "a negative limit");
  const auto image = MakeImage({ 4, 4, 4 });
  AddRandomField(image, 3);
  filter->SetInputData(image);
  filter->SetInterval(0, 0.3, 0.6);
  filter->SetSizeWarningLimit(10);
  const std::string warning = ToSingleLine(WarningsOf(filter));
  for (const char* part : { "The output will have ", " tetrahedra and take about 0.1 MB of ",
         " memory", "narrower intervals", "coarser input", "KeepInteriorCells",
         "SizeWarningLimit (10 tetrahedra; 0 turns it off)", "a quarter of the memory" })
  {
    check.Contains(warning, part);
  }
  filter->KeepInteriorCellsOn();
  check.That(ToSingleLine(WarningsOf(filter)).find("KeepInteriorCells") == std::string::npos,
    "no advice to turn on what is on");
}

/// The reported memory is that of the output, including its arrays, up to 25 %.
void CheckBytes(Check& check)
{
  check.SetContext("bytes");
  const auto image = MakeImage({ 36, 36, 36 });
  AddRandomField(image, 3);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(image->GetNumberOfPoints());
  vectors->Fill(1.0);
  image->GetPointData()->AddArray(vectors);
  vtkNew<vtkFloatArray> cells;
  cells->SetName("cells");
  cells->SetNumberOfComponents(6);
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(1.0);
  image->GetCellData()->AddArray(cells);
  for (const bool hasArrays : { true, false })
  {
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputData(image);
    filter->SetInterval(0, 0.3, 0.6);
    filter->SetSizeWarningLimit(1000);
    const std::vector<ReportedSize> sizes = FindSizes(WarningsOf(filter));
    const double bytes = 1024.0 * filter->GetOutput()->GetActualMemorySize();
    check.That(sizes.size() == 1 && sizes[0].Bytes > 0.95 * bytes && sizes[0].Bytes < 1.3 * bytes,
      "reported bytes of " + std::to_string(bytes) + (hasArrays ? " with arrays" : ""));
    image->GetPointData()->RemoveArray("vectors");
    image->GetCellData()->RemoveArray("cells");
  }
}

/// The datasets of a composite input count together and cause one warning.
void CheckComposite(Check& check)
{
  check.SetContext("composite");
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkIdType number = 0;
  for (unsigned int b = 0; b < 4; ++b)
  {
    const auto image = MakeImage({ 5, 5, 5 });
    AddRandomField(image, b);
    blocks->SetBlock(2 * b, image);
  }
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInterval(0, 0.3, 0.6);
  filter->SetSizeWarningLimit(0);
  std::vector<vtkIdType> sums;
  for (unsigned int b = 0; b < 4; ++b)
  {
    filter->SetInputDataObject(blocks->GetBlock(2 * b));
    filter->Update();
    sums.push_back(number += filter->GetOutput()->GetNumberOfCells());
  }
  filter->SetInputDataObject(blocks);
  filter->SetSizeWarningLimit(sums[1]);
  const std::string warning = WarningsOf(filter);
  const std::vector<ReportedSize> sizes = FindSizes(warning);
  check.That(sizes.size() == 1 && sizes[0].Tetrahedra == sums[2],
    "one warning, at the dataset that exceeds the limit: " + warning);
  check.Contains(warning, "will have at least ");
  filter->SetSizeWarningLimit(sums[3]);
  check.That(WarningsOf(filter).empty(), "no warning for all datasets at the limit");
}

/// An observer of the warning can abort before the output is allocated.
void CheckAbort(Check& check)
{
  check.SetContext("abort");
  const auto image = MakeImage({ 9, 9, 9 });
  AddRandomField(image, 3);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(image);
  filter->SetInterval(0, 0.3, 0.6);
  filter->SetSizeWarningLimit(10);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::WarningEvent, abort);
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells after an abort by the warning");
}

}

int TestIntervalVolumeSize(int, char*[])
{
  Check check;
  check.SetContext("image");
  CheckDataSet(MakeImage({ 9, 8, 7 }), check);
  check.SetContext("mixed cells");
  CheckDataSet(MakeMesh(MeshKind::Mixed, { 5, 5, 5 }), check);
  CheckText(check);
  CheckBytes(check);
  CheckComposite(check);
  CheckAbort(check);
  return check.Result();
}
