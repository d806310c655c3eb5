// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/TransportPhase.h"

#include "Support/Transport/TransportRandom.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace reference
{

namespace
{
constexpr double Pi = 3.14159265358979324;
}

TransportPhase TransportPhase::HenyeyGreenstein(double g)
{
  if (!(std::abs(g) < 1.0))
  {
    throw std::invalid_argument(
      "HenyeyGreenstein: the mean cosine must be between -1 and 1, exclusive");
  }
  TransportPhase phase;
  phase.MeanCosine = g;
  return phase;
}

TransportPhase TransportPhase::Table(
  const std::vector<double>& cosines, const std::vector<double>& values)
{
  if (cosines.size() < 2 || cosines.size() != values.size() || cosines.front() != -1.0 ||
    cosines.back() != 1.0 || !std::is_sorted(cosines.begin(), cosines.end()) ||
    *std::min_element(values.begin(), values.end()) < 0.0)
  {
    throw std::invalid_argument(
      "Table: the cosines must rise from -1 to 1, with one nonnegative value each");
  }
  TransportPhase phase;
  phase.Cosines = cosines;
  phase.Values = values;
  phase.Cumulative = { 0.0 };
  for (std::size_t i = 1; i < cosines.size(); ++i)
  {
    const double width = cosines[i] - cosines[i - 1];
    phase.Cumulative.push_back(phase.Cumulative.back() + 0.5 * width * (values[i - 1] + values[i]));
    // The integral of the cosine times the function, which is linear between nodes.
    phase.MeanCosine += width *
      (cosines[i - 1] * (2.0 * values[i - 1] + values[i]) +
        cosines[i] * (values[i - 1] + 2.0 * values[i])) /
      6.0;
  }
  const double sum = phase.Cumulative.back();
  if (!(sum > 0.0))
  {
    throw std::invalid_argument("Table: at least one value must be positive");
  }
  phase.MeanCosine /= sum;
  for (std::size_t i = 0; i < cosines.size(); ++i)
  {
    phase.Values[i] /= sum;
    phase.Cumulative[i] /= sum;
  }
  return phase;
}

double TransportPhase::GetValue(double cosine) const
{
  if (this->Cosines.empty())
  {
    const double g = this->MeanCosine;
    const double square = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (4.0 * Pi * square * std::sqrt(square));
  }
  const auto above = std::upper_bound(this->Cosines.begin() + 1, this->Cosines.end() - 1, cosine);
  const std::size_t i = static_cast<std::size_t>(above - this->Cosines.begin());
  const double width = this->Cosines[i] - this->Cosines[i - 1];
  const double t =
    width > 0.0 ? std::clamp((cosine - this->Cosines[i - 1]) / width, 0.0, 1.0) : 1.0;
  return ((1.0 - t) * this->Values[i - 1] + t * this->Values[i]) / (2.0 * Pi);
}

double TransportPhase::SampleTable(double cumulative) const
{
  const auto above =
    std::upper_bound(this->Cumulative.begin() + 1, this->Cumulative.end() - 1, cumulative);
  const std::size_t i = static_cast<std::size_t>(above - this->Cumulative.begin());
  const double width = this->Cosines[i] - this->Cosines[i - 1];
  const double low = this->Values[i - 1];
  const double slope = this->Values[i] - low;
  // Solves rest = low * t + slope * t^2 / 2 for t. This form of the root is numerically stable.
  const double rest = width > 0.0 ? (cumulative - this->Cumulative[i - 1]) / width : 0.0;
  const double root = std::sqrt(std::max(low * low + 2.0 * slope * rest, 0.0));
  const double t = low + root > 0.0 ? 2.0 * rest / (low + root) : 0.0;
  return this->Cosines[i - 1] + width * std::min(t, 1.0);
}

double TransportPhase::SampleCosine(double cumulative) const
{
  if (!this->Cosines.empty())
  {
    return this->SampleTable(cumulative);
  }
  const double g = this->MeanCosine;
  const double across = 2.0 * cumulative - 1.0;
  if (std::abs(g) < 1e-3)
  {
    // Second-order expansion for small g, for which the formula below loses precision.
    return across + g * (1.0 - across * across) * (1.5 - 2.0 * g * across);
  }
  const double ratio = (1.0 - g * g) / (1.0 + g * across);
  return (1.0 + g * g - ratio * ratio) / (2.0 * g);
}

glm::dvec3 TransportPhase::Scatter(const glm::dvec3& direction, TransportRandom& random) const
{
  const double cosine = std::clamp(this->SampleCosine(random.Get()), -1.0, 1.0);
  const double azimuth = 2.0 * Pi * random.Get();
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  // Orthonormal basis: T. Duff et al., "Building an orthonormal basis, revisited", 2017.
  const double sign = std::copysign(1.0, direction.z);
  const double a = -1.0 / (sign + direction.z);
  const double b = direction.x * direction.y * a;
  const glm::dvec3 first(1.0 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x);
  const glm::dvec3 second(b, sign + direction.y * direction.y * a, -direction.y);
  const glm::dvec3 to =
    cosine * direction + sine * (std::cos(azimuth) * first + std::sin(azimuth) * second);
  // Without normalization, rounding errors would accumulate over thousands of scattering events.
  return to / std::sqrt(to.x * to.x + to.y * to.y + to.z * to.z);
}

}
