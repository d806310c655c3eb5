// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Checks/ReferenceExact.h"

#include "Support/Arrays/ReferenceIndices.h"

#include <cmath>

namespace reference
{

Exact::Exact(double value)
{
  this->Add(value);
}

void Exact::Add(double value)
{
  // Carries the value through the terms by two-sum, smallest term first. Each rounding error
  // becomes a term.
  std::vector<double> terms;
  double carried = value;
  for (double term : this->Terms)
  {
    const double sum = carried + term;
    const double virtualTerm = sum - carried;
    const double lost = (carried - (sum - virtualTerm)) + (term - virtualTerm);
    if (lost != 0)
    {
      terms.push_back(lost);
    }
    carried = sum;
  }
  if (carried != 0)
  {
    terms.push_back(carried);
  }
  this->Terms = terms;
}

Exact Exact::operator+(const Exact& other) const
{
  Exact sum = *this;
  for (double term : other.Terms)
  {
    sum.Add(term);
  }
  return sum;
}

Exact Exact::operator-(const Exact& other) const
{
  Exact difference = *this;
  for (double term : other.Terms)
  {
    difference.Add(-term);
  }
  return difference;
}

Exact Exact::operator*(const Exact& other) const
{
  Exact result;
  for (double a : this->Terms)
  {
    for (double b : other.Terms)
    {
      const double product = a * b;
      result.Add(std::fma(a, b, -product));
      result.Add(product);
    }
  }
  return result;
}

int Exact::Sign() const
{
  if (this->Terms.empty())
  {
    return 0;
  }
  return this->Terms.back() > 0 ? 1 : -1;
}

long double Exact::Round() const
{
  long double sum = 0;
  for (double term : this->Terms)
  {
    sum += term;
  }
  return sum;
}

Exact ExactDeterminant(const std::array<ExactPoint, 4>& points)
{
  std::array<ExactPoint, 3> d;
  for (const auto& [i, a] : AllIndices(3, 3))
  {
    d[i][a] = points[i + 1][a] - points[0][a];
  }
  const auto minor = [&](int a, int b) { return d[0][a] * d[1][b] - d[0][b] * d[1][a]; };
  return minor(1, 2) * d[2][0] + minor(2, 0) * d[2][1] + minor(0, 1) * d[2][2];
}

}
