// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement/TetrahedronWalk.h"

#include "Common/Vectors.h"
#include "TetGen/TetGenProblem.h"

#include <algorithm>
#include <limits>

namespace interlume
{

namespace
{
/// A point is inside a tetrahedron if no barycentric coordinate is less than the negative of this
/// value.
constexpr double Rounding = 1e-12;
}

TetrahedronWalk::TetrahedronWalk(const TetGenSolution& mesh)
  : Mesh(mesh)
{
}

std::array<double, 4> TetrahedronWalk::GetWeights(int tetrahedron, const double* point) const
{
  using Vectors::SixVolumes;
  std::array<const double*, 4> x;
  for (int i = 0; i < 4; ++i)
  {
    x[i] = &this->Mesh.Points[3 * this->Mesh.Tetrahedra[4 * tetrahedron + i]];
  }
  const double fullVolume = SixVolumes(x[0], x[1], x[2], x[3]);
  std::array<double, 4> weights;
  for (int i = 0; i < 4; ++i)
  {
    std::array<const double*, 4> part = x;
    part[i] = point;
    weights[i] = SixVolumes(part[0], part[1], part[2], part[3]) / fullVolume;
  }
  return weights;
}

int TetrahedronWalk::Find(const double* point, std::array<double, 4>& weights)
{
  int current = this->Last;
  // Rounding errors in degenerate tetrahedra can make the walk cycle, so limit its length.
  for (int step = 0; step < this->Mesh.GetNumberOfTetrahedra(); ++step)
  {
    weights = this->GetWeights(current, point);
    const auto lowest = std::min_element(weights.begin(), weights.end());
    if (*lowest >= -Rounding)
    {
      this->Last = current;
      return current;
    }
    const int next = this->Mesh.Neighbors[4 * current + (lowest - weights.begin())];
    if (next < 0)
    {
      break;
    }
    current = next;
  }
  this->Last = this->Search(point);
  weights = this->GetWeights(this->Last, point);
  return this->Last;
}

int TetrahedronWalk::Search(const double* point) const
{
  int best = 0;
  double bestWeight = -std::numeric_limits<double>::infinity();
  for (int t = 0; t < this->Mesh.GetNumberOfTetrahedra(); ++t)
  {
    const std::array<double, 4> weights = this->GetWeights(t, point);
    const double lowest = *std::min_element(weights.begin(), weights.end());
    if (lowest > bestWeight)
    {
      best = t;
      bestWeight = lowest;
    }
  }
  return best;
}

}
