// SPDX-License-Identifier: BSD-3-Clause
// Real tetrahedra seen along the axes, where faces are seen edge-on and points coincide: no pixel
// of either render path is off. TestTetrahedraMapperAlignedData does so with every file.
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/DataTetrahedra.h"
#include "Tetrahedra/PathComparison.h"

int TestTetrahedraMapperAligned(int, char*[])
{
  using namespace reference;
  Check check;
  const DataTetrahedra cases[] = {
    { "disk_out_ref.vtu", "AsH3", 0.1327, 0.1848 },
    { "disk_out_ref.vtu", "Temp", 600.0, 913.0 },
    { "mug.ex2", "convected", 0.3, 0.6 },
    { "hydrogen_orbital.vti", "probability_density", 0.6, 0.9 },
    { "bluntfin.vts", "Density", 2.0, 5.0 },
    { "post_tets.vtk", "Pressure" },
  };
  for (const DataTetrahedra& data : cases)
  {
    ComparePathsAlongAxes(data.Make({ { 160, 160 } }), data.GetName(), check);
  }
  return check.Result();
}
