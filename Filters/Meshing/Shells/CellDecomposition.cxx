// SPDX-License-Identifier: BSD-3-Clause
#include "Shells/CellDecomposition.h"

#include "Common/Vectors.h"
#include "Mesh/TetrahedronMath.h"
#include "Shells/CellShell.h"
#include "TetGen/MeshingJob.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
using TetrahedronMath::PolarSine;
using Vectors::Difference;

/// Polar sines below which a tetrahedron is degenerate or nearly degenerate.
constexpr double DegenerateShape = 1e-12;
constexpr double NearlyDegenerateShape = 1e-8;
/// Maximum number of steps in the search for an interior point.
constexpr int CenterSteps = 1000;
}

CellDecomposition::CellDecomposition(const CellShell& shell)
  : Shell(shell)
{
}

Error CellDecomposition::Execute(MeshingJob& job)
{
  if (this->Shell.Triangles.empty() || this->DecomposeFromPoint())
  {
    return {};
  }
  if (!(this->Shell.Volume > 0.0))
  {
    return "it has no volume";
  }
  const Error error = this->DecomposeWithTetGen(job);
  if (job.IsCanceled())
  {
    this->Tetrahedra.clear();
    return {};
  }
  if (!error)
  {
    ++job.Report.CellsByTetGen;
    return error;
  }
  if (this->DecomposeFromKernelPoint())
  {
    ++job.Report.CellsConed;
    return {};
  }
  return error.Within("", ", and no inside point sees all faces");
}

bool CellDecomposition::DecomposeFromPoint()
{
  const int points = static_cast<int>(this->Shell.PointIds.size());
  for (int apex = 0; apex < points; ++apex)
  {
    const auto touches = [apex](const CellShell::Triangle& triangle)
    {
      return std::find(triangle.Points.begin(), triangle.Points.end(), apex) !=
        triangle.Points.end();
    };
    std::vector<int> faces;
    for (const auto& triangle : this->Shell.Triangles)
    {
      if (touches(triangle))
      {
        faces.push_back(triangle.Face);
      }
    }
    this->Tetrahedra.clear();
    bool isGood = true;
    for (const auto& triangle : this->Shell.Triangles)
    {
      if (touches(triangle))
      {
        continue;
      }
      const auto& p = triangle.Points;
      // A face that contains the apex must be split into a fan around the apex. Otherwise, its
      // other triangles would give degenerate tetrahedra.
      isGood = isGood && std::find(faces.begin(), faces.end(), triangle.Face) == faces.end() &&
        PolarSine(this->Shell.GetPoint(apex), this->Shell.GetPoint(p[0]),
          this->Shell.GetPoint(p[1]), this->Shell.GetPoint(p[2])) > DegenerateShape;
      this->Tetrahedra.push_back({ { apex, p[0], p[1], p[2] } });
    }
    if (isGood && !this->Tetrahedra.empty())
    {
      return true;
    }
  }
  this->Tetrahedra.clear();
  return false;
}

bool CellDecomposition::MatchesShell(const TetGenSolution& solution) const
{
  std::vector<std::array<int, 3>> outside;
  for (std::size_t i = 0; i < solution.Neighbors.size(); ++i)
  {
    if (solution.Neighbors[i] < 0)
    {
      outside.push_back(solution.GetFace(i));
    }
  }
  std::vector<std::array<int, 3>> expected;
  for (const auto& triangle : this->Shell.Triangles)
  {
    expected.push_back(triangle.Points);
    std::sort(expected.back().begin(), expected.back().end());
  }
  std::sort(outside.begin(), outside.end());
  std::sort(expected.begin(), expected.end());
  return outside == expected;
}

Error CellDecomposition::DecomposeWithTetGen(MeshingJob& job)
{
  const Error mismatch("TetGen's tetrahedra do not match its faces", ErrorCode::Process);
  TetGenProblem problem;
  problem.Switches = "pYMJnQ";
  problem.Points = this->Shell.Points;
  for (const auto& triangle : this->Shell.Triangles)
  {
    problem.Triangles.insert(
      problem.Triangles.end(), triangle.Points.begin(), triangle.Points.end());
    problem.Markers.push_back(static_cast<int>(problem.Markers.size()) + 1);
  }
  TetGenSolution solution;
  Error error = job.Solve(problem, solution);
  if (error || !this->MatchesShell(solution))
  {
    return error ? error : mismatch;
  }
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < solution.Tetrahedra.size(); i += 4)
  {
    const int* t = &solution.Tetrahedra[i];
    this->Tetrahedra.push_back({ { t[0], t[1], t[2], t[3] } });
    minimum = std::min(minimum,
      PolarSine(&solution.Points[3 * t[0]], &solution.Points[3 * t[1]], &solution.Points[3 * t[2]],
        &solution.Points[3 * t[3]]));
  }
  glm::dvec3 center;
  if (minimum < NearlyDegenerateShape && this->FindKernelPoint(center) &&
    this->GetMinimumShape(glm::value_ptr(center)) > minimum)
  {
    this->Tetrahedra.clear();
    return mismatch;
  }
  this->NewPoints.assign(
    solution.Points.begin() + static_cast<std::ptrdiff_t>(problem.Points.size()),
    solution.Points.end());
  if (!(minimum > 0.0))
  {
    this->Tetrahedra.clear();
    this->NewPoints.clear();
    return mismatch;
  }
  return {};
}

double CellDecomposition::GetMinimumShape(const double* apex) const
{
  double minimum = std::numeric_limits<double>::infinity();
  for (const auto& triangle : this->Shell.Triangles)
  {
    const auto& p = triangle.Points;
    minimum = std::min(minimum,
      PolarSine(
        apex, this->Shell.GetPoint(p[0]), this->Shell.GetPoint(p[1]), this->Shell.GetPoint(p[2])));
  }
  return minimum;
}

bool CellDecomposition::FindKernelPoint(glm::dvec3& center) const
{
  // Start at the mean of the points, then move inward in decreasing steps. Each step is orthogonal
  // to the triangle with the smallest signed distance from the center, which is negative outside
  // (S. Agmon, "The relaxation method for linear inequalities", Canadian Journal of Mathematics 6,
  // 1954).
  const auto number = static_cast<double>(this->Shell.PointIds.size());
  center = glm::dvec3(0.0);
  for (std::size_t i = 0; i < this->Shell.Points.size(); ++i)
  {
    center[i % 3] += this->Shell.Points[i] / number;
  }
  double step = 0.1 * std::cbrt(this->Shell.Volume);
  glm::dvec3 best = center;
  double bestShape = this->GetMinimumShape(glm::value_ptr(center));
  for (int i = 0; i < CenterSteps; ++i)
  {
    double nearest = std::numeric_limits<double>::infinity();
    glm::dvec3 inward{ 0.0, 0.0, 0.0 };
    for (const auto& triangle : this->Shell.Triangles)
    {
      const double* a = this->Shell.GetPoint(triangle.Points[0]);
      const glm::dvec3 normal = glm::cross(Difference(this->Shell.GetPoint(triangle.Points[1]), a),
        Difference(this->Shell.GetPoint(triangle.Points[2]), a));
      const double length = std::sqrt(glm::dot(normal, normal));
      const double distance = -glm::dot(normal, Difference(glm::value_ptr(center), a)) / length;
      if (distance < nearest)
      {
        nearest = distance;
        inward = -normal / length;
      }
    }
    const double move = nearest < 0.0 ? step - nearest : step;
    center += move * inward;
    step *= 0.98;
    const double shape = this->GetMinimumShape(glm::value_ptr(center));
    if (shape > bestShape)
    {
      bestShape = shape;
      best = center;
    }
  }
  center = best;
  return bestShape > 0.0;
}

bool CellDecomposition::DecomposeFromKernelPoint()
{
  glm::dvec3 center;
  if (!this->FindKernelPoint(center))
  {
    return false;
  }
  const int apex = static_cast<int>(this->Shell.PointIds.size());
  this->NewPoints = { center.x, center.y, center.z };
  this->Tetrahedra.clear();
  for (const auto& triangle : this->Shell.Triangles)
  {
    const auto& p = triangle.Points;
    this->Tetrahedra.push_back({ { apex, p[0], p[1], p[2] } });
  }
  return true;
}

}
