// SPDX-License-Identifier: BSD-3-Clause
// Samples of an emitter: moments of disk and square, stratification, weights, and images.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkAreaLight.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "Lights/EmitterGrid.h"
#include "Lights/EmitterSamples.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <functional>
#include <set>

namespace
{

using namespace reference;
using interlume::EmitterGrid;
using interlume::EmitterSamples;
using Samples = std::vector<EmitterSamples::Sample>;

// Creates an image with floating-point colors. \a color takes coordinates from -1/2 to 1/2.
vtkSmartPointer<vtkImageData> MakeImage(
  int width, int height, const std::function<glm::dvec3(double, double)>& color)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_DOUBLE, 3);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const glm::dvec3 c = color((i + 0.5) / width - 0.5, (j + 0.5) / height - 0.5);
      for (int k = 0; k < 3; ++k)
      {
        image->GetPointData()->GetScalars()->SetComponent(j * width + i, k, c[k]);
      }
    }
  }
  return image;
}

void CheckWeights(Check& check, const Samples& samples)
{
  glm::dvec3 sum(0.0);
  bool isPositive = true;
  for (const EmitterSamples::Sample& sample : samples)
  {
    sum += sample.Weight;
    isPositive =
      isPositive && sample.Weight.r >= 0.0 && sample.Weight.g >= 0.0 && sample.Weight.b >= 0.0;
  }
  check.That(sum == glm::dvec3(1.0), "the weights add up to exactly 1");
  check.That(isPositive, "no weight is below 0");
}

// Returns the weighted mean of f over the samples, with the weights of a color channel.
double GetMean(
  const Samples& samples, int channel, const std::function<double(const glm::dvec2&)>& f)
{
  double sum = 0.0;
  for (const EmitterSamples::Sample& sample : samples)
  {
    sum += sample.Weight[channel] * f(sample.Position);
  }
  return sum;
}

double X(const glm::dvec2& p)
{
  return p.x;
}
double Y(const glm::dvec2& p)
{
  return p.y;
}

// A square of side 1 has the variance 1/12 along each axis, and a disk of radius R = 1/2 has R^2/4.
// The variance of N samples of the square is (1 - 1/N^2) / 12.
void CheckMoments(Check& check)
{
  for (const bool isRound : { false, true })
  {
    const double variance = isRound ? 0.25 * 0.25 : 1.0 / 12.0;
    for (const int count : { 4, 7, 16, 64, 100, 256, 1024 })
    {
      check.SetContext((isRound ? "disk of " : "square of ") + std::to_string(count));
      const Samples samples = EmitterSamples::Make(isRound, nullptr, count);
      check.Equal(static_cast<long long>(samples.size()), count, "samples");
      CheckWeights(check, samples);
      const double bound = isRound ? 0.6 / count : 1.01 / (count * count);
      check.Near(GetMean(samples, 0, X), 0.0, 1e-13, "mean of x", 1.0);
      check.Near(GetMean(samples, 0, Y), 0.0, 1e-13, "mean of y", 1.0);
      check.Near(GetMean(samples, 1, [](const glm::dvec2& p) { return p.x * p.x; }), variance,
        bound, "variance of x");
      check.Near(GetMean(samples, 2, [](const glm::dvec2& p) { return p.y * p.y; }), variance,
        bound, "variance of y");
      check.Near(GetMean(samples, 0, [](const glm::dvec2& p) { return p.x * p.y; }) / variance, 0.0,
        1.6 / count, "covariance", 1.0);
      for (const EmitterSamples::Sample& sample : samples)
      {
        const glm::dvec2& p = sample.Position;
        check.That(isRound ? glm::dot(p, p) <= 0.25 : std::max(std::abs(p.x), std::abs(p.y)) <= 0.5,
          "inside");
        check.That(sample.Weight == glm::dvec3(1.0 / count) ||
            std::abs(sample.Weight.r * count - 1.0) < 1e-11,
          "equal weights");
      }
    }
  }
}

// If the number N of samples is a power of 2, every grid of N cells whose number of columns is a
// power of 2 has one sample in each cell. For any N, each of N columns contains one sample, and no
// two samples have the same x or y.
void CheckStrata(Check& check)
{
  for (const int count : { 2, 3, 8, 10, 32, 77, 256 })
  {
    check.SetContext("strata of " + std::to_string(count));
    const Samples samples = EmitterSamples::Make(false, nullptr, count);
    const bool isPower = (count & (count - 1)) == 0;
    for (int columns = 1; columns <= count; columns *= isPower ? 2 : count)
    {
      if (!isPower && columns == 1)
      {
        continue;
      }
      const int rows = count / columns;
      std::set<int> cells;
      std::set<double> across;
      std::set<double> up;
      for (const EmitterSamples::Sample& sample : samples)
      {
        const int i = static_cast<int>(std::floor((sample.Position.x + 0.5) * columns));
        const int j = static_cast<int>(std::floor((sample.Position.y + 0.5) * rows));
        cells.insert(j * columns + i);
        across.insert(sample.Position.x);
        up.insert(sample.Position.y);
      }
      check.Equal(static_cast<long long>(cells.size()), count, "cells with a sample");
      check.Equal(static_cast<long long>(across.size()), count, "distinct x coordinates");
      check.Equal(static_cast<long long>(up.size()), count, "distinct y coordinates");
    }
  }
}

// Compares the fraction of samples in segments of a disk with the segments' relative area.
void CheckSegments(Check& check)
{
  double largest = 0.0;
  const int count = 256;
  const Samples samples = EmitterSamples::Make(true, nullptr, count);
  for (int rotation = 0; rotation < 36; ++rotation)
  {
    const double angle = rotation * 3.141592653589793 / 36.0;
    for (const double distance : { -0.4, -0.2, 0.0, 0.1, 0.3, 0.45 })
    {
      const double below = GetMean(samples, 0,
        [&](const glm::dvec2& p)
        { return p.x * std::cos(angle) + p.y * std::sin(angle) < distance ? 1.0 : 0.0; });
      const double t = 2.0 * distance;
      const double area = 1.0 - (std::acos(t) - t * std::sqrt(1.0 - t * t)) / 3.141592653589793;
      reference::KeepLargest(largest, std::abs(below - area));
    }
  }
  check.SetContext("segments");
  check.That(largest < 0.02, "largest error " + std::to_string(largest) + " below 0.02");
}

void CheckSingleSample(Check& check)
{
  check.SetContext("one sample");
  const auto image =
    MakeImage(4, 4, [](double x, double) { return glm::dvec3(x + 0.5, 0.0, 0.0); });
  for (const int count : { 1, 0, -3 })
  {
    const EmitterGrid grid(true, image);
    for (const EmitterGrid* emitter : { static_cast<const EmitterGrid*>(nullptr), &grid })
    {
      const Samples samples = EmitterSamples::Make(true, emitter, count);
      check.That(samples.size() == 1 && samples[0].Position == glm::dvec2(0.0) &&
          samples[0].Weight == glm::dvec3(1.0),
        "the center of the emitter");
    }
  }
}

void CheckImages(Check& check)
{
  check.SetContext("a ramp whose green decreases");
  const auto ramp = MakeImage(
    64, 32, [](double x, double y) { return glm::dvec3(0.5 + x, 0.25 - 0.5 * x, 0.3 + 0.4 * y); });
  const EmitterGrid rampGrid(false, ramp);
  for (const int count : { 16, 100, 1024 })
  {
    const Samples samples = EmitterSamples::Make(false, &rampGrid, count);
    CheckWeights(check, samples);
    // The centroid of red is the integral of x (1/2 + x), divided by the integral of 1/2 + x.
    check.Near(GetMean(samples, 0, X), 1.0 / 6.0, 0.3 / count + 1e-3, "center of red", 1.0);
    check.Near(GetMean(samples, 1, X), -1.0 / 6.0, 0.3 / count + 1e-3, "center of green", 1.0);
    check.Near(GetMean(samples, 2, Y), 0.4 / 12.0 / 0.3, 0.5 / count + 1e-3,
      "height of the center of blue", 1.0);
    std::set<double> across;
    std::set<double> up;
    for (const EmitterSamples::Sample& sample : samples)
    {
      across.insert(sample.Position.x);
      up.insert(sample.Position.y);
    }
    check.Equal(static_cast<long long>(across.size()), count, "distinct x coordinates");
    check.Equal(static_cast<long long>(up.size()), count, "distinct y coordinates");
  }

  check.SetContext("a spot on black");
  const auto spot = MakeImage(256, 256,
    [](double x, double y)
    { return std::hypot(x - 0.2, y + 0.1) < 0.05 ? glm::dvec3(1.0, 0.5, 0.0) : glm::dvec3(0.0); });
  for (const bool isRound : { false, true })
  {
    const EmitterGrid grid(isRound, spot);
    const Samples samples = EmitterSamples::Make(isRound, &grid, 16);
    CheckWeights(check, samples);
    for (const EmitterSamples::Sample& sample : samples)
    {
      check.Near(std::hypot(sample.Position.x - 0.2, sample.Position.y + 0.1), 0.0, 0.06,
        "samples are inside the spot", 1.0);
      check.Near(sample.Weight.b, 1.0 / 16.0, 1e-12, "the weight of a channel without light");
    }
    const glm::dvec3 color = grid.GetColor();
    check.That(
      color.r == 1.0 && std::abs(color.g - 0.5) < 1e-9 && color.b == 0.0, "the color of the spot");
  }

  check.SetContext("a disk that excludes the corners of an image");
  const auto corners = MakeImage(200, 200,
    [](double x, double y)
    { return std::hypot(x, y) < 0.52 ? glm::dvec3(0.2, 0.4, 0.1) : glm::dvec3(1.0, 0.0, 0.0); });
  const glm::dvec3 inside = EmitterGrid(true, corners).GetColor();
  check.Near(inside.r, 0.5, 1e-9, "red");
  check.Near(inside.b, 0.25, 1e-9, "blue");
  check.That(EmitterGrid(false, corners).GetColor().r > 0.9, "a square includes the corners");

  check.SetContext("black");
  const auto black = MakeImage(3, 2, [](double, double) { return glm::dvec3(0.0); });
  const EmitterGrid blackGrid(true, black);
  check.That(blackGrid.GetColor() == glm::dvec3(0.0), "no light");
  const Samples samples = EmitterSamples::Make(true, &blackGrid, 8);
  CheckWeights(check, samples);
  check.Near(GetMean(samples, 0, X), 0.0, 1e-15,
    "the samples of a black emitter are those of a uniform emitter", 1.0);
}

// A light caches the colors of its image, and updates them when the pixels, the image or the shape
// change.
void CheckCachedColors(Check& check)
{
  check.SetContext("cached colors");
  const auto image =
    MakeImage(64, 64, [](double x, double) { return glm::dvec3(x < 0.0 ? 1.0 : 0.0); });
  const auto other =
    MakeImage(64, 64, [](double x, double) { return glm::dvec3(x < 0.0 ? 0.0 : 1.0, 0.0, 0.0); });
  vtkNew<vtkAreaLight> light;
  light->SetEmitter(image);
  const auto areEqual = [&](const std::string& name)
  {
    vtkNew<vtkAreaLight> fresh;
    fresh->SetShape(light->GetShape());
    fresh->SetEmitter(light->GetEmitter());
    const std::vector<vtkAreaLight::Sample> found = light->GetSamples(16);
    const std::vector<vtkAreaLight::Sample> expected = fresh->GetSamples(16);
    double colors[2][3];
    light->GetEmitterColor(colors[0]);
    fresh->GetEmitterColor(colors[1]);
    bool isEqual =
      found.size() == expected.size() && std::equal(colors[0], colors[0] + 3, colors[1]);
    for (std::size_t i = 0; isEqual && i < found.size(); ++i)
    {
      isEqual = std::equal(found[i].Position, found[i].Position + 3, expected[i].Position) &&
        std::equal(found[i].Weight, found[i].Weight + 3, expected[i].Weight);
    }
    return check.That(isEqual, name);
  };
  areEqual("an image");
  light->SetShapeToSquare();
  areEqual("another shape");
  light->SetEmitter(other);
  areEqual("another image");
  vtkDataArray* values = other->GetPointData()->GetScalars();
  double before[3];
  light->GetEmitterColor(before);
  values->FillComponent(2, 1.0);
  double cached[3];
  light->GetEmitterColor(cached);
  check.That(std::equal(before, before + 3, cached), "changes without Modified() are ignored");
  values->Modified();
  areEqual("other values");
  light->SetEmitter(nullptr);
  areEqual("no image");
}

// The light sources that replace an area light have the positions or directions of its samples, and
// their colors add up to the light's color.
void CheckSources(Check& check)
{
  check.SetContext("sources");
  for (const bool isPositional : { true, false })
  {
    interlume::LightSource light;
    light.IsPositional = isPositional;
    light.Position = { 1.0, 2.0, 5.0 };
    light.Direction = { 0.0, 0.0, -1.0 };
    light.Ambient = glm::dvec3(0.1);
    light.EmitterAxes = { glm::dvec3(0.5, 0.0, 0.0), glm::dvec3(0.0, 0.25, 0.0) };
    glm::dvec3 diffuse(0.0);
    for (const EmitterSamples::Sample& sample : EmitterSamples::Make(true, nullptr, 8))
    {
      const interlume::LightSource source = EmitterSamples::MakeSource(light, sample);
      diffuse += source.Diffuse;
      const glm::dvec3 offset(0.5 * sample.Position.x, 0.25 * sample.Position.y, 0.0);
      const glm::dvec3 position = isPositional ? light.Position + offset : light.Position;
      const glm::dvec3 direction =
        isPositional ? light.Direction : glm::normalize(light.Direction - offset);
      check.Near(glm::length(source.Position - position), 0.0, 1e-15, "position", 1.0);
      check.Near(glm::length(source.Direction - direction), 0.0, 1e-15, "direction", 1.0);
      check.That(!source.Area, "a sample has no extent");
    }
    check.Near(glm::length(diffuse - light.Diffuse), 0.0, 1e-15, "colors add up", 1.0);
  }
}
}

int TestEmitterSamples(int, char*[])
{
  Check check;
  CheckMoments(check);
  CheckStrata(check);
  CheckSegments(check);
  CheckSingleSample(check);
  CheckImages(check);
  CheckCachedColors(check);
  CheckSources(check);
  return check.Result();
}
