#include "FlowTolerances.h"

#include "BenchTiming.h"
#include "FlowCases.h"
#include "FlowMethods.h"

#include "ReferenceFlowMaps.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace flow
{
namespace
{
const char* const Norm = "mean distance from the formula";
constexpr double ClaimedTolerance = 1e-6;

/// A linear field and where it carries a point in a time.
struct LinearCase
{
  std::string Name;
  vtkSmartPointer<vtkAnalyticFlowSource> Source;
  std::function<reference::FlowVector(const reference::FlowVector&, double)> Map;
};

vtkSmartPointer<vtkAnalyticFlowSource> NewSource(int field, int points)
{
  auto source = vtkSmartPointer<vtkAnalyticFlowSource>::New();
  source->SetField(field);
  source->SetDimensions(points, points, points);
  return source;
}

LinearCase MakeSaddle(const std::string& name, const reference::FlowVector& rates, int points)
{
  auto source = NewSource(vtkAnalyticFlowSource::SADDLE, points);
  source->SetSaddleRates(rates[0], rates[1], rates[2]);
  return { name, source, [rates](const reference::FlowVector& x, double t) {
            return reference::MapSaddle(x, { { 0.0, 0.0, 0.0 } }, rates, t);
          } };
}

std::vector<LinearCase> MakeCases(const BenchOptions& options)
{
  const int points = options.Pick(64, 32, 8);
  std::vector<LinearCase> cases;
  const reference::FlowVector velocity = { { 1.0, 0.4, -0.3 } };
  auto uniform = NewSource(vtkAnalyticFlowSource::UNIFORM, points);
  uniform->SetVelocity(velocity[0], velocity[1], velocity[2]);
  cases.push_back({ "uniform", uniform, [velocity](const reference::FlowVector& x, double t) {
                     return reference::MapUniform(x, velocity, t);
                   } });
  cases.push_back(MakeSaddle("saddle", { { 1.0, 1.0, -2.0 } }, points));
  const reference::FlowVector rates = { { -1.0, -0.8, -0.6 } };
  constexpr double swirl = 3.0;
  auto spiral = NewSource(vtkAnalyticFlowSource::NODE, points);
  spiral->SetNodeRates(rates[0], rates[1], rates[2]);
  spiral->SetSwirl(swirl);
  cases.push_back(
    { "spiral", spiral, [rates](const reference::FlowVector& x, double t) {
       return reference::MapNode(x, { { 0.0, 0.0, 0.0 } }, rates, { { 0.0, 0.0, 1.0 } }, swirl, t);
     } });
  for (const auto& ratio : { std::pair<const char*, double>("stiff-1e2", 1e2),
         std::pair<const char*, double>("stiff-1e4", 1e4),
         std::pair<const char*, double>("stiff-1e6", 1e6) })
  {
    cases.push_back(
      MakeSaddle(ratio.first, { { -1.0, ratio.second, 0.5 * ratio.second } }, points));
  }
  return cases;
}

struct Errors
{
  double Mean = 0.0;
  /// The share of answers within 10 times the tolerance.
  double Within = 0.0;
  /// Samples that have an answer.
  vtkIdType Answers = 0;
};

Errors Compare(const Case& what, const LinearCase& linear, const Answer& answer, double largest)
{
  Errors errors;
  vtkIdType within = 0;
  for (vtkIdType i = 0; i < what.Seeds->GetNumberOfPoints(); ++i)
  {
    const End& end = answer.Ends[static_cast<std::size_t>(i)];
    if (!end.HasAnswer)
    {
      continue;
    }
    reference::FlowVector start{};
    what.Seeds->GetPoint(i, start.data());
    const reference::FlowVector place = linear.Map(start, -end.Time);
    const double apart =
      std::hypot(place[0] - end.Place[0], place[1] - end.Place[1], place[2] - end.Place[2]);
    errors.Mean += apart;
    ++errors.Answers;
    within += apart <= 10.0 * largest * end.Time + 1e-13 ? 1 : 0;
  }
  const auto answers = static_cast<double>(std::max<vtkIdType>(1, errors.Answers));
  errors.Mean /= answers;
  errors.Within = static_cast<double>(within) / answers;
  return errors;
}

const std::vector<std::pair<int, const char*>> Integrators = { { vtkImplicitFlowField::AUTOMATIC,
                                                                 "automatic" },
  { vtkImplicitFlowField::DORMAND_PRINCE, "dormand-prince" },
  { vtkImplicitFlowField::RUNGE_KUTTA_4, "runge-kutta-4" },
  { vtkImplicitFlowField::ROSENBROCK, "rosenbrock" } };

bool IsMethod(const std::string& method)
{
  return std::any_of(Integrators.begin(), Integrators.end(),
    [&](const std::pair<int, const char*>& integrator) { return method == integrator.second; });
}
}

//------------------------------------------------------------------------------
void AddToleranceRows(const BenchOptions& options, BenchRows& rows)
{
  const auto tolerances =
    options.Pick<std::vector<double>>({ 1e-2, 1e-4, ClaimedTolerance, 1e-8, 1e-10 },
      { 1e-3, ClaimedTolerance, 1e-9 }, { ClaimedTolerance, 1e-9 });
  for (const LinearCase& linear : MakeCases(options))
  {
    // Explicit methods take a hundred thousand steps there.
    const bool isStiff = linear.Name.rfind("stiff", 0) == 0;
    const auto seeds = MakeSeeds(
      isStiff ? options.Pick(200, 24, 8) : options.Pick(2000, 400, 30), 0.8, options.Seed);
    linear.Source->Update();
    constexpr double face = 0.97;
    const Case what = { linear.Name, linear.Source->GetOutput(), seeds,
      { { -face, face, -face, face, -face, face } }, true };
    for (const auto& integrator : Integrators)
    {
      for (const double tolerance : tolerances)
      {
        const auto filter = NewAdvection(what, integrator.first, tolerance);
        filter->SetMaximumError(tolerance);
        BenchRow row = rows.Make(linear.Name, integrator.second);
        row.Seconds = TimeOnce(WithThreads(1,
          [&]()
          {
            filter->Update();
            return vtkSmartPointer<vtkObjectBase>(filter->GetOutputDataObject(0));
          }));
        const Errors errors =
          Compare(what, linear, ReadAdvection(what, filter), filter->GetMaximumError());
        const vtkFlowReport& report = filter->GetReport();
        row.Parameter = tolerance;
        if (errors.Answers > 0)
        {
          row.Error = errors.Mean;
          row.ErrorNorm = Norm;
        }
        row.Counts["samples"] = report.Samples;
        row.Counts["answers"] = errors.Answers;
        row.Counts["within"] = errors.Within;
        row.Counts["steps"] = report.Steps;
        row.Counts["stiff_steps"] = report.StiffSteps;
        row.Counts["rejected"] = report.RejectedSteps + report.RejectedStiffSteps;
        row.Counts["evaluations"] = report.Evaluations;
        rows.Add(row);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<BenchClaim> CheckToleranceClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtLeast(
    "at a tolerance of 1e-6, 99.9 % of the answers within 10 times of it, automatic", 0.999, rows,
    [](const BenchRow& row) -> std::optional<double>
    {
      return row.Method == "automatic" && row.Parameter.get<double>() == ClaimedTolerance
        ? std::optional<double>(row.Counts["within"].get<double>())
        : std::nullopt;
    }) };
}

//------------------------------------------------------------------------------
std::vector<BenchPlot> MakeTolerancePlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    // Errors of 0 have no place on the axis.
    if (!IsMethod(row.Method) || !(row.Error.value_or(0.0) > 0.0) || row.Case == "uniform")
    {
      continue;
    }
    const std::string title = "Integrators, " + row.Case + ", 1 thread";
    if (plots.empty() || plots.back().Title != title)
    {
      BenchPlot plot;
      plot.Name = "flow-tolerance-" + row.Case;
      plot.Title = title;
      plot.XLabel = "run time (s)";
      plot.YLabel = Norm;
      plot.LogX = true;
      plot.LogY = true;
      plot.DefaultSeries = "automatic";
      plots.push_back(plot);
    }
    plots.back().AddPoint(row.Method, false, *row.Seconds, *row.Error);
  }
  // A line of one point is an error to VTK's charts.
  for (BenchPlot& plot : plots)
  {
    for (BenchPlot::Series& series : plot.AllSeries)
    {
      if (series.X.size() == 1)
      {
        series.X.push_back(series.X.front());
        series.Y.push_back(series.Y.front());
      }
    }
  }
  return plots;
}
}
