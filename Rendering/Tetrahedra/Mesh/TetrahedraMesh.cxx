// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetrahedraMesh.h"

#include "Common/ThreadLocals.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace interlume
{

double TetrahedraMesh::GetRadius() const
{
  ThreadLocals<double> squares;
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size() / 3),
    [&](vtkIdType first, vtkIdType last)
    {
      double& square = squares.Local();
      for (vtkIdType i = first; i < last; ++i)
      {
        const glm::dvec3 p = glm::make_vec3(&this->Points[3 * i]);
        square = std::max(square, glm::dot(p, p));
      }
    });
  const auto largest = std::max_element(squares.begin(), squares.end());
  return largest == squares.end() ? 0.0 : std::sqrt(*largest);
}

bool TetrahedraMesh::HasPointBehind(const glm::dvec4& plane, double tolerance) const
{
  // All points are in the cube [-1, 1]^3. Skip the search if this cube is in front of the plane.
  // The factor allows for rounding errors.
  if (plane.w >= (1.0 + 1e-9) * (std::abs(plane.x) + std::abs(plane.y) + std::abs(plane.z)))
  {
    return false;
  }
  std::atomic<bool> isBehind{ false };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Points.size() / 3),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType p = first; p < last && !isBehind; ++p)
      {
        if (this->GetDistance(plane, static_cast<std::uint32_t>(p)) < -tolerance)
        {
          isBehind = true;
        }
      }
    });
  return isBehind;
}

}
