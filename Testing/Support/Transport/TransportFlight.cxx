// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/TransportFlight.h"

#include <algorithm>
#include <cmath>

namespace reference
{

double TransportFlight::SampleCollision(
  const TransportMedium& medium, const TransportRay& ray, TransportRandom& random)
{
  constexpr double never = std::numeric_limits<double>::infinity();
  double collision = never;
  double depth = -std::log(random.Get());
  medium.Walk(ray, never,
    [&](double a, double b, const ExtinctionRange& range)
    {
      while (depth < range.Largest * (b - a))
      {
        a += depth / range.Largest;
        if (range.Minimum == range.Largest ||
          random.Get() * range.Largest < medium.GetExtinction(ray.At(a)))
        {
          collision = a;
          return false;
        }
        depth = -std::log(random.Get());
      }
      depth -= range.Largest * (b - a);
      return true;
    });
  return collision;
}

double TransportFlight::EstimateTransmittance(
  const TransportMedium& medium, const TransportRay& ray, double end, TransportRandom& random)
{
  glm::dvec3 transmittance(1.0);
  medium.Walk(ray, end,
    [&](double a, double b, const ExtinctionRange& range)
    {
      transmittance *= std::exp(-range.Minimum * (b - a));
      const double rest = range.Largest - range.Minimum;
      while (rest > 0.0)
      {
        a -= std::log(random.Get()) / rest;
        if (a >= b)
        {
          break;
        }
        transmittance *= (range.Largest - medium.GetExtinction(ray.At(a))) / rest;
      }
      return ApplyRussianRoulette(transmittance, random);
    });
  return transmittance.x;
}

bool TransportFlight::ApplyRussianRoulette(glm::dvec3& weight, TransportRandom& random)
{
  constexpr double threshold = 0.1;
  const double largest = std::max({ weight.x, weight.y, weight.z });
  if (largest >= threshold)
  {
    return true;
  }
  if (random.Get() * threshold >= largest)
  {
    weight = glm::dvec3(0.0);
    return false;
  }
  weight *= threshold / largest;
  return true;
}

}
