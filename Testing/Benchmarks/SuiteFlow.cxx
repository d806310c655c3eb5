#include "BenchSuites.h"
#include "FlowSpeed.h"
#include "FlowTolerances.h"

#include <utility>

namespace
{
class SuiteFlow : public BenchSuite
{
public:
  std::string GetName() const override { return "flow"; }
  std::string GetTitle() const override
  {
    return "vtkImplicitFlowField: run time, error against run time";
  }

  std::vector<std::string> GetDescription() const override
  {
    return {
      "image, hexahedra, tetrahedra: one period of ABC flow, backward from random seeds to a box "
      "just inside the field, 1 thread; the points of the unstructured grids are moved by up to a "
      "tenth of a cell. streamtracer is vtkStreamTracer without vorticity, with the fastest of its "
      "ways to find cells: the default on images, vtkStaticCellLocator on unstructured grids "
      "(vtkModifiedBSPTree and the default's point locator were slower). RK4: the parameter is the "
      "step in lengths of a cell; RK45: MaximumError, steps up to two cells. Its steps are those "
      "of its output. Both work on the field that VTK interpolates. The error is the mean distance "
      "of the ends from the streamlines of that field, by Boost's runge_kutta_fehlberg78 in steps "
      "of at most a tenth of a cell through VTK's interpolation, which is itself good to some "
      "1e-8. time_error is the mean error of the time at the end: vtkStreamTracer keeps time to "
      "first order only.",
      "equal-error: the default of vtkImplicitFlowField against the first setting of "
      "streamtracer, the step halved or MaximumError divided by ten each time, whose error is at "
      "most twice as large. steps_per_second_ratio compares steps a second at those settings, "
      "without setup_seconds, what one streamline takes with all that is made of the field first; "
      "the ratio of times is that of samples a second. threads-2: two threads against one. "
      "samples: every point of the image to the domain's faces, but at most 20 units of time.",
      "uniform, saddle, spiral, stiff: linear fields, which interpolation keeps, so that the place "
      "after the time found is known by a formula. The parameter is MaximumError, for speeds "
      "near 1. within: the share of the answers whose error is at most 10 MaximumError times their "
      "time. stiff-1e2 ... 1e6: saddles of that ratio of eigenvalues, which damp backward.",
    };
  }

  void Run(const BenchOptions& options, BenchRows& rows) const override
  {
    flow::AddSpeedRows(options, rows);
    flow::AddToleranceRows(options, rows);
  }

  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override
  {
    std::vector<BenchClaim> claims = flow::CheckSpeedClaims(rows);
    for (BenchClaim& claim : flow::CheckToleranceClaims(rows))
    {
      claims.push_back(std::move(claim));
    }
    return claims;
  }

  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const override
  {
    std::vector<BenchPlot> plots = flow::MakeSpeedPlots(rows);
    for (BenchPlot& plot : flow::MakeTolerancePlots(rows))
    {
      plots.push_back(std::move(plot));
    }
    return plots;
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<BenchSuite> MakeFlowSuite()
{
  return std::make_unique<SuiteFlow>();
}
