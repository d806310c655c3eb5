// SPDX-License-Identifier: BSD-3-Clause
// Errors of streamlines, measured against exact streamlines or a method of order 8(7): their
// convergence with the step size, and their size at a fixed tolerance.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceAdvection.h"

#include "Advection/AdvectionRate.h"
#include "Advection/DormandPrinceStep.h"
#include "vtkImplicitFlowField.h" // for the integrators
#include "Advection/RosenbrockStep.h"
#include "Advection/RungeKutta4Step.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace
{

using namespace reference;

const BoxGrid Cells = []
{
  BoxGrid grid;
  grid.Origin = { -20.1, -20.13, -20.17 };
  grid.Spacing = { 0.5, 0.5, 0.5 };
  grid.Cells = { 81, 81, 81 };
  return grid;
}();

enum Walkers
{
  Space,
  Cubes,
  NumberOfWalkers
};
const char* const WalkerNames[NumberOfWalkers] = { "space", "cubes" };

interlume::AdvectionResult AdvectIn(int walker, const Flow& flow, const BoxGrid& grid,
  const interlume::AdvectionOptions& options, Position x)
{
  return walker == Space ? Advect(SingleCellWalker(flow), options, x)
                         : Advect(BoxWalker(flow, grid), options, x);
}

struct Method
{
  const char* Name;
  int Integrator;
  /// Minimum order of convergence in a single cell, and in many cells, where steps end at faces.
  double Orders[2];
};
const Method Methods[] = {
  { "Dormand and Prince", vtkImplicitFlowField::DORMAND_PRINCE, { 4.7, 3.8 } },
  { "Runge-Kutta 4", vtkImplicitFlowField::RUNGE_KUTTA_4, { 3.8, 3.8 } },
  { "Rosenbrock", vtkImplicitFlowField::ROSENBROCK, { 3.7, 2.8 } },
};

/// Returns the slope of the regression line through points.
double Slope(const std::vector<double>& x, const std::vector<double>& y)
{
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    meanX += x[i] / static_cast<double>(x.size());
    meanY += y[i] / static_cast<double>(x.size());
  }
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    covariance += (x[i] - meanX) * (y[i] - meanY);
    variance += (x[i] - meanX) * (x[i] - meanX);
  }
  return covariance / variance;
}

struct Scene
{
  const char* Name;
  Flow Field;
  std::vector<Position> Starts;
  double Time;
  /// Exact solution. If null, a method of order 8(7) is used.
  std::function<Position(const Position&, double)> Exact;
};

std::vector<Position> RandomPositions(std::size_t number, const Position& low, const Position& high)
{
  std::mt19937 random(7);
  std::vector<Position> positions(number);
  for (Position& position : positions)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      position[i] = low[i] + (high[i] - low[i]) * (random() / 4294967296.0);
    }
  }
  return positions;
}

std::vector<Scene> MakeScenes()
{
  std::vector<Scene> scenes;
  scenes.push_back(
    { "rotation", Flow::Rotation(1.0), RandomPositions(12, { 0.5, -2, -1 }, { 2, 2, 1 }), 6.0,
      [](const Position& x, double t)
      {
        return Position{ x[0] * std::cos(t) - x[1] * std::sin(t),
          x[0] * std::sin(t) + x[1] * std::cos(t), x[2] };
      } });
  scenes.push_back({ "saddle", Flow::Linear({ 1, 0, 0, 0, -1, 0, 0, 0, 0.2 }),
    RandomPositions(12, { 0.1, 0.5, -1 }, { 0.4, 2, 1 }), 3.0, [](const Position& x, double t) {
      return Position{ x[0] * std::exp(t), x[1] * std::exp(-t), x[2] * std::exp(0.2 * t) };
    } });
  scenes.push_back({ "orbit around a sphere", Flow::PotentialAroundSphere(),
    RandomPositions(12, { -3, 0.3, 0.2 }, { -2.5, 0.8, 0.8 }), 7.0, nullptr });
  scenes.push_back({ "Beltrami", Flow::Beltrami(1.0, 0.7, 0.43),
    RandomPositions(12, { 0, 0, 0 }, { 6, 6, 6 }), 4.0, nullptr });
  for (Scene& scene : scenes)
  {
    if (!scene.Exact)
    {
      scene.Exact = [flow = scene.Field](const Position& x, double t) { return flow.Follow(x, t); };
    }
  }
  return scenes;
}

/// Tests how three errors of a single step converge: the error at its end, the error of the dense
/// output, and the error estimate.
template <typename Method>
void TestStep(Check& check, const char* name, double endOrder, double denseOrder)
{
  const Flow flow = Flow::Beltrami(1.0, 0.7, 0.43);
  const SingleCellWalker walker(flow);
  std::vector<double> steps;
  std::vector<double> ends;
  std::vector<double> between;
  std::vector<double> estimates;
  for (double h : { 0.4, 0.2, 0.1, 0.05, 0.025 })
  {
    double sums[3] = {};
    for (const Position& start : RandomPositions(20, { 0, 0, 0 }, { 6, 6, 6 }))
    {
      interlume::AdvectionEnd counts;
      interlume::AdvectionRate<SingleCellWalker> rate(walker, false, counts);
      double first[3];
      rate(start.data(), first);
      Method method;
      check.That(method.Take(rate, start.data(), first, h), "a step");
      sums[0] += std::pow(Distance(method.End, flow.Follow(start, h)), 2.0);
      interlume::DenseOutput<double> dense;
      method.GetDenseOutput(dense);
      for (double theta : { 0.2, 0.45, 0.6, 0.85 })
      {
        double p[3];
        dense.GetPoint(theta, p);
        sums[1] += std::pow(Distance(p, flow.Follow(start, theta * h)), 2.0);
      }
      sums[2] += std::pow(interlume::Vectors::SafeLength(glm::make_vec3(method.Error)), 2.0);
      double p[3];
      dense.GetPoint(1.0, p);
      check.That(Distance(p, { method.End[0], method.End[1], method.End[2] }) <= 1e-14,
        "the dense output ends at the end of the step");
    }
    steps.push_back(std::log(h));
    ends.push_back(0.5 * std::log(sums[0]));
    between.push_back(0.5 * std::log(sums[1]));
    estimates.push_back(0.5 * std::log(sums[2]));
  }
  const double orders[3] = { Slope(steps, ends), Slope(steps, between), Slope(steps, estimates) };
  std::cout << name << ": local orders " << orders[0] << " at the end, " << orders[1]
            << " between, " << orders[2] << " of the estimate\n";
  const std::string what = std::string("local order of ") + name;
  check.That(orders[0] >= endOrder - 0.3, what + " at the end of the step");
  check.Near(orders[1], denseOrder, 0.06, what + " of the dense output");
  check.Near(orders[2], Method::ErrorOrder + 1.0, 0.06, what + " of the error estimate");
}

void TestSlopes(Check& check)
{
  for (const Scene& scene : MakeScenes())
  {
    std::vector<Position> ends;
    for (const Position& start : scene.Starts)
    {
      ends.push_back(scene.Exact(start, scene.Time));
    }
    for (int walker = 0; walker < NumberOfWalkers; ++walker)
    {
      for (const Method& method : Methods)
      {
        std::vector<double> steps;
        std::vector<double> errors;
        for (double tolerance : { 1e-5, 1e-6, 1e-7, 1e-8, 1e-9 })
        {
          OwningAdvectionOptions options = ForwardOptions();
          options.Integrator = method.Integrator;
          options.MaximumError = tolerance;
          options.MaximumTime = scene.Time;
          double number = 0.0;
          double squares = 0.0;
          for (std::size_t i = 0; i < ends.size(); ++i)
          {
            const interlume::AdvectionResult result =
              AdvectIn(walker, scene.Field, Cells, options, scene.Starts[i]);
            check.Equal(result.Status, vtkFlowStatus::OUT_OF_TIME, scene.Name);
            check.That(result.StiffSteps ==
                (method.Integrator == vtkImplicitFlowField::ROSENBROCK
                    ? NumberOfSteps(result) - result.RejectedStiffSteps
                    : 0),
              "steps of the requested method");
            number += NumberOfSteps(result);
            squares += std::pow(Distance(result.Position, ends[i]), 2.0);
          }
          const double error = std::sqrt(squares / static_cast<double>(ends.size()));
          check.That(error <= 10.0 * tolerance * scene.Time, "the error is within the tolerance");
          steps.push_back(-std::log(number));
          errors.push_back(std::log(error));
        }
        const double slope = Slope(steps, errors);
        const std::string what =
          std::string(scene.Name) + " in " + WalkerNames[walker] + ", " + method.Name;
        std::cout << what << ": order " << slope << "\n";
        check.That(slope >= method.Orders[walker == Space ? 0 : 1], "order of " + what);
      }
    }
  }
}

/// The kinks of trilinear interpolation at cell faces do not reduce the order of convergence.
void TestKinks(Check& check)
{
  const Flow flow = Flow::Beltrami(1.0, 0.7, 0.43);
  BoxGrid grid = Cells;
  grid.IsInterpolated = true;
  const std::vector<Position> starts = RandomPositions(12, { 0, 0, 0 }, { 6, 6, 6 });
  OwningAdvectionOptions options = ForwardOptions();
  options.MaximumTime = 4.0;
  for (const Method& method : Methods)
  {
    std::vector<Position> ends;
    options.Integrator = vtkImplicitFlowField::DORMAND_PRINCE;
    options.MaximumError = 1e-13;
    for (const Position& start : starts)
    {
      const interlume::AdvectionResult result = AdvectIn(Cubes, flow, grid, options, start);
      ends.push_back({ result.Position[0], result.Position[1], result.Position[2] });
    }
    options.Integrator = method.Integrator;
    std::vector<double> steps;
    std::vector<double> errors;
    for (double tolerance : { 1e-6, 1e-7, 1e-8, 1e-9 })
    {
      options.MaximumError = tolerance;
      double number = 0.0;
      double squares = 0.0;
      for (std::size_t i = 0; i < ends.size(); ++i)
      {
        const interlume::AdvectionResult result = AdvectIn(Cubes, flow, grid, options, starts[i]);
        number += NumberOfSteps(result);
        squares += std::pow(Distance(result.Position, ends[i]), 2.0);
      }
      const double error = std::sqrt(squares / static_cast<double>(ends.size()));
      check.That(error <= 10.0 * tolerance * options.MaximumTime,
        "the error with kinks is within the tolerance");
      steps.push_back(-std::log(number));
      errors.push_back(std::log(error));
    }
    std::cout << "kinks, " << method.Name << ": order " << Slope(steps, errors) << "\n";
    check.That(Slope(steps, errors) >= method.Orders[1], "order with kinks");
  }
}

/// Traces 2,000 streamlines to surfaces, in a single cell and in many cells. At least 99.9 % of
/// their errors are within ten times the tolerance.
void TestTolerance(Check& check)
{
  struct Case
  {
    const char* Name;
    Flow Field;
    vtkSmartPointer<FormulaSurface> Surface;
    Position Low;
    Position High;
    bool IsBackward;
  };
  const Case cases[] = {
    { "rotation", Flow::Rotation(1.0), FormulaSurface::Plane({ 1, 0, 0 }, 0.1, 1, 2),
      { -2, -2, -1 }, { 2, 2, 1 }, true },
    { "saddle", Flow::Linear({ 1, 0, 0, 0, -1, 0, 0, 0, 0.2 }),
      FormulaSurface::Sphere({ 0, 0, 0 }, 3.0), { -1, -1, -1 }, { 1, 1, 1 }, false },
    { "orbit around a sphere", Flow::PotentialAroundSphere(),
      FormulaSurface::Plane({ 1, 0, 0 }, -3.0, 1, 2), { -3, 1.1, -2 }, { 4, 2, 2 }, true },
    { "Beltrami", Flow::Beltrami(1.0, 0.7, 0.43), FormulaSurface::Sphere({ 3, 3, 3 }, 2.0),
      { 1.9, 1.9, 1.9 }, { 4.1, 4.1, 4.1 }, true },
  };
  constexpr double tolerance = 1e-6;
  for (int walker : { Space, Cubes })
  {
    int number = 0;
    int good = 0;
    double worst = 0.0;
    for (const Case& one : cases)
    {
      OwningAdvectionOptions options = ForwardOptions({ one.Surface });
      options.SetBackward(one.IsBackward);
      options.MaximumError = tolerance;
      options.MaximumTime = 50.0;
      int arrivals = 0;
      for (const Position& start : RandomPositions(700, one.Low, one.High))
      {
        const interlume::AdvectionResult result =
          AdvectIn(walker, one.Field, Cells, options, start);
        if (result.Status != vtkFlowStatus::REACHED_SURFACE || arrivals == 500)
        {
          continue;
        }
        ++arrivals;
        const Position end = one.Field.Follow(start, one.IsBackward ? -result.Time : result.Time);
        const double error = std::max(
          Distance(result.Position, end), std::abs(one.Surface->EvaluateDistance(end.data())));
        const double part = error / (tolerance * std::max(1.0, result.Time));
        reference::KeepLargest(worst, part);
        good += part <= 10.0;
        double uv[2];
        one.Surface->EvaluateParameters(result.Position, uv);
        check.That(uv[0] == result.Parameters[0] && uv[1] == result.Parameters[1] &&
            std::abs(one.Surface->EvaluateDistance(result.Position)) <= 1e-13,
          "the end lies on the surface");
      }
      std::cout << WalkerNames[walker] << ", " << one.Name << ": " << arrivals
                << " samples reach the surface\n";
      number += arrivals;
    }
    std::cout << WalkerNames[walker] << ": " << good << " of " << number
              << " within ten times the tolerance, maximum " << worst << " times\n";
    check.Equal(number, 2000, "samples that reach the surface");
    check.That(good >= 0.999 * number, "99.9 % within ten times the tolerance");
  }
}

}

int TestAdvectionOrder(int, char*[])
{
  Check check;
  TestStep<interlume::DormandPrinceStep<double>>(check, "Dormand and Prince", 6.0, 5.0);
  TestStep<interlume::RungeKutta4Step>(check, "Runge-Kutta 4", 5.0, 5.0);
  TestStep<interlume::RosenbrockStep>(check, "Rosenbrock", 5.0, 4.0);
  TestSlopes(check);
  TestKinks(check);
  TestTolerance(check);
  return check.Result();
}
