// SPDX-License-Identifier: BSD-3-Clause
#include "Meshers/Meshers.h"

#include "Common/Vectors.h"
#include "Refinement/MeshRefinement.h"
#include "Surfaces/ClosedSurface.h"
#include "Surfaces/SurfaceContacts.h"
#include "Surfaces/SurfaceCrossings.h"
#include "Surfaces/SurfaceRegions.h"
#include "TetGen/MeshingJob.h"

#include <algorithm>
#include <limits>

namespace interlume
{

namespace
{
/// Projects \a x onto the plane of a triangle. Returns the triangle's points and the barycentric
/// coordinates of \a x. At least one coordinate is negative if \a x is outside the triangle.
PointSources InterpolateInTriangle(const ClosedSurface& surface, int triangle, const double* x)
{
  using namespace Vectors;
  const std::array<int, 3>& corners =
    surface.InputTriangles[surface.Triangles[triangle].Origin].Points;
  const double* a = surface.GetPoint(corners[0]);
  const double* b = surface.GetPoint(corners[1]);
  const double* c = surface.GetPoint(corners[2]);
  const glm::dvec3 normal = surface.GetNormal(corners);
  const double area = glm::dot(normal, normal);
  const double beta = glm::dot(normal, glm::cross(Difference(x, a), Difference(c, a))) / area;
  const double gamma = glm::dot(normal, glm::cross(Difference(b, a), Difference(x, a))) / area;
  PointSources point;
  point.NumberOfSources = 3;
  for (int i = 0; i < 3; ++i)
  {
    point.Sources[i] = surface.Points.SourceIds[corners[i]];
  }
  point.Weights = { { 1.0 - beta - gamma, beta, gamma, 0.0 } };
  return point;
}

/// Returns the points and barycentric coordinates for interpolating at \a x. \a triangles are those
/// of a patch; the one that contains \a x is used.
PointSources InterpolateInPatch(
  const ClosedSurface& surface, const std::vector<int>& triangles, const double* x)
{
  PointSources best;
  double bestWeight = -std::numeric_limits<double>::infinity();
  for (int triangle : triangles)
  {
    const PointSources point = InterpolateInTriangle(surface, triangle, x);
    const double smallest = *std::min_element(point.Weights.begin(), point.Weights.begin() + 3);
    if (smallest > bestWeight)
    {
      best = point;
      bestWeight = smallest;
    }
  }
  return best;
}

/// Returns an error if a patch has no triangles in the solution.
Error CheckPatches(const ClosedSurface& surface, const TetGenSolution& solution)
{
  std::vector<bool> isFound(surface.NumberOfPatches, false);
  for (int marker : solution.Markers)
  {
    if (marker > 0 && marker <= surface.NumberOfPatches)
    {
      isFound[marker - 1] = true;
    }
  }
  for (const ClosedSurface::Triangle& triangle : surface.Triangles)
  {
    if (!isFound[triangle.Patch])
    {
      return Error("TetGen failed: the mesh does not contain cell " +
          std::to_string(triangle.Cell) + " of the surface.",
        ErrorCode::Process);
    }
  }
  return {};
}

/// If input cells intersect, returns an error that names them.
Error CheckCrossings(const ClosedSurface& surface)
{
  constexpr std::size_t maximumListed = 8;
  const std::vector<vtkIdType> cells = SurfaceCrossings::FindCells(surface);
  if (cells.empty())
  {
    return {};
  }
  std::string message =
    "The surface intersects itself: " + std::to_string(cells.size()) + " cells intersect others:";
  for (std::size_t i = 0; i < std::min(maximumListed, cells.size()); ++i)
  {
    message += " " + std::to_string(cells[i]);
  }
  return message + (cells.size() > maximumListed ? ", ..." : ".") +
    " Move the parts apart, remove these cells and close the holes, or join the parts, for example "
    "with vtkBooleanOperationPolyDataFilter.";
}

Error Fill(MeshingJob& job, const TetGenProblem& problem, TetGenSolution& solution)
{
  return job.IsRefining() ? MeshRefinement::Execute(job, problem, solution)
                          : job.Solve(problem, solution);
}

/// Returns a sentence that names two cells that nearly touch, or an empty string.
std::string NameNearCells(ClosedSurface& surface)
{
  constexpr double near = 1e-6;
  SurfaceContacts contacts(surface, near);
  return contacts.Find() ? ". Cells " + std::to_string(contacts.GetFirstCells()[0]) + " and " +
      std::to_string(contacts.GetFirstCells()[1]) +
      " nearly touch without common points: join them, or move them apart"
                         : std::string();
}

void SetMesh(const ClosedSurface& surface, const TetGenSolution& solution, MeshingJob& job)
{
  interlume::Tetrahedra& mesh = job.Mesh;
  mesh.Points = solution.Points;
  mesh.Origins.resize(solution.GetNumberOfPoints());
  const int given = static_cast<int>(surface.Points.SourceIds.size());
  for (int p = 0; p < given; ++p)
  {
    mesh.Origins[p].NumberOfSources = 1;
    mesh.Origins[p].Sources[0] = surface.Points.SourceIds[p];
  }
  std::vector<std::vector<int>> triangles(surface.NumberOfPatches);
  std::vector<int> layers(surface.NumberOfPatches, 1);
  std::vector<vtkIdType> firstCells(surface.NumberOfPatches, std::numeric_limits<vtkIdType>::max());
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const ClosedSurface::Triangle& triangle = surface.Triangles[t];
    triangles[triangle.Patch].push_back(static_cast<int>(t));
    layers[triangle.Patch] = triangle.Layers;
    firstCells[triangle.Patch] = std::min(firstCells[triangle.Patch], triangle.Cell);
  }
  // Where patches meet, each of them gives the same values, so any of them can be used.
  std::vector<int> patches(solution.GetNumberOfPoints(), std::numeric_limits<int>::max());
  for (std::size_t i = 0; i < solution.Triangles.size(); ++i)
  {
    int& patch = patches[solution.Triangles[i]];
    patch = std::min(patch, solution.Markers[i / 3] - 1);
  }
  for (int p = given; p < solution.GetNumberOfPoints(); ++p)
  {
    if (patches[p] >= 0 && patches[p] < surface.NumberOfPatches)
    {
      mesh.Origins[p] = InterpolateInPatch(surface, triangles[patches[p]], &solution.Points[3 * p]);
    }
  }
  const SurfaceRegions regions(solution, firstCells, layers, job.FillNestedShells);
  for (int t = 0; t < solution.GetNumberOfTetrahedra(); ++t)
  {
    const int region = regions(t);
    if (region >= 0)
    {
      mesh.Tetrahedra.insert(
        mesh.Tetrahedra.end(), &solution.Tetrahedra[4 * t], &solution.Tetrahedra[4 * t] + 4);
      mesh.Regions.push_back(region);
    }
  }
  job.Report.Regions = regions.GetNumberOfRegions();
  mesh.RemoveUnusedPoints();
}
}

Error Meshers::MeshSurface(MeshingJob& job)
{
  ClosedSurface surface;
  Error error = surface.Take(job.Input, job.SplitContacts);
  job.Report.SurfaceTriangles = static_cast<vtkIdType>(surface.Triangles.size());
  job.SetUnit(surface.Points.UnitExponent);
  job.Report.SplitTriangles = surface.NumberOfSplitTriangles;
  job.Report.MergedPoints = surface.Points.NumberOfMerged;
  for (vtkIdType cell : surface.FoldedCells)
  {
    job.Report.AddFoldedFace(cell);
  }
  error = error.Then([&] { return CheckCrossings(surface); });
  if (error || job.IsCanceled())
  {
    return error;
  }
  job.SetProgress(0.1);
  TetGenSolution solution;
  error = Fill(job, surface.MakeProblem(job.PreserveBoundary), solution);
  if (error && !job.IsCanceled() && !job.TetGen.HasTimedOut() && !job.PreserveBoundary)
  {
    // TetGen 1.5 can fail on facets that are planar up to rounding error. Retry with one facet per
    // triangle and another point order, which succeeds on such surfaces.
    TetGenProblem problem = surface.MakeProblem(false);
    problem.Switches = "pMb10JnQ";
    error = Fill(job, problem, solution);
  }
  if (error)
  {
    return error.Within("", NameNearCells(surface));
  }
  if (job.IsCanceled())
  {
    return {};
  }
  error = CheckPatches(surface, solution);
  if (!error)
  {
    SetMesh(surface, solution, job);
  }
  return error;
}

}
