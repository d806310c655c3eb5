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
/// Quality bound that TetGen reaches most reliably.
constexpr double ReliableQualityBound = 2.0;
/// A pass is rejected if its smallest volume is below this fraction of the first mesh's smallest
/// volume or, if the volume bound is smaller than that, below this fraction of the bound. It is
/// also rejected if its minimum polar sine is below both MinimumShape and that of the first mesh.
constexpr double MinimumVolumeRatio = 1e-6;
constexpr double MinimumShape = 1e-6;
constexpr int MaximumNumberOfPasses = 12;
/// Maximum number of consecutive passes without improvement. Such a pass does not end the
/// refinement, because a later pass may still improve the mesh.
constexpr int MaximumNumberOfStalls = 2;
/// TetGen 1.6 leaves some tetrahedra slightly above a bound. If no tetrahedron exceeds a bound by
/// more than NearBoundFactor, each pass without improvement is followed by a pass with tighter
/// bounds. TighterQuality and TighterVolume are the fractions by which a bound is tightened.
constexpr double NearBoundFactor = 1.5;
constexpr double TighterQuality = 0.02;
constexpr double TighterVolume = 0.1;
/// Maximum factor by which refinement may multiply the number of points if there is no volume bound
/// or if the first mesh nearly meets it. More points indicate that the refinement would not
/// terminate.
constexpr int MaximumGrowth = 4;
/// Weaker quality bounds. They are used for tetrahedra that remain too large because refinement
/// with the given bound would not terminate next to small angles.
constexpr std::array<double, 2> WeakerBounds{ { 4.0, 16.0 } };

MeshMeasures Measure(const MeshingJob& job, const TetGenSolution& mesh)
{
  MeshMeasures measures;
  measures.QualityBound = job.QualityBound;
  measures.MaximumVolume = job.MaximumVolume;
  measures.Add(mesh.Points, mesh.Tetrahedra);
  return measures;
}

bool IsNearBounds(const MeshMeasures& measures)
{
  return (measures.QualityBound <= 0.0 ||
           measures.LargestRadiusEdgeRatio <= NearBoundFactor * measures.QualityBound) &&
    (measures.MaximumVolume <= 0.0 ||
      measures.LargestVolume <= NearBoundFactor * measures.MaximumVolume);
}

/// Returns false if a tetrahedron is tiny or degenerate compared to the first mesh and the volume
/// bound.
bool IsSound(const MeshMeasures& now, const MeshMeasures& first)
{
  const double size = now.MaximumVolume > 0.0 ? std::min(first.SmallestVolume, now.MaximumVolume)
                                              : first.SmallestVolume;
  return now.MinimumShape > std::min(MinimumShape, first.MinimumShape) &&
    now.SmallestVolume > MinimumVolumeRatio * size;
}

/// Solves \a problem with all bounds. If TetGen fails, retries without a volume bound, and with a
/// quality bound that TetGen reaches more reliably. If both attempts fail, keeps \a mesh, or
/// returns the error if \a mesh is empty.
Error SolveWithin(MeshingJob& job, const TetGenProblem& problem, TetGenSolution& mesh)
{
  const double quality = job.QualityBound > 0.0 ? job.QualityBound : ReliableQualityBound;
  Error error;
  for (bool isWeaker : { false, true })
  {
    TetGenProblem bounded = problem;
    bounded.Switches +=
      job.GetRefinementSwitches(isWeaker ? std::max(quality, ReliableQualityBound) : quality,
        isWeaker ? 0.0 : job.MaximumVolume, job.MaximumNumberOfAddedPoints);
    TetGenSolution solution;
    error = job.Solve(bounded, solution);
    if (job.IsCanceled() || job.TetGen.HasTimedOut())
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

/// Refines \a mesh until the bounds are met or it has \a maximumNumberOfPoints points.
Error RunPasses(MeshingJob& job, int maximumNumberOfPoints, TetGenSolution& mesh)
{
  const MeshMeasures first = Measure(job, mesh);
  MeshMeasures best = first;
  if (first.LargestVolume <= NearBoundFactor * job.MaximumVolume || job.MaximumVolume <= 0.0)
  {
    maximumNumberOfPoints =
      MaximumGrowth * std::min(maximumNumberOfPoints / MaximumGrowth, mesh.GetNumberOfPoints());
  }
  TetGenSolution current = mesh;
  double quality = job.QualityBound;
  std::size_t weaker = 0;
  int stalls = 0;
  for (int pass = 0; pass < MaximumNumberOfPasses && best.Excess > 0.0 &&
       current.GetNumberOfPoints() < maximumNumberOfPoints;
       ++pass)
  {
    const int tighter = IsNearBounds(best) ? stalls : 0;
    TetGenProblem problem;
    // If the input is a mesh, TetGen's limit applies to all points, not only to added points.
    problem.Switches = std::string("rMJnQ") + (job.PreserveBoundary ? "Y" : "") +
      job.GetRefinementSwitches(quality / (1.0 + TighterQuality * tighter),
        job.MaximumVolume / (1.0 + TighterVolume * tighter), maximumNumberOfPoints);
    problem.Points = current.Points;
    problem.Tetrahedra = current.Tetrahedra;
    problem.Triangles = current.Triangles;
    problem.Markers = current.Markers;
    TetGenSolution refined;
    const Error error = job.Solve(problem, refined);
    // Exceeding the time limit is an error: the result must not depend on the speed of the machine.
    if (job.IsCanceled() || job.TetGen.HasTimedOut())
    {
      return error;
    }
    // If TetGen fails for another reason, the previous mesh remains valid.
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
    if (isSound && stalls <= MaximumNumberOfStalls)
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
  if (error || job.IsCanceled())
  {
    return error;
  }
  job.SetProgress(0.3);
  const int maximumNumberOfPoints =
    static_cast<int>(problem.Points.size() / 3) + job.MaximumNumberOfAddedPoints;
  error = RunPasses(job, maximumNumberOfPoints, mesh);
  if (!error && !job.IsCanceled() && job.MaximumVolume > 0.0)
  {
    VolumeBisection(job, mesh).Execute(maximumNumberOfPoints);
  }
  return error;
}

}
