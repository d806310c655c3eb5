// SPDX-License-Identifier: BSD-3-Clause
// Streamlines that end without a surface: every status, and limits that are reached exactly.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceAdvection.h"

#include "vtkFlowSettings.h"
#include "Advection/Advection.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace reference;

BoxGrid Cubes(int number)
{
  BoxGrid grid;
  grid.Cells = { number, number, number };
  return grid;
}

void TestOutside(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0, 0 });
  const BoxGrid grid = Cubes(4);
  const auto surface = FormulaSurface::Plane({ 1, 0, 0 }, -1.0, 1, 2);
  const auto result = Advect(BoxWalker(flow, grid), ForwardOptions({ surface }), { -1, 2, 2 });
  check.Equal(result.Status, vtkFlowStatus::OUTSIDE, "a sample outside, even on a surface");
  check.That(result.Position[0] == -1 && result.Time == 0.0 && result.Id == -1 &&
      result.Cells == 0 && result.Evaluations == 0,
    "results of a sample outside");
}

void TestLeaving(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0.5, 0 });
  BoxGrid grid = Cubes(4);
  auto left = Advect(BoxWalker(flow, grid), ForwardOptions(), { 0.5, 0.5, 0.5 });
  check.Equal(left.Status, vtkFlowStatus::LEFT_DOMAIN, "the streamline leaves the domain");
  check.Near(left.Time, 3.5, 1e-14, "time of leaving");
  check.Near(left.Position[1], 2.25, 1e-14, "position of leaving");
  check.Equal(left.Cells, 6, "cells entered");
  // The grid has no cells at index 2 along x.
  grid.IsCell = [](const auto& cell) { return cell[0] != 2; };
  interlume::AdvectionOptions options = ForwardOptions();
  options.DomainFaces = true;
  options.DomainFaceId = 0;
  left = Advect(BoxWalker(flow, grid), options, { 0.5, 0.5, 0.5 });
  check.Equal(left.Status, vtkFlowStatus::LEFT_DOMAIN, "a face of a hole is not a domain face");
  check.Near(left.Time, 1.5, 1e-14, "time until the hole");
  // Samples on the boundary, with outward, inward and tangential flow.
  grid = Cubes(4);
  const BoxWalker walker(flow, grid);
  left = Advect(walker, options, { 4, 1.25, 0.5 });
  check.That(left.Status == vtkFlowStatus::REACHED_SURFACE && left.Id == 1 && left.Time == 0.0 &&
      left.Parameters[0] == 0.3125,
    "outward from a face: " + Describe(left));
  left = Advect(walker, options, { 0, 1.25, 0.5 });
  check.That(left.Id == 1 && std::abs(left.Time - 4.0) < 1e-14, "inward from a face");
  const Flow along = Flow::Uniform({ 1, 0, 0 });
  for (const Position& start :
    { Position{ 0.5, 4, 4 }, Position{ 0.5, 0, 4 }, Position{ 0, 0, 0 } })
  {
    left = Advect(BoxWalker(along, grid), options, start);
    check.That(left.Id == 1 && std::abs(left.Time - (4.0 - start[0])) < 1e-14,
      "along an edge of the domain: " + Describe(left));
  }
}

/// Tests streamlines through edges and corners, along faces, and around an edge.
void TestEdges(Check& check)
{
  BoxGrid grid = Cubes(8);
  interlume::AdvectionOptions options = ForwardOptions();
  options.MaximumTime = 50.0;
  for (const Position& velocity : { Position{ 1, 1, 1 }, Position{ 1, 1, 0 }, Position{ 1, 0, 0 },
         Position{ 1, -1, 1 }, Position{ -1, -1, -1 }, Position{ 1, 1e-14, -1e-14 },
         Position{ 1, 1e-17, 1 }, Position{ 1, 1 + 1e-15, 1 } })
  {
    const Flow flow = Flow::Uniform(velocity);
    const auto result = Advect(BoxWalker(flow, grid), options, { 4, 4, 4 });
    check.Equal(result.Status, vtkFlowStatus::LEFT_DOMAIN, "from a corner: " + Describe(result));
    check.Near(result.Time, 4.0, 1e-13, "time from the center");
    for (std::size_t i = 0; i < 3; ++i)
    {
      check.Near(
        result.Position[i], 4.0 + 4.0 * velocity[i], 1e-12, "position from the center", 1.0);
    }
    check.That(NumberOfSteps(result) <= 12 && result.Cells <= 40, "few steps and cells");
  }
  // Cells next to the diagonal are missing, so cells along the diagonal share only an edge.
  grid.IsCell = [](const auto& cell) { return cell[0] == cell[1]; };
  auto result = Advect(BoxWalker(Flow::Uniform({ 1, 1, 0 }), grid), options, { 0.5, 0.5, 0.5 });
  check.Equal(
    result.Status, vtkFlowStatus::LEFT_DOMAIN, "the streamline ends at an edge without cells");
  check.Near(result.Time, 0.5, 1e-14, "time to the edge");
  grid.IsCell = [](const auto& cell) { return cell[0] == cell[1] || cell[0] == cell[1] + 1; };
  const Flow diagonal = Flow::Uniform({ 1, 1, 0 });
  result = Advect(BoxWalker(diagonal, grid), options, { 0.5, 0.5, 0.5 });
  check.That(result.Status == vtkFlowStatus::LEFT_DOMAIN && std::abs(result.Time - 7.5) < 1e-13,
    "around an edge, through the cells on one side: " + Describe(result));
  grid.IsCell = [](const auto& cell) { return cell[0] == cell[1] || cell[0] + 1 == cell[1]; };
  result = Advect(BoxWalker(diagonal, grid), options, { 0.5, 0.5, 0.5 });
  check.That(result.Status == vtkFlowStatus::LEFT_DOMAIN && std::abs(result.Time - 7.5) < 1e-13,
    "around an edge, through the cells on the other side: " + Describe(result));
  // Closed orbits of several radii, around a grid point and around a point on a grid edge.
  grid.IsCell = nullptr;
  const Flow rotation = Flow::Linear({ 0, -1, 0, 1, 0, 0, 0, 0, 0 }, { 4, 4, 4 });
  options.MaximumError = 1e-9;
  options.MaximumTime = 20.0 * vtkMath::Pi();
  for (double radius : { 1e-6, 1e-3, 0.5, 1.0, 2.0, 3.5 })
  {
    for (double height : { 4.0, 4.3 })
    {
      const auto orbit = Advect(BoxWalker(rotation, grid), options, { 4 + radius, 4, height });
      check.Equal(orbit.Status, vtkFlowStatus::OUT_OF_TIME, "ten orbits");
      check.Near(
        Distance(orbit.Position, { 4 + radius, 4, height }), 0.0, 6e-8, "the orbit is closed", 1.0);
    }
  }
  // The velocities of two adjacent cells point toward each other.
  grid.CellVelocity = [](const auto& cell) {
    return Position{ cell[0] < 4 ? 1.0 : -1.0, 0.125, 0.0 };
  };
  options = ForwardOptions();
  options.MaximumNumberOfSteps = 2000;
  result = Advect(BoxWalker(rotation, grid), options, { 3.5, 4.2, 4.5 });
  check.That(
    NumberOfSteps(result) <= 2000 && result.Time > 0.5 && std::abs(result.Position[0] - 4.0) < 0.1,
    "alternating between two cells: " + Describe(result));
}

void TestStagnation(Check& check)
{
  const Flow node = Flow::Linear({ -1, 0, 0, 0, -1, 0, 0, 0, -1 }, { 2.3, 2.4, 2.6 });
  const BoxGrid grid = Cubes(4);
  const BoxWalker walker(node, grid);
  for (int integrator = vtkFlowSettings::AUTOMATIC; integrator <= vtkFlowSettings::ROSENBROCK;
       ++integrator)
  {
    interlume::AdvectionOptions options = ForwardOptions();
    options.Integrator = integrator;
    options.MinimumSpeed = 1e-3;
    auto result = Advect(walker, options, { 0.3, 0.4, 0.6 });
    check.Equal(result.Status, vtkFlowStatus::STAGNATED, "a node");
    const double distance = Distance(result.Position, { 2.3, 2.4, 2.6 });
    check.That(distance < 1e-3 && distance > 1e-6, "the streamline ends where the flow is slow");
    // Without a minimum speed, the streamline ends where steps become too small.
    options.MinimumSpeed = 0.0;
    result = Advect(walker, options, { 0.3, 0.4, 0.6 });
    check.That(result.Status == vtkFlowStatus::STAGNATED && NumberOfSteps(result) < 1000,
      "at the node: " + Describe(result));
    check.That(Distance(result.Position, { 2.3, 2.4, 2.6 }) <= options.MaximumError * result.Time,
      "the end is the node within the error: " + Describe(result));
    const auto origin = Advect(
      SingleCellWalker(Flow::Linear({ -1, 0, 0, 0, -1, 0, 0, 0, -1 })), options, { 0.3, 0.4, 0.6 });
    check.That(origin.Status == vtkFlowStatus::STAGNATED && NumberOfSteps(origin) < 1000,
      "a node at the origin: " + Describe(origin));
  }
  interlume::AdvectionOptions options = ForwardOptions();
  const Flow zero = Flow::Uniform({ 0, 0, 0 });
  const auto still = Advect(BoxWalker(zero, grid), options, { 1, 2, 3 });
  check.That(still.Status == vtkFlowStatus::STAGNATED && still.Time == 0.0 &&
      NumberOfSteps(still) == 0 && still.Position[1] == 2.0,
    "no flow");
}

void TestLimits(Check& check)
{
  const Flow flow = Flow::Rotation(1.0);
  BoxGrid grid = Cubes(8);
  grid.Origin = { -4, -4, -4 };
  const BoxWalker walker(flow, grid);
  for (int integrator = vtkFlowSettings::AUTOMATIC; integrator <= vtkFlowSettings::ROSENBROCK;
       ++integrator)
  {
    interlume::AdvectionOptions options = ForwardOptions();
    options.Integrator = integrator;
    options.MaximumError = 1e-9;
    for (double time : { 0.1, 1.0 / 3.0, 2.0, 7.7 })
    {
      options.MaximumTime = time;
      const auto result = Advect(walker, options, { 3, 0.1, 0.2 });
      check.Equal(result.Status, vtkFlowStatus::OUT_OF_TIME, "a limit of the time");
      check.That(result.Time == time, "the time equals the limit");
      const double cosine = std::cos(time);
      const double sine = std::sin(time);
      check.Near(
        Distance(result.Position, { 3 * cosine - 0.1 * sine, 3 * sine + 0.1 * cosine, 0.2 }), 0.0,
        2e-8, "the position at the limit", 1.0);
    }
    options.MaximumTime = VTK_DOUBLE_MAX;
    for (int number : { 1, 2, 17, 500 })
    {
      options.MaximumNumberOfSteps = number;
      const auto result = Advect(walker, options, { 3, 0.1, 0.2 });
      check.Equal(result.Status, vtkFlowStatus::OUT_OF_STEPS, "a limit of the number of steps");
      check.Equal(NumberOfSteps(result), number, "the number of steps equals the limit");
      check.Near(std::hypot(result.Position[0], result.Position[1]), std::hypot(3.0, 0.1), 1e-6,
        "the position lies on the circle");
    }
  }
}

void TestNotFinite(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0, 0 });
  BoxGrid grid = Cubes(4);
  grid.IsFinite = [](const auto& cell) { return cell[0] != 2; };
  interlume::AdvectionOptions options = ForwardOptions();
  auto result = Advect(BoxWalker(flow, grid), options, { 0.5, 0.5, 0.5 });
  check.Equal(result.Status, vtkFlowStatus::NOT_FINITE, "a cell with non-finite velocity");
  check.Near(result.Time, 1.5, 1e-14, "time of reaching the cell");
  check.Near(result.Position[0], 2.0, 1e-14, "position at the cell");
  result = Advect(BoxWalker(flow, grid), options, { 2.5, 0.5, 0.5 });
  check.That(
    result.Status == vtkFlowStatus::NOT_FINITE && result.Time == 0.0, "a sample in the cell");
  // The velocity is NaN for x >= 2 (wall), or becomes infinite at x = 2 (pole). There is no cell
  // face at x = 2.
  Flow wall = flow;
  wall.Velocity = [](const double* x, double* v)
  {
    v[0] = x[0] < 2.0 ? 1.0 : std::numeric_limits<double>::quiet_NaN();
    v[1] = v[2] = 0.0;
  };
  Flow pole = flow;
  pole.Velocity = [](const double* x, double* v)
  {
    v[0] = 1.0 / (2.0 - x[0]);
    v[1] = v[2] = 0.0;
  };
  pole.Gradient = [](const double* x, double* gradient)
  {
    std::fill(gradient, gradient + 9, 0.0);
    gradient[0] = 1.0 / ((2.0 - x[0]) * (2.0 - x[0]));
  };
  for (int integrator = vtkFlowSettings::AUTOMATIC; integrator <= vtkFlowSettings::ROSENBROCK;
       ++integrator)
  {
    options.Integrator = integrator;
    result = Advect(SingleCellWalker(wall), options, { 0, 0, 0 });
    check.Equal(result.Status, vtkFlowStatus::NOT_FINITE, "NaN ahead: " + Describe(result));
    check.Near(result.Time, 2.0, 1e-12, "time to NaN");
    options.MaximumNumberOfSteps = 20000;
    result = Advect(SingleCellWalker(pole), options, { 0, 0, 0 });
    check.That(NumberOfSteps(result) <= 20000 && std::abs(result.Time - 2.0) < 1e-3,
      "infinity ahead: " + Describe(result));
  }
}

/// Tests root finding for polynomials in Bernstein form and for other functions.
void TestRoots(Check& check)
{
  const auto product = [](const std::vector<double>& roots, double factor)
  {
    // factor * prod (root - theta), in the power basis and then in Bernstein form
    std::vector<double> powers = { factor };
    for (double root : roots)
    {
      std::vector<double> next(powers.size() + 1, 0.0);
      for (std::size_t i = 0; i < powers.size(); ++i)
      {
        next[i] += root * powers[i];
        next[i + 1] -= powers[i];
      }
      powers = next;
    }
    interlume::DenseOutput<double> dense{};
    dense.Degree = static_cast<int>(powers.size()) - 1;
    for (std::size_t i = 0; i < powers.size(); ++i)
    {
      dense.Coefficients[i][0] = powers[i];
    }
    double points[interlume::DenseOutput<double>::MaximumDegree + 1][3];
    dense.GetControlPoints(points);
    std::vector<double> bernstein;
    for (int i = 0; i <= dense.Degree; ++i)
    {
      bernstein.push_back(points[i][0]);
    }
    return interlume::BernsteinRoot::Find(bernstein.data(), dense.Degree);
  };
  check.Near(product({ 0.3 }, 1.0), 0.3, 1e-15, "one root");
  check.Near(product({ 0.3, 0.301, 2.0, 3.0 }, 1.0), 0.3, 1e-12, "two roots close together");
  check.Near(product({ 0.7, 0.2, 0.9, 1.5, -1.0 }, -1.0), 0.2, 1e-13, "the first of five roots");
  check.Near(product({ 0.2, 0.7, 0.9, 1.5, 2.0 }, 1.0), 0.2, 1e-13, "the first of three roots");
  check.Near(product({ 1e-9, 0.5 }, 1.0), 1e-9, 1e-15, "a root near the start", 1e-9);
  check.Near(product({ 0.999999, 3.0 }, 1.0), 0.999999, 1e-14, "a root near the end");
  check.That(product({ 1.001, 3.0 }, 1.0) > 1.0, "a root after the end");
  check.That(product({ -0.001, -3.0 }, 1.0) > 1.0, "roots before the start");
  const double above[3] = { 1.0, -0.1, 1.0 };
  check.That(
    interlume::BernsteinRoot::Find(above, 2) > 1.0, "a negative control point of a positive curve");
  const double dip[3] = { 1.0, -1.1, 1.0 };
  check.Near(interlume::BernsteinRoot::Find(dip, 2), (4.2 - std::sqrt(0.84)) / 8.4, 1e-14,
    "roots on entering and leaving");
  for (double power : { 1.0, 3.0, 9.0 })
  {
    int calls = 0;
    auto function = [&](double x)
    {
      ++calls;
      return std::pow(x, power) - 0.3;
    };
    check.Near(interlume::BracketedRoot::Find(function, 0.0, -0.3, 2.0, std::pow(2.0, power) - 0.3),
      std::pow(0.3, 1.0 / power), 1e-14, "a multiple root");
    check.That(calls < 40, std::to_string(calls) + " evaluations");
  }
  auto jump = [](double x) { return x < 0.625 ? 1.0 : -2.0; };
  check.Near(
    interlume::BracketedRoot::Find(jump, 0.0, 1.0, 1.0, -2.0), 0.625, 1e-15, "a discontinuity");
}

/// Fifteen steps at the stability limit indicate a stiff problem. Six successive steps far from the
/// limit reset the test.
void TestStiffness(Check& check)
{
  interlume::StiffnessTest test;
  const auto add = [&test](int number, double stiffness)
  {
    for (int i = 0; i < number; ++i)
    {
      test.Add(stiffness);
    }
    return test.IsStiff();
  };
  check.That(!add(100, 3.2), "large but stable steps");
  check.That(!add(14, 3.3), "fourteen stiff steps");
  check.That(!add(5, 3.2) && add(1, 3.3), "a fifteenth stiff step after stable steps");
  check.That(add(100, 2.1) && add(5, 1.9) && add(1, 2.1) && add(5, 1.9),
    "fewer than six small steps in sequence");
  check.That(!add(1, 1.9), "six small steps in sequence");
  check.That(!add(14, 3.3) && !add(6, 3.2) && !add(14, 3.3) && add(1, 3.3), "counting restarts");
}

/// Steps far from the stability limit count the same whether they are added together or one by one.
void TestHarmlessSteps(Check& check)
{
  std::mt19937 random(5);
  for (int run = 0; run < 200; ++run)
  {
    interlume::StiffnessTest together;
    interlume::StiffnessTest separate;
    while (!separate.IsStiff())
    {
      // Add the harmless steps in two parts, as if they were in two cells.
      const int harmless = static_cast<int>(random() % 8);
      const int first = static_cast<int>(random() % (harmless + 1));
      together.AddNonStiff(first);
      together.AddNonStiff(harmless - first);
      for (int i = 0; i < harmless; ++i)
      {
        separate.Add(interlume::StiffnessTest::MinimumStiff);
      }
      const int stiff = 1 + static_cast<int>(random() % 16);
      for (int i = 0; i < stiff && !separate.IsStiff(); ++i)
      {
        together.Add(3.3);
        separate.Add(3.3);
        check.Equal(together.IsStiff(), separate.IsStiff(), "stiffness after steps added together");
      }
    }
  }
}

/// Advection objects can be reused. Each streamline equals the streamline of a new object.
void TestReuse(Check& check)
{
  const Flow flow = Flow::Beltrami(1.0, 0.7, 0.43);
  const BoxGrid grid = Cubes(6);
  const auto sphere = FormulaSurface::Sphere({ 3, 3, 3 }, 0.5);
  interlume::AdvectionOptions options = ForwardOptions();
  options.Surfaces.push_back({ sphere, 4 });
  options.MaximumTime = 20.0;
  interlume::Advection<BoxWalker> advection(BoxWalker(flow, grid), options);
  interlume::AdvectionResult result;
  for (int i = 0; i < 200; ++i)
  {
    const Position start = { 0.03 * i, 6.0 - 0.029 * i, 1.0 + 0.02 * i };
    advection.Follow(start.data(), result);
    const auto fresh = Advect(BoxWalker(flow, grid), options, start);
    check.That(result.Status == fresh.Status && result.Time == fresh.Time &&
        result.Position[0] == fresh.Position[0] && result.Steps == fresh.Steps &&
        result.Evaluations == fresh.Evaluations &&
        result.DistanceEvaluations == fresh.DistanceEvaluations && result.Cells == fresh.Cells &&
        result.Parameters[0] == fresh.Parameters[0],
      "same streamline with a reused object: " + Describe(result) + " and " + Describe(fresh));
  }
}

}

int TestAdvectionStatus(int, char*[])
{
  Check check;
  TestOutside(check);
  TestLeaving(check);
  TestEdges(check);
  TestStagnation(check);
  TestLimits(check);
  TestNotFinite(check);
  TestRoots(check);
  TestStiffness(check);
  TestHarmlessSteps(check);
  TestReuse(check);
  return check.Result();
}
