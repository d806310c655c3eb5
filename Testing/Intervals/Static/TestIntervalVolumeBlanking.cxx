// SPDX-License-Identifier: BSD-3-Clause
// Ghost, hidden and blanked cells, cells of hidden points, and cells with NaN or infinite scalars
// are skipped and counted. Other cells are unaffected.
#include "Common/DataDigest.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>

namespace
{

using namespace reference;

constexpr double CellVolume = 0.1 * 0.3 * 0.7;
constexpr int NumberOfCells = 4 * 4 * 4;
/// An interior point of the grid with 5 x 5 x 5 points. Eight cells use the point.
constexpr vtkIdType InnerPoint = 2 + 5 * (2 + 5 * 2);

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
  check.Equal(extraction.Report->GetCount("Cells"), NumberOfCells, std::string(what) + ": cells");
}

void CheckBlanked(vtkDataSet* data, int left, const char* what, Check& check)
{
  CheckLeftOut(data, left, what, check);
  check.Equal(ExtractIntervals(data, { { 0, 1 } }).Report->GetCount("BlankedCells"), left,
    std::string(what) + ": blanked cells of the interval volume");
  check.Near(ExtractContours(data, { 0.5 }).Report->GetNumber("BlankedCells"), left, 0.0,
    std::string(what) + ": blanked cells of the contour");
}

void CheckGhosts(size_t form, Check& check)
{
  auto make = [&] { return FormsOf(MakeInput())[form]; };
  {
    DataSetVariant lattice = make();
    check.SetContext(lattice.Name);
    CheckBlanked(lattice.Data, 0, "nothing", check);
  }
  for (unsigned char flag :
    { vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL })
  {
    DataSetVariant lattice = make();
    SetGhost(lattice.Data->GetCellData(), NumberOfCells, 21, flag);
    CheckBlanked(lattice.Data, 1, "cell flag", check);
  }
  {
    DataSetVariant lattice = make();
    SetGhost(lattice.Data->GetPointData(), 125, InnerPoint, vtkDataSetAttributes::HIDDENPOINT);
    CheckBlanked(lattice.Data, 8, "hidden point", check);
  }
  {
    // A duplicate point exists in another process too, but its cells belong to this process.
    DataSetVariant lattice = make();
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
    const DataSetVariant lattice = FormsOf(image)[form];
    check.SetContext(lattice.Name + ", " + std::to_string(value));
    CheckLeftOut(lattice.Data, 8, "not finite", check);
    check.Equal(ExtractIntervals(lattice.Data, { { 0, 1 } }).Report->GetCount("NonFiniteCells"), 8,
      "non-finite cells of the interval volume");
    check.Near(ExtractContours(lattice.Data, { 0.5 }).Report->GetNumber("NonFiniteCells"), 8, 0.0,
      "non-finite cells of the contour");
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

/// Returns a hash of all outputs for a grid, and the cell counts of the report.
std::string GetDigest(vtkDataSet* data, double unit, bool usesIndex, bool keepsInterior)
{
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(data);
  filter->GenerateBoundariesOn();
  filter->SetKeepInteriorCells(keepsInterior);
  filter->SetUseValueIndex(usesIndex);
  filter->WarnOnEmptyOutputOff();
  // The value index is built when the intervals change.
  for (const double upper : { 0.6, 0.8 })
  {
    filter->SetInterval(0, 0.25 * unit, 0.5 * unit);
    filter->SetInterval(1, 0.5 * unit, upper * unit);
    filter->Update();
  }
  interlume::DataDigest digest;
  for (int port = 0; port < 2; ++port)
  {
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    digest.AddGrid(output);
    for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
    {
      digest.Add(output->GetPointData()->GetArray(i));
    }
    for (int i = 0; i < output->GetCellData()->GetNumberOfArrays(); ++i)
    {
      digest.Add(output->GetCellData()->GetArray(i));
    }
  }
  vtkInterlumeReport* report = filter->GetReport();
  std::string text = digest.Take();
  for (const char* name : { "Cells", "CellsWithOutput", "BlankedCells" })
  {
    text += std::string(", ") + name + " " + std::to_string(report->GetNumber(name));
  }
  return text;
}

/// If the cells that are not blanked form a box, for example in a piece with a layer of ghost
/// cells, filters visit only the box unless they use a value index. The results must be the same.
void CheckBoxes(Check& check)
{
  constexpr int cells = 6;
  std::minstd_rand random(11);
  const auto draw = [&random](int end) { return static_cast<int>(random() % end); };
  for (int number = 0; number < 200; ++number)
  {
    int first[3];
    int last[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = draw(3) == 0 ? draw(cells) : draw(2);
      last[axis] =
        cells - (draw(3) == 0 ? draw(cells - first[axis]) : draw(std::min(2, cells - first[axis])));
    }
    auto image = MakeImage({ cells, cells, cells });
    const bool isTied = number % 2 == 1;
    isTied ? AddIntegerField(image, 4, number) : AddRandomField(image, number);
    const double unit = isTied ? 4.0 : 1.0;
    SetGhost(image->GetCellData(), cells * cells * cells, 0, 0);
    vtkUnsignedCharArray* marks = image->GetCellGhostArray();
    vtkNew<vtkDoubleArray> ids;
    ids->SetName("Ids");
    ids->SetNumberOfValues(marks->GetNumberOfValues());
    std::iota(ids->GetPointer(0), ids->GetPointer(ids->GetNumberOfValues()), 0.0);
    image->GetCellData()->AddArray(ids);
    for (int c = 0; c < cells * cells * cells; ++c)
    {
      const int at[3] = { c % cells, c / cells % cells, c / cells / cells };
      bool isWithin = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        isWithin = isWithin && at[axis] >= first[axis] && at[axis] < last[axis];
      }
      const auto mark = static_cast<unsigned char>(
        draw(2) == 0 ? vtkDataSetAttributes::DUPLICATECELL : vtkDataSetAttributes::HIDDENCELL);
      // If a cell inside the box is blanked too, the remaining cells do not form a box.
      const bool isHole = number % 7 == 0 && draw(20) == 0;
      marks->SetValue(c, isWithin && !isHole ? 0 : mark);
    }
    for (const bool keepsInterior : { false, true })
    {
      check.SetContext("box " + std::to_string(number) + (keepsInterior ? ", interior cells" : ""));
      const std::string found = GetDigest(image, unit, false, keepsInterior);
      const std::string expected = GetDigest(image, unit, true, keepsInterior);
      check.That(found == expected, found + " for " + expected);
    }
  }
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
  CheckBoxes(check);
  return check.Result();
}
