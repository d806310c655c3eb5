// SPDX-License-Identifier: BSD-3-Clause
// The opacity that is estimated from a histogram: background and noise are transparent, and the
// rest is visible, for CT scans, signed data, labels, and data without a background.
#include "Support/Checks/ReferenceCheck.h"

#include "OpacityEstimate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using interlume::OpacityEstimate;
using interlume::ValueHistogram;
using Points = std::vector<OpacityEstimate::Point>;
using Values = std::vector<double>;

constexpr int SAMPLES = 100000;
constexpr double LARGEST = 0.8;
constexpr double LABEL = 0.3;

/// Normally distributed samples that are a fraction of all samples.
struct Part
{
  double Fraction;
  double Mean;
  double Deviation;
};

Values Draw(const std::vector<Part>& parts)
{
  std::mt19937 random(1);
  Values values;
  for (const Part& part : parts)
  {
    std::normal_distribution<double> distribution(part.Mean, part.Deviation);
    for (int i = 0; i < part.Fraction * SAMPLES; ++i)
    {
      values.push_back(distribution(random));
    }
  }
  return values;
}

Values Round(Values values, double smallest, double largest)
{
  for (double& value : values)
  {
    value = std::clamp(std::round(value), smallest, largest);
  }
  return values;
}

/// Estimates opacity from a histogram of values. The histogram's range excludes non-finite values.
Points Estimate(const Values& values, bool areIntegers)
{
  double range[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      range[0] = std::min(range[0], value);
      range[1] = std::max(range[1], value);
    }
  }
  ValueHistogram histogram = ValueHistogram::Make(range[0], range[1], areIntegers);
  for (const double value : values)
  {
    histogram.Add(value);
  }
  return OpacityEstimate::Find(histogram);
}

double Evaluate(const Points& points, double value)
{
  if (value <= points.front().Value)
  {
    return points.front().Opacity;
  }
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const OpacityEstimate::Point& a = points[i - 1];
    const OpacityEstimate::Point& b = points[i];
    if (value <= b.Value)
    {
      return a.Opacity + (b.Opacity - a.Opacity) * (value - a.Value) / (b.Value - a.Value);
    }
  }
  return points.back().Opacity;
}

/// Checks the order of the points, their largest opacity, and the fraction of values with a nonzero
/// opacity.
void CheckPoints(Check& check, const Points& points, const Values& values)
{
  check.That(points.size() >= 2, "has points");
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    check.That(points[i - 1].Value < points[i].Value, "ascending values");
  }
  double largest = 0.0;
  for (const OpacityEstimate::Point& point : points)
  {
    largest = std::max(largest, point.Opacity);
  }
  check.That(largest == LARGEST, "largest opacity");
  const auto shown = std::count_if(
    values.begin(), values.end(), [&](double value) { return Evaluate(points, value) > 0.0; });
  const double fraction = static_cast<double>(shown) / static_cast<double>(values.size());
  check.That(fraction > 0.09 && fraction < 0.61, "fraction shown: " + std::to_string(fraction));
}

void CheckScans(Check& check)
{
  check.SetContext("8 bits, noise cut off at 0");
  const Values bytes = Round(Draw({ { 0.8, 0.0, 8.0 }, { 0.2, 150.0, 10.0 } }), 0.0, 255.0);
  const Points byBytes = Estimate(bytes, true);
  CheckPoints(check, byBytes, bytes);
  check.That(Evaluate(byBytes, 24.0) == 0.0, "noise is transparent");
  check.That(Evaluate(byBytes, 150.0) > 0.3, "object is visible");

  check.SetContext("floating point, scaled and moved");
  Values numbers = bytes;
  for (double& value : numbers)
  {
    value = 3.0 + 1e-6 * value;
  }
  const Points byNumbers = Estimate(numbers, false);
  CheckPoints(check, byNumbers, numbers);
  for (const double value : { 0.0, 24.0, 130.0, 150.0, 170.0 })
  {
    const double error = Evaluate(byNumbers, 3.0 + 1e-6 * value) - Evaluate(byBytes, value);
    check.That(std::abs(error) < 0.05, "equals 8 bits at " + std::to_string(value));
  }

  check.SetContext("not a number and infinite");
  Values gaps = numbers;
  gaps.insert(gaps.end(), SAMPLES, std::numeric_limits<double>::quiet_NaN());
  gaps.push_back(std::numeric_limits<double>::infinity());
  gaps.push_back(-std::numeric_limits<double>::infinity());
  const Points byGaps = Estimate(gaps, false);
  check.That(std::equal(byGaps.begin(), byGaps.end(), byNumbers.begin(), byNumbers.end(),
               [](const OpacityEstimate::Point& a, const OpacityEstimate::Point& b)
               { return a.Value == b.Value && a.Opacity == b.Opacity; }),
    "ignored");

  // Samples outside the scanned circle are padding. In the second scan, more samples are padding
  // than air.
  for (const double padding : { 0.15, 0.35 })
  {
    check.SetContext("16 bits, " + std::to_string(padding) + " of the samples are padding");
    const double rest = 1.0 - padding;
    const Values scan = Round(Draw({ { padding, -2000.0, 0.0 }, { 0.5 * rest, -1000.0, 30.0 },
                                { 0.4 * rest, 50.0, 40.0 }, { 0.1 * rest, 800.0, 300.0 } }),
      -2000.0, 3000.0);
    const Points points = Estimate(scan, true);
    CheckPoints(check, points, scan);
    check.That(Evaluate(points, -2000.0) == 0.0, "padding is transparent");
    check.That(Evaluate(points, -920.0) == 0.0, "air is transparent");
    check.That(Evaluate(points, 50.0) > 0.1, "tissue is visible");
    check.That(Evaluate(points, 800.0) > Evaluate(points, 50.0) + 0.2, "bone is more opaque");
  }
}

void CheckSides(Check& check)
{
  std::mt19937 random(2);
  std::exponential_distribution<double> distance(1.0);
  Values both;
  Values below;
  for (int i = 0; i < SAMPLES; ++i)
  {
    both.push_back((i % 2 == 0 ? 1.0 : -1.0) * distance(random));
    below.push_back(-500.0 * distance(random));
  }
  check.SetContext("velocity component around 0");
  const Points onBoth = Estimate(both, false);
  CheckPoints(check, onBoth, both);
  check.That(Evaluate(onBoth, 0.0) == 0.0, "0 is transparent");
  for (const double value : { 1.0, 2.0, 3.0, 5.0 })
  {
    const double error = Evaluate(onBoth, value) - Evaluate(onBoth, -value);
    check.That(std::abs(error) < 0.05, "symmetric at " + std::to_string(value));
  }
  check.That(Evaluate(onBoth, 6.0) > 0.5, "fast is visible");

  check.SetContext("pressure below 0");
  const Points onOne = Estimate(below, false);
  CheckPoints(check, onOne, below);
  check.That(Evaluate(onOne, -100.0) == 0.0, "background is transparent");
  check.That(Evaluate(onOne, -3000.0) > 0.5, "low pressure is visible");
}

void CheckWithoutBackground(Check& check)
{
  const std::vector<std::pair<std::string, std::function<double(double)>>> distributions{
    { "uniform", [](double x) { return x; } },
    { "rising", [](double x) { return std::sqrt(x); } },
    { "falling", [](double x) { return 1.0 - std::sqrt(1.0 - x); } },
    { "bell", [](double x) { return std::asin(2.0 * x - 1.0); } },
  };
  for (const auto& [name, quantile] : distributions)
  {
    check.SetContext(name);
    Values values;
    for (int i = 0; i < SAMPLES; ++i)
    {
      values.push_back(quantile((i + 0.5) / SAMPLES));
    }
    CheckPoints(check, Estimate(values, false), values);
  }
}

void CheckLabels(Check& check)
{
  check.SetContext("labels");
  for (const double background : { 0.0, 3.0, 9.0 })
  {
    Values labels(SAMPLES, background);
    for (const double label : { 0.0, 3.0, 5.0, 9.0 })
    {
      labels.insert(labels.end(), SAMPLES / 10, label);
    }
    const Points points = Estimate(labels, true);
    for (const double label : { 0.0, 3.0, 5.0, 9.0 })
    {
      const double expected = label == background ? 0.0 : LABEL;
      check.That(Evaluate(points, label) == expected,
        std::to_string(label) + " if the background is " + std::to_string(background));
    }
  }
}

void CheckEmpty(Check& check)
{
  check.SetContext("nothing to see");
  check.That(Estimate({}, false).empty(), "no values");
  check.That(Estimate(Values(10, 5.0), false).empty(), "one value");
  check.That(Estimate(Values(10, 5.0), true).empty(), "one integer");
  check.That(Estimate(Values(10, std::nan("")), false).empty(), "not a number");
}

}

int TestOpacityEstimate(int, char*[])
{
  Check check;
  CheckScans(check);
  CheckSides(check);
  CheckWithoutBackground(check);
  CheckLabels(check);
  CheckEmpty(check);
  return check.Result();
}
