// SPDX-License-Identifier: BSD-3-Clause
#include "Lights/EmitterSamples.h"

#include "Lights/EmitterGrid.h"
#include "Space/UnitVector.h"

#include "vtkAreaLight.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace interlume
{

namespace
{

// Returns the second coordinate of a point of the net, multiplied by 2^32.
std::uint32_t GetNetDigits(std::uint32_t index)
{
  std::uint32_t digits = 0;
  std::uint32_t column = std::uint32_t(1) << 31;
  for (; index; index >>= 1)
  {
    digits ^= index & 1 ? column : 0;
    column |= column >> 1;
  }
  return digits;
}

// Returns the points of the net in the unit square. Each column and each row of a grid with count
// columns and rows contains one point, at the center of a cell.
std::vector<glm::dvec2> MakeNet(int count)
{
  std::vector<int> rows(static_cast<std::size_t>(count));
  std::iota(rows.begin(), rows.end(), 0);
  std::sort(rows.begin(), rows.end(),
    [](int a, int b)
    {
      return GetNetDigits(static_cast<std::uint32_t>(a)) <
        GetNetDigits(static_cast<std::uint32_t>(b));
    });
  std::vector<glm::dvec2> net(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    net[static_cast<std::size_t>(rows[row])] =
      glm::dvec2(rows[row] + 0.5, static_cast<double>(row) + 0.5) / static_cast<double>(count);
  }
  return net;
}

// Scales the weights of a channel so that their sum is 1. If all samples are 0 in this channel, the
// weights are equal. The weights are rounded to multiples of 2^-50, which add up without rounding
// errors in any order.
void NormalizeChannel(std::vector<EmitterSamples::Sample>& samples, int channel)
{
  const double unit = std::ldexp(1.0, -50);
  double total = 0.0;
  for (const EmitterSamples::Sample& sample : samples)
  {
    total += sample.Weight[channel];
  }
  double rest = 1.0;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    double& weight = samples[i].Weight[channel];
    weight = total > 0.0 ? weight / total : 1.0 / static_cast<double>(samples.size());
    weight = unit * std::round(weight / unit);
    rest -= weight;
    largest = weight > samples[largest].Weight[channel] ? i : largest;
  }
  samples[largest].Weight[channel] += rest;
}

}

std::vector<EmitterSamples::Sample> EmitterSamples::Make(
  bool isRound, const EmitterGrid* grid, int count)
{
  if (count <= 1)
  {
    return { Sample() };
  }
  std::vector<glm::dvec2> points = MakeNet(count);
  std::vector<glm::dvec3> colors(points.size(), glm::dvec3(1.0));
  const bool isUniform = !grid || grid->IsBlack();
  if (!isUniform)
  {
    colors = grid->Warp(points);
  }
  std::vector<Sample> samples(points.size());
  glm::dvec2 mean(0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    samples[i] = { EmitterGrid::MapToEmitter(isRound, points[i]), colors[i] };
    mean += samples[i].Position / static_cast<double>(count);
  }
  for (Sample& sample : samples)
  {
    // The mean of the net's points is slightly off center, by less than half a row, and would shift
    // the shadow.
    sample.Position -= isUniform ? mean : glm::dvec2(0.0);
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    NormalizeChannel(samples, channel);
  }
  return samples;
}

LightSource EmitterSamples::MakeSource(const LightSource& light, const Sample& sample)
{
  const glm::dvec3 offset =
    sample.Position.x * light.EmitterAxes[0] + sample.Position.y * light.EmitterAxes[1];
  LightSource source = light;
  source.Area = nullptr;
  if (light.IsPositional)
  {
    source.Position += offset;
  }
  else
  {
    source.Direction = UnitVector::Normalize(light.Direction - offset, light.Direction);
  }
  source.Ambient *= sample.Weight;
  source.Diffuse *= sample.Weight;
  source.Specular *= sample.Weight;
  return source;
}

std::vector<LightSource> EmitterSamples::Split(
  const std::vector<LightSource>& lights, const std::vector<int>& indices, int count)
{
  std::vector<LightSource> result;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const LightSource& light = lights[i];
    if (std::find(indices.begin(), indices.end(), static_cast<int>(i)) == indices.end())
    {
      result.push_back(light);
      continue;
    }
    for (const Sample& sample : Make(light, count))
    {
      result.push_back(MakeSource(light, sample));
    }
  }
  return result;
}

std::vector<EmitterSamples::Sample> EmitterSamples::Make(const LightSource& light, int count)
{
  return Make(light.Area->GetShape() == vtkAreaLight::ROUND, light.Area->GetGrid(), count);
}

}
