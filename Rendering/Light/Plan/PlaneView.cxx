// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/PlaneView.h"

#include <cmath>

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace interlume
{

glm::dmat3x4 PlaneView::GetPoints(const glm::dmat4& view, const std::array<double, 4>& plane)
{
  // The view's third row is not used. The plane's equation, which is 0 on the plane, replaces it.
  const glm::dmat4 rows(
    glm::row(view, 0), glm::row(view, 1), glm::row(view, 3), glm::make_vec4(plane.data()));
  const glm::dmat4 matrix = glm::transpose(rows);
  if (!(std::abs(glm::determinant(matrix)) > 0.0))
  {
    return glm::dmat3x4(0.0);
  }
  const glm::dmat4 inverse = glm::inverse(matrix);
  return { inverse[0], inverse[1], inverse[2] };
}

glm::dmat3 PlaneView::GetHomography(
  const glm::dmat4& from, const glm::dmat4& to, const std::array<double, 4>& plane)
{
  const glm::dmat3x4 points = GetPoints(from, plane);
  glm::dmat3 result;
  for (int column = 0; column < 3; ++column)
  {
    result[column] = { glm::dot(glm::row(to, 0), points[column]),
      glm::dot(glm::row(to, 1), points[column]), glm::dot(glm::row(to, 3), points[column]) };
  }
  return result;
}

}
