// SPDX-License-Identifier: BSD-3-Clause
// Optional results along streamlines, compared with exact values: maximum speed, arc length and
// means.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceAdvection.h"

#include "vtkImplicitFlowField.h" // for the integrators
#include "vtkMath.h"

#include <cmath>

namespace
{

using namespace reference;

const BoxGrid Cells = []
{
  BoxGrid grid;
  grid.Origin = { -6, -6, -6 };
  grid.Spacing = { 0.5, 0.4, 0.3 };
  grid.Cells = { 24, 30, 40 };
  return grid;
}();

OwningAdvectionOptions ExtraOptions(
  const std::vector<vtkSmartPointer<FormulaSurface>>& surfaces = {})
{
  OwningAdvectionOptions options = ForwardOptions(surfaces);
  options.MaximumError = 1e-8;
  options.ComputeMaximumSpeed = true;
  options.ComputeArcLength = true;
  options.ComputeMeanVorticity = true;
  options.MeanNumbers = { 1, 0 };
  return options;
}

/// Adds two arrays to a flow: x and y^2 + 3.
Flow WithArrays(Flow flow)
{
  flow.Array = [](int array, const double* x) { return array == 0 ? x[0] : x[1] * x[1] + 3.0; };
  return flow;
}

std::vector<interlume::AdvectionResult> AdvectInAll(
  const Flow& flow, const interlume::AdvectionOptions& options, const Position& start)
{
  return { Advect(SingleCellWalker(flow), options, start),
    Advect(BoxWalker(flow, Cells), options, start) };
}

void TestRotation(Check& check)
{
  const Flow flow = WithArrays(Flow::Rotation(2.0));
  for (int integrator = vtkImplicitFlowField::AUTOMATIC;
       integrator <= vtkImplicitFlowField::ROSENBROCK; ++integrator)
  {
    check.SetContext("integrator " + std::to_string(integrator));
    // The streamline reaches the plane y = 0 after half a rotation.
    OwningAdvectionOptions options =
      ExtraOptions({ FormulaSurface::Plane({ 0, 1, 0 }, -1e-9, 0, 2) });
    options.Integrator = integrator;
    for (const auto& result : AdvectInAll(flow, options, { 2.5, 0, 1 }))
    {
      const double half = 0.5 * vtkMath::Pi();
      check.Near(result.Time, half, 1e-7, "time of half a rotation");
      check.Near(result.MaximumSpeed, 5.0, 1e-7, "largest speed");
      check.Near(result.ArcLength, 5.0 * half, 1e-7, "length");
      check.Near(result.MeanVorticity, 4.0, 1e-12, "vorticity");
      check.Equal(static_cast<long long>(result.Means.size()), 2, "means");
      check.Near(result.Means[0], 3.0 + 0.5 * 6.25, 1e-7, "mean of y squared");
      check.Near(result.Means[1], 0.0, 1e-7, "mean of x", 1.0);
    }
  }
  check.SetContext("");
}

void TestSaddle(Check& check)
{
  const Flow flow = WithArrays(Flow::Linear({ 1, 0, 0, 0, -1, 0, 0, 0, 0 }));
  OwningAdvectionOptions options = ExtraOptions();
  options.MaximumTime = 2.0;
  // The exact arc length, computed by Simpson's rule.
  const Position start = { 0.3, 2.0, 0.1 };
  double length = 0.0;
  constexpr int pieces = 20000;
  for (int i = 0; i <= pieces; ++i)
  {
    const double t = 2.0 * i / pieces;
    const double weight = i == 0 || i == pieces ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    length += weight * std::hypot(0.3 * std::exp(t), 2.0 * std::exp(-t)) * 2.0 / (3.0 * pieces);
  }
  for (const auto& result : AdvectInAll(flow, options, start))
  {
    check.Near(result.ArcLength, length, 1e-7, "length at a saddle");
    check.Near(
      result.MaximumSpeed, std::hypot(0.3 * std::exp(2.0), 2.0 * std::exp(-2.0)), 1e-7, "speed");
    check.Near(result.MeanVorticity, 0.0, 1e-12, "no vorticity", 1.0);
    check.Near(result.Means[0], 3.0 + 1.0 * (1.0 - std::exp(-4.0)), 1e-7, "mean of y squared");
    check.Near(result.Means[1], 0.15 * (std::exp(2.0) - 1.0), 1e-7, "mean of x");
  }
}

/// The curl of this flow equals the flow.
void TestBeltrami(Check& check)
{
  const Flow flow = WithArrays(Flow::Beltrami(1.0, 0.7, 0.43));
  OwningAdvectionOptions options = ExtraOptions();
  options.MaximumTime = 3.0;
  for (const auto& result : AdvectInAll(flow, options, { 0.5, 0.6, 0.7 }))
  {
    check.Near(
      result.MeanVorticity * result.Time, result.ArcLength, 1e-7, "mean vorticity and arc length");
    check.That(result.ArcLength > 2.0, "the streamline is long");
    check.That(result.MaximumSpeed >= result.ArcLength / result.Time,
      "the maximum speed is at least the mean speed");
  }
}

void TestNoTime(Check& check)
{
  const Flow flow = WithArrays(Flow::Rotation(2.0));
  const auto surface = FormulaSurface::Plane({ 1, 0, 0 }, 2.5, 1, 2);
  for (const auto& result : AdvectInAll(flow, ExtraOptions({ surface }), { 2.5, 0.5, 1 }))
  {
    check.That(result.Status == vtkFlowStatus::REACHED_SURFACE && result.Time == 0.0,
      "a sample on a surface");
    check.Near(result.MaximumSpeed, 2.0 * std::hypot(2.5, 0.5), 1e-14, "speed at the sample");
    check.Near(result.ArcLength, 0.0, 0.0, "zero length");
    check.Near(result.MeanVorticity, 4.0, 1e-14, "vorticity at the sample");
    check.Near(result.Means[0], 3.25, 1e-14, "mean of y squared at the sample");
    check.Near(result.Means[1], 2.5, 1e-14, "mean of x at the sample");
  }
  const auto outside = Advect(BoxWalker(flow, Cells), ExtraOptions(), { 7, 0, 0 });
  check.That(outside.Status == vtkFlowStatus::OUTSIDE && outside.MaximumSpeed == 0.0 &&
      outside.Means.size() == 2 && outside.Means[0] == 0.0,
    "a sample outside has no results");
}

/// Results that are not requested are 0 and cause no evaluations. The streamline is unchanged.
void TestOff(Check& check)
{
  int gradients = 0;
  Flow flow = WithArrays(Flow::Rotation(2.0));
  flow.Gradient = [&gradients, gradient = flow.Gradient](const double* x, double* matrix)
  {
    ++gradients;
    gradient(x, matrix);
  };
  int velocities = 0;
  flow.Velocity = [&velocities, velocity = flow.Velocity](const double* x, double* v)
  {
    ++velocities;
    velocity(x, v);
  };
  OwningAdvectionOptions options = ForwardOptions();
  options.MaximumTime = 3.0;
  const auto plain = Advect(BoxWalker(flow, Cells), options, { 2.5, 0, 1 });
  check.Equal(velocities, plain.Evaluations, "evaluations are counted");
  check.Equal(gradients, 0, "no gradients");
  check.That(plain.MaximumSpeed == 0.0 && plain.ArcLength == 0.0 && plain.MeanVorticity == 0.0 &&
      plain.Means.empty(),
    "results that were not requested are 0");
  OwningAdvectionOptions all = ExtraOptions();
  all.MaximumError = options.MaximumError;
  all.MaximumTime = 3.0;
  const auto full = Advect(BoxWalker(flow, Cells), all, { 2.5, 0, 1 });
  check.That(full.Position[0] == plain.Position[0] && full.Steps == plain.Steps &&
      full.Evaluations == plain.Evaluations,
    "the streamline is unchanged");
  options.Integrator = vtkImplicitFlowField::ROSENBROCK;
  gradients = 0;
  const auto stiff = Advect(BoxWalker(flow, Cells), options, { 2.5, 0, 1 });
  check.Equal(stiff.JacobianEvaluations, gradients, "Jacobians are counted");
  check.Equal(gradients, stiff.StiffSteps + stiff.RejectedStiffSteps, "one Jacobian per step");
}

}

int TestAdvectionExtras(int, char*[])
{
  Check check;
  TestRotation(check);
  TestSaddle(check);
  TestBeltrami(check);
  TestNoTime(check);
  TestOff(check);
  return check.Result();
}
