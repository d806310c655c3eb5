// SPDX-License-Identifier: BSD-3-Clause
#include "Common/Vectors.h"
#include "Mesh/TetrahedronMath.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace TetrahedronMath
{
using Vectors::Difference;

double PolarSine(const double* a, const double* b, const double* c, const double* d)
{
  const glm::dvec3 e = Difference(b, a);
  const glm::dvec3 f = Difference(c, a);
  const glm::dvec3 g = Difference(d, a);
  const double lengths =
    std::sqrt(glm::dot(e, e)) * std::sqrt(glm::dot(f, f)) * std::sqrt(glm::dot(g, g));
  return lengths > 0.0 ? glm::dot(e, glm::cross(f, g)) / lengths : 0.0;
}

double RadiusEdgeRatio(const double* a, const double* b, const double* c, const double* d)
{
  const glm::dvec3 e = Difference(b, a);
  const glm::dvec3 f = Difference(c, a);
  const glm::dvec3 g = Difference(d, a);
  const glm::dvec3 fg = glm::cross(f, g);
  const glm::dvec3 ge = glm::cross(g, e);
  const glm::dvec3 ef = glm::cross(e, f);
  const double determinant = glm::dot(e, fg);
  const glm::dvec3 center =
    (glm::dot(e, e) * fg + glm::dot(f, f) * ge + glm::dot(g, g) * ef) / (2.0 * determinant);
  const glm::dvec3 fe = Difference(c, b);
  const glm::dvec3 gf = Difference(d, c);
  const glm::dvec3 eg = Difference(b, d);
  const double shortest = std::min({ glm::dot(e, e), glm::dot(f, f), glm::dot(g, g),
    glm::dot(fe, fe), glm::dot(gf, gf), glm::dot(eg, eg) });
  return std::sqrt(glm::dot(center, center) / shortest);
}

}

}
