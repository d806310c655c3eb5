// SPDX-License-Identifier: BSD-3-Clause
// Output is bit-identical for any number of threads, for slices between the time levels of a grid
// and at a time level.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkUnstructuredGrid.h"

int TestSimplexTimeSliceThreads(int, char*[])
{
  using namespace reference;
  Check check;
  KuhnOptions options;
  options.Cells = { { 16, 12, 12, 2 } };
  options.IsRetained = [](const std::array<int, 4>& cell)
  { return (cell[0] + cell[1] * cell[2] + cell[3]) % 3 != 0; };
  auto grid = MakeKuhnGrid(options);
  CheckThreads(
    "simplices",
    [&grid]
    {
      return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ SliceAt(grid, 0.3),
        SliceAt(grid, 1.0) };
    },
    check);
  return check.Result();
}
