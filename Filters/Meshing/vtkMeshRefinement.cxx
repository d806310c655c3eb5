#include "vtkMeshRefinement.h"

#include "vtkMeshMeasures.h"
#include "vtkMeshingJob.h"

#include <array>

namespace
{
/// A pass whose smallest tetrahedron is this much smaller than before, or this flat, is no gain.
constexpr double LeastVolumeRatio = 1e-6;
constexpr double LeastShape = 1e-6;
constexpr int MostPasses = 10;
/// Weaker bounds, for large tetrahedra next to angles at which the bound that was set has no end.
constexpr std::array<double, 2> WeakerBounds{ { 4.0, 16.0 } };

vtkMeshMeasures Measure(const vtkMeshingJob& job, const vtkTetGenSolution& mesh)
{
  vtkMeshMeasures measures;
  measures.QualityBound = job.QualityBound;
  measures.MaximumVolume = job.MaximumVolume;
  measures.Add(mesh.Points, mesh.Tetrahedra);
  return measures;
}

bool IsBetter(const vtkMeshMeasures& now, const vtkMeshMeasures& before)
{
  return now.ExceedingVolume < before.ExceedingVolume &&
    now.LeastShape > std::min(LeastShape, before.LeastShape) &&
    now.SmallestVolume > LeastVolumeRatio * before.SmallestVolume;
}
}

bool vtkMeshRefinement::Execute(vtkMeshingJob& job, vtkTetGenSolution& mesh)
{
  const int given = mesh.GetNumberOfPoints();
  vtkMeshMeasures best = Measure(job, mesh);
  double quality = job.QualityBound;
  std::size_t weaker = 0;
  for (int pass = 0; pass < MostPasses && best.ExceedingVolume > 0.0; ++pass)
  {
    const int left = job.MaximumNumberOfAddedPoints - (mesh.GetNumberOfPoints() - given);
    if (left <= 0)
    {
      return true;
    }
    vtkTetGenProblem problem;
    problem.Switches = std::string("rMJnQ") + (job.PreserveBoundary ? "Y" : "") +
      job.GetRefinementSwitches(quality, job.MaximumVolume, left);
    problem.Points = mesh.Points;
    problem.Tetrahedra = mesh.Tetrahedra;
    problem.Triangles = mesh.Triangles;
    problem.Markers = mesh.Markers;
    vtkTetGenSolution refined;
    const bool isSolved = job.Solve(problem, refined);
    // A limit of time is not to decide about the result: it is an error.
    if (job.IsCancelled() || job.TetGen.IsLate())
    {
      return false;
    }
    // Where TetGen fails otherwise, the mesh before is good.
    job.Error.clear();
    const vtkMeshMeasures measures = isSolved ? Measure(job, refined) : best;
    if (IsBetter(measures, best))
    {
      mesh = std::move(refined);
      best = measures;
    }
    else if (best.AboveMaximumVolume > 0 && weaker < WeakerBounds.size())
    {
      quality = std::max(quality, WeakerBounds[weaker++]);
    }
    else
    {
      return true;
    }
  }
  return true;
}
