// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/LegendCorner.h"

#include "Benchmarks/Results/BenchPlot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace
{
/// About the size of a legend, in shares of the frame: a line of it, a letter, and the mark.
constexpr double LineHeight = 0.033;
constexpr double LetterWidth = 0.0095;
constexpr double MarkWidth = 0.045;
/// Places that a line from one point to the next is asked for.
constexpr int PlacesOfLine = 16;

/// Where a number lies between the ends of its axis, 0 to 1.
double ShareOf(double number, const std::array<double, 2>& range, bool isLogarithmic)
{
  if (isLogarithmic)
  {
    return std::log(number / range[0]) / std::log(range[1] / range[0]);
  }
  return (number - range[0]) / (range[1] - range[0]);
}

/// Places along the lines of the plot, in shares of the frame.
std::vector<std::array<double, 2>> FindPlaces(
  const BenchPlot& plot, const std::array<double, 2>& x, const std::array<double, 2>& y)
{
  std::vector<std::array<double, 2>> places;
  for (const BenchPlot::Series& series : plot.AllSeries)
  {
    for (std::size_t i = 0; i < series.X.size(); ++i)
    {
      const std::array<double, 2> place = { ShareOf(series.X[i], x, plot.LogX),
        ShareOf(series.Y[i], y, plot.LogY) };
      if (i == 0)
      {
        places.push_back(place);
        continue;
      }
      const std::array<double, 2> from = places.back();
      for (int step = 1; step <= PlacesOfLine; ++step)
      {
        const double share = static_cast<double>(step) / PlacesOfLine;
        places.push_back(
          { from[0] + share * (place[0] - from[0]), from[1] + share * (place[1] - from[1]) });
      }
    }
  }
  return places;
}
}

LegendCorner FindLegendCorner(
  const BenchPlot& plot, const std::array<double, 2>& x, const std::array<double, 2>& y)
{
  // The front and the default have lines of their own.
  std::size_t longest = 12;
  std::size_t lines = 2;
  for (const BenchPlot::Series& series : plot.AllSeries)
  {
    longest = std::max(longest, series.Label.size() + (series.IsPeer ? 7 : 0));
    ++lines;
  }
  const double width = MarkWidth + LetterWidth * static_cast<double>(longest);
  const double height = LineHeight * static_cast<double>(lines);
  const auto places = FindPlaces(plot, x, y);
  LegendCorner best;
  auto fewest = std::numeric_limits<std::ptrdiff_t>::max();
  for (const LegendCorner corner :
    { LegendCorner{ true, true }, { true, false }, { false, true }, { false, false } })
  {
    const auto hidden = std::count_if(places.begin(), places.end(),
      [&](const std::array<double, 2>& place)
      {
        const double across = corner.IsRight ? 1.0 - place[0] : place[0];
        const double down = corner.IsTop ? 1.0 - place[1] : place[1];
        return across < width && down < height;
      });
    if (hidden < fewest)
    {
      fewest = hidden;
      best = corner;
    }
  }
  return best;
}
