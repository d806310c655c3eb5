// SPDX-License-Identifier: BSD-3-Clause
// Intersections of streamlines with termination surfaces: ids, parameters and times, compared with
// exact values.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceAdvection.h"

#include "vtkImplicitFlowField.h" // for the integrators
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace reference;

using Surface = vtkSmartPointer<FormulaSurface>;

const BoxGrid Cells = []
{
  BoxGrid grid;
  grid.Origin = { -10, -10, -10 };
  grid.Spacing = { 0.5, 0.4, 0.8 };
  grid.Cells = { 40, 50, 25 };
  return grid;
}();

std::vector<interlume::AdvectionResult> AdvectInAll(
  const Flow& flow, const interlume::AdvectionOptions& options, const Position& start)
{
  return { Advect(SingleCellWalker(flow), options, start),
    Advect(BoxWalker(flow, Cells), options, start) };
}

struct Expected
{
  int Id;
  double U;
  double V;
  double Time;
};

void Expect(Check& check, const interlume::AdvectionResult& result, const Expected& answer,
  double tolerance, const std::string& what)
{
  check.Equal(result.Status, vtkFlowStatus::REACHED_SURFACE, what + ": " + Describe(result));
  check.Equal(result.Id, answer.Id, what + ", id");
  check.Near(result.Parameters[0], answer.U, tolerance, what + ", u", 1.0);
  check.Near(result.Parameters[1], answer.V, tolerance, what + ", v", 1.0);
  check.Near(result.Time, answer.Time, tolerance, what + ", time", 1.0);
}

void TestExact(Check& check)
{
  const Surface plane = FormulaSurface::Plane({ 1, 0, 0 }, -3.0, 1, 2);
  const Surface sphere = FormulaSurface::Sphere({ 0, 0, 0 }, 4.0);
  for (int integrator = vtkImplicitFlowField::AUTOMATIC;
       integrator <= vtkImplicitFlowField::ROSENBROCK; ++integrator)
  {
    check.SetContext("integrator " + std::to_string(integrator));
    OwningAdvectionOptions options = ForwardOptions({ plane });
    options.Integrator = integrator;
    options.SetBackward(true);
    const Flow uniform = Flow::Uniform({ 2, 1, 0.5 });
    for (const auto& result : AdvectInAll(uniform, options, { 1, 2, 3 }))
    {
      Expect(check, result, { 10, 0.0, 2.0, 2.0 }, 1e-13, "uniform to a plane");
      check.Near(result.Position[0], -3.0, 1e-14, "the position on the plane");
    }
    options = ForwardOptions({ sphere });
    options.Integrator = integrator;
    // Solves |x0 + v t| = 4, a quadratic equation in t.
    const Position start = { 0.5, -1, 1.25 };
    const double a = 5.25;
    const double b = 2 * start[0] + start[1] + 0.5 * start[2];
    const double c = start[0] * start[0] + start[1] * start[1] + start[2] * start[2] - 16.0;
    const double t = (-b + std::sqrt(b * b - a * c)) / a;
    const Position end = { start[0] + 2 * t, start[1] + t, start[2] + 0.5 * t };
    double uv[2];
    sphere->EvaluateParameters(end.data(), uv);
    for (const auto& result : AdvectInAll(uniform, options, start))
    {
      Expect(check, result, { 10, uv[0], uv[1], t }, 1e-13, "uniform to a sphere");
    }

    // Trace backward by less than a quarter of a rotation, to a plane through the axis of rotation.
    options = ForwardOptions({ FormulaSurface::Plane({ 0.6, 0.8, 0 }, 0.0, 1, 2) });
    options.Integrator = integrator;
    options.SetBackward(true);
    options.MaximumError = 1e-9;
    const double quarter = std::atan2(0.6, -0.8);
    for (const auto& result : AdvectInAll(Flow::Rotation(2.0), options, { 1.5, 0, 0.3 }))
    {
      // The streamline ends where (x,y) has the direction (0.8,-0.6).
      Expect(check, result, { 10, -1.5 * 0.6, 0.3, 0.5 * (vtkMath::Pi() - quarter) }, 1e-8,
        "rotation to a plane");
    }

    // The path is (0.3 exp(t), 2 exp(-t), 0.5). It ends at a distance of 4 from the origin.
    options = ForwardOptions({ sphere });
    options.Integrator = integrator;
    options.MaximumError = 1e-9;
    double low = 0.0;
    double high = 5.0;
    for (int i = 0; i < 100; ++i)
    {
      const double midpoint = 0.5 * (low + high);
      const double x = 0.3 * std::exp(midpoint);
      const double y = 2.0 * std::exp(-midpoint);
      (x * x + y * y + 0.25 < 16.0 ? low : high) = midpoint;
    }
    const double saddleEnd[3] = { 0.3 * std::exp(low), 2.0 * std::exp(-low), 0.5 };
    sphere->EvaluateParameters(saddleEnd, uv);
    const Flow saddle = Flow::Linear({ 1, 0, 0, 0, -1, 0, 0, 0, 0 });
    for (const auto& result : AdvectInAll(saddle, options, { 0.3, 2, 0.5 }))
    {
      Expect(check, result, { 10, uv[0], uv[1], low }, 2e-8, "saddle to a sphere");
    }
  }
  check.SetContext("");
}

void TestStartOnSurface(Check& check)
{
  const Surface plane = FormulaSurface::Plane({ 0, 1, 0 }, 0.7, 0, 2);
  const Flow flow = Flow::Uniform({ 0, 1, 0 });
  for (bool isBackward : { false, true })
  {
    OwningAdvectionOptions options = ForwardOptions({ plane });
    options.SetBackward(isBackward);
    for (const auto& result : AdvectInAll(flow, options, { 0.25, 0.7, 0.5 }))
    {
      Expect(check, result, { 10, 0.25, 0.5, 0.0 }, 0.0, "start on a plane");
      check.Equal(NumberOfSteps(result), 0, "no steps");
      check.That(result.Position[1] == 0.7, "the sample is the end");
    }
  }
  // A sample is on the surface if its distance is within rounding error. A distance of 1e-6 is not.
  const Surface sphere = FormulaSurface::Sphere({ 0.1, 0.2, 0.3 }, 0.7);
  const double s = 0.7 / std::sqrt(3.0);
  for (const auto& result :
    AdvectInAll(flow, ForwardOptions({ sphere }), { 0.1 + s, 0.2 + s, 0.3 + s }))
  {
    check.That(
      result.Status == vtkFlowStatus::REACHED_SURFACE && result.Time == 0.0, "start on a sphere");
  }
  OwningAdvectionOptions options = ForwardOptions({ plane });
  for (const auto& result : AdvectInAll(flow, options, { 0.25, 0.7 - 1e-6, 0.5 }))
  {
    Expect(check, result, { 10, 0.25, 0.5, 1e-6 }, 1e-15, "start near a plane");
  }
  // A sample on the plane, but outside its extent, is traced to the next surface.
  plane->Extent = [](const double* x) { return x[0] > 1.0; };
  options = ForwardOptions({ plane, FormulaSurface::Plane({ 0, 1, 0 }, 2.7, 0, 2) });
  for (const auto& result : AdvectInAll(flow, options, { 0.25, 0.7, 0.5 }))
  {
    Expect(check, result, { 20, 0.25, 0.5, 2.0 }, 1e-13, "start on the plane of a rectangle");
  }
}

void TestTangents(Check& check)
{
  const Flow flow = Flow::Rotation(1.0);
  const Position start = { std::cos(1.0), -std::sin(1.0), 0.0 };
  const auto advect = [&](double offset)
  {
    OwningAdvectionOptions options =
      ForwardOptions({ FormulaSurface::Plane({ 1, 0, 0 }, offset, 1, 2) });
    options.MaximumError = 1e-12;
    options.MaximumTime = 2.0;
    return AdvectInAll(flow, options, start);
  };
  for (double depth : { 1e-2, 1e-4, 1e-6, 1e-8, 1e-9 })
  {
    check.SetContext("depth " + std::to_string(depth));
    for (const auto& result : advect(1.0 - depth))
    {
      const double angle = std::acos(1.0 - depth);
      Expect(check, result, { 10, -std::sin(angle), 0.0, 1.0 - angle },
        std::max(1e-10, 1e-11 / angle), "through a thin segment behind the plane");
    }
    for (const auto& result : advect(1.0 + depth))
    {
      check.Equal(result.Status, vtkFlowStatus::OUT_OF_TIME, "the plane is missed");
    }
  }
  check.SetContext("");
  // The streamline is tangent to the plane. Rounding errors decide whether it reaches the plane,
  // but the result is repeatable.
  const auto once = advect(1.0);
  const auto again = advect(1.0);
  for (std::size_t i = 0; i < once.size(); ++i)
  {
    check.That(once[i].Status == again[i].Status && once[i].Time == again[i].Time, "a tangent");
  }
}

/// Tests spheres with radii down to 1e-4 in a uniform flow, in which the step size grows. All
/// intersections are found, and no false ones.
void TestSmallSpheres(Check& check)
{
  std::mt19937 random(3);
  const auto number = [&random] { return random() / 4294967296.0; };
  const Flow flow = Flow::Uniform({ 1, 0, 0 });
  int hits = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const double radius = std::pow(10.0, -4.0 * number());
    const double away = 1.5 * radius * number();
    const double along = radius + 8.0 * number();
    const Surface sphere = FormulaSurface::Sphere({ along, away, 0.0 }, radius);
    OwningAdvectionOptions options = ForwardOptions({ sphere });
    options.MaximumTime = i % 2 == 0 ? 1e3 : 9.9;
    const bool isHit = away < radius;
    hits += isHit;
    const double expected = isHit ? along - std::sqrt(radius * radius - away * away) : 0.0;
    const auto results = i % 2 == 0 ? std::vector<interlume::AdvectionResult>{ Advect(
                                        SingleCellWalker(flow), options, { 0, 0, 0 }) }
                                    : AdvectInAll(flow, options, { 0, 0, 0 });
    for (const auto& result : results)
    {
      check.Equal(result.Status,
        isHit ? vtkFlowStatus::REACHED_SURFACE : vtkFlowStatus::OUT_OF_TIME,
        "a sphere of radius " + std::to_string(radius) + ", " + std::to_string(away / radius) +
          " radii off the axis");
      if (isHit && result.Status == vtkFlowStatus::REACHED_SURFACE)
      {
        check.Near(result.Time, expected, 1e-12, "time to the sphere", 1.0);
      }
    }
  }
  check.That(hits > 500 && hits < 800, "some spheres are hit and some are missed");
  // Trace a curved streamline with steps larger than the spheres.
  const Flow rotation = Flow::Rotation(1.0);
  for (int i = 0; i < 300; ++i)
  {
    const double angle = 0.3 + 5.0 * number();
    const double radius = 0.02 + 0.1 * number();
    const double off = radius * 1.5 * (2.0 * number() - 1.0);
    const Surface sphere = FormulaSurface::Sphere(
      { (2.0 + off) * std::cos(angle), (2.0 + off) * std::sin(angle), 0.0 }, radius);
    OwningAdvectionOptions options = ForwardOptions({ sphere });
    options.MaximumTime = 6.0;
    options.MaximumError = 1e-7;
    // Law of cosines. The distance between the sphere's center and the circle of radius 2 is |off|.
    const double cosine = (4.0 + (2.0 + off) * (2.0 + off) - radius * radius) / (4.0 * (2.0 + off));
    for (const auto& result : AdvectInAll(rotation, options, { 2, 0, 0 }))
    {
      check.Equal(result.Status,
        cosine < 1.0 ? vtkFlowStatus::REACHED_SURFACE : vtkFlowStatus::OUT_OF_TIME,
        "a sphere on a circle, " + Describe(result));
      if (cosine < 1.0)
      {
        check.Near(result.Time, angle - std::acos(cosine), 2e-5, "time on a circle", 1.0);
      }
    }
  }
}

void TestExtents(Check& check)
{
  const Flow rotation = Flow::Rotation(1.0);
  const Position start = { std::cos(1.0), -std::sin(1.0), 0.0 };
  OwningAdvectionOptions options;
  const auto each = [&](const Surface& surface, const Flow& flow, const Position& from,
                      const Expected& answer, const char* what)
  {
    options = ForwardOptions({ surface });
    options.MaximumError = 1e-11;
    options.MaximumTime = 20.0;
    for (const auto& result : AdvectInAll(flow, options, from))
    {
      Expect(check, result, answer, 1e-9, what);
    }
  };
  const Surface half = FormulaSurface::Plane({ 0, 1, 0 }, 0.0, 0, 2);
  half->Extent = [](const double* x) { return x[0] < 0.0; };
  each(half, rotation, start, { 10, -1.0, 0.0, 1.0 + vtkMath::Pi() }, "the second root");
  // The streamline starts on the other side of the plane. Its first intersection is outside the
  // extent, and its second intersection is inside.
  half->Extent = [](const double* x) { return x[0] > 0.99 && x[2] > -1.0; };
  each(half, rotation, { std::cos(1.0), std::sin(1.0), 0.0 },
    { 10, 1.0, 0.0, 2.0 * vtkMath::Pi() - 1.0 }, "after one rotation");
  // Only the far half of a sphere exists. The streamline enters through the missing half.
  const Surface bowl = FormulaSurface::Sphere({ 3, 0, 0 }, 0.01);
  bowl->Extent = [](const double* x) { return x[0] > 3.0; };
  each(bowl, Flow::Uniform({ 1, 0, 0 }), { -9, 0, 0 }, { 10, 0.0, 0.5, 12.01 }, "the far half");
  // The distance is discontinuous past the boundary edge of the surface, as for an open mesh.
  const Surface open = FormulaSurface::Plane({ 0, 1, 0 }, 0.0, 0, 2);
  open->Distance = [](const double* x)
  { return x[0] < 0.0 ? x[1] : std::copysign(std::hypot(x[0], x[1]), x[1]); };
  each(open, rotation, start, { 10, -1.0, 0.0, 1.0 + vtkMath::Pi() }, "after a discontinuity");
  // Parts of a surface have separate ids.
  const Surface parts = FormulaSurface::Plane({ 1, 0, 0 }, 2.0, 1, 2);
  parts->Part = [](const double* x) { return x[1] > 0.0 ? 3 : 1; };
  each(parts, Flow::Uniform({ 1, 0, 0 }), { 0, 1, 0 }, { 13, 1.0, 0.0, 2.0 }, "a part");
  each(parts, Flow::Uniform({ 1, 0, 0 }), { 0, -1, 0 }, { 11, -1.0, 0.0, 2.0 }, "another part");
}

void TestSeveral(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0, 0 });
  const Surface plane = FormulaSurface::Plane({ 1, 0, 0 }, 5.0, 1, 2);
  const Surface same = FormulaSurface::Plane({ -1, 0, 0 }, -5.0, 2, 1);
  const Surface sphere = FormulaSurface::Sphere({ 5.2, 0, 0 }, 1.0);
  struct
  {
    std::vector<Surface> Surfaces;
    int Id;
    double Time;
    const char* What;
  } const cases[] = {
    { { plane, sphere }, 20, 4.2, "the sphere is first" },
    { { sphere, plane }, 10, 4.2, "the sphere is first, although added last" },
    { { plane, same }, 10, 5.0, "the same plane twice" },
    { { same, plane }, 10, 5.0, "the same plane twice, other order" },
    { { FormulaSurface::Sphere({ 6, 0, 0 }, 1.0), plane }, 10, 5.0, "a tangent sphere" },
    { { plane, FormulaSurface::Sphere({ 6, 0, 0 }, 1.0) }, 10, 5.0, "a tangent sphere added last" },
    { { FormulaSurface::Plane({ 1, 0, 0 }, 5.0 + 1e-9, 1, 2), plane }, 20, 5.0,
      "two planes at a distance of 1e-9" },
    { { FormulaSurface::Plane({ 0, 1, 0 }, 3.0, 1, 2), plane }, 20, 5.0,
      "a plane that is not reached" },
  };
  for (const auto& one : cases)
  {
    for (const Position& start : { Position{ 0, 0, 0 }, Position{ 0.123456789, 0, 0 } })
    {
      for (const auto& result : AdvectInAll(flow, ForwardOptions(one.Surfaces), start))
      {
        Expect(check, result,
          { one.Id, result.Parameters[0], result.Parameters[1], one.Time - start[0] }, 1e-12,
          one.What);
      }
    }
  }
}

void TestBoundary(Check& check)
{
  const Flow flow = Flow::Uniform({ 1, 0.25, 0.125 });
  const SingleCellWalker box(flow, { -1, 1, -1, 1, -1, 1 });
  const auto advect = [&](const Surface& surface, bool hasFaces)
  {
    OwningAdvectionOptions options = ForwardOptions({ surface });
    options.DomainFaces = hasFaces;
    options.DomainFaceId = 500;
    return Advect(box, options, { 0, 0, 0 });
  };
  const Surface outside = FormulaSurface::Plane({ 1, 0, 0 }, 1.1, 1, 2);
  const interlume::AdvectionResult left = advect(outside, false);
  check.Equal(left.Status, vtkFlowStatus::LEFT_DOMAIN, "a surface outside: " + Describe(left));
  check.That(left.Id == -1 && left.Parameters[0] == 0.0 && left.Parameters[1] == 0.0,
    "id and parameters of no surface");
  check.Near(left.Time, 1.0, 1e-14, "time of leaving the domain");
  Expect(check, advect(outside, true), { 501, 0.625, 0.5625, 1.0 }, 1e-14, "through a face");
  Expect(check, advect(FormulaSurface::Plane({ 1, 0, 0 }, 1.0, 1, 2), true),
    { 10, 0.25, 0.125, 1.0 }, 1e-12, "a surface in the domain boundary");
  // A plane within rounding error of the domain boundary, on either side.
  for (double tilt : { -1e-15, 1e-15 })
  {
    Expect(check, advect(FormulaSurface::Plane({ 1, 0, 0 }, 1.0 + tilt, 1, 2), false),
      { 10, 0.25, 0.125, 1.0 }, 1e-12, "a surface close to the domain boundary");
  }
  // Streamlines through each of the six faces of a box.
  for (int face = 0; face < 6; ++face)
  {
    Position velocity{};
    velocity[static_cast<std::size_t>(face / 2)] = face % 2 == 0 ? -1.0 : 1.0;
    const Flow along = Flow::Uniform(velocity);
    OwningAdvectionOptions options = ForwardOptions();
    options.DomainFaces = true;
    options.DomainFaceId = 7;
    const auto result = Advect(BoxWalker(along, Cells), options, { 1, 2, 3 });
    const double parts[3] = { 11.0 / 20.0, 12.0 / 20.0, 13.0 / 20.0 };
    const double u = face / 2 == 0 ? parts[1] : parts[0];
    const double v = face / 2 == 2 ? parts[1] : parts[2];
    const int axis = face / 2;
    const double at = 1.0 + axis;
    Expect(check, result, { 7 + face, u, v, face % 2 == 0 ? at + 10.0 : 10.0 - at }, 1e-13,
      "a face of a box");
  }
}

/// Distances are evaluated only if the streamline may have reached the surface.
void TestCounts(Check& check)
{
  const Flow flow = Flow::Rotation(1.0);
  int calls = 0;
  const Surface counted = FormulaSurface::Plane({ 1, 0, 0 }, 1000.0, 1, 2);
  counted->Distance = [&calls](const double* x)
  {
    ++calls;
    return x[0] - 1000.0;
  };
  OwningAdvectionOptions options = ForwardOptions({ counted });
  options.MaximumTime = 100.0;
  const auto far = Advect(BoxWalker(flow, Cells), options, { 3, 0, 0 });
  check.Equal(far.DistanceEvaluations, calls, "distance evaluations are counted");
  check.That(NumberOfSteps(far) > 500 && calls <= 2,
    std::to_string(calls) + " distances of a surface far away");
  calls = 0;
  counted->Distance = [&calls](const double* x)
  {
    ++calls;
    return x[0] - 3.0001;
  };
  const auto near = Advect(BoxWalker(flow, Cells), options, { 3, 0, 0 });
  check.Equal(near.Status, vtkFlowStatus::OUT_OF_TIME, "the surface is not reached");
  check.Equal(near.DistanceEvaluations, calls, "distance evaluations are counted");
  check.That(calls < 3 * NumberOfSteps(near),
    std::to_string(calls) + " distances in " + std::to_string(NumberOfSteps(near)) + " steps");
}

}

int TestAdvectionSurfaces(int, char*[])
{
  Check check;
  TestExact(check);
  TestStartOnSurface(check);
  TestTangents(check);
  TestSmallSpheres(check);
  TestExtents(check);
  TestSeveral(check);
  TestBoundary(check);
  TestCounts(check);
  return check.Result();
}
