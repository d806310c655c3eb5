// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/InverseJacobian.h"

#include "Cells/MultilinearCell.h"

#include <cmath>
#include <utility>

namespace interlume
{

// Scales each column to a length of about 1 before the inversion. The scales are powers of 2, so
// scaling causes no rounding errors.
void InverseJacobian::InvertScaled(const double columns[3][4], double inverse[3][3])
{
  double scaled[3][4];
  double scales[3];
  for (int j = 0; j < 3; ++j)
  {
    scales[j] = MultilinearCell::GetScale(Vectors::InfinityNorm(glm::make_vec3(columns[j])));
    for (int i = 0; i < 3; ++i)
    {
      scaled[j][i] = scales[j] * columns[j][i];
    }
    scaled[j][3] = 0.0;
  }
  if (!InvertRegular(scaled, inverse))
  {
    InvertSingular(columns, inverse);
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inverse[i][j] *= scales[i];
    }
  }
}

// Computes the QR factorization of the normalized columns by Gram-Schmidt orthogonalization with
// column pivoting. Then solves for the inverse by back substitution.
void InverseJacobian::InvertSingular(const double columns[3][4], double inverse[3][3])
{
  // A column is independent if at least this fraction of its length remains after
  // orthogonalization.
  constexpr double minimumFraction = 1e-10;
  int order[3] = { 0, 1, 2 };
  double rest[3][3];
  double length[3];
  for (int j = 0; j < 3; ++j)
  {
    length[j] = std::hypot(columns[j][0], columns[j][1], columns[j][2]);
    for (int i = 0; i < 3; ++i)
    {
      inverse[j][i] = 0.0;
      rest[j][i] = length[j] > 0.0 ? columns[j][i] / length[j] : 0.0;
    }
  }
  double q[3][3];
  double r[3][3];
  int rank = 0;
  for (; rank < 3; ++rank)
  {
    int best = rank;
    for (int k = rank + 1; k < 3; ++k)
    {
      const double* candidate = rest[order[k]];
      const double* leader = rest[order[best]];
      best = Vectors::Dot(candidate, candidate) > Vectors::Dot(leader, leader) ? k : best;
    }
    std::swap(order[rank], order[best]);
    for (int m = 0; m < rank; ++m)
    {
      std::swap(r[m][rank], r[m][best]);
    }
    const double* pivot = rest[order[rank]];
    const double size = std::sqrt(Vectors::Dot(pivot, pivot));
    if (!(size > minimumFraction))
    {
      break;
    }
    r[rank][rank] = size;
    for (int i = 0; i < 3; ++i)
    {
      q[rank][i] = pivot[i] / size;
    }
    for (int k = rank + 1; k < 3; ++k)
    {
      double* other = rest[order[k]];
      r[rank][k] = Vectors::Dot(q[rank], other);
      for (int i = 0; i < 3; ++i)
      {
        other[i] -= r[rank][k] * q[rank][i];
      }
    }
  }
  for (int m = rank - 1; m >= 0; --m)
  {
    double* row = inverse[order[m]];
    for (int i = 0; i < 3; ++i)
    {
      double sum = q[m][i];
      for (int k = m + 1; k < rank; ++k)
      {
        sum -= r[m][k] * inverse[order[k]][i];
      }
      row[i] = sum / r[m][m];
    }
  }
  for (int m = 0; m < rank; ++m)
  {
    for (int i = 0; i < 3; ++i)
    {
      inverse[order[m]][i] /= length[order[m]];
    }
  }
}

}
