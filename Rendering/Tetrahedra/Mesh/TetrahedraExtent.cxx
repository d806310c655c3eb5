// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetrahedraExtent.h"

#include "Common/Vectors.h"
#include "Mesh/TetrahedraMesh.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace interlume
{

double TetrahedraExtent::GetRadius(const TetrahedraMesh& mesh)
{
  constexpr vtkIdType chunkSize = 16384;
  const vtkIdType number = static_cast<vtkIdType>(mesh.Points.size() / 3);
  std::vector<double> radii((number + chunkSize - 1) / chunkSize, 0.0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(radii.size()), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        double radius = 0.0;
        const vtkIdType end = std::min(number, (chunk + 1) * chunkSize);
        for (vtkIdType i = chunk * chunkSize; i < end; ++i)
        {
          const glm::dvec3 p = glm::make_vec3(&mesh.Points[3 * i]);
          radius = std::max(radius, glm::dot(p, p));
        }
        radii[chunk] = radius;
      }
    });
  const auto greatest = std::max_element(radii.begin(), radii.end());
  return greatest == radii.end() ? 0.0 : std::sqrt(*greatest);
}

}
