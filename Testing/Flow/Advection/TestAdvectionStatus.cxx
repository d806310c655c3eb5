// SPDX-License-Identifier: BSD-3-Clause
// How streamlines end where they reach no surface: every status, and limits to the last digit.
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

Lattice Cubes(int number)
{
  Lattice lattice;
  lattice.Cells = { number, number, number };
  return lattice;
}

void TestOutside(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0, 0 });
  const Lattice lattice = Cubes(4);
  const auto surface = FormulaSurface::Plane({ 1, 0, 0 }, -1.0, 1, 2);
  const auto result =
    Advect(LatticeWalker(flow, lattice), ForwardOptions({ surface }), { -1, 2, 2 });
  check.Equal(result.Status, vtkFlowStatus::OUTSIDE, "a sample outside, even on a surface");
  check.That(result.Position[0] == -1 && result.Time == 0.0 && result.Id == -1 &&
      result.Cells == 0 && result.Evaluations == 0,
    "nothing but the sample");
}

void TestLeaving(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0.5, 0 });
  Lattice lattice = Cubes(4);
  auto left = Advect(LatticeWalker(flow, lattice), ForwardOptions(), { 0.5, 0.5, 0.5 });
  check.Equal(left.Status, vtkFlowStatus::LEFT_DOMAIN, "the end of the field");
  check.Near(left.Time, 3.5, 1e-14, "time until there");
  check.Near(left.Position[1], 2.25, 1e-14, "place there");
  check.Equal(left.Cells, 6, "cells entered");
  // A cell that is missing.
  lattice.IsCell = [](const auto& cell) { return cell[0] != 2; };
  interlume::AdvectionOptions options = ForwardOptions();
  options.DomainFaces = true;
  options.DomainFaceId = 0;
  left = Advect(LatticeWalker(flow, lattice), options, { 0.5, 0.5, 0.5 });
  check.Equal(left.Status, vtkFlowStatus::LEFT_DOMAIN, "a hole is no face of the domain");
  check.Near(left.Time, 1.5, 1e-14, "time until the hole");
  // A sample on the boundary, outwards and inwards and along it.
  lattice = Cubes(4);
  const LatticeWalker walker(flow, lattice);
  left = Advect(walker, options, { 4, 1.25, 0.5 });
  check.That(left.Status == vtkFlowStatus::REACHED_SURFACE && left.Id == 1 && left.Time == 0.0 &&
      left.Parameters[0] == 0.3125,
    "outwards from a face: " + Describe(left));
  left = Advect(walker, options, { 0, 1.25, 0.5 });
  check.That(left.Id == 1 && std::abs(left.Time - 4.0) < 1e-14, "inwards from a face");
  const Flow along = Flow::Uniform({ 1, 0, 0 });
  for (const Place& start : { Place{ 0.5, 4, 4 }, Place{ 0.5, 0, 4 }, Place{ 0, 0, 0 } })
  {
    left = Advect(LatticeWalker(along, lattice), options, start);
    check.That(left.Id == 1 && std::abs(left.Time - (4.0 - start[0])) < 1e-14,
      "along an edge of the domain: " + Describe(left));
  }
}

/// Through edges and corners, along faces, and round an edge that is all of a streamline's middle.
void TestEdges(Check& check)
{
  Lattice lattice = Cubes(8);
  interlume::AdvectionOptions options = ForwardOptions();
  options.MaximumTime = 50.0;
  for (const Place& velocity :
    { Place{ 1, 1, 1 }, Place{ 1, 1, 0 }, Place{ 1, 0, 0 }, Place{ 1, -1, 1 }, Place{ -1, -1, -1 },
      Place{ 1, 1e-14, -1e-14 }, Place{ 1, 1e-17, 1 }, Place{ 1, 1 + 1e-15, 1 } })
  {
    const Flow flow = Flow::Uniform(velocity);
    const auto result = Advect(LatticeWalker(flow, lattice), options, { 4, 4, 4 });
    check.Equal(result.Status, vtkFlowStatus::LEFT_DOMAIN, "from a corner: " + Describe(result));
    check.Near(result.Time, 4.0, 1e-13, "time from the middle");
    for (std::size_t i = 0; i < 3; ++i)
    {
      check.Near(result.Position[i], 4.0 + 4.0 * velocity[i], 1e-12, "place from the middle", 1.0);
    }
    check.That(NumberOfSteps(result) <= 12 && result.Cells <= 40, "few steps and cells");
  }
  // Missing cells beside the diagonal: there is no way but through the edge.
  lattice.IsCell = [](const auto& cell) { return cell[0] == cell[1]; };
  auto result =
    Advect(LatticeWalker(Flow::Uniform({ 1, 1, 0 }), lattice), options, { 0.5, 0.5, 0.5 });
  check.Equal(result.Status, vtkFlowStatus::LEFT_DOMAIN, "nothing beyond an edge");
  check.Near(result.Time, 0.5, 1e-14, "time to the edge");
  lattice.IsCell = [](const auto& cell) { return cell[0] == cell[1] || cell[0] == cell[1] + 1; };
  const Flow diagonal = Flow::Uniform({ 1, 1, 0 });
  result = Advect(LatticeWalker(diagonal, lattice), options, { 0.5, 0.5, 0.5 });
  check.That(result.Status == vtkFlowStatus::LEFT_DOMAIN && std::abs(result.Time - 7.5) < 1e-13,
    "round an edge by the cells on one side: " + Describe(result));
  lattice.IsCell = [](const auto& cell) { return cell[0] == cell[1] || cell[0] + 1 == cell[1]; };
  result = Advect(LatticeWalker(diagonal, lattice), options, { 0.5, 0.5, 0.5 });
  check.That(result.Status == vtkFlowStatus::LEFT_DOMAIN && std::abs(result.Time - 7.5) < 1e-13,
    "round an edge by the cells on the other side: " + Describe(result));
  // Closed orbits round an edge and a corner, and through the middles of faces.
  lattice.IsCell = nullptr;
  const Flow rotation = Flow::Linear({ 0, -1, 0, 1, 0, 0, 0, 0, 0 }, { 4, 4, 4 });
  options.MaximumError = 1e-9;
  options.MaximumTime = 20.0 * vtkMath::Pi();
  for (double radius : { 1e-6, 1e-3, 0.5, 1.0, 2.0, 3.5 })
  {
    for (double height : { 4.0, 4.3 })
    {
      const auto orbit =
        Advect(LatticeWalker(rotation, lattice), options, { 4 + radius, 4, height });
      check.Equal(orbit.Status, vtkFlowStatus::OUT_OF_TIME, "ten times around");
      check.Near(Distance(orbit.Position, { 4 + radius, 4, height }), 0.0, 6e-8, "back again", 1.0);
    }
  }
  // Two cells of which each sends the streamline to the other.
  lattice.CellVelocity = [](const auto& cell) {
    return Place{ cell[0] < 4 ? 1.0 : -1.0, 0.125, 0.0 };
  };
  options = ForwardOptions();
  options.MaximumNumberOfSteps = 2000;
  result = Advect(LatticeWalker(rotation, lattice), options, { 3.5, 4.2, 4.5 });
  check.That(
    NumberOfSteps(result) <= 2000 && result.Time > 0.5 && std::abs(result.Position[0] - 4.0) < 0.1,
    "to and fro: " + Describe(result));
}

void TestStagnation(Check& check)
{
  const Flow node = Flow::Linear({ -1, 0, 0, 0, -1, 0, 0, 0, -1 }, { 2.3, 2.4, 2.6 });
  const Lattice lattice = Cubes(4);
  const LatticeWalker walker(node, lattice);
  for (int integrator = vtkFlowSettings::AUTOMATIC; integrator <= vtkFlowSettings::ROSENBROCK;
       ++integrator)
  {
    interlume::AdvectionOptions options = ForwardOptions();
    options.Integrator = integrator;
    options.MinimumSpeed = 1e-3;
    auto result = Advect(walker, options, { 0.3, 0.4, 0.6 });
    check.Equal(result.Status, vtkFlowStatus::STAGNATED, "a node");
    const double distance = Distance(result.Position, { 2.3, 2.4, 2.6 });
    check.That(distance < 1e-3 && distance > 1e-6, "it is slow there");
    // Without a least speed it ends where steps are lost.
    options.MinimumSpeed = 0.0;
    result = Advect(walker, options, { 0.3, 0.4, 0.6 });
    check.That(result.Status == vtkFlowStatus::STAGNATED && NumberOfSteps(result) < 1000,
      "at the node: " + Describe(result));
    check.That(Distance(result.Position, { 2.3, 2.4, 2.6 }) <= options.MaximumError * result.Time,
      "the node to the error: " + Describe(result));
    const auto origin = Advect(
      SpaceWalker(Flow::Linear({ -1, 0, 0, 0, -1, 0, 0, 0, -1 })), options, { 0.3, 0.4, 0.6 });
    check.That(origin.Status == vtkFlowStatus::STAGNATED && NumberOfSteps(origin) < 1000,
      "a node at the origin: " + Describe(origin));
  }
  interlume::AdvectionOptions options = ForwardOptions();
  const Flow zero = Flow::Uniform({ 0, 0, 0 });
  const auto still = Advect(LatticeWalker(zero, lattice), options, { 1, 2, 3 });
  check.That(still.Status == vtkFlowStatus::STAGNATED && still.Time == 0.0 &&
      NumberOfSteps(still) == 0 && still.Position[1] == 2.0,
    "no flow");
}

void TestLimits(Check& check)
{
  const Flow flow = Flow::Rotation(1.0);
  Lattice lattice = Cubes(8);
  lattice.Origin = { -4, -4, -4 };
  const LatticeWalker walker(flow, lattice);
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
      check.Equal(result.Status, vtkFlowStatus::OUT_OF_TIME, "a limit of time");
      check.That(result.Time == time, "the time of the limit");
      const double cosine = std::cos(time);
      const double sine = std::sin(time);
      check.Near(
        Distance(result.Position, { 3 * cosine - 0.1 * sine, 3 * sine + 0.1 * cosine, 0.2 }), 0.0,
        2e-8, "the place at that time", 1.0);
    }
    options.MaximumTime = VTK_DOUBLE_MAX;
    for (int number : { 1, 2, 17, 500 })
    {
      options.MaximumNumberOfSteps = number;
      const auto result = Advect(walker, options, { 3, 0.1, 0.2 });
      check.Equal(result.Status, vtkFlowStatus::OUT_OF_STEPS, "a limit of steps");
      check.Equal(NumberOfSteps(result), number, "as many steps");
      check.Near(std::hypot(result.Position[0], result.Position[1]), std::hypot(3.0, 0.1), 1e-6,
        "the circle");
    }
  }
}

void TestNotFinite(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0, 0 });
  Lattice lattice = Cubes(4);
  lattice.IsFinite = [](const auto& cell) { return cell[0] != 2; };
  interlume::AdvectionOptions options = ForwardOptions();
  auto result = Advect(LatticeWalker(flow, lattice), options, { 0.5, 0.5, 0.5 });
  check.Equal(result.Status, vtkFlowStatus::NOT_FINITE, "a cell that is not finite");
  check.Near(result.Time, 1.5, 1e-14, "time to there");
  check.Near(result.Position[0], 2.0, 1e-14, "place there");
  result = Advect(LatticeWalker(flow, lattice), options, { 2.5, 0.5, 0.5 });
  check.That(result.Status == vtkFlowStatus::NOT_FINITE && result.Time == 0.0, "a sample in it");
  // A field that is NaN from x = 2 in the midst of a cell, and one that becomes infinite there.
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
    result = Advect(SpaceWalker(wall), options, { 0, 0, 0 });
    check.Equal(result.Status, vtkFlowStatus::NOT_FINITE, "NaN ahead: " + Describe(result));
    check.Near(result.Time, 2.0, 1e-12, "time to NaN");
    options.MaximumNumberOfSteps = 20000;
    result = Advect(SpaceWalker(pole), options, { 0, 0, 0 });
    check.That(NumberOfSteps(result) <= 20000 && std::abs(result.Time - 2.0) < 1e-3,
      "infinity ahead: " + Describe(result));
  }
}

/// The parts: roots of polynomials in Bernstein's form, and of functions.
void TestRoots(Check& check)
{
  const auto product = [](const std::vector<double>& roots, double factor)
  {
    // factor prod (root - theta), by powers and then in Bernstein's form
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
  check.Near(product({ 0.7, 0.2, 0.9, 1.5, -1.0 }, -1.0), 0.2, 1e-13, "the first of five");
  check.Near(product({ 0.2, 0.7, 0.9, 1.5, 2.0 }, 1.0), 0.2, 1e-13, "the first of three");
  check.Near(product({ 1e-9, 0.5 }, 1.0), 1e-9, 1e-15, "a root near the start", 1e-9);
  check.Near(product({ 0.999999, 3.0 }, 1.0), 0.999999, 1e-14, "a root near the end");
  check.That(product({ 1.001, 3.0 }, 1.0) > 1.0, "a root beyond the end");
  check.That(product({ -0.001, -3.0 }, 1.0) > 1.0, "roots before the start");
  const double above[3] = { 1.0, -0.1, 1.0 };
  check.That(
    interlume::BernsteinRoot::Find(above, 2) > 1.0, "a control point below 0, the curve above");
  const double dip[3] = { 1.0, -1.1, 1.0 };
  check.Near(
    interlume::BernsteinRoot::Find(dip, 2), (4.2 - std::sqrt(0.84)) / 8.4, 1e-14, "in and out");
  for (double power : { 1.0, 3.0, 9.0 })
  {
    int calls = 0;
    auto function = [&](double x)
    {
      ++calls;
      return std::pow(x, power) - 0.3;
    };
    check.Near(interlume::BracketedRoot::Find(function, 0.0, -0.3, 2.0, std::pow(2.0, power) - 0.3),
      std::pow(0.3, 1.0 / power), 1e-14, "a root of a power");
    check.That(calls < 40, std::to_string(calls) + " evaluations");
  }
  auto jump = [](double x) { return x < 0.625 ? 1.0 : -2.0; };
  check.Near(interlume::BracketedRoot::Find(jump, 0.0, 1.0, 1.0, -2.0), 0.625, 1e-15, "a jump");
}

/// Fifteen steps at the edge of stability are stiff, six small ones are no more.
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
  check.That(!add(100, 3.2), "large, but stable steps");
  check.That(!add(14, 3.3), "fourteen steps");
  check.That(!add(5, 3.2) && add(1, 3.3), "a fifteenth, after others");
  check.That(add(100, 2.1) && add(5, 1.9) && add(1, 2.1) && add(5, 1.9), "not small for long");
  check.That(!add(1, 1.9), "six small ones");
  check.That(!add(14, 3.3) && !add(6, 3.2) && !add(14, 3.3) && add(1, 3.3), "counted anew");
}

/// Harmless steps that are added together count as the same steps added one by one.
void TestHarmlessSteps(Check& check)
{
  std::mt19937 random(5);
  for (int run = 0; run < 200; ++run)
  {
    interlume::StiffnessTest together;
    interlume::StiffnessTest apart;
    while (!apart.IsStiff())
    {
      // In two parts, as where a cell ends between them.
      const int harmless = static_cast<int>(random() % 8);
      const int first = static_cast<int>(random() % (harmless + 1));
      together.AddHarmless(first);
      together.AddHarmless(harmless - first);
      for (int i = 0; i < harmless; ++i)
      {
        apart.Add(interlume::StiffnessTest::LeastStiff);
      }
      const int stiff = 1 + static_cast<int>(random() % 16);
      for (int i = 0; i < stiff && !apart.IsStiff(); ++i)
      {
        together.Add(3.3);
        apart.Add(3.3);
        check.Equal(together.IsStiff(), apart.IsStiff(), "stiffness after steps added together");
      }
    }
  }
}

/// One object follows many streamlines, each as if it were alone.
void TestReuse(Check& check)
{
  const Flow flow = Flow::Beltrami(1.0, 0.7, 0.43);
  const Lattice lattice = Cubes(6);
  const auto sphere = FormulaSurface::Sphere({ 3, 3, 3 }, 0.5);
  interlume::AdvectionOptions options = ForwardOptions();
  options.Surfaces.push_back({ sphere, 4 });
  options.MaximumTime = 20.0;
  interlume::Advection<LatticeWalker> advection(LatticeWalker(flow, lattice), options);
  interlume::AdvectionResult result;
  for (int i = 0; i < 200; ++i)
  {
    const Place start = { 0.03 * i, 6.0 - 0.029 * i, 1.0 + 0.02 * i };
    advection.Follow(start.data(), result);
    const auto alone = Advect(LatticeWalker(flow, lattice), options, start);
    check.That(result.Status == alone.Status && result.Time == alone.Time &&
        result.Position[0] == alone.Position[0] && result.Steps == alone.Steps &&
        result.Evaluations == alone.Evaluations &&
        result.DistanceEvaluations == alone.DistanceEvaluations && result.Cells == alone.Cells &&
        result.Parameters[0] == alone.Parameters[0],
      "the same again: " + Describe(result) + " and " + Describe(alone));
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
