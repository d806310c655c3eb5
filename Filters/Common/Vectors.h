// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Vectors_h
#define interlume_Vectors_h

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace interlume
{

/**
 * Functions for `glm::dvec3` that GLM does not provide. To convert a `const double*` to a
 * `glm::dvec3`, use `glm::make_vec3`.
 */
namespace Vectors
{
/// Returns the infinity norm, the largest absolute component.
inline double InfinityNorm(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

/// Returns the mean of the components.
inline double Mean(const glm::dvec3& v)
{
  return (v.x + v.y + v.z) / 3.0;
}

inline bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Returns the length, even if the squares of components overflow or underflow.
inline double SafeLength(const glm::dvec3& v)
{
  const double square = glm::dot(v, v);
  if (square > 1e-280 && square < 1e280)
  {
    return std::sqrt(square);
  }
  const double largest = InfinityNorm(v);
  if (!(largest > 0.0 && std::isfinite(largest)))
  {
    return square;
  }
  const glm::dvec3 scaled = v / largest;
  return largest * std::sqrt(glm::dot(scaled, scaled));
}

/// Returns the scalar product. Inlining is forced, since GCC does not inline this function into the
/// large functions of advection.
[[gnu::always_inline]] inline double Dot(const double* a, const double* b)
{
  return glm::dot(glm::make_vec3(a), glm::make_vec3(b));
}

inline glm::dvec3 Difference(const double* a, const double* b)
{
  return glm::make_vec3(a) - glm::make_vec3(b);
}

/// Returns six times the signed volume of a tetrahedron: the triple product of b-a, c-a and d-a.
inline double SixVolumes(const double* a, const double* b, const double* c, const double* d)
{
  return glm::dot(Difference(b, a), glm::cross(Difference(c, a), Difference(d, a)));
}
}

}

#endif
