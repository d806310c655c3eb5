// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/PhaseFunction.h"

#include "vtkMath.h"

#include <boost/math/special_functions/legendre.hpp>

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
}

void PhaseFunction::SetIsotropic()
{
  this->Table.clear();
  this->Anisotropy = 0.0;
}

Error PhaseFunction::SetHenyeyGreenstein(double g)
{
  if (!(std::abs(g) < 1.0))
  {
    return "The anisotropy of the phase function is " + std::to_string(g) +
      ". Set a value between -1 and 1, exclusive.";
  }
  this->Table.clear();
  this->Anisotropy = g;
  return {};
}

Error PhaseFunction::SetTable(const std::vector<double>& values)
{
  if (values.size() < 2)
  {
    return "The phase function's table has fewer than 2 values. Add points to PhaseTable.";
  }
  for (const double value : values)
  {
    if (!(value >= 0.0 && std::isfinite(value)))
    {
      return "The phase function's table has the value " + std::to_string(value) +
        ", which is negative or not finite. Correct PhaseTable.";
    }
  }
  const double largest = *std::max_element(values.begin(), values.end());
  if (!(largest > 0.0))
  {
    return "The phase function's table has no value above 0. Correct PhaseTable.";
  }
  // The trapezoidal rule is exact for a piecewise linear function.
  double sum = -0.5 * (values.front() + values.back()) / largest;
  for (const double value : values)
  {
    sum += value / largest;
  }
  const double integral = 2.0 * vtkMath::Pi() * sum * 2.0 / static_cast<double>(values.size() - 1);
  this->Table = values;
  for (double& value : this->Table)
  {
    value = value / largest / integral;
  }
  return {};
}

double PhaseFunction::Value(double cosine) const
{
  cosine = std::min(std::max(cosine, -1.0), 1.0);
  if (this->Table.empty())
  {
    const double g = this->Anisotropy;
    // This form avoids cancellation if both g and the cosine are near 1.
    const double base = (1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 - cosine);
    return (1.0 - g) * (1.0 + g) / (4.0 * vtkMath::Pi() * base * std::sqrt(base));
  }
  const double position = 0.5 * (cosine + 1.0) * static_cast<double>(this->Table.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), this->Table.size() - 2);
  const double fraction = position - static_cast<double>(below);
  return (1.0 - fraction) * this->Table[below] + fraction * this->Table[below + 1];
}

template <typename Function>
double PhaseFunction::Integrate(double lower, Function&& function) const
{
  // Equal steps in the logarithm of 1 + scale - cosine resolve a forward peak. Equal steps in the
  // logarithm of 1 + scale + cosine resolve a backward peak.
  const double scale = this->Table.empty()
    ? std::max(0.5 * (1.0 - std::abs(this->Anisotropy)) * (1.0 - std::abs(this->Anisotropy)), 1e-12)
    : 0.05;
  const int steps = this->Table.empty() ? 2000 : 200 * static_cast<int>(this->Table.size());
  const double sign = this->Anisotropy < 0.0 ? -1.0 : 1.0;
  const double from = sign > 0.0 ? lower : -1.0;
  const double to = sign > 0.0 ? 1.0 : -lower;
  const double start = std::log(1.0 + scale - to);
  const double end = std::log(1.0 + scale - from);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double distance = std::exp(start + (end - start) * (i + 0.5) / steps);
    const double cosine = sign * (1.0 + scale - distance);
    sum += distance * this->Value(cosine) * function(cosine);
  }
  return 2.0 * vtkMath::Pi() * sum * (end - start) / steps;
}

double PhaseFunction::Moment(int n) const
{
  if (this->Table.empty())
  {
    return std::pow(this->Anisotropy, n);
  }
  return this->Integrate(-1.0, [n](double cosine) { return boost::math::legendre_p(n, cosine); }) /
    this->Integrate(-1.0, [](double) { return 1.0; });
}

double PhaseFunction::ForwardFraction() const
{
  const double g = this->Anisotropy;
  if (this->Table.empty())
  {
    return std::abs(g) < 1e-6
      ? 0.5 + 0.75 * g
      : (1.0 - g) * (1.0 + g) / (2.0 * g) * (1.0 / (1.0 - g) - 1.0 / std::sqrt(1.0 + g * g));
  }
  return this->Integrate(0.0, [](double) { return 1.0; }) /
    this->Integrate(-1.0, [](double) { return 1.0; });
}

double PhaseFunction::ForwardVariance() const
{
  const double fraction = this->Integrate(0.0, [](double) { return 1.0; });
  return fraction > 0.0
    ? 0.5 * this->Integrate(0.0, [](double c) { return 1.0 - c * c; }) / fraction
    : 0.0;
}

bool PhaseFunction::operator==(const PhaseFunction& other) const
{
  return this->Table == other.Table && this->Anisotropy == other.Anisotropy;
}

}
