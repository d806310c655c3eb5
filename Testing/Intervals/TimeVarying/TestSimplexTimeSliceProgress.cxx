// SPDX-License-Identifier: BSD-3-Clause
// Progress is reported and never decreases, an abort leaves a valid output, and PrintSelf prints
// the time.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkUnstructuredGrid.h"

int TestSimplexTimeSliceProgress(int, char*[])
{
  using namespace reference;
  Check check;
  KuhnOptions options;
  options.Cells = { { 8, 8, 8, 2 } };
  auto grid = MakeKuhnGrid(options);
  for (const double t : { 0.3, 0.0 })
  {
    check.SetContext("t = " + std::to_string(t));
    vtkNew<vtkSimplexTimeSlice> filter;
    filter->SetTime(t);
    CheckProgress(filter, grid, VTK_TETRA, check);
  }
  check.SetContext("print");
  vtkNew<vtkSimplexTimeSlice> filter;
  check.That(filter->GetTime() == 0.0, "the default time is 0");
  filter->SetTime(3.125);
  CheckPrinted(Print(filter), { "Time: 3.125" }, check);
  return check.Result();
}
