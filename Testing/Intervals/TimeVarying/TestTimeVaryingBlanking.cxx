// SPDX-License-Identifier: BSD-3-Clause
// Ghost, hidden and blanked cells, cells of hidden points, and cells with NaN or infinity at a step
// are skipped in the adjacent slabs and counted. Other cells are not affected.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>

namespace
{

using namespace reference;

constexpr double CellVolume = 0.1 * 0.3 * 0.7;
constexpr int NumberOfCells = 4 * 4 * 4;
/// Index of an interior point of the 5 x 5 x 5 grid points. Eight cells use it.
constexpr vtkIdType InnerPoint = 2 + 5 * (2 + 5 * 2);
const std::vector<double> Times = { 0, 1, 3 };

TimeSteps MakeSteps(const DataSetVariant& form)
{
  TimeSteps steps = RepeatGrid(form.Data, Times);
  AddRandomTimeField(steps, 3);
  return steps;
}

/// Checks the number of skipped cells in each slab. \a count is the name of this number in the
/// report.
void CheckSkipped(const TimeSteps& steps, const std::array<int, 2>& skipped, const char* count,
  const std::string& what, Check& check)
{
  const TimeVaryingExtraction found = ExtractTimeVarying(steps, { { { 0, 1 } } });
  double expected = 0;
  for (int slab = 0; slab < 2; ++slab)
  {
    const double here =
      (NumberOfCells - skipped[slab]) * CellVolume * (Times[slab + 1] - Times[slab]);
    expected += here;
    check.Near(static_cast<double>(MeasureSimplices(found.Simplices, Any, slab).Sum), here, 1e-12,
      what + ": 4-simplices of slab " + std::to_string(slab));
  }
  check.Near(static_cast<double>(MeasureWeightedTetrahedra(found.Tetrahedra).Sum), expected, 1e-12,
    what + ": tetrahedra");
  check.Equal(found.Report->GetCount("Cells"), 2 * NumberOfCells, what + ": cells of all slabs");
  check.Equal(found.Report->GetCount(count), skipped[0] + skipped[1], what + ": cells skipped");
}

void SetGhost(const TimeSteps& steps, bool points, vtkIdType at, unsigned char flag)
{
  for (const TimeStep& step : steps)
  {
    vtkDataSet* data = GetDataSet(step);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(points ? data->GetNumberOfPoints() : data->GetNumberOfCells());
    ghosts->FillValue(0);
    ghosts->SetValue(at, flag);
    data->GetAttributes(points ? vtkDataObject::POINT : vtkDataObject::CELL)->AddArray(ghosts);
  }
}

void CheckForm(const DataSetVariant& form, Check& check)
{
  check.SetContext(form.Name);
  const char* const blanked = "BlankedCells";
  CheckSkipped(MakeSteps(form), { 0, 0 }, blanked, "nothing", check);
  for (unsigned char flag :
    { vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL })
  {
    const TimeSteps steps = MakeSteps(form);
    SetGhost(steps, false, 21, flag);
    CheckSkipped(steps, { 1, 1 }, blanked, "cell flag", check);
  }
  TimeSteps steps = MakeSteps(form);
  SetGhost(steps, true, InnerPoint, vtkDataSetAttributes::HIDDENPOINT);
  CheckSkipped(steps, { 8, 8 }, blanked, "hidden point", check);
  steps = MakeSteps(form);
  SetGhost(steps, true, InnerPoint, vtkDataSetAttributes::DUPLICATEPOINT);
  CheckSkipped(steps, { 0, 0 }, blanked, "duplicate point", check);
  // Only one step has a hidden cell, a hidden point or a non-finite value.
  steps = MakeSteps(form);
  SetGhost({ steps[0] }, false, 21, vtkDataSetAttributes::HIDDENCELL);
  CheckSkipped(steps, { 1, 0 }, blanked, "hidden at the first step", check);
  steps = MakeSteps(form);
  SetGhost({ steps[1] }, true, InnerPoint, vtkDataSetAttributes::HIDDENPOINT);
  CheckSkipped(steps, { 8, 8 }, blanked, "hidden point at the second of three steps", check);
  const std::array<int, 2> skipped[] = { { 8, 0 }, { 8, 8 }, { 0, 8 } };
  for (double value : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    for (int at = 0; at < 3; ++at)
    {
      steps = MakeSteps(form);
      GetDataSet(steps[at])->GetPointData()->GetScalars()->SetComponent(InnerPoint, 0, value);
      CheckSkipped(steps, skipped[at], "NonFiniteCells",
        std::to_string(value) + " at step " + std::to_string(at), check);
    }
  }
}

}

int TestTimeVaryingBlanking(int, char*[])
{
  Check check;
  for (const DataSetVariant& form : FormsOf(MakeImage({ 4, 4, 4 })))
  {
    CheckForm(form, check);
  }
  return check.Result();
}
