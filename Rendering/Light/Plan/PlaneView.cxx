// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/PlaneView.h"

#include <cmath>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace interlume
{

glm::dmat3 PlaneView::GetHomography(const std::array<double, 16>& from,
  const std::array<double, 16>& to, const std::array<double, 4>& plane)
{
  // The third row of a view is not used: depth on the plane takes its place, which is 0.
  glm::dmat4 rows(glm::make_vec4(&from[0]), glm::make_vec4(&from[4]), glm::make_vec4(&from[12]),
    glm::make_vec4(plane.data()));
  const glm::dmat4 view = glm::transpose(rows);
  if (!(std::abs(glm::determinant(view)) > 0.0))
  {
    return glm::dmat3(0.0);
  }
  const glm::dmat4 inverse = glm::inverse(view);
  glm::dmat3 result;
  for (int column = 0; column < 3; ++column)
  {
    const glm::dvec4 point = inverse[column];
    result[column] = { glm::dot(glm::make_vec4(&to[0]), point),
      glm::dot(glm::make_vec4(&to[4]), point), glm::dot(glm::make_vec4(&to[12]), point) };
  }
  return result;
}

}
