#include "vtkRealEigenvalues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace
{
constexpr double Epsilon = std::numeric_limits<double>::epsilon();

using Complex = std::complex<double>;
using Matrix = std::array<std::array<double, 3>, 3>;

// A diagonal similarity by powers of 2 that makes rows and columns alike in size.
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
      const double row = std::abs(a[i][j]) + std::abs(a[i][k]);
      const double column = std::abs(a[j][i]) + std::abs(a[k][i]);
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
          a[i][other] = std::ldexp(a[i][other], -half);
          a[other][i] = std::ldexp(a[other][i], half);
        }
      }
    }
  }
}

// A <- P A P, P the reflection that takes v to a multiple of the first of its axes; v has \a size
// coordinates, which are the last ones of the matrix.
void Reflect(Matrix& a, std::array<double, 3> v, int size)
{
  const int first = 3 - size;
  double norm = 0.0;
  for (int i = first; i < 3; ++i)
  {
    norm = std::hypot(norm, v[i]);
  }
  if (norm == 0.0)
  {
    return;
  }
  v[first] += std::copysign(norm, v[first]);
  double square = 0.0;
  for (int i = first; i < 3; ++i)
  {
    square += v[i] * v[i];
  }
  for (int line = 0; line < 3; ++line)
  {
    double sum = 0.0;
    for (int i = first; i < 3; ++i)
    {
      sum += v[i] * a[i][line];
    }
    for (int i = first; i < 3; ++i)
    {
      a[i][line] -= 2.0 * sum / square * v[i];
    }
  }
  for (int line = 0; line < 3; ++line)
  {
    double sum = 0.0;
    for (int i = first; i < 3; ++i)
    {
      sum += v[i] * a[line][i];
    }
    for (int i = first; i < 3; ++i)
    {
      a[line][i] -= 2.0 * sum / square * v[i];
    }
  }
}

// Makes the entry below the two diagonals 0.
void MakeHessenberg(Matrix& a)
{
  Reflect(a, { { 0.0, a[1][0], a[2][0] } }, 2);
  a[2][0] = 0.0;
}

// Francis' implicit step with the shifts of the last block, or others now and then, lest it goes in
// circles.
void Step(Matrix& a, int iteration)
{
  double trace = a[1][1] + a[2][2];
  double determinant = a[1][1] * a[2][2] - a[1][2] * a[2][1];
  if (iteration % 10 == 9)
  {
    const double shift = std::abs(a[1][0]) + std::abs(a[2][1]);
    trace = 1.5 * shift;
    determinant = shift * shift;
  }
  Reflect(a,
    { { a[0][0] * (a[0][0] - trace) + determinant + a[0][1] * a[1][0],
      a[1][0] * (a[0][0] + a[1][1] - trace), a[1][0] * a[2][1] } },
    3);
  MakeHessenberg(a);
}

std::array<Complex, 2> SolvePair(double a, double b, double c, double d)
{
  const double half = 0.5 * (a - d);
  const double square = half * half + b * c;
  if (square < 0.0)
  {
    const double imaginary = std::sqrt(-square);
    return { { Complex(0.5 * (a + d), imaginary), Complex(0.5 * (a + d), -imaginary) } };
  }
  // The larger one first, without cancellation.
  const double larger = half + std::copysign(std::sqrt(square), half);
  const double smaller = larger == 0.0 ? 0.0 : -b * c / larger;
  return { { Complex(d + larger, 0.0), Complex(d + smaller, 0.0) } };
}

bool IsSmall(const Matrix& a, int i)
{
  double size = std::abs(a[i - 1][i - 1]) + std::abs(a[i][i]);
  size = size == 0.0 ? 1.0 : size;
  return std::abs(a[i][i - 1]) <= Epsilon * size;
}
}

void vtkRealEigenvalues::Compute(const double matrix[9], double eigenvalues[6])
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
  Matrix a;
  for (int i = 0; i < 9; ++i)
  {
    a[i / 3][i % 3] = matrix[i] / largest;
  }
  Balance(a);
  MakeHessenberg(a);
  constexpr int maximumNumberOfSteps = 100;
  for (int i = 0; i < maximumNumberOfSteps && !IsSmall(a, 1) && !IsSmall(a, 2); ++i)
  {
    Step(a, i);
  }
  const bool isFirstAlone = std::abs(a[1][0]) < std::abs(a[2][1]);
  const int alone = isFirstAlone ? 0 : 2;
  const int pair = isFirstAlone ? 1 : 0;
  const auto both =
    SolvePair(a[pair][pair], a[pair][pair + 1], a[pair + 1][pair], a[pair + 1][pair + 1]);
  std::array<Complex, 3> values = { { both[0], both[1], Complex(a[alone][alone], 0.0) } };
  std::sort(values.begin(), values.end(),
    [](const Complex& x, const Complex& y)
    { return x.real() != y.real() ? x.real() > y.real() : x.imag() > y.imag(); });
  for (int i = 0; i < 3; ++i)
  {
    eigenvalues[2 * i] = largest * values[i].real();
    eigenvalues[2 * i + 1] = largest * values[i].imag();
  }
}
