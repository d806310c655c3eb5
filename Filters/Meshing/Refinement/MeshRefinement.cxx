// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement/MeshRefinement.h"

#include "Mesh/MeshMeasures.h"
#include "Refinement/VolumeBisection.h"
#include "TetGen/MeshingJob.h"

#include <array>

namespace interlume
{

namespace
{
/// The bound on the shape that TetGen reaches most surely.
constexpr double SureQualityBound = 2.0;
/// A pass whose smallest tetrahedron is this much smaller than before, or this flat, is no gain.
constexpr double LeastVolumeRatio = 1e-6;
constexpr double LeastShape = 1e-6;
constexpr int MostPasses = 12;
/// The number of passes in a row that may fail to come nearer to the bounds: some then go on.
constexpr int MostStalls = 2;
/// TetGen 1.6 ends with some tetrahedra just beyond a bound. Where none is further beyond than
/// this, a pass that failed is followed by one with bounds that are tighter by these parts more.
constexpr double NearlyHeld = 1.5;
constexpr double TighterQuality = 0.02;
constexpr double TighterVolume = 0.1;
/// The factor by which passes may multiply the points of a mesh that nearly holds the volume bound:
/// more is the sign of a refinement without end.
constexpr int MostGrowth = 4;
/// The factors of weaker bounds, for large tetrahedra next to angles at which the bound that was
/// set has no end.
constexpr std::array<double, 2> WeakerBounds{ { 4.0, 16.0 } };

MeshMeasures Measure(const MeshingJob& job, const TetGenSolution& mesh)
{
  MeshMeasures measures;
  measures.QualityBound = job.QualityBound;
  measures.MaximumVolume = job.MaximumVolume;
  measures.Add(mesh.Points, mesh.Tetrahedra);
  return measures;
}

bool IsNearlyHeld(const MeshMeasures& measures)
{
  return (measures.QualityBound <= 0.0 ||
           measures.LargestRadiusEdgeRatio <= NearlyHeld * measures.QualityBound) &&
    (measures.MaximumVolume <= 0.0 ||
      measures.LargestVolume <= NearlyHeld * measures.MaximumVolume);
}

/// Returns whether no tetrahedron is tiny or flat beside those of the first mesh and the bounds.
bool IsSound(const MeshMeasures& now, const MeshMeasures& first)
{
  const double size = now.MaximumVolume > 0.0 ? std::min(first.SmallestVolume, now.MaximumVolume)
                                              : first.SmallestVolume;
  return now.LeastShape > std::min(LeastShape, first.LeastShape) &&
    now.SmallestVolume > LeastVolumeRatio * size;
}

/// Solves \a problem with all bounds, or if TetGen fails, with a bound on the shape that it reaches
/// more surely. If both fail and there is a \a mesh already, keeps it.
Error SolveWithin(MeshingJob& job, const TetGenProblem& problem, TetGenSolution& mesh)
{
  const double quality = job.QualityBound > 0.0 ? job.QualityBound : SureQualityBound;
  Error error;
  for (bool isWeaker : { false, true })
  {
    TetGenProblem bounded = problem;
    bounded.Switches +=
      job.GetRefinementSwitches(isWeaker ? std::max(quality, SureQualityBound) : quality,
        isWeaker ? 0.0 : job.MaximumVolume, job.MaximumNumberOfAddedPoints);
    TetGenSolution solution;
    error = job.Solve(bounded, solution);
    if (job.IsCancelled() || job.TetGen.IsLate())
    {
      return error;
    }
    if (!error)
    {
      mesh = std::move(solution);
      return error;
    }
  }
  return mesh.Tetrahedra.empty() ? error : Error();
}

/// Refines \a mesh until the bounds hold or it has \a most points.
Error RunPasses(MeshingJob& job, int most, TetGenSolution& mesh)
{
  const MeshMeasures first = Measure(job, mesh);
  MeshMeasures best = first;
  if (first.LargestVolume <= NearlyHeld * job.MaximumVolume || job.MaximumVolume <= 0.0)
  {
    most = MostGrowth * std::min(most / MostGrowth, mesh.GetNumberOfPoints());
  }
  TetGenSolution current = mesh;
  double quality = job.QualityBound;
  std::size_t weaker = 0;
  int stalls = 0;
  for (int pass = 0; pass < MostPasses && best.Excess > 0.0 && current.GetNumberOfPoints() < most;
       ++pass)
  {
    const int tighter = IsNearlyHeld(best) ? stalls : 0;
    TetGenProblem problem;
    // In a mesh that it refines, TetGen counts every point.
    problem.Switches = std::string("rMJnQ") + (job.PreserveBoundary ? "Y" : "") +
      job.GetRefinementSwitches(quality / (1.0 + TighterQuality * tighter),
        job.MaximumVolume / (1.0 + TighterVolume * tighter), most);
    problem.Points = current.Points;
    problem.Tetrahedra = current.Tetrahedra;
    problem.Triangles = current.Triangles;
    problem.Markers = current.Markers;
    TetGenSolution refined;
    const Error error = job.Solve(problem, refined);
    // A limit of time is not to decide about the result: it is an error.
    if (job.IsCancelled() || job.TetGen.IsLate())
    {
      return error;
    }
    // Where TetGen fails otherwise, the mesh before is good.
    const bool isSolved = !error;
    const MeshMeasures measures = isSolved ? Measure(job, refined) : first;
    const bool isSound = isSolved && IsSound(measures, first);
    const bool isBetter = isSound && measures.Excess < best.Excess;
    stalls = isBetter ? 0 : stalls + 1;
    if (isBetter)
    {
      mesh = refined;
      best = measures;
    }
    if (isSound && stalls <= MostStalls)
    {
      current = std::move(refined);
    }
    else if (best.AboveMaximumVolume > 0 && weaker < WeakerBounds.size())
    {
      current = mesh;
      quality = std::max(quality, WeakerBounds[weaker++]);
      stalls = 0;
    }
    else
    {
      break;
    }
  }
  return {};
}
}

Error MeshRefinement::Execute(MeshingJob& job, const TetGenProblem& problem, TetGenSolution& mesh)
{
  Error error = SolveWithin(job, problem, mesh);
  if (error || job.IsCancelled())
  {
    return error;
  }
  job.SetProgress(0.3);
  const int most = static_cast<int>(problem.Points.size() / 3) + job.MaximumNumberOfAddedPoints;
  error = RunPasses(job, most, mesh);
  if (!error && !job.IsCancelled() && job.MaximumVolume > 0.0)
  {
    VolumeBisection(job, mesh).Execute(most);
  }
  return error;
}

}
