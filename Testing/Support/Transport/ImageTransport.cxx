// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/ImageTransport.h"

#include "Support/Transport/TransportFlight.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace reference
{

namespace
{

constexpr double FullSolidAngle = 4.0 * 3.14159265358979324;
constexpr double Never = std::numeric_limits<double>::infinity();

/// Returns the direct light of all sources that is scattered at the ray's origin into the direction
/// opposite to the ray.
glm::dvec3 GetLight(const TransportMedium& medium, const TransportRay& ray,
  const ImageTransportSettings& settings, TransportRandom& random)
{
  glm::dvec3 sum(0.0);
  for (const TransportLight& light : settings.Lights)
  {
    const double cosine = -glm::dot(light.Direction, ray.Direction);
    const double phaseFactor = FullSolidAngle * settings.Phase.GetValue(cosine);
    sum += phaseFactor *
      TransportFlight::EstimateTransmittance(
        medium, { ray.Origin, -light.Direction }, Never, random) *
      light.Color;
  }
  return sum;
}

/// Returns the color and the opacity (0 or 1) of one path.
std::array<double, 4> Follow(const TransportMedium& medium, TransportRay ray,
  const ImageTransportSettings& settings, TransportRandom& random)
{
  glm::dvec3 color(0.0);
  double distance = TransportFlight::SampleCollision(medium, ray, random);
  const double opacity = std::isfinite(distance) ? 1.0 : 0.0;
  glm::dvec3 weight(1.0);
  for (int scatterings = 1; std::isfinite(distance); ++scatterings)
  {
    ray.Origin = ray.At(distance);
    weight *= medium.GetAlbedo(ray.Origin);
    if (!TransportFlight::ApplyRussianRoulette(weight, random))
    {
      break;
    }
    color += weight * GetLight(medium, ray, settings, random);
    ray.Direction = settings.Phase.Scatter(ray.Direction, random);
    if (scatterings == settings.MaximumScatterings)
    {
      color += weight * settings.Surroundings *
        (settings.Surroundings == glm::dvec3(0.0)
            ? 0.0
            : TransportFlight::EstimateTransmittance(medium, ray, Never, random));
      break;
    }
    distance = TransportFlight::SampleCollision(medium, ray, random);
    if (!std::isfinite(distance))
    {
      color += weight * settings.Surroundings;
    }
  }
  return { { color.x, color.y, color.z, opacity } };
}

}

TransportImage TraceImage(const TransportMedium& medium, int width, int height,
  const SightLines& lines, const ImageTransportSettings& settings)
{
  TransportImage image = { RgbaImage(width, height), RgbaImage(width, height) };
  const double paths = static_cast<double>(settings.PathsPerPixel);
  vtkSMPTools::For(0, static_cast<vtkIdType>(width) * height, 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType pixel = begin; pixel < end; ++pixel)
      {
        const int i = static_cast<int>(pixel % width);
        const int j = static_cast<int>(pixel / width);
        const TransportRay ray = lines(i, j);
        std::array<double, 4> sums{};
        std::array<double, 4> squares{};
        for (std::uint64_t path = 0; path < settings.PathsPerPixel; ++path)
        {
          TransportRandom random(
            settings.Seed, static_cast<std::uint64_t>(pixel) * settings.PathsPerPixel + path);
          const std::array<double, 4> score = Follow(medium, ray, settings, random);
          for (std::size_t channel = 0; channel < 4; ++channel)
          {
            sums[channel] += score[channel];
            squares[channel] += score[channel] * score[channel];
          }
        }
        for (std::size_t channel = 0; channel < 4; ++channel)
        {
          const double mean = sums[channel] / paths;
          const double variance = std::max(squares[channel] / paths - mean * mean, 0.0);
          image.Mean.At(i, j)[channel] = mean;
          image.StandardError.At(i, j)[channel] = std::sqrt(variance / paths);
        }
      }
    });
  return image;
}

}
