// SPDX-License-Identifier: BSD-3-Clause
#include "Meshers/Meshers.h"

#include "Common/Vectors.h"
#include "Mesh/DistinctPoints.h"
#include "Refinement/MeshRefinement.h"
#include "Refinement/TetrahedronWalk.h"
#include "Surfaces/ClosedSurface.h"
#include "TetGen/MeshingJob.h"

#include "vtkDataSet.h"

namespace interlume
{

namespace
{
/// Returns whether all points lie exactly in one plane.
bool IsFlat(const std::vector<double>& x)
{
  using namespace Vectors;
  // Find three points that are not collinear, then look for a point outside their plane.
  const double* a = x.data();
  std::size_t p = 6;
  glm::dvec3 normal{ 0.0, 0.0, 0.0 };
  for (; p < x.size() && glm::dot(normal, normal) == 0.0; p += 3)
  {
    normal = glm::cross(Difference(&x[3], a), Difference(&x[p], a));
  }
  for (; p < x.size(); p += 3)
  {
    if (glm::dot(normal, Difference(&x[p], a)) != 0.0)
    {
      return false;
    }
  }
  return true;
}

/// Returns a TetGen problem with the points and the facets of their convex hull. \a coarse contains
/// the Delaunay tetrahedra of the points.
TetGenProblem MakeHull(
  const MeshingJob& job, const DistinctPoints& points, const TetGenSolution& coarse)
{
  std::vector<int> triangles;
  for (std::size_t i = 0; i < coarse.Neighbors.size(); ++i)
  {
    for (std::size_t k = 1; coarse.Neighbors[i] < 0 && k < 4; ++k)
    {
      triangles.push_back(coarse.Tetrahedra[i - i % 4 + (i + k) % 4]);
    }
  }
  return ClosedSurface(points, triangles).MakeProblem(job.PreserveBoundary);
}

void SetMesh(const TetGenSolution& solution, const TetGenSolution& coarse,
  const std::vector<vtkIdType>& sourceIds, interlume::Tetrahedra& mesh)
{
  mesh.Points = solution.Points;
  mesh.Origins.resize(solution.GetNumberOfPoints());
  TetrahedronWalk walk(coarse);
  for (std::size_t p = 0; p < mesh.Origins.size(); ++p)
  {
    PointSources& origin = mesh.Origins[p];
    if (p < sourceIds.size())
    {
      origin.NumberOfSources = 1;
      origin.Sources[0] = sourceIds[p];
      continue;
    }
    const int tetrahedron = walk.Find(&mesh.Points[3 * p], origin.Weights);
    origin.NumberOfSources = 4;
    for (int i = 0; i < 4; ++i)
    {
      origin.Sources[i] = sourceIds[coarse.Tetrahedra[4 * tetrahedron + i]];
    }
  }
  mesh.Tetrahedra.assign(solution.Tetrahedra.begin(), solution.Tetrahedra.end());
  mesh.RemoveUnusedPoints();
}
}

Error Meshers::MeshPoints(MeshingJob& job)
{
  DistinctPoints points;
  Error error = points.Take(job.Input, std::vector<bool>(job.Input->GetNumberOfPoints(), true));
  job.SetUnit(points.UnitExponent);
  job.Report.MergedPoints = points.NumberOfMerged;
  if (error || job.IsCanceled())
  {
    return error;
  }
  if (points.SourceIds.size() < 4 || IsFlat(points.Coordinates))
  {
    return "The " + std::to_string(points.SourceIds.size()) +
      " distinct points lie in a plane, so they form no tetrahedron.";
  }
  job.SetProgress(0.1);
  TetGenProblem problem;
  problem.Switches = "MJnQ";
  problem.Points = points.Coordinates;
  TetGenSolution coarse;
  error = job.Solve(problem, coarse);
  TetGenSolution refined = coarse;
  if (!error && !job.IsCanceled() && job.IsRefining())
  {
    error = MeshRefinement::Execute(job, MakeHull(job, points, coarse), refined);
  }
  if (!error && !job.IsCanceled())
  {
    SetMesh(refined, coarse, points.SourceIds, job.Mesh);
  }
  return error;
}

}
