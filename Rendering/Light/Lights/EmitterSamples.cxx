// SPDX-License-Identifier: BSD-3-Clause
#include "Lights/EmitterSamples.h"

#include "Lights/LightImage.h"
#include "Space/UnitVector.h"

#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkMath.h"

#include <cstdint>
#include <numeric>

namespace interlume
{

namespace
{

// Computes the second coordinate of a point of the net, 32 binary digits.
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

// Computes points of the unit square, in the middle of their columns and rows.
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

// Maps the unit square to the emitter and keeps areas.
glm::dvec2 GetPlace(bool isRound, const glm::dvec2& point)
{
  const glm::dvec2 place = point - 0.5;
  if (!isRound || place == glm::dvec2(0.0))
  {
    return place;
  }
  const bool isWide = std::abs(place.x) > std::abs(place.y);
  const double radius = isWide ? place.x : place.y;
  const double angle =
    0.25 * vtkMath::Pi() * (isWide ? place.y / place.x : 2.0 - place.x / place.y);
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

// The colours of an emitter at the middles of the cells of a grid of the unit square.
class ColorGrid
{
public:
  ColorGrid(bool isRound, vtkImageData* image)
  {
    int size[3];
    image->GetDimensions(size);
    this->Size = std::min(std::max({ 128, size[0], size[1] }), 512);
    this->Colors.reserve(static_cast<std::size_t>(this->Size) * this->Size);
    const LightImage colors(image);
    for (int j = 0; j < this->Size; ++j)
    {
      for (int i = 0; i < this->Size; ++i)
      {
        const glm::dvec2 place =
          GetPlace(isRound, glm::dvec2(i + 0.5, j + 0.5) / static_cast<double>(this->Size)) + 0.5;
        this->Colors.push_back(colors.GetColor(place.x, place.y, true));
      }
    }
  }

  glm::dvec3 GetMean() const
  {
    return std::accumulate(this->Colors.begin(), this->Colors.end(), glm::dvec3(0.0)) /
      static_cast<double>(this->Colors.size());
  }

  // Moves points that are spread evenly to where the emitter is bright; returns their colours, each
  // over its own brightness. The emitter is not black.
  std::vector<glm::dvec3> Warp(std::vector<glm::dvec2>& points) const
  {
    const auto size = static_cast<std::size_t>(this->Size);
    std::vector<double> rows;
    std::vector<std::vector<double>> columns(size);
    double total = 0.0;
    for (std::size_t j = 0; j < size; ++j)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < size; ++i)
      {
        columns[j].push_back(sum += GetBrightness(this->Colors[j * size + i]));
      }
      rows.push_back(total += sum);
    }
    std::vector<glm::dvec3> colors;
    for (glm::dvec2& point : points)
    {
      const std::size_t j = Find(rows, point.y);
      const std::size_t i = Find(columns[j], point.x);
      const glm::dvec3& color = this->Colors[j * size + i];
      colors.push_back(color / GetBrightness(color));
    }
    return colors;
  }

private:
  static double GetBrightness(const glm::dvec3& color) { return color.r + color.g + color.b; }

  // Finds the cell in which the sums reach a share of the last one; the share becomes the place.
  static std::size_t Find(const std::vector<double>& sums, double& share)
  {
    const double sum = share * sums.back();
    // The first sum above it ends a cell that is not black.
    const auto above = std::upper_bound(sums.begin(), sums.end(), sum);
    const auto cell = static_cast<std::size_t>(above - sums.begin());
    const double before = cell > 0 ? sums[cell - 1] : 0.0;
    share = (static_cast<double>(cell) + (sum - before) / (sums[cell] - before)) /
      static_cast<double>(sums.size());
    return cell;
  }

  int Size = 0;
  std::vector<glm::dvec3> Colors;
};

// Scales the weights of a channel so that their sum is 1; all are the same where the samples have
// nothing of it. As multiples of 2^-50 they are added without rounding, in any order.
void Normalize(std::vector<EmitterSamples::Sample>& samples, int channel)
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
  bool isRound, vtkImageData* image, int count)
{
  if (count <= 1)
  {
    return { Sample() };
  }
  std::vector<glm::dvec2> points = MakeNet(count);
  std::vector<glm::dvec3> colors(points.size(), glm::dvec3(1.0));
  bool isUniform = true;
  if (image)
  {
    const ColorGrid grid(isRound, image);
    isUniform = grid.GetMean() == glm::dvec3(0.0);
    colors = isUniform ? colors : grid.Warp(points);
  }
  std::vector<Sample> samples(points.size());
  glm::dvec2 mean(0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    samples[i] = { GetPlace(isRound, points[i]), colors[i] };
    mean += samples[i].Place / static_cast<double>(count);
  }
  for (Sample& sample : samples)
  {
    // The mean of the net is some thousandths off, less than half a row, and would move the shadow.
    sample.Place -= isUniform ? mean : glm::dvec2(0.0);
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    Normalize(samples, channel);
  }
  return samples;
}

LightSource EmitterSamples::MakeSource(const LightSource& light, const Sample& sample)
{
  const glm::dvec3 offset =
    sample.Place.x * light.EmitterAxes[0] + sample.Place.y * light.EmitterAxes[1];
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
  return Make(light.Area->GetShape() == vtkAreaLight::ROUND, light.Area->GetEmitter(), count);
}

glm::dvec3 EmitterSamples::GetColor(bool isRound, vtkImageData* image)
{
  if (!image)
  {
    return glm::dvec3(1.0);
  }
  const glm::dvec3 mean = ColorGrid(isRound, image).GetMean();
  const double largest = std::max({ mean.r, mean.g, mean.b });
  return largest > 0.0 ? mean / largest : mean;
}

}
