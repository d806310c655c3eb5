// SPDX-License-Identifier: BSD-3-Clause
// Output is bit-identical for 1, 2 and 8 threads and every backend.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataSet.h"
#include "vtkUnstructuredGrid.h"

int TestTimeVaryingThreads(int, char*[])
{
  using namespace reference;
  Check check;
  for (const NamedGrid& grid : MakeAllGridTypes({ 3, 4, 3 }, 2))
  {
    const TimeSteps steps = RepeatGrid(grid.Data, { 0, 0.7, 1.9 });
    AddRandomTimeField(steps, 6, "g");
    AddRandomTimeField(steps, 5);
    CheckThreads(
      grid.Name,
      [&]
      {
        const TimeVaryingExtraction found =
          ExtractTimeVarying(steps, { { { 0.2, 0.4 }, { 0.4, 0.7 } } });
        return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ found.Tetrahedra,
          found.Boundaries, found.Simplices };
      },
      check);
  }
  return check.Result();
}
