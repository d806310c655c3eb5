// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TextureSearch.h"

#include "Common/Vectors.h"
#include "Termination/ClosestTrianglePoint.h"

#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
struct TextureTriangle
{
  explicit TextureTriangle(const TerminationTriangles::Triangle& triangle)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Corners[i] = { triangle.Texture[i][0], triangle.Texture[i][1], 0.0 };
    }
  }

  bool HasArea() const
  {
    const auto& c = this->Corners;
    return std::abs((c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) -
             (c[2][0] - c[0][0]) * (c[1][1] - c[0][1])) > std::numeric_limits<double>::min();
  }

  glm::dvec3 Corners[3];
};
}

void TextureSearch::Build(const TerminationTriangles* mesh, const bool isPeriodic[2])
{
  this->Mesh = mesh;
  std::copy_n(isPeriodic, 2, this->IsPeriodic);
  std::vector<BoxTree::Box> boxes;
  for (const auto& triangle : mesh->Triangles)
  {
    const TextureTriangle projected(triangle);
    BoxTree::Box box;
    for (int i = 0; i < 3; ++i)
    {
      const auto range =
        std::minmax({ projected.Corners[0][i], projected.Corners[1][i], projected.Corners[2][i] });
      box.Lower[i] = range.first;
      box.Upper[i] = range.second;
    }
    boxes.push_back(box);
  }
  this->Tree.Build(boxes);
}

bool TextureSearch::FindPoint(const double uv[2], double x[3]) const
{
  const double tolerance = vtkTerminationSurface::BorderTolerance;
  double limit = tolerance * tolerance;
  bool isFound = false;
  // Triangles across a seam extend below 0 or above 1, so also search at coordinates shifted by one
  // period.
  const int reach[2] = { this->IsPeriodic[0] ? 1 : 0, this->IsPeriodic[1] ? 1 : 0 };
  for (int i = -reach[0]; i <= reach[0]; ++i)
  {
    for (int j = -reach[1]; j <= reach[1]; ++j)
    {
      const glm::dvec3 target{ uv[0] + i, uv[1] + j, 0.0 };
      this->Tree.VisitNear(glm::value_ptr(target), limit,
        [this, x, &target, &limit, &isFound](int item, double& squaredLimit)
        {
          const TextureTriangle projected(this->Mesh->Triangles[item]);
          const ClosestTrianglePoint foot(
            target, projected.Corners[0], projected.Corners[1], projected.Corners[2]);
          if (projected.HasArea() && foot.SquaredDistance < squaredLimit)
          {
            squaredLimit = limit = foot.SquaredDistance;
            isFound = true;
            const glm::dvec3& origin = this->Mesh->GetCorner(item, 0);
            const glm::dvec3 point =
              (origin + foot.Weights[1] * (this->Mesh->GetCorner(item, 1) - origin) +
                foot.Weights[2] * (this->Mesh->GetCorner(item, 2) - origin)) /
              this->Mesh->Scale;
            std::copy_n(glm::value_ptr(point), 3, x);
          }
        });
    }
  }
  return isFound;
}

}
