// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowConservation.h"
#include "Benchmarks/Flow/FlowExplicit.h"
#include "Benchmarks/Flow/FlowSpeed.h"
#include "Benchmarks/Flow/FlowTolerances.h"
#include "Benchmarks/Flow/FlowVolumeSpeed.h"
#include "Benchmarks/Suites/BenchSuites.h"

#include <utility>

namespace
{
class SuiteFlow : public BenchSuite
{
public:
  std::string GetName() const override { return "flow"; }
  std::string GetTitle() const override
  {
    return "vtkImplicitFlowField, vtkFlowVolume: run time, error against run time";
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
      "of the ends from the streamlines of that field, by Boost's runge_kutta_fehlberg78: on "
      "images "
      "in steps that end at the faces of cells, good to 1e-12; else in steps of at most a tenth of "
      "a cell through VTK's interpolation, good to some 1e-8. time_error is the mean error of the "
      "time at the end: vtkStreamTracer keeps time to "
      "first order only.",
      "equal-error: the default of vtkImplicitFlowField against the first setting of "
      "streamtracer, the step halved or MaximumError divided by ten each time, whose error is at "
      "most twice as large, or below 3e-8, to which its points in single precision are rounded. "
      "steps_per_second_ratio compares steps a second of processor time at those settings, "
      "without what one streamline takes with all that is made of the field first, setup_seconds; "
      "the ratio of times is that of samples a second. equal-error-again: the same filter executed "
      "again on the same grid, of which it has kept which faces meet, kept_faces. threads-2: two "
      "threads against one.",
      "uniform, rotation, saddle, spiral, stiff: linear fields, which interpolation keeps, so that "
      "streamlines are known by formulas; source-sink, sphere, abc: with the reference above. The "
      "parameter is MaximumError over the largest speed; in stiff fields, saddles of that ratio of "
      "eigenvalues that damp backward, MaximumError. within: the share of the answers that are no "
      "further than 10 MaximumError times their time from where the field carries the sample in "
      "that time. RK4 and RK45 as above.",
      "hurricane: advection of as many samples, at most 10 units of time; new stream volumes when "
      "the inflow mapping, the interval alone, or the range of times alone changes, against that "
      "advection. advections: how often it was done again.",
      "conservation: stream volumes from a disc in fields without divergence, the flux through "
      "five time surfaces against that through the disc.",
      "contraction, beside, around: the stream volume of a disc where it is known by formulas, "
      "Zhang's table 4.1 measured. explicit: a patch of triangles carried along by vtkRungeKutta4, "
      "in the manner of Max, Becker and Crawfis (1993), the parameter being its rings; "
      "explicit-halved: with edges halved where streamlines part. implicit: vtkImplicitFlowField, "
      "vtkInflowMapping and vtkFlowVolume, the parameter being samples a side; implicit-again: the "
      "same after a change of the mapping; implicit-refined: with two levels of refinement. The "
      "error is the volume of tetrahedra whose middle is "
      "outside, and the volume missing, over the tube's; boundary_distance the distance of the "
      "tube's sides, root mean square.",
    };
  }

  void Run(const BenchOptions& options, BenchRows& rows) const override
  {
    flow::AddSpeedRows(options, rows);
    flow::AddToleranceRows(options, rows);
    flow::AddVolumeRows(options, rows);
    flow::AddConservationRows(options, rows);
    flow::AddExplicitRows(options, rows);
  }

  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override
  {
    std::vector<BenchClaim> claims = flow::CheckSpeedClaims(rows);
    for (const auto& check :
      { flow::CheckToleranceClaims, flow::CheckVolumeClaims, flow::CheckConservationClaims })
    {
      for (BenchClaim& claim : check(rows))
      {
        claims.push_back(std::move(claim));
      }
    }
    return claims;
  }

  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const override
  {
    std::vector<BenchPlot> plots = flow::MakeSpeedPlots(rows);
    for (const auto& make : { flow::MakeTolerancePlots, flow::MakeExplicitPlots })
    {
      for (BenchPlot& plot : make(rows))
      {
        plots.push_back(std::move(plot));
      }
    }
    return plots;
  }
};
}

std::unique_ptr<BenchSuite> MakeFlowSuite()
{
  return std::make_unique<SuiteFlow>();
}
