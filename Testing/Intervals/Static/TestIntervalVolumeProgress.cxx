// SPDX-License-Identifier: BSD-3-Clause
// Progress is reported and never decreases, an abort leaves a valid output, and PrintSelf prints
// every public value.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

void CheckPrint(Check& check)
{
  const std::vector<std::string> report = { "Cells", "CellsVisited", "CellsByBits",
    "CellsWithOutput", "LowerDimensionalCells", "NonFiniteCells", "BlankedCells", "LinearizedCells",
    "ConcavePolyhedra", "UnsupportedCells", "CollapsedSimplices", "InteriorCells", "NonPlanarFaces",
    "ArraysInterpolated", "ArraysCopied", "Passes", "WorkingBytes", "ReusedBytes", "IdleBytes" };
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInterval(0, 1.25, 2.5);
  volume->SetInterval(1, 3.125, 4.75);
  volume->AddCriterion("density", 17.5, 18.25);
  const std::string volumeText = Print(volume);
  CheckPrinted(volumeText, report, check);
  CheckPrinted(volumeText,
    { "GenerateBoundaries", "KeepInteriorCells", "OutputPointsPrecision", "UseValueIndex",
      "ReuseMemory", "1.25", "2.5", "3.125", "4.75", "density", "17.5", "18.25" },
    check);
  vtkNew<vtkIsotableContour> contour;
  contour->SetValue(0, 6.375);
  contour->SetValue(1, 7.625);
  const std::string contourText = Print(contour);
  CheckPrinted(contourText, report, check);
  CheckPrinted(contourText,
    { "OutputPointsPrecision", "MergePoints", "UseValueIndex", "6.375", "7.625" }, check);
}

// The datasets of a composite input share the progress range. Each criterion adds a pass per
// dataset. An abort stops the remaining datasets.
void CheckComposite(vtkImageData* image, Check& check)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, image);
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInputDataObject(blocks);
  volume->SetInterval(0, 0.2, 0.4);
  volume->AddCriterion(image->GetPointData()->GetScalars()->GetName(), 0.25, 0.35);
  ProgressWatch watch;
  ObserveProgress(volume, watch);
  volume->Update();
  CheckMonotonicProgress(watch, 10, check);
  watch = ProgressWatch();
  watch.AbortAt = 0.1;
  volume->Modified();
  volume->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(volume->GetOutputDataObject(0));
  vtkIdType cells = 0;
  for (unsigned int block = 0; block < 2; ++block)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(block));
    cells += grid ? grid->GetNumberOfCells() : 0;
  }
  check.Equal(cells, 0, "cells of all datasets after an abort in the first");
}

}

int TestIntervalVolumeProgress(int, char*[])
{
  Check check;
  auto image = MakeImage({ 40, 40, 40 });
  AddRandomField(image, 2);
  auto mesh = MakeMesh(MeshKind::Mixed, { 20, 20, 20 });
  AddRandomField(mesh, 2);
  vtkDataSet* const inputs[] = { image, mesh };
  for (vtkDataSet* data : inputs)
  {
    check.SetContext(std::string("intervals of ") + data->GetClassName());
    vtkNew<vtkIntervalVolume> volume;
    volume->SetInterval(0, 0.2, 0.4);
    volume->GenerateBoundariesOn();
    CheckProgress(volume, data, VTK_TETRA, check);
    check.SetContext(std::string("contours of ") + data->GetClassName());
    vtkNew<vtkIsotableContour> contour;
    contour->SetValue(0, 0.4);
    CheckProgress(contour, data, VTK_TRIANGLE, check);
  }
  auto hexahedra = MakeMesh(MeshKind::Hexahedra, { 20, 20, 20 });
  AddRandomField(hexahedra, 2);
  vtkDataSet* const inputsOfHexahedra[] = { image, hexahedra };
  for (vtkDataSet* data : inputsOfHexahedra)
  {
    // With random values, no hexahedron is interior.
    check.SetContext(std::string("with KeepInteriorCells, ") + data->GetClassName());
    vtkNew<vtkIntervalVolume> volume;
    volume->SetInterval(0, 0.2, 0.4);
    volume->KeepInteriorCellsOn();
    CheckProgress(volume, data, VTK_TETRA, check);
  }
  check.SetContext("composite");
  CheckComposite(image, check);
  check.SetContext("print");
  CheckPrint(check);
  return check.Result();
}
