// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Scattering/ScatteringParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeScatteringSuite()
{
  return { "scattering", "Scattered light: error of its modes against run time",
    { "Frames of vtkShadowedSliceMapper, off-screen, until OpenGL says they are done, in which the "
      "light and the camera have moved by half a degree, so that scattered light is found anew.",
      "slab: slabs of matter in parallel light, drawn from five directions on either side and "
      "integrated over them, against the reflection and transmission that H. C. van de Hulst, "
      "\"Multiple Light Scattering\", 1980, prints. The parameter is the number of cells of the "
      "grid through the slab.",
      "limits: the same for full, over phase functions, albedos and depths, against the paths of "
      "our own Monte Carlo solver, in light at right angles.",
      "cloud: a cumulus of an optical depth of about 25, Henyey and Greenstein's g = 0.85, albedo "
      "1, against the paths of our own Monte Carlo solver. equal-error: full with its defaults, "
      "and the time that this solver takes until its noise is as large as that error.",
      "cloud, the view turns: frames in which the light stays, so that what it has scattered is "
      "kept." },
    { scattering::MakeSlabPart(), scattering::MakeCloudPart() } };
}
