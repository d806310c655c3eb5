// SPDX-License-Identifier: BSD-3-Clause
#include "OpacityEstimate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace interlume
{

namespace
{

using Counts = std::vector<double>;
using Points = std::vector<OpacityEstimate::Point>;

constexpr int MAXIMUM_BINS = 1024;
constexpr int MAXIMUM_LABELS = 16;
constexpr double LABEL_OPACITY = 0.3;
constexpr double LARGEST_OPACITY = 0.8;
/// Fraction of the samples that is cut off at the end of a tail.
constexpr double TAIL = 1e-3;
/// Minimum fraction of the samples to show.
constexpr double LEAST = 0.1;
/// Fraction of the samples to show if the histogram has no bend.
constexpr double RARE = 0.15;
/// Maximum fraction of the samples to show.
constexpr double MOST = 0.6;
/// A bin with a smaller fraction of the samples counts as empty.
constexpr double NEGLIGIBLE = 1e-5;
/// Minimum depth of a bend below the straight line, relative to the difference in height between
/// the ends of that line.
constexpr double SMALLEST_BEND = 0.1;
/// Both sides of the background are shown if the ratio of their numbers of samples is at least this
/// value.
constexpr double SIMILAR = 0.2;
/// The last bin of a side is padding if it has more than this fraction of the samples that the side
/// shows.
constexpr double PADDING = 0.9;

/// Returns the moving average over about \a width bins.
Counts Smooth(const Counts& counts, int width)
{
  const int size = static_cast<int>(counts.size());
  Counts sums(counts.size() + 1);
  std::partial_sum(counts.begin(), counts.end(), sums.begin() + 1);
  Counts means(counts.size());
  for (int i = 0; i < size; ++i)
  {
    const int begin = std::max(0, i - width / 2);
    const int end = std::min(size, i + width / 2 + 1);
    means[i] = (sums[end] - sums[begin]) / (end - begin);
  }
  return means;
}

/// Returns the highest bin of the peak with the most samples. A wide window finds the peak, and a
/// narrow one its highest bin.
int FindPeak(const Counts& counts, const Counts& smoothed)
{
  const int size = static_cast<int>(counts.size());
  const Counts wide = Smooth(counts, size / 32);
  const int center = static_cast<int>(std::max_element(wide.begin(), wide.end()) - wide.begin());
  const auto begin = smoothed.begin() + std::max(0, center - size / 64);
  const auto end = smoothed.begin() + std::min(size, center + size / 64 + 1);
  return static_cast<int>(std::max_element(begin, end) - smoothed.begin());
}

/// The bins on one side of the background, numbered from its peak. Fractions are relative to all
/// samples, not only those of this side.
struct Side
{
  Counts Tail; ///< Fraction of the samples in a bin and all bins after it.
  int Threshold = 0;
  int End = 0; ///< 0 if there is nothing to show.

  Side(const Counts& counts, const Counts& smoothed, double total);
  int FindQuantile(double fraction) const
  {
    const auto found = std::find_if(
      this->Tail.begin(), this->Tail.end(), [=](double tail) { return tail <= fraction; });
    return static_cast<int>(found - this->Tail.begin());
  }
  /// Returns the fraction of the samples that this side shows.
  double GetFraction() const { return this->End > 0 ? this->Tail[this->Threshold] : 0.0; }
  /// Returns the fraction of the samples that are at least \a distance bins from the peak.
  double GetFraction(int distance) const
  {
    return static_cast<std::size_t>(distance) < this->Tail.size() ? this->Tail[distance] : 0.0;
  }
  /// Returns true if this side has nothing to show, or far fewer samples than \a other in the range
  /// of distances from the peak that both sides show.
  bool IsMinorTo(const Side& other) const
  {
    const int distance = std::max(this->Threshold, other.Threshold);
    return this->End == 0 || this->GetFraction(distance) < SIMILAR * other.GetFraction(distance);
  }
  /// Returns true if nearly all samples shown are in the last bin.
  bool IsPadding() const { return this->Tail.back() > PADDING * this->GetFraction(); }
  struct Step
  {
    int Bin;
    double Opacity;
  };
  /// Returns the opacity function of this side, which shows at least the fraction \a least of the
  /// samples.
  std::vector<Step> GetSteps(double least) const;
};

Side::Side(const Counts& counts, const Counts& smoothed, double total)
  : Tail(counts.size())
{
  double sum = 0.0;
  for (std::size_t i = counts.size(); i-- > 0;)
  {
    sum += counts[i];
    this->Tail[i] = sum / total;
  }
  const int end = this->FindQuantile(TAIL) - 1;
  if (end < 2)
  {
    return;
  }
  this->End = end;
  const auto height = [&](int bin)
  { return std::log(std::max(smoothed[bin] / total, NEGLIGIBLE)); };
  const double slope = (height(end) - height(0)) / end;
  double bend = 0.0;
  for (int bin = 0; bin <= end; ++bin)
  {
    const double depth = height(0) + slope * bin - height(bin);
    if (depth > bend)
    {
      bend = depth;
      this->Threshold = bin;
    }
  }
  if (bend <= -SMALLEST_BEND * slope * end)
  {
    this->Threshold = this->FindQuantile(RARE);
  }
  this->Threshold = std::clamp(this->Threshold, 0, end);
}

std::vector<Side::Step> Side::GetSteps(double least) const
{
  std::vector<Step> steps;
  if (this->End == 0)
  {
    return steps;
  }
  const int threshold =
    std::clamp(std::min(this->Threshold, this->FindQuantile(least)), 1, this->End - 1);
  steps.push_back({ threshold, 0.0 });
  for (const double rank : { 0.25, 0.5, 0.75 })
  {
    const int bin = this->FindQuantile((1.0 - rank) * this->Tail[threshold]);
    if (bin > steps.back().Bin && bin < this->End)
    {
      steps.push_back({ bin, rank * LARGEST_OPACITY });
    }
  }
  steps.push_back({ this->End, LARGEST_OPACITY });
  return steps;
}

/// Returns the points of the opacity function for a histogram of labels. \a bins are the nonempty
/// bins.
Points FindLabelPoints(const ValueHistogram& histogram, const std::vector<int>& bins)
{
  const auto background = std::max_element(bins.begin(), bins.end(),
    [&](int a, int b) { return histogram.Counts[a] < histogram.Counts[b]; });
  const double center = histogram.GetCenter(*background);
  Points points;
  if (background != bins.begin())
  {
    const double lower = histogram.GetCenter(*std::prev(background));
    points.push_back({ 0.5 * (lower + center), LABEL_OPACITY });
  }
  points.push_back({ center, 0.0 });
  if (std::next(background) != bins.end())
  {
    const double upper = histogram.GetCenter(*std::next(background));
    points.push_back({ 0.5 * (center + upper), LABEL_OPACITY });
  }
  return points;
}

}

ValueHistogram ValueHistogram::Make(double smallest, double largest, bool areIntegers)
{
  ValueHistogram result;
  const double length = largest - smallest;
  double bins = MAXIMUM_BINS;
  result.First = smallest;
  result.Width = length / bins;
  if (areIntegers)
  {
    result.Width = std::ceil((length + 1.0) / bins);
    bins = std::ceil((length + 1.0) / result.Width);
    result.First = smallest - 0.5;
  }
  result.Counts.resize(static_cast<std::size_t>(bins));
  return result;
}

void ValueHistogram::Add(double value, double weight)
{
  const double bin = std::floor((value - this->First) / this->Width);
  const auto size = static_cast<double>(this->Counts.size());
  if (bin >= 0.0 && bin <= size) // the largest value is at the end of the last bin
  {
    this->Counts[static_cast<std::size_t>(std::min(bin, size - 1.0))] += weight;
  }
}

std::vector<OpacityEstimate::Point> OpacityEstimate::Find(const ValueHistogram& histogram)
{
  Counts counts = histogram.Counts;
  std::vector<int> filled;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    if (counts[i] > 0.0)
    {
      filled.push_back(static_cast<int>(i));
    }
  }
  if (filled.size() < 2)
  {
    return {};
  }
  if (filled.size() <= MAXIMUM_LABELS)
  {
    return FindLabelPoints(histogram, filled);
  }
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  const int size = static_cast<int>(counts.size());
  Points points;
  for (bool isFound = false; !isFound;)
  {
    const Counts smoothed = Smooth(counts, size / 128);
    const int peak = FindPeak(counts, smoothed);
    const Side upper(Counts(counts.begin() + peak, counts.end()),
      Counts(smoothed.begin() + peak, smoothed.end()), total);
    const Side lower(Counts(counts.rend() - peak - 1, counts.rend()),
      Counts(smoothed.rend() - peak - 1, smoothed.rend()), total);
    const bool isPadded = lower.IsPadding() && upper.GetFraction() > TAIL;
    const bool isLower = !isPadded && !lower.IsMinorTo(upper);
    const bool isUpper = !isLower || !upper.IsMinorTo(lower);
    isFound = isLower || upper.GetFraction() <= MOST || upper.Threshold == 0;
    if (!isFound)
    {
      std::fill_n(counts.begin(), peak + upper.Threshold, 0.0);
      continue;
    }
    // If both sides are shown, show the same fraction of the samples on each.
    const double least =
      std::max({ LEAST, isLower ? lower.GetFraction() : 0.0, isUpper ? upper.GetFraction() : 0.0 });
    if (isLower)
    {
      for (const Side::Step& step : lower.GetSteps(least))
      {
        points.insert(points.begin(), { histogram.GetCenter(peak - step.Bin), step.Opacity });
      }
    }
    if (isUpper)
    {
      for (const Side::Step& step : upper.GetSteps(least))
      {
        points.push_back({ histogram.GetCenter(peak + step.Bin), step.Opacity });
      }
    }
  }
  return points;
}

}
