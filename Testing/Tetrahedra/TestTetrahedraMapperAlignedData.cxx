// SPDX-License-Identifier: BSD-3-Clause
// Tests every file in Data/ seen along the axes, as full grids and interval volumes. Some grids of
// these files are in TestTetrahedraMapperAligned, which has a lower bound.
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/DataTetrahedra.h"
#include "Tetrahedra/PathComparison.h"

int TestTetrahedraMapperAlignedData(int, char*[])
{
  using namespace reference;
  Check check;
  const DataTetrahedra cases[] = {
    { "disk_out_ref.vtu", "Temp" },
    { "mug.ex2", "convected" },
    { "mug.ex2", "diffused", 0.2, 0.8 },
    { "bluntfin.vts", "Density" },
    { "post.vts", "Pressure", 3.4, 4.4 },
    { "post_tets.vtk", "Pressure", 0.5, 0.9 },
    { "bonsai.vti", "ImageFile", 235.0, 255.0 },
    { "brainsmall.vti", "density", 121.0, 182.0 },
    { "headsq_quarter.vti", "density", 2400.0, 3600.0 },
    { "hydrogen_orbital.vti", "probability_density", 0.3, 0.6 },
    { "ironProt.vtk", "scalars", 230.0, 255.0 },
    { "isabel_pressure_sub100.vti", "pressure", -4600.0, -3600.0 },
    { "neghip.vti", "SLCImage", 230.0, 255.0 },
    { "tooth.vti", "density", 247.0, 255.0 },
  };
  for (const DataTetrahedra& data : cases)
  {
    // More pixels may differ: a plane of voxels that is seen edge-on can pass through the centers
    // of a whole column of pixels.
    CompareRenderPathsAlongAxes(data.Make({ { 120, 120 } }), data.GetName(), check, 3e-3);
  }
  return check.Result();
}
