// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RealEigenvalues.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace interlume
{

namespace
{
using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Balances a matrix by a diagonal similarity transform with powers of 2, so that rows and columns
// have similar norms. Eigen does not do this. Without it, gradients lose precision if the
// coordinates have different units.
void Balance(Matrix& a)
{
  bool isChanging = true;
  for (int sweep = 0; isChanging && sweep < 100; ++sweep)
  {
    isChanging = false;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const double row = std::abs(a(i, j)) + std::abs(a(i, k));
      const double column = std::abs(a(j, i)) + std::abs(a(k, i));
      if (row == 0.0 || column == 0.0)
      {
        continue;
      }
      const int half = static_cast<int>(std::lround(0.5 * std::log2(row / column)));
      if (half != 0)
      {
        isChanging = true;
        for (const int other : { j, k })
        {
          a(i, other) = std::ldexp(a(i, other), -half);
          a(other, i) = std::ldexp(a(other, i), half);
        }
      }
    }
  }
}
}

void RealEigenvalues::Compute(const double matrix[9], double eigenvalues[6])
{
  double largest = 0.0;
  bool isFinite = true;
  for (int i = 0; i < 9; ++i)
  {
    largest = std::max(largest, std::abs(matrix[i]));
    isFinite = isFinite && std::isfinite(matrix[i]);
  }
  if (!isFinite || largest == 0.0)
  {
    std::fill_n(eigenvalues, 6, isFinite ? 0.0 : std::numeric_limits<double>::quiet_NaN());
    return;
  }
  Matrix a = Eigen::Map<const Matrix>(matrix) / largest;
  Balance(a);
  Eigen::Vector3cd values = Eigen::EigenSolver<Matrix>(a, false).eigenvalues();
  std::sort(values.data(), values.data() + 3,
    [](const std::complex<double>& x, const std::complex<double>& y)
    { return x.real() != y.real() ? x.real() > y.real() : x.imag() > y.imag(); });
  for (int i = 0; i < 3; ++i)
  {
    eigenvalues[2 * i] = largest * values[i].real();
    eigenvalues[2 * i + 1] = largest * values[i].imag();
  }
}

}
