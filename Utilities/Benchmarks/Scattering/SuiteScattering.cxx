// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Scattering/ScatteringClouds.h"
#include "Benchmarks/Scattering/ScatteringModes.h"
#include "Benchmarks/Scattering/ScatteringSlabs.h"
#include "Benchmarks/Suites/BenchSuites.h"

namespace
{
class SuiteScattering : public BenchSuite
{
public:
  std::string GetName() const override { return "scattering"; }
  std::string GetTitle() const override
  {
    return "Scattered light: error of its modes against run time";
  }

  std::vector<std::string> GetDescription() const override
  {
    return {
      "Frames of vtkShadowedSliceMapper, off-screen, until OpenGL says they are done, in which the "
      "light and the camera have moved by half a degree, so that scattered light is found anew.",
      "slab: slabs of matter in parallel light, drawn from five directions on either side and "
      "integrated over them, against the reflection and transmission that H. C. van de Hulst, "
      "\"Multiple Light Scattering\", 1980, prints. The parameter is the number of cells of the "
      "grid through the slab.",
      "limits: the same for full, over phase functions, albedos and depths, against the paths of "
      "our "
      "own Monte Carlo solver, in light at right angles.",
      "cloud: a cumulus of an optical depth of about 25, Henyey and Greenstein's g = 0.85, albedo "
      "1, "
      "against the paths of our own Monte Carlo solver. equal-error: full with its defaults, and "
      "the "
      "time that this solver takes until its noise is as large as that error.",
      "cloud, the view turns: frames in which the light stays, so that what it has scattered is "
      "kept."
    };
  }

  void Run(const BenchOptions& options, BenchRows& rows) const override
  {
    scattering::AddSlabRows(options, rows);
    scattering::AddLimitRows(options, rows);
    scattering::AddCloudRows(options, rows);
    scattering::AddViewRows(options, rows);
  }

  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override
  {
    return { BenchClaim::AtMost("full at most 2 times the time of shadows alone", 2.0, rows,
               CountOf(scattering::Full, "over_shadowed")),
      BenchClaim::AtMost(
        "full at most 1.25 times the time of shadows alone while only the view turns", 1.25, rows,
        CountOf(scattering::Full, "view_over_shadowed")) };
  }

  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const override
  {
    return scattering::MakeCloudPlots(rows);
  }
};
}

std::unique_ptr<BenchSuite> MakeScatteringSuite()
{
  return std::make_unique<SuiteScattering>();
}
