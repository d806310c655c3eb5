// SPDX-License-Identifier: BSD-3-Clause
// Tests streamlines of extreme fields: each must end with a status after a bounded number of steps.
#include "StabilityChecks.h"

#include "Support/Flow/ReferenceAdvection.h"

#include "vtkImplicitFlowField.h" // for the integrators
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace reference;
using namespace stability;

BoxGrid MakeBoxGrid(const Position& spacing, int number)
{
  BoxGrid lattice;
  lattice.Spacing = spacing;
  lattice.Cells = { number, number, number };
  for (std::size_t i = 0; i < 3; ++i)
  {
    lattice.Origin[i] = -0.5 * number * spacing[i] + 0.0123 * spacing[i];
  }
  return lattice;
}

/// Returns a flow with speed 1 along x that is attracted to the curve y = sin(x), z = 0 at \a rate.
Flow AttractToCurve(double rate)
{
  Flow flow;
  flow.Velocity = [rate](const double* x, double* v)
  {
    v[0] = 1.0;
    v[1] = std::cos(x[0]) - rate * (x[1] - std::sin(x[0]));
    v[2] = -rate * x[2];
  };
  flow.Gradient = [rate](const double* x, double* gradient)
  {
    std::fill(gradient, gradient + 9, 0.0);
    gradient[3] = -std::sin(x[0]) + rate * std::cos(x[0]);
    gradient[4] = gradient[8] = -rate;
  };
  return flow;
}

/// Returns the integration methods that were used and their numbers of steps, including rejected
/// steps.
std::string DescribeMethod(const interlume::AdvectionResult& result)
{
  const int stiff = result.StiffSteps + result.RejectedStiffSteps;
  const std::string others = "explicit: " + std::to_string(NumberOfSteps(result) - stiff);
  return stiff == 0 ? others : "Rosenbrock: " + std::to_string(stiff) + ", " + others;
}

/// Reports the number of steps and the error of each method for several eigenvalue ratios, in one
/// cell and across cells.
void TestStiff(StabilityCatalogue& catalogue)
{
  const BoxGrid lattice = MakeBoxGrid({ 0.3, 0.3, 0.3 }, 61);
  constexpr double time = 5.0;
  const struct
  {
    const char* Name;
    int Integrator;
  } methods[] = { { "automatic", vtkImplicitFlowField::AUTOMATIC },
    { "rosenbrock", vtkImplicitFlowField::ROSENBROCK },
    { "explicit", vtkImplicitFlowField::DORMAND_PRINCE } };
  for (double rate : { 1e2, 1e3, 1e4, 1e5, 1e6 })
  {
    const Flow flow = AttractToCurve(rate);
    const Position start = { -2.0, std::sin(-2.0) + 0.01, 0.01 };
    const double decay = 0.01 * std::exp(-rate * time);
    const Position end = { 3.0, std::sin(3.0) + decay, decay };
    for (const auto& method : methods)
    {
      interlume::AdvectionOptions options = ForwardOptions();
      options.Integrator = method.Integrator;
      options.MaximumTime = time;
      options.MaximumNumberOfSteps = 100000;
      for (bool isLattice : { false, true })
      {
        const auto result = isLattice ? Advect(BoxWalker(flow, lattice), options, start)
                                      : Advect(SingleCellWalker(flow), options, start);
        const std::string name = std::string("stiff-") + FormatShort(rate) + "-" + method.Name +
          (isLattice ? "-cells" : "");
        const std::string extreme = "eigenvalues 1 to " + FormatShort(rate) + ", " + method.Name +
          (isLattice ? ", across cells" : ", in one cell");
        const int steps = NumberOfSteps(result);
        const std::string chosen = DescribeMethod(result);
        if (method.Integrator == vtkImplicitFlowField::DORMAND_PRINCE)
        {
          // An explicit method is stable only with at least rate * time / 3.3 steps.
          const bool isOut = result.Status == vtkFlowStatus::OUT_OF_STEPS;
          catalogue.Check(name, extreme,
            "status out of time, or out of steps if more than 100000 are needed", Describe(result),
            isOut ? rate > 1e4 && steps == options.MaximumNumberOfSteps
                  : result.Status == vtkFlowStatus::OUT_OF_TIME && steps < rate * time + 500.0,
            chosen);
          continue;
        }
        catalogue.Measure(name + "-error", extreme,
          "distance from the exact end, status out of time; " + Describe(result),
          result.Status == vtkFlowStatus::OUT_OF_TIME ? Distance(result.Position, end)
                                                      : std::nan(""),
          10.0 * options.MaximumError * time, chosen);
        // The field has kinks at cell faces, and the step control restarts after each face. At rate
        // 1e6, rounding errors in the step control change the number of steps by 5 %.
        catalogue.Measure(name + "-steps", extreme,
          "number of steps, with Rosenbrock steps for rates above 100",
          rate > 100.0 && result.StiffSteps == 0 ? std::nan("") : steps,
          isLattice ? 2200.0 : 2000.0, chosen);
      }
    }
  }
  // A nonstiff field must be integrated with the explicit method only.
  interlume::AdvectionOptions options = ForwardOptions();
  options.MaximumTime = 50.0;
  options.MaximumError = 1e-2;
  const Flow flow = Flow::Beltrami(1.0, 0.7, 0.43);
  const auto result = Advect(SingleCellWalker(flow), options, { 0.5, 0.6, 0.7 });
  catalogue.Measure("not-stiff", "a nonstiff chaotic field", "number of Rosenbrock steps",
    result.StiffSteps, 0.0, DescribeMethod(result));
  options.MaximumError = 1e-6;
  // In a field with a stiff half, integration must return to the explicit method after leaving this
  // half.
  Flow passing = AttractToCurve(1.0);
  const auto rate = [](double x) { return x < 0.0 ? 1e4 : 0.1; };
  passing.Velocity = [rate](const double* x, double* v)
  {
    v[0] = 1.0;
    v[1] = std::cos(x[0]) - rate(x[0]) * (x[1] - std::sin(x[0]));
    v[2] = 0.0;
  };
  passing.Gradient = [rate](const double* x, double* gradient)
  {
    std::fill(gradient, gradient + 9, 0.0);
    gradient[3] = -std::sin(x[0]) + rate(x[0]) * std::cos(x[0]);
    gradient[4] = -rate(x[0]);
  };
  BoxGrid half = MakeBoxGrid({ 0.25, 0.25, 0.25 }, 80);
  half.Origin = { -10, -10, -10 };
  const Position stiffStart = { -3.0, std::sin(-3.0) + 0.01, 0.1 };
  options.MaximumTime = 3.0;
  const auto stiff = Advect(BoxWalker(passing, half), options, stiffStart);
  options.MaximumTime = 10.0;
  const auto passed = Advect(BoxWalker(passing, half), options, stiffStart);
  catalogue.Check("stiff-for-a-while", "eigenvalues 1e4 in half of the cells, then 0.1",
    "Rosenbrock steps in the stiff half, few after it",
    std::to_string(stiff.StiffSteps) + " and " +
      std::to_string(passed.StiffSteps - stiff.StiffSteps),
    stiff.StiffSteps > 5 && stiff.StiffSteps < 400 && passed.StiffSteps - stiff.StiffSteps <= 10 &&
      passed.Steps > 40 && passed.Steps < 400 &&
      std::abs(passed.Position[1] - std::sin(7.0)) < 1e-4,
    DescribeMethod(passed));
}

void TestNodes(StabilityCatalogue& catalogue)
{
  const BoxGrid lattice = MakeBoxGrid({ 0.2, 0.2, 0.2 }, 30);
  for (double spin : { 0.0, 1.0, 100.0, 1e4 })
  {
    const Flow flow = Flow::Linear({ -1, -spin, 0, spin, -1, 0, 0, 0, -1 }, { 0.1, 0.07, 0.05 });
    interlume::AdvectionOptions options = ForwardOptions();
    options.MinimumSpeed = 1e-4;
    options.MaximumError = 1e-6 * std::max(1.0, spin);
    for (bool isLattice : { false, true })
    {
      const auto result = isLattice ? Advect(BoxWalker(flow, lattice), options, { 1, 1, 1 })
                                    : Advect(SingleCellWalker(flow), options, { 1, 1, 1 });
      catalogue.Check(std::string("spiral-") + FormatShort(spin) + (isLattice ? "-cells" : ""),
        "a spiral sink with " + FormatShort(spin / (2.0 * vtkMath::Pi())) +
          " rotations per unit of time",
        "status stagnated; at 1e4 also out of steps or closed orbit", Describe(result),
        (result.Status == vtkFlowStatus::STAGNATED ||
          (spin >= 1e4 &&
            (result.Status == vtkFlowStatus::OUT_OF_STEPS ||
              result.Status == vtkFlowStatus::CLOSED_ORBIT))) &&
          NumberOfSteps(result) <= options.MaximumNumberOfSteps,
        DescribeMethod(result));
    }
  }
}

void TestScales(StabilityCatalogue& catalogue)
{
  const auto surface = FormulaSurface::Plane({ 1, 0, 0 }, 1.0, 1, 2);
  const BoxGrid lattice = MakeBoxGrid({ 0.3, 0.3, 0.3 }, 31);
  for (double speed : { 1e-12, 1e-6, 1e6, 1e12 })
  {
    const Flow flow = Flow::Rotation(1.0).Times(speed);
    interlume::AdvectionOptions options = ForwardOptions();
    options.Surfaces.push_back({ surface, 3 });
    options.MaximumError = 1e-9 * speed;
    const auto result = Advect(BoxWalker(flow, lattice), options, { 0, -2, 0.5 });
    catalogue.Measure("speed-" + FormatShort(speed), "speeds of " + FormatShort(speed),
      "relative error of the time to a plane; " + Describe(result),
      result.Id == 3 ? result.Time * speed / (vtkMath::Pi() / 6.0) - 1.0 : std::nan(""), 1e-7);
  }
  const Flow slow = Flow::Uniform({ 1e-290, 0, 0 });
  interlume::AdvectionOptions options = ForwardOptions();
  options.Surfaces.push_back({ surface, 3 });
  options.MaximumError = 1e-296;
  const auto late = Advect(BoxWalker(slow, lattice), options, { 0, 0, 0 });
  catalogue.Measure("time-1e290", "speeds of 1e-290",
    "relative error of the time to a plane; " + Describe(late),
    late.Id == 3 ? late.Time / 1e290 - 1.0 : std::nan(""), 1e-12);
  const Flow zero = Flow::Uniform({ 0, 0, 0 });
  const auto still = Advect(BoxWalker(zero, lattice), options, { 0, 0, 0 });
  catalogue.Check("zero-field", "vectors 0 everywhere", "status stagnated after 0 steps",
    Describe(still), still.Status == vtkFlowStatus::STAGNATED && NumberOfSteps(still) == 0);
  // Advection without bounds, surfaces or a time limit.
  const Flow uniform = Flow::Uniform({ 1, 2, 3 });
  const auto endless = Advect(SingleCellWalker(uniform), ForwardOptions(), { 0, 0, 0 });
  catalogue.Check("endless", "an unbounded uniform field", "a status within 10000 steps",
    Describe(endless), NumberOfSteps(endless) <= 10000);
}

void TestFields(StabilityCatalogue& catalogue)
{
  BoxGrid lattice = MakeBoxGrid({ 0.25, 0.25, 0.25 }, 32);
  interlume::AdvectionOptions options = ForwardOptions();
  options.MaximumTime = 30.0;
  // A block of NaN cells at the center.
  lattice.IsFinite = [](const auto& cell)
  { return std::any_of(cell.begin(), cell.end(), [](int i) { return i < 14 || i > 17; }); };
  const auto blocked =
    Advect(BoxWalker(Flow::Uniform({ 1, 0, 0 }), lattice), options, { -3, 0.1, 0.1 });
  catalogue.Measure("nan-block", "NaN in 4^3 cells",
    "distance from the end to the block, status not finite",
    blocked.Status == vtkFlowStatus::NOT_FINITE
      ? blocked.Position[0] - (lattice.Origin[0] + 14 * 0.25)
      : std::nan(""),
    1e-14);
  const auto around = Advect(BoxWalker(Flow::Rotation(1.0), lattice), options, { 2, 0.0, 0.1 });
  catalogue.Check("nan-beside", "streamlines around 4^3 cells with NaN", "status out of time",
    Describe(around), around.Status == vtkFlowStatus::OUT_OF_TIME);
  lattice.IsFinite = nullptr;

  // An oblique streamline through a shear layer of thickness 1e-4. Its x coordinate is an integral
  // of tanh.
  const Flow shear = Flow::ShearLayer(1e-4, { 0, 0.25, 0 });
  options.MaximumTime = 3.2;
  for (bool isLattice : { false, true })
  {
    const auto result = isLattice ? Advect(BoxWalker(shear, lattice), options, { 0, -0.5, 0 })
                                  : Advect(SingleCellWalker(shear), options, { 0, -0.5, 0 });
    catalogue.Measure(isLattice ? "shear-layer-cells" : "shear-layer", "a shear layer of 1e-4",
      "distance from the exact end; " + Describe(result),
      result.Status == vtkFlowStatus::OUT_OF_TIME ? Distance(result.Position, { -0.8, 0.3, 0 })
                                                  : std::nan(""),
      10.0 * options.MaximumError * options.MaximumTime);
    catalogue.Measure(isLattice ? "shear-layer-cells-steps" : "shear-layer-steps",
      "a shear layer of 1e-4", "number of steps", NumberOfSteps(result), 2000.0);
  }

  // Cells with an aspect ratio of 1e4.
  const BoxGrid thin = MakeBoxGrid({ 1.0, 1e-4, 1.0 }, 101);
  const Flow spin = Flow::Linear({ 0, -1e4, 0, 1e-4, 0, 0, 0, 0, 0 });
  options.MaximumTime = 2.0 * vtkMath::Pi();
  const auto turned = Advect(BoxWalker(spin, thin), options, { 30, 0, 0.2 });
  catalogue.Measure("cells-1e4", "cells of 1 : 1e-4 : 1",
    "distance from the start after one revolution; " + Describe(turned),
    turned.Status == vtkFlowStatus::OUT_OF_TIME ? Distance(turned.Position, { 30, 0, 0.2 })
                                                : std::nan(""),
    1e-4);

  // A closed orbit is detected when the streamline returns to its start.
  options = ForwardOptions();
  options.MaximumNumberOfSteps = 20000;
  const auto orbit = Advect(BoxWalker(Flow::Rotation(1.0), lattice), options, { 2, 0, 0 });
  catalogue.Check("closed-orbit", "a circle, no limit of time",
    "status closed orbit, on the circle", Describe(orbit),
    orbit.Status == vtkFlowStatus::CLOSED_ORBIT &&
      std::abs(std::hypot(orbit.Position[0], orbit.Position[1]) - 2.0) < 1e-6 * orbit.Time);
}

void TestSurfaces(StabilityCatalogue& catalogue)
{
  const BoxGrid lattice = MakeBoxGrid({ 0.25, 0.25, 0.25 }, 32);
  const Flow rotation = Flow::Rotation(1.0);
  const auto advect =
    [&](const std::vector<vtkSmartPointer<FormulaSurface>>& surfaces, Position start)
  {
    OwningAdvectionOptions options = ForwardOptions(surfaces);
    options.MaximumTime = 7.0;
    options.MaximumError = 1e-10;
    return Advect(BoxWalker(rotation, lattice), options, start);
  };
  const auto plane = [](double offset) { return FormulaSurface::Plane({ 1, 0, 0 }, offset, 1, 2); };
  const auto on = advect({ plane(2.0) }, { 2, 0.1, 0 });
  catalogue.Check("sample-on-surface", "a sample on a plane", "the surface is reached at time 0",
    Describe(on), on.Status == vtkFlowStatus::REACHED_SURFACE && on.Time == 0.0);
  const double angle = std::acos(1.0 - 0.5e-7);
  const auto grazed = advect({ plane(2.0 - 1e-7) }, { 0, -2, 0 });
  catalogue.Measure("tangent", "a circle that extends 1e-7 past a plane",
    "error of the time; " + Describe(grazed),
    grazed.Id == 10 ? grazed.Time - (0.5 * vtkMath::Pi() - angle) : std::nan(""), 1e-5);
  const auto touched = advect({ plane(2.0) }, { 0, -2, 0 });
  catalogue.Check("tangent-exact", "a circle that touches a plane", "status reached or out of time",
    Describe(touched),
    touched.Status == vtkFlowStatus::REACHED_SURFACE ||
      touched.Status == vtkFlowStatus::OUT_OF_TIME);
  const auto outside = advect({ plane(100.0) }, { 0, -2, 0 });
  catalogue.Check("surface-outside", "a surface outside the domain", "out of time",
    Describe(outside), outside.Status == vtkFlowStatus::OUT_OF_TIME);
  const auto first =
    advect({ plane(1.0), FormulaSurface::Sphere({ 1, -2, 0 }, 0.5) }, { 0, -2, 0 });
  catalogue.Check("overlapping", "a plane within a sphere", "the sphere is reached first",
    Describe(first), first.Id == 20);
  const auto same = advect({ plane(1.0), plane(1.0) }, { 0, -2, 0 });
  catalogue.Check("same-twice", "the same plane twice", "the first plane is reached",
    Describe(same), same.Id == 10);
}

}

int TestStabilityFlow(int argc, char* argv[])
{
  return RunCases(__func__, "vtkImplicitFlowField", argc, argv,
    { TestStiff, TestNodes, TestScales, TestFields, TestSurfaces });
}
