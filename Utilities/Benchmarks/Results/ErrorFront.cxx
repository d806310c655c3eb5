// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/ErrorFront.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tuple>

namespace
{
ErrorPoint PointOf(const BenchPlot::Series& series, std::size_t i)
{
  return { series.Label, i < series.Names.size() ? series.Names[i] : std::string(), series.X[i],
    series.Y[i] };
}

/// Returns the cheapest point of the front whose error is at most the error of \a point, or
/// \a point itself if it is cheaper.
ErrorPoint FindRival(const BenchPlot& plot, const ErrorPoint& point)
{
  const std::vector<ErrorPoint> front = FindParetoFront(plot);
  const auto rival = std::find_if(front.begin(), front.end(),
    [&point](const ErrorPoint& other) { return other.Error <= point.Error; });
  return rival == front.end() || rival->Cost > point.Cost ? point : *rival;
}

std::string NameOf(const ErrorPoint& point)
{
  return point.Name.empty() || point.Name == point.Series ? point.Series
                                                          : point.Series + " " + point.Name;
}

std::string NumbersOf(const ErrorPoint& point)
{
  std::ostringstream text;
  text << std::setprecision(3) << "error " << point.Error << " in " << point.Cost << " s";
  return text.str();
}
}

std::vector<ErrorPoint> FindParetoFront(const BenchPlot& plot)
{
  std::vector<ErrorPoint> all;
  for (const BenchPlot::Series& series : plot.AllSeries)
  {
    for (std::size_t i = 0; series.IsChoice && i < series.X.size(); ++i)
    {
      all.push_back(PointOf(series, i));
    }
  }
  std::stable_sort(all.begin(), all.end(),
    [](const ErrorPoint& a, const ErrorPoint& b)
    { return std::tie(a.Cost, a.Error) < std::tie(b.Cost, b.Error); });
  std::vector<ErrorPoint> front;
  for (const ErrorPoint& point : all)
  {
    if (front.empty() || point.Error < front.back().Error)
    {
      front.push_back(point);
    }
  }
  return front;
}

std::optional<double> GetCostRelativeToFront(const BenchPlot& plot)
{
  if (plot.DefaultPoint.X.empty())
  {
    return std::nullopt;
  }
  const ErrorPoint byDefault = PointOf(plot.DefaultPoint, 0);
  return byDefault.Cost / FindRival(plot, byDefault).Cost;
}

std::string SummaryOf(const BenchPlot& plot)
{
  const std::optional<double> over = GetCostRelativeToFront(plot);
  if (!over)
  {
    return {};
  }
  const ErrorPoint byDefault = PointOf(plot.DefaultPoint, 0);
  const ErrorPoint rival = FindRival(plot, byDefault);
  std::ostringstream text;
  text << "The default, " << NameOf(byDefault) << " (" << NumbersOf(byDefault) << "), is ";
  if (*over <= 1.0)
  {
    text << "on the front.";
  }
  else
  {
    text << (*over <= FrontTolerance ? "within the measurement noise of the front: "
                                     : "not on the front: ")
         << NameOf(rival) << " has " << NumbersOf(rival) << ".";
  }
  return text.str();
}
