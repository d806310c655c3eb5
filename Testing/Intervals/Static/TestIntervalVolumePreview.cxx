// SPDX-License-Identifier: BSD-3-Clause
// Previews of large structured grids: coarse, without gaps, and without effect on later executions.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <random>

namespace
{

using namespace reference;

constexpr LinearFunction Linear = { 0.3, { 0.7, -0.4, 0.9 } };
// The dimensions are no multiples of the strides.
const std::array<int, 3> Cells = { 16, 11, 13 };
constexpr vtkIdType Limit = 120;

double VolumeOf(vtkIntervalVolume* filter)
{
  return static_cast<double>(MeasureTetrahedra(filter->GetOutput()).Sum);
}

/// In a linear field, a coarse grid has the region of the full grid.
void CheckLinear(Check& check)
{
  for (const DataSetVariant& form : FormsOf(MakeImage(Cells)))
  {
    check.SetContext(form.Name);
    AddLinearField(form.Data, Linear);
    double range[2];
    form.Data->GetPointData()->GetScalars()->GetRange(range);
    const double lower = 0.7 * range[0] + 0.3 * range[1];
    const double upper = 0.4 * range[0] + 0.6 * range[1];
    vtkNew<vtkIntervalVolume> filter;
    filter->SetInputDataObject(form.Data);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->GenerateOriginArraysOn();
    filter->SetInterval(0, lower, upper);
    filter->SetPreviewCellLimit(Limit);
    filter->Update();
    const double volume = static_cast<double>(ClippedVolume(form.Data, { { "f", lower, upper } }));
    check.Near(VolumeOf(filter), volume, 2e-6, "volume of the preview");
    const bool isStructured = !vtkUnstructuredGrid::SafeDownCast(form.Data);
    check.Equal(filter->GetReport()->GetCount("Cells"),
      isStructured ? 6 * 4 * 5 : form.Data->GetNumberOfCells(), "cells of the preview");
    check.That(isStructured != filter->GetOutput()->GetCellData()->HasArray("OriginCell"),
      "origins exist in exact previews only");
    filter->SetPreviewCellLimit(form.Data->GetNumberOfCells());
    filter->Update();
    check.Equal(filter->GetReport()->GetCount("Cells"), form.Data->GetNumberOfCells(),
      "cells of a preview below the limit");
  }
}

template <typename Filter>
void CheckOutput(Filter* filter, vtkDataObject* input, Filter* fresh, Check& check)
{
  fresh->SetInputDataObject(input);
  fresh->SetPreviewCellLimit(filter->GetPreviewCellLimit());
  filter->Update();
  fresh->Update();
  const std::string difference = FindDifference(filter->GetOutput(), fresh->GetOutput());
  check.That(difference.empty(), difference);
}

/// Any sequence of previews and exact executions has the output of fresh filters.
void CheckSequence(Check& check)
{
  const auto image = MakeImage(Cells);
  AddRandomField(image, 5);
  vtkNew<vtkIntervalVolume> volume;
  vtkNew<vtkIsotableContour> contour;
  volume->SetInputDataObject(image);
  contour->SetInputDataObject(image);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> bound(0.0, 1.0);
  const vtkIdType limits[] = { 0, 10, Limit, 1000, 100000 };
  for (int step = 0; step < 60; ++step)
  {
    check.SetContext("step " + std::to_string(step));
    const double lower = bound(random);
    const double upper = lower + bound(random);
    volume->SetUseValueIndex(step % 7 != 0);
    volume->SetPreviewCellLimit(limits[random() % std::size(limits)]);
    volume->SetInterval(0, lower, upper);
    contour->SetPreviewCellLimit(volume->GetPreviewCellLimit());
    contour->SetValue(0, lower);
    if (step == 30)
    {
      AddRandomField(image, 6);
    }
    vtkNew<vtkIntervalVolume> freshVolume;
    freshVolume->SetInterval(0, lower, upper);
    CheckOutput(volume.Get(), image.Get(), freshVolume.Get(), check);
    vtkNew<vtkIsotableContour> freshContour;
    freshContour->SetValue(0, lower);
    CheckOutput(contour.Get(), image.Get(), freshContour.Get(), check);
  }
}

/// The previews of pieces fill the volume of the full grid.
void CheckPieces(Check& check)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-7, 9, -5, 8, -6, 10);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetInterval(0, -1e9, 1e9);
  filter->SetPreviewCellLimit(40);
  for (const int pieces : { 1, 2, 5 })
  {
    double volume = 0.0;
    for (int piece = 0; piece < pieces; ++piece)
    {
      filter->UpdatePiece(piece, pieces, 0);
      volume += VolumeOf(filter);
      check.That(filter->GetReport()->GetCount("Cells") <= 40, "the limit applies to each piece");
    }
    check.Near(volume, 16.0 * 13.0 * 16.0, 1e-9, std::to_string(pieces) + " pieces");
  }
}

/// Coarse cells have the blanking of their first cell.
void CheckBlanking(Check& check)
{
  const auto image = MakeImage({ 12, 12, 12 });
  AddLinearField(image, Linear);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(image->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    ghosts->SetValue(cell, cell % 12 < 6 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  image->GetCellData()->AddArray(ghosts);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputDataObject(image);
  filter->SetInterval(0, -1e9, 1e9);
  filter->Update();
  const double exact = VolumeOf(filter);
  filter->SetPreviewCellLimit(64);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Cells"), 64, "cells of the preview");
  check.Near(VolumeOf(filter), exact, 1e-5, "volume without hidden cells");
}

/// Datasets of a composite dataset share the limit. Cell arrays are averaged on the coarse grid.
void CheckComposite(Check& check)
{
  const auto image = MakeImage(Cells);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("id");
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    ids->InsertNextValue(cell);
  }
  image->GetCellData()->AddArray(ids);
  const std::vector<DataSetVariant> forms = FormsOf(image);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(4);
  blocks->SetBlock(0, forms[0].Data);
  blocks->SetBlock(2, forms[1].Data);
  blocks->SetBlock(3, forms.back().Data);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputDataObject(blocks);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "id");
  filter->SetInterval(0, -1e9, 1e9);
  filter->SetPreviewCellLimit(2 * 48);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Cells"), 2 * 48 + image->GetNumberOfCells(),
    "cells of the preview");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* coarse = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(0));
  const double volume = static_cast<double>(MeshVolume(image));
  check.Near(static_cast<double>(MeasureTetrahedra(coarse).Sum), volume, 1e-5, "volume of a block");
  vtkDataArray* cells = coarse->GetCellData()->GetArray("id");
  bool areFirst = true;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfTuples(); ++cell)
  {
    const auto id = static_cast<vtkIdType>(cells->GetTuple1(cell));
    areFirst = areFirst && id % 16 % 4 == 0 && id / 16 % 11 % 4 == 0 && id / (16 * 11) % 4 == 0;
  }
  check.That(areFirst, "coarse cells have the arrays of their first cells");
}

/// Previews do not warn, but report errors.
void CheckMessages(Check& check)
{
  const auto image = MakeImage(Cells);
  AddLinearField(image, Linear);
  image->GetPointData()->GetScalars()->SetComponent(0, 0, std::numeric_limits<double>::infinity());
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputDataObject(image);
  filter->SetInterval(0, 1e6, 2e6);
  for (const vtkIdType limit : { Limit, vtkIdType(100000) })
  {
    filter->SetPreviewCellLimit(limit);
    check.That(WarningsOf(filter).empty(), "a preview does not warn");
  }
  filter->SetPreviewCellLimit(0);
  check.Contains(WarningsOf(filter), "The output is empty");
  filter->SetPreviewCellLimit(Limit);
  filter->SetInterval(0, 2.0, 1.0);
  check.Contains(UpdateAndGetErrors(filter), "lower");
}

}

int TestIntervalVolumePreview(int, char*[])
{
  return RunChecks(
    { CheckLinear, CheckSequence, CheckPieces, CheckBlanking, CheckComposite, CheckMessages });
}
