// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InverseJacobian_h
#define interlume_InverseJacobian_h

#include "Common/Vectors.h"

namespace interlume
{

/**
 * @class   InverseJacobian
 * @brief   computes the inverse of the Jacobian dx/dp of a cell
 *
 * \a columns[j] is dx/dp_j. Row i of the result is dp_i/dx. If the columns are linearly dependent,
 * for example on a collapsed edge, the inverse does not exist. Redundant coordinates then get zero
 * rows, so that they do not change along a streamline. The other rows are the least-squares
 * solution.
 */
class InverseJacobian
{
public:
  static void Invert(const double columns[3][4], double inverse[3][3])
  {
    if (!InvertRegular(columns, inverse))
    {
      InvertScaled(columns, inverse);
    }
  }

  static void Multiply(const double rows[3][3], const double vector[3], double product[3])
  {
    const double v[3] = { vector[0], vector[1], vector[2] };
    for (int i = 0; i < 3; ++i)
    {
      product[i] = Vectors::Dot(rows[i], v);
    }
  }

  /// Computes sum_j d[j] columns[j].
  static void Combine(const double columns[3][4], const double d[3], double sum[3])
  {
    const double factor[3] = { d[0], d[1], d[2] };
    for (int i = 0; i < 3; ++i)
    {
      sum[i] = factor[0] * columns[0][i] + factor[1] * columns[1][i] + factor[2] * columns[2][i];
    }
  }

private:
  /// Returns false if the columns are linearly dependent, or if their squares overflow or
  /// underflow.
  static bool InvertRegular(const double columns[3][4], double inverse[3][3])
  {
    const glm::dvec3 a = glm::make_vec3(columns[0]);
    const glm::dvec3 b = glm::make_vec3(columns[1]);
    const glm::dvec3 c = glm::make_vec3(columns[2]);
    const glm::dvec3 rows[3] = { glm::cross(b, c), glm::cross(c, a), glm::cross(a, b) };
    const double determinant = glm::dot(a, rows[0]);
    // The scale is the product of the squared column lengths. Therefore flat or small cells are
    // accepted, but not cells that are sheared almost into a plane.
    const double scale = glm::dot(a, a) * glm::dot(b, b) * glm::dot(c, c);
    if (!(determinant * determinant > 1e-18 * scale && scale < 1e300))
    {
      return false;
    }
    const double factor = 1.0 / determinant;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        inverse[i][j] = rows[i][j] * factor;
      }
    }
    return true;
  }
  static void InvertScaled(const double columns[3][4], double inverse[3][3]);
  static void InvertSingular(const double columns[3][4], double inverse[3][3]);
};

}

#endif
