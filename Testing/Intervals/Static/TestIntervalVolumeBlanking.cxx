// SPDX-License-Identifier: BSD-3-Clause
// Ghost, hidden and blanked cells, cells of hidden points, and cells with NaN or infinity are left
// out and counted; everything else stays.
#include "Reference/Checks/ReferenceCheck.h"
#include "Reference/Intervals/ReferenceExtraction.h"
#include "Reference/Meshes/ReferenceField.h"
#include "Reference/Meshes/ReferenceLattice.h"
#include "Reference/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>

namespace
{

using namespace reference;

constexpr double CellVolume = 0.1 * 0.3 * 0.7;
constexpr int NumberOfCells = 4 * 4 * 4;
/// A point inside the lattice of 5 x 5 x 5 points: eight cells use it.
constexpr vtkIdType InnerPoint = 2 + 5 * (2 + 5 * 2);

void SetGhost(vtkDataSetAttributes* attributes, vtkIdType size, vtkIdType at, unsigned char value)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(size);
  ghosts->FillValue(0);
  ghosts->SetValue(at, value);
  attributes->AddArray(ghosts);
}

vtkSmartPointer<vtkImageData> MakeInput()
{
  auto image = MakeImage({ 4, 4, 4 });
  AddRandomField(image, 3);
  return image;
}

void CheckLeftOut(vtkDataSet* data, int left, const char* what, Check& check)
{
  const Extraction extraction = ExtractIntervals(data, { { 0, 1 } });
  check.Near(static_cast<double>(MeasureTetrahedra(extraction.Volume).Sum),
    (NumberOfCells - left) * CellVolume, 1e-12, std::string(what) + ": volume");
  check.Equal(extraction.Report.Cells, NumberOfCells, std::string(what) + ": cells");
}

void CheckBlanked(vtkDataSet* data, int left, const char* what, Check& check)
{
  CheckLeftOut(data, left, what, check);
  check.Equal(ExtractIntervals(data, { { 0, 1 } }).Report.BlankedCells, left,
    std::string(what) + ": blanked cells of the interval volume");
  check.Equal(ExtractContours(data, { 0.5 }).Report.BlankedCells, left,
    std::string(what) + ": blanked cells of the contour");
}

void CheckGhosts(size_t form, Check& check)
{
  auto make = [&] { return FormsOf(MakeInput())[form]; };
  {
    LatticeForm lattice = make();
    check.SetContext(lattice.Name);
    CheckBlanked(lattice.Data, 0, "nothing", check);
  }
  for (unsigned char flag :
    { vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL })
  {
    LatticeForm lattice = make();
    SetGhost(lattice.Data->GetCellData(), NumberOfCells, 21, flag);
    CheckBlanked(lattice.Data, 1, "cell flag", check);
  }
  {
    LatticeForm lattice = make();
    SetGhost(lattice.Data->GetPointData(), 125, InnerPoint, vtkDataSetAttributes::HIDDENPOINT);
    CheckBlanked(lattice.Data, 8, "hidden point", check);
  }
  {
    // A duplicate point is another process's too; its cells are still this one's.
    LatticeForm lattice = make();
    SetGhost(lattice.Data->GetPointData(), 125, InnerPoint, vtkDataSetAttributes::DUPLICATEPOINT);
    CheckBlanked(lattice.Data, 0, "duplicate point", check);
  }
}

void CheckNonFinite(size_t form, Check& check)
{
  for (double value : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    auto image = MakeInput();
    vtkDoubleArray::SafeDownCast(image->GetPointData()->GetScalars())->SetValue(InnerPoint, value);
    const LatticeForm lattice = FormsOf(image)[form];
    check.SetContext(lattice.Name + ", " + std::to_string(value));
    CheckLeftOut(lattice.Data, 8, "not finite", check);
    check.Equal(ExtractIntervals(lattice.Data, { { 0, 1 } }).Report.NonFiniteCells, 8,
      "cells of the interval volume that are not finite");
    check.Equal(ExtractContours(lattice.Data, { 0.5 }).Report.NonFiniteCells, 8,
      "cells of the contour that are not finite");
  }
}

void CheckBlankingCalls(Check& check)
{
  check.SetContext("blanking calls");
  vtkNew<vtkUniformGrid> uniform;
  uniform->DeepCopy(MakeInput());
  uniform->BlankCell(5);
  uniform->BlankCell(6);
  CheckBlanked(uniform, 2, "vtkUniformGrid", check);
  vtkNew<vtkStructuredGrid> structured;
  structured->DeepCopy(FormsOf(MakeInput())[1].Data);
  structured->BlankCell(7);
  CheckBlanked(structured, 1, "vtkStructuredGrid, cell", check);
  structured->BlankPoint(InnerPoint);
  CheckBlanked(structured, 9, "vtkStructuredGrid, cell and point", check);
}

}

int TestIntervalVolumeBlanking(int, char*[])
{
  Check check;
  for (size_t form = 0; form < FormsOf(MakeInput()).size(); ++form)
  {
    CheckGhosts(form, check);
    CheckNonFinite(form, check);
  }
  CheckBlankingCalls(check);
  return check.Result();
}
