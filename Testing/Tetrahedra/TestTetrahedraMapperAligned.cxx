// SPDX-License-Identifier: BSD-3-Clause
// Tests both render paths on data seen along the axes, where faces are edge-on and projected points
// coincide. TestTetrahedraMapperAlignedData uses every file, and other parts of these files.
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
    CompareRenderPathsAlongAxes(data.Make({ { 160, 160 } }), data.GetName(), check);
  }
  return check.Result();
}
