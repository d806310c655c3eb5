// SPDX-License-Identifier: BSD-3-Clause
// Closed orbits are detected long before the maximum number of steps. Spirals that run inward,
// outward or along an axis reach the same surfaces as without the detection, however slow they are,
// and so do streamlines near a repelling orbit.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceAdvection.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationPlane.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <array>
#include <cmath>

namespace
{

using namespace reference;

/// Returns cells of width 1 in [-4, 4]^3.
BoxGrid MakeGrid()
{
  BoxGrid grid;
  grid.Cells = { 8, 8, 8 };
  grid.Origin = { -4, -4, -4 };
  return grid;
}

void TestClosed(Check& check)
{
  const Flow flow = Flow::Rotation(1.0);
  const BoxGrid grid = MakeGrid();
  const BoxWalker walker(flow, grid);
  for (int integrator = vtkImplicitFlowField::AUTOMATIC;
       integrator <= vtkImplicitFlowField::ROSENBROCK; ++integrator)
  {
    check.SetContext("closed, integrator " + std::to_string(integrator));
    OwningAdvectionOptions options =
      ForwardOptions({ FormulaSurface::Plane({ { 0, 0, 1 } }, 2.0, 0, 1) });
    options.Integrator = integrator;
    options.MaximumNumberOfSteps = 20000;
    for (const double radius : { 1.3, 2.0, 3.3 })
    {
      const auto result = Advect(walker, options, { radius, 0.1, 0.2 });
      check.Equal(result.Status, vtkFlowStatus::CLOSED_ORBIT, Describe(result));
      check.That(NumberOfSteps(result) < options.MaximumNumberOfSteps / 4, Describe(result));
      options.SetBackward(!options.IsBackward());
    }
    // The distance to the surface is within the uncertainty of the orbit, so the orbit does not
    // count as closed.
    const auto near = Advect(walker, options, { 2.0, 0.1, 1.999999 });
    check.Equal(near.Status, vtkFlowStatus::OUT_OF_STEPS, Describe(near));
  }
}

/// Tests spirals in the flow (-y - inward x, x - inward y, along z) that start at (radius, 0, z).
void TestSpirals(Check& check)
{
  const BoxGrid grid = MakeGrid();
  int late = 0;
  for (const double inward : { 0.1, 0.01, 1e-3, 1e-4, -0.1, -0.01, -1e-3, -1e-4 })
  {
    for (const double along : { 0.0, 0.05, 5e-3, 5e-4 })
    {
      check.SetContext("inward " + std::to_string(inward) + ", along " + std::to_string(along));
      const Flow flow = Flow::Linear({ { -inward, -1, 0, 1, -inward, 0, 0, 0, along } });
      const BoxWalker walker(flow, grid);
      OwningAdvectionOptions options = ForwardOptions(
        { FormulaSurface::Sphere({ 0, 0, 0 }, 0.9), FormulaSurface::Sphere({ 0, 0, 0 }, 3.9) });
      for (const double radius : { 0.95, 1.5, 2.5, 3.7 })
      {
        for (const double z : { 0.0, 1e-6, 0.01 })
        {
          // Time at which the exact streamline reaches one of the spheres.
          double time = 0.0;
          const auto distance = [&](double t)
          { return std::hypot(radius * std::exp(-inward * t), z * std::exp(along * t)); };
          while (distance(time) > 0.9 && distance(time) < 3.9 && time < 2e4)
          {
            time += 0.01;
          }
          // The step limit affects the detection of orbits, so a low and a high limit are compared.
          options.MaximumNumberOfSteps = 2000;
          const auto result = Advect(walker, options, { radius, 0, z });
          options.MaximumNumberOfSteps = 200000;
          const auto full = Advect(walker, options, { radius, 0, z });
          if (time < 2e4)
          {
            check.Equal(full.Status, vtkFlowStatus::REACHED_SURFACE, Describe(full));
            check.Near(full.Time, time, 1e-3, "time", 10.0);
          }
          // A streamline that needs fewer steps than the low limit also reaches its surface with
          // the low limit.
          const bool isReached =
            full.Status == vtkFlowStatus::REACHED_SURFACE && NumberOfSteps(full) < 2000;
          check.That(!isReached || result.Status == vtkFlowStatus::REACHED_SURFACE,
            Describe(result) + " instead of " + Describe(full));
          late += isReached && NumberOfSteps(full) > 500 ? 1 : 0;
        }
      }
    }
  }
  check.That(late > 5, "some streamlines take many steps: " + std::to_string(late));
}

/// Tests streamlines near a repelling orbit, where dr/dt = rate (r - 2) with r = hypot(x, y).
void TestRepelled(Check& check)
{
  const BoxGrid grid = MakeGrid();
  for (const double rate : { 0.03, 0.1, 0.5 })
  {
    for (const double start : { 1e-2, 1e-4, 1e-6, -1e-2, -1e-4, -1e-6 })
    {
      check.SetContext("repelled, " + std::to_string(rate) + ", " + std::to_string(start));
      Flow flow = Flow::Rotation(1.0);
      flow.Velocity = [rate](const double* x, double* v)
      {
        const double r = std::hypot(x[0], x[1]);
        const double outward = rate * (r - 2.0) / r;
        v[0] = -x[1] + outward * x[0];
        v[1] = x[0] + outward * x[1];
        v[2] = 0.0;
      };
      const BoxWalker walker(flow, grid);
      OwningAdvectionOptions options = ForwardOptions(
        { FormulaSurface::Sphere({ 0, 0, 0 }, 1.1), FormulaSurface::Sphere({ 0, 0, 0 }, 3.1) });
      options.Integrator = vtkImplicitFlowField::DORMAND_PRINCE;
      options.MaximumError = 1e-9;
      options.MaximumNumberOfSteps = 200000;
      const auto result = Advect(walker, options, { 2.0 + start, 0, 0 });
      check.Equal(result.Status, vtkFlowStatus::REACHED_SURFACE, Describe(result));
    }
  }
}

/// Hill's vortex of radius 0.6 in uniform flow.
Vector Hill(const Vector& x)
{
  constexpr double a = 0.6;
  const double across = x[0] * x[0] + x[1] * x[1];
  const double r = std::sqrt(across + x[2] * x[2]);
  if (r < a)
  {
    const double outward = 1.5 * x[2] / (a * a);
    return { { outward * x[0], outward * x[1], 1.5 * (1.0 - (across + r * r) / (a * a)) } };
  }
  const double outward = 1.5 * a * a * a * x[2] / std::pow(r, 5);
  return { { outward * x[0], outward * x[1],
    -1.0 + std::pow(a / r, 3) - 1.5 * a * a * a * across / std::pow(r, 5) } };
}

void TestHill(Check& check)
{
  check.SetContext("Hill's vortex");
  vtkNew<vtkImageData> image;
  image->SetDimensions(33, 33, 33);
  image->SetOrigin(-1, -1, -1);
  image->SetSpacing(1.0 / 16, 1.0 / 16, 1.0 / 16);
  AddVectors(image, Hill);
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(-2, -2, 0.95);
  plane->SetPoint1(2, -2, 0.95);
  plane->SetPoint2(-2, 2, 0.95);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputData(image);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  field->AddTerminationSurface(plane);
  field->Update();
  vtkInterlumeReport* report = field->GetReport();
  const vtkIdType closed = report->GetNumber("Statuses", vtkFlowStatus::CLOSED_ORBIT);
  const vtkIdType out = report->GetNumber("Statuses", vtkFlowStatus::OUT_OF_STEPS);
  check.That(closed > 1000, "closed orbits: " + std::to_string(closed));
  check.That(out < closed / 4, "out of steps: " + std::to_string(out));
}

}

int TestAdvectionRecurrence(int, char*[])
{
  Check check;
  TestClosed(check);
  TestSpirals(check);
  TestRepelled(check);
  TestHill(check);
  return check.Result();
}
