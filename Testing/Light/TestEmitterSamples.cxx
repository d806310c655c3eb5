// SPDX-License-Identifier: BSD-3-Clause
// Samples of an emitter: moments of disc and square, strata, weights, and the light of images.
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

// An image of floating point colours, x and y from -1/2 to 1/2.
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
  check.That(sum == glm::dvec3(1.0), "weights are exactly 1 in sum");
  check.That(isPositive, "no weight is below 0");
}

// The mean of f over the samples, weighted by a channel.
double GetMean(
  const Samples& samples, int channel, const std::function<double(const glm::dvec2&)>& f)
{
  double sum = 0.0;
  for (const EmitterSamples::Sample& sample : samples)
  {
    sum += sample.Weight[channel] * f(sample.Place);
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

// A square of edge 1 has a variance of 1/12 along each axis, a disc of radius R = 1/2 R^2/4; the
// variance of N samples of the square is (1 - 1/N^2) / 12.
void CheckMoments(Check& check)
{
  for (const bool isRound : { false, true })
  {
    const double variance = isRound ? 0.25 * 0.25 : 1.0 / 12.0;
    for (const int count : { 4, 7, 16, 64, 100, 256, 1024 })
    {
      check.SetContext((isRound ? "disc of " : "square of ") + std::to_string(count));
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
        const glm::dvec2& p = sample.Place;
        check.That(isRound ? glm::dot(p, p) <= 0.25 : std::max(std::abs(p.x), std::abs(p.y)) <= 0.5,
          "inside");
        check.That(sample.Weight == glm::dvec3(1.0 / count) ||
            std::abs(sample.Weight.r * count - 1.0) < 1e-11,
          "equal weights");
      }
    }
  }
}

// Each rectangle of area 1/N that columns and rows of powers of 2 make has one sample, and each
// column and row of any number of samples.
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
        const int i = static_cast<int>(std::floor((sample.Place.x + 0.5) * columns));
        const int j = static_cast<int>(std::floor((sample.Place.y + 0.5) * rows));
        cells.insert(j * columns + i);
        across.insert(sample.Place.x);
        up.insert(sample.Place.y);
      }
      check.Equal(static_cast<long long>(cells.size()), count, "rectangles with a sample");
      check.Equal(static_cast<long long>(across.size()), count, "distinct in x");
      check.Equal(static_cast<long long>(up.size()), count, "distinct in y");
    }
  }
}

// The share of the samples of a disc on one side of a line that turns, against the segment's area.
void CheckSegments(Check& check)
{
  double worst = 0.0;
  const int count = 256;
  const Samples samples = EmitterSamples::Make(true, nullptr, count);
  for (int turn = 0; turn < 36; ++turn)
  {
    const double angle = turn * 3.141592653589793 / 36.0;
    for (const double distance : { -0.4, -0.2, 0.0, 0.1, 0.3, 0.45 })
    {
      const double below = GetMean(samples, 0,
        [&](const glm::dvec2& p)
        { return p.x * std::cos(angle) + p.y * std::sin(angle) < distance ? 1.0 : 0.0; });
      const double t = 2.0 * distance;
      const double area = 1.0 - (std::acos(t) - t * std::sqrt(1.0 - t * t)) / 3.141592653589793;
      worst = std::max(worst, std::abs(below - area));
    }
  }
  check.SetContext("segments");
  check.That(worst < 0.02, "worst " + std::to_string(worst) + " below 0.02");
}

void CheckFew(Check& check)
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
      check.That(samples.size() == 1 && samples[0].Place == glm::dvec2(0.0) &&
          samples[0].Weight == glm::dvec3(1.0),
        "the centre");
    }
  }
}

void CheckImages(Check& check)
{
  check.SetContext("a ramp, of which green falls");
  const auto ramp = MakeImage(
    64, 32, [](double x, double y) { return glm::dvec3(0.5 + x, 0.25 - 0.5 * x, 0.3 + 0.4 * y); });
  const EmitterGrid rampGrid(false, ramp);
  for (const int count : { 16, 100, 1024 })
  {
    const Samples samples = EmitterSamples::Make(false, &rampGrid, count);
    CheckWeights(check, samples);
    // The integral of x (1/2 + x) over that of 1/2 + x.
    check.Near(GetMean(samples, 0, X), 1.0 / 6.0, 0.3 / count + 1e-3, "centre of red", 1.0);
    check.Near(GetMean(samples, 1, X), -1.0 / 6.0, 0.3 / count + 1e-3, "centre of green", 1.0);
    check.Near(
      GetMean(samples, 2, Y), 0.4 / 12.0 / 0.3, 0.5 / count + 1e-3, "height of blue's centre", 1.0);
    std::set<double> across;
    std::set<double> up;
    for (const EmitterSamples::Sample& sample : samples)
    {
      across.insert(sample.Place.x);
      up.insert(sample.Place.y);
    }
    check.Equal(static_cast<long long>(across.size()), count, "distinct in x");
    check.Equal(static_cast<long long>(up.size()), count, "distinct in y");
  }

  check.SetContext("a spot in the dark");
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
      check.Near(
        std::hypot(sample.Place.x - 0.2, sample.Place.y + 0.1), 0.0, 0.06, "in the spot", 1.0);
      check.Near(sample.Weight.b, 1.0 / 16.0, 1e-12, "the weight of a channel that is nowhere");
    }
    const glm::dvec3 color = grid.GetColor();
    check.That(color.r == 1.0 && std::abs(color.g - 0.5) < 1e-9 && color.b == 0.0, "its colour");
  }

  check.SetContext("a disc that has the middle of an image alone");
  const auto corners = MakeImage(200, 200,
    [](double x, double y)
    { return std::hypot(x, y) < 0.52 ? glm::dvec3(0.2, 0.4, 0.1) : glm::dvec3(1.0, 0.0, 0.0); });
  const glm::dvec3 inside = EmitterGrid(true, corners).GetColor();
  check.Near(inside.r, 0.5, 1e-9, "red");
  check.Near(inside.b, 0.25, 1e-9, "blue");
  check.That(EmitterGrid(false, corners).GetColor().r > 0.9, "a square has the corners");

  check.SetContext("black");
  const auto black = MakeImage(3, 2, [](double, double) { return glm::dvec3(0.0); });
  const EmitterGrid blackGrid(true, black);
  check.That(blackGrid.GetColor() == glm::dvec3(0.0), "no light");
  const Samples samples = EmitterSamples::Make(true, &blackGrid, 8);
  CheckWeights(check, samples);
  check.Near(GetMean(samples, 0, X), 0.0, 1e-15, "samples as of a uniform one", 1.0);
}

// A light keeps the colours of its image, and finds them again where they, the image or the shape
// have changed.
void CheckKept(Check& check)
{
  check.SetContext("kept colours");
  const auto image =
    MakeImage(64, 64, [](double x, double) { return glm::dvec3(x < 0.0 ? 1.0 : 0.0); });
  const auto other =
    MakeImage(64, 64, [](double x, double) { return glm::dvec3(x < 0.0 ? 0.0 : 1.0, 0.0, 0.0); });
  vtkNew<vtkAreaLight> light;
  light->SetEmitter(image);
  const auto areEqual = [&](const std::string& name)
  {
    vtkNew<vtkAreaLight> anew;
    anew->SetShape(light->GetShape());
    anew->SetEmitter(light->GetEmitter());
    const std::vector<vtkAreaLight::Sample> found = light->GetSamples(16);
    const std::vector<vtkAreaLight::Sample> expected = anew->GetSamples(16);
    double colors[2][3];
    light->GetEmitterColor(colors[0]);
    anew->GetEmitterColor(colors[1]);
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
  double kept[3];
  light->GetEmitterColor(kept);
  check.That(std::equal(before, before + 3, kept), "values that are not known to have changed");
  values->Modified();
  areEqual("other values");
  light->SetEmitter(nullptr);
  areEqual("no image");
}

// The lights that stand for samples: where they are, and that their colours are the light's.
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
      const glm::dvec3 offset(0.5 * sample.Place.x, 0.25 * sample.Place.y, 0.0);
      const glm::dvec3 position = isPositional ? light.Position + offset : light.Position;
      const glm::dvec3 direction =
        isPositional ? light.Direction : glm::normalize(light.Direction - offset);
      check.Near(glm::length(source.Position - position), 0.0, 1e-15, "position", 1.0);
      check.Near(glm::length(source.Direction - direction), 0.0, 1e-15, "direction", 1.0);
      check.That(!source.Area, "without extent");
    }
    check.Near(glm::length(diffuse - light.Diffuse), 0.0, 1e-15, "colours add up", 1.0);
  }
}
}

int TestEmitterSamples(int, char*[])
{
  Check check;
  CheckMoments(check);
  CheckStrata(check);
  CheckSegments(check);
  CheckFew(check);
  CheckImages(check);
  CheckKept(check);
  CheckSources(check);
  return check.Result();
}
