// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/PlotSvg.h"

#include "Benchmarks/Results/ErrorFront.h"
#include "Support/Pages/HtmlText.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace
{
constexpr double Left = 110.0;
constexpr double Right = 850.0;
constexpr double Top = 60.0;
constexpr double Bottom = 730.0;

/// SVG paths of the marks, centered at the origin. The last two have no area and are only stroked.
const char* const Shapes[] = { "M-9 0a9 9 0 1 0 18 0a9 9 0 1 0-18 0z", "M-8-8h16v16h-16z",
  "M0-11L11 0L0 11L-11 0z", "M0-10L10 8H-10z", "M0 10L10-8H-10z", "M-9-9H9L-9 9H9z",
  "M-10 0H10M0-10V10", "M-8-8L8 8M8-8L-8 8" };
constexpr std::size_t NumberOfShapes = sizeof(Shapes) / sizeof(Shapes[0]);

const char* const Colors[] = { "#440154", "#005c96", "#dc501e", "#55b98c", "#f5b43c", "#5a5a5a",
  "#be6ebe", "#146450", "#5a96c8", "#6e3c14" };

std::string PlotNumber(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/// A range of numbers, and the range of pixels in which it is drawn.
struct Axis
{
  double Low = 0.0;
  double High = 1.0;
  bool IsLogarithmic = false;
  double First = 0.0;
  double Last = 1.0;

  double Scaled(double number) const { return this->IsLogarithmic ? std::log10(number) : number; }
  double At(double number) const
  {
    const double low = this->Scaled(this->Low);
    const double fraction = (this->Scaled(number) - low) / (this->Scaled(this->High) - low);
    return this->First + fraction * (this->Last - this->First);
  }
};

/// Returns an axis for the numbers of all series. A logarithmic axis covers full decades. A linear
/// axis starts at 0 and extends slightly beyond the largest number.
Axis MakeAxis(const BenchPlot& plot, std::vector<double> BenchPlot::Series::*numbers,
  bool isLogarithmic, double first, double last)
{
  double low = std::numeric_limits<double>::max();
  double high = plot.Reference;
  for (const BenchPlot::Series& series : plot.AllSeries)
  {
    for (const double number : series.*numbers)
    {
      if (!isLogarithmic || number > 0.0)
      {
        low = std::min(low, number);
        high = std::max(high, number);
      }
    }
  }
  if (!isLogarithmic)
  {
    return { 0.0, high > 0.0 ? 1.1 * high : 1.0, false, first, last };
  }
  return { std::pow(10.0, std::floor(std::log10(low) - 0.05)),
    std::pow(10.0, std::ceil(std::log10(high) + 0.05)), true, first, last };
}

std::vector<double> TicksOf(const Axis& axis)
{
  std::vector<double> ticks;
  if (axis.IsLogarithmic)
  {
    const int first = static_cast<int>(std::lround(std::log10(axis.Low)));
    const int last = static_cast<int>(std::lround(std::log10(axis.High)));
    for (int decade = first; decade <= last; decade += std::max(1, (last - first + 7) / 8))
    {
      ticks.push_back(std::pow(10.0, decade));
    }
    return ticks;
  }
  const double decade = std::pow(10.0, std::floor(std::log10(axis.High)));
  const double mantissa = axis.High / decade;
  const double step = decade * (mantissa > 5.0 ? 2.0 : mantissa > 2.0 ? 1.0 : 0.25);
  for (double tick = 0.0; tick <= axis.High; tick += step)
  {
    ticks.push_back(tick);
  }
  return ticks;
}

/// Writes an SVG image from back to front.
class Svg
{
public:
  explicit Svg(const BenchPlot& plot)
    : Plot(plot)
    , Y(MakeAxis(plot, &BenchPlot::Series::Y, plot.LogY, Bottom, Top))
  {
    const double groups = static_cast<double>(plot.BarLabels.size());
    this->X = plot.Kind == BenchPlot::BARS
      ? Axis{ -0.5, groups - 0.5, false, Left, Right }
      : MakeAxis(plot, &BenchPlot::Series::X, plot.LogX, Left, Right);
  }

  std::string Make(const std::string& caption)
  {
    this->Text
      << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1200 840\" "
         "font-family=\"sans-serif\" font-size=\"17\" fill=\"none\" "
         "stroke-linejoin=\"round\">\n<rect width=\"1200\" height=\"840\" fill=\"#fff\"/>\n";
    this->AddFrame();
    if (this->Plot.Kind == BenchPlot::BARS)
    {
      this->AddBars();
    }
    else
    {
      this->AddLines();
    }
    this->AddCaption(caption);
    this->Text << "</svg>\n";
    return this->Text.str();
  }

private:
  void AddText(double x, double y, const char* anchor, const std::string& text,
    const std::string& more = std::string())
  {
    this->Text << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor
               << "\" fill=\"#333\"" << more << ">" << html::Escaped(text) << "</text>\n";
  }

  void AddPath(const std::string& path, const std::string& attributes)
  {
    this->Text << "<path d=\"" << path << "\" " << attributes << "/>\n";
  }

  void AddFrame()
  {
    const BenchPlot& plot = this->Plot;
    this->AddText(0.5 * (Left + Right), 36.0, "middle", plot.Title, " font-size=\"22\"");
    this->AddText(0.5 * (Left + Right), Bottom + 54.0, "middle", plot.XLabel);
    this->AddText(0.0, 0.0, "middle", plot.YLabel,
      " transform=\"translate(30 " + PlotNumber(0.5 * (Top + Bottom)) + ") rotate(-90)\"");
    for (const double tick : TicksOf(this->Y))
    {
      const std::string height = PlotNumber(this->Y.At(tick));
      this->AddPath(
        "M" + PlotNumber(Left) + " " + height + "H" + PlotNumber(Right), "stroke=\"#e1e1e1\"");
      this->AddText(Left - 10.0, this->Y.At(tick) + 6.0, "end", PlotNumber(tick));
    }
    for (std::size_t i = 0; i < plot.BarLabels.size(); ++i)
    {
      this->AddText(this->X.At(static_cast<double>(i)), Bottom + 26.0, "middle", plot.BarLabels[i]);
    }
    if (plot.Kind == BenchPlot::LINES)
    {
      for (const double tick : TicksOf(this->X))
      {
        const std::string x = PlotNumber(this->X.At(tick));
        this->AddPath(
          "M" + x + " " + PlotNumber(Top) + "V" + PlotNumber(Bottom), "stroke=\"#e1e1e1\"");
        this->AddText(this->X.At(tick), Bottom + 26.0, "middle", PlotNumber(tick));
      }
    }
    this->AddPath("M" + PlotNumber(Left) + " " + PlotNumber(Top) + "V" + PlotNumber(Bottom) + "H" +
        PlotNumber(Right),
      "stroke=\"#000\"");
  }

  void AddBars()
  {
    const double width = 0.8 / static_cast<double>(this->Plot.AllSeries.size());
    for (std::size_t i = 0; i < this->Plot.AllSeries.size(); ++i)
    {
      const BenchPlot::Series& series = this->Plot.AllSeries[i];
      const std::string look = "class=\"bar\" fill=\"" + ColorOf(i) + "\"";
      for (std::size_t j = 0; j < series.X.size(); ++j)
      {
        const double first = series.X[j] - 0.4 + width * static_cast<double>(i);
        this->AddPath("M" + PlotNumber(this->X.At(first)) + " " + PlotNumber(Bottom) + "V" +
            PlotNumber(this->Y.At(series.Y[j])) + "H" + PlotNumber(this->X.At(first + width)) +
            "V" + PlotNumber(Bottom) + "z",
          look);
      }
      this->AddPath("M" + this->AddLegend(series.Label) + "m-30-8h30v16h-30z", look);
    }
    if (this->Plot.Reference > 0.0)
    {
      this->AddPath("M" + PlotNumber(Left) + " " + PlotNumber(this->Y.At(this->Plot.Reference)) +
          "H" + PlotNumber(Right),
        "stroke=\"#000\" stroke-dasharray=\"8 5\"");
    }
  }

  void AddLines()
  {
    if (this->Plot.HasFront)
    {
      this->AddFront();
    }
    bool isNamed = false;
    for (std::size_t i = 0; i < this->Plot.AllSeries.size(); ++i)
    {
      const BenchPlot::Series& series = this->Plot.AllSeries[i];
      this->AddSeries(series, i);
      if (series.Label == this->Plot.DefaultSeries)
      {
        this->AddRings(series, isNamed);
      }
    }
    this->AddRings(this->Plot.DefaultPoint, isNamed);
  }

  /// Draws the Pareto front as a staircase. Points above and to the right of the front are
  /// dominated.
  void AddFront()
  {
    std::string path;
    for (const ErrorPoint& point : FindParetoFront(this->Plot))
    {
      if (!this->IsDrawn(point.Cost, point.Error))
      {
        continue;
      }
      const std::string x = PlotNumber(this->X.At(point.Cost));
      const std::string y = PlotNumber(this->Y.At(point.Error));
      path += path.empty() ? "M" + x + " " + y : "H" + x + "V" + y;
    }
    if (path.find('H') != std::string::npos)
    {
      const std::string look =
        "class=\"front\" stroke=\"#999\" stroke-width=\"5\" stroke-dasharray=\"2 6\"";
      this->AddPath(path, look);
      this->AddPath("M" + this->AddLegend("Pareto front") + "h-40", look);
    }
  }

  bool IsDrawn(double x, double y) const
  {
    return (!this->Plot.LogX || x > 0.0) && (!this->Plot.LogY || y > 0.0);
  }

  void AddSeries(const BenchPlot::Series& series, std::size_t index)
  {
    const std::string color = ColorOf(index);
    const std::string look = std::string("class=\"line") +
      (!series.IsChoice       ? " no-choice\" stroke-dasharray=\"12 4 3 4"
          : series.IsBaseline ? " peer\" stroke-dasharray=\"9 6"
                              : "") +
      "\" stroke-width=\"3\" stroke=\"" + color + "\"";
    const auto addMark = [&](const std::string& at)
    {
      this->Text << "<path " << MarkOf(index) << " color=\"" << color << "\" transform=\"translate("
                 << at << ")\"/>\n";
    };
    std::string path;
    for (std::size_t i = 0; i < series.X.size(); ++i)
    {
      if (this->IsDrawn(series.X[i], series.Y[i]))
      {
        path += (path.empty() ? "M" : "L") + this->PositionOf(series, i);
      }
    }
    this->AddPath(path, look);
    for (std::size_t i = 0; i < series.X.size(); ++i)
    {
      if (this->IsDrawn(series.X[i], series.Y[i]))
      {
        addMark(this->PositionOf(series, i));
        this->AddText(this->X.At(series.X[i]) + 11.0, this->Y.At(series.Y[i]) - 9.0, "start",
          i < series.Names.size() ? series.Names[i] : std::string(), " font-size=\"13\"");
      }
    }
    const std::string position = this->AddLegend(series.Label +
      (!series.IsChoice       ? " (no choice)"
          : series.IsBaseline ? " (peer)"
                              : ""));
    this->AddPath("M" + position + "h-40", look);
    addMark(position + ") translate(-20");
  }

  void AddRings(const BenchPlot::Series& series, bool& isNamed)
  {
    const std::string look = "class=\"default\" stroke=\"#000\" stroke-width=\"3\" d=\"M-16 0a16 "
                             "16 0 1 0 32 0a16 16 0 1 0-32 0z\" transform=\"translate(";
    for (std::size_t i = 0; i < series.X.size(); ++i)
    {
      this->Text << "<path " << look << this->PositionOf(series, i) << ")\"/>\n";
    }
    if (!series.X.empty() && !isNamed)
    {
      isNamed = true;
      const std::string position = this->AddLegend("default");
      this->Text << "<path " << look << position << ") translate(-20) scale(0.7)\"/>\n";
    }
  }

  std::string PositionOf(const BenchPlot::Series& series, std::size_t i) const
  {
    return PlotNumber(this->X.At(series.X[i])) + " " + PlotNumber(this->Y.At(series.Y[i]));
  }

  /// Adds an entry to the legend. Returns the coordinates of the right end of the line sample,
  /// which the caller draws.
  std::string AddLegend(const std::string& label)
  {
    this->LegendHeight += 30.0;
    this->AddText(Right + 75.0, this->LegendHeight + 6.0, "start", label, " font-size=\"15\"");
    return PlotNumber(Right + 65.0) + " " + PlotNumber(this->LegendHeight);
  }

  void AddCaption(const std::string& caption)
  {
    std::istringstream lines(caption);
    double height = 810.0;
    for (std::string line; std::getline(lines, line); height += 20.0)
    {
      this->AddText(24.0, height, "start", line, " font-size=\"14\"");
    }
  }

  const BenchPlot& Plot;
  Axis X;
  Axis Y;
  double LegendHeight = Top - 10.0;
  std::ostringstream Text;
};
}

std::string MarkOf(std::size_t series)
{
  const std::size_t mark = series % NumberOfMarks;
  return std::string("class=\"mark\" stroke=\"currentColor\" stroke-width=\"3\" fill=\"") +
    (mark < NumberOfShapes ? "currentColor" : "#fff") + "\" d=\"" + Shapes[mark % NumberOfShapes] +
    "\"";
}

std::string ColorOf(std::size_t series)
{
  return Colors[series % (sizeof(Colors) / sizeof(Colors[0]))];
}

std::string MakeSvg(const BenchPlot& plot, const std::string& caption)
{
  return Svg(plot).Make(caption);
}

std::vector<BenchPlot> WritePlots(
  const std::vector<BenchPlot>& plots, const std::string& folder, const std::string& caption)
{
  std::filesystem::create_directories(folder);
  std::vector<BenchPlot> drawn;
  for (const BenchPlot& plot : plots)
  {
    if (!plot.AllSeries.empty())
    {
      const std::string path = (std::filesystem::path(folder) / (plot.Name + ".svg")).string();
      std::ofstream file(path);
      file << MakeSvg(plot, caption);
      if (!file)
      {
        throw std::runtime_error("Cannot write the file " + path);
      }
      drawn.push_back(plot);
    }
  }
  return drawn;
}
