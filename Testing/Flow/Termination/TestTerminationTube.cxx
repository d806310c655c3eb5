// SPDX-License-Identifier: BSD-3-Clause
// Tubes around straight, curved, knotted and closed lines: distance, continuous angle and length,
// round ends, and messages.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceTermination.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationTube.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

Vector OnHelix(double t)
{
  return { { 0.5 * std::cos(4.0 * t), 0.5 * std::sin(4.0 * t), t - 0.5 } };
}

// A closed nonplanar line, whose frame is rotated after one circuit.
Vector OnRing(double t)
{
  const double angle = 2.0 * Pi * t;
  return { { 0.7 * std::cos(angle), 0.6 * std::sin(angle),
    0.2 * std::sin(2.0 * angle) + 0.1 * std::cos(3.0 * angle) } };
}

std::vector<Vector> MakeLine(
  const std::function<Vector(double)>& position, int segments, bool isClosed)
{
  std::vector<Vector> line;
  for (int i = 0; i <= segments; ++i)
  {
    line.push_back(position(isClosed && i == segments ? 0.0 : static_cast<double>(i) / segments));
  }
  return line;
}

double DistanceFromLine(const std::vector<Vector>& line, const Vector& x)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const Vector side = line[i + 1] - line[i];
    const Vector p = x - line[i];
    const double t = std::max(0.0, std::min(Dot(p, side) / Dot(side, side), 1.0));
    nearest = std::min(nearest, GetNorm(p - t * side));
  }
  return nearest;
}

void SetPoints(vtkTerminationTube* tube, const std::vector<Vector>& line)
{
  tube->RemoveAllPoints();
  for (const Vector& point : line)
  {
    tube->AddPoint(point[0], point[1], point[2]);
  }
}

// Checks that positions are continuous along v, and that parameters are continuous on the surface.
void CheckContinuity(vtkTerminationTube* tube, const SurfaceScale& scale, double radius,
  const std::string& name, Check& check)
{
  const int steps = 4000;
  const auto pointAt = [tube](double u, double v)
  {
    const double uv[2] = { u, v };
    Vector x = { { 0.0, 0.0, 0.0 } };
    tube->EvaluatePoint(0, uv, x.data());
    return x;
  };
  for (double u : { 0.0, 0.2, 0.4, 0.6, 0.8 })
  {
    Vector before = pointAt(u, 0.0);
    for (int i = 1; i <= steps; ++i)
    {
      const Vector x = pointAt(u, static_cast<double>(i) / steps);
      // At bends, positions are closer together on the inside and farther apart on the outside.
      check.That(GetNorm(x - before) < 0.02 * scale.Size, name + ": continuous along the tube");
      before = x;
    }
  }
  Random random(21);
  for (int i = 0; i < 3000; ++i)
  {
    const double v = random.Get(0.01, 0.99);
    const Vector x = pointAt(random.Get(0.0, 1.0), v);
    const Vector y = x + 1e-5 * scale.Size * random.GetDirection();
    double a[2];
    double b[2];
    tube->EvaluateParameters(x.data(), a);
    tube->EvaluateParameters(y.data(), b);
    const double du = a[0] - b[0] - std::round(a[0] - b[0]);
    const double dv = tube->IsPeriodic(1) ? a[1] - b[1] - std::round(a[1] - b[1]) : a[1] - b[1];
    check.Near(du, 0.0, 1e-5 / (2.0 * Pi * radius) * 4.0, name + ": u is continuous", 1.0);
    check.Near(dv, 0.0, 2e-4, name + ": v is continuous", 1.0);
  }
}

void CheckTube(const std::vector<Vector>& unit, double radius, const SurfaceScale& scale,
  const std::string& name, Check& check)
{
  check.SetContext(name + ", size " + std::to_string(scale.Size));
  std::vector<Vector> line;
  line.reserve(unit.size());
  for (const Vector& point : unit)
  {
    line.push_back(scale.Center + scale.Size * point);
  }
  vtkNew<vtkTerminationTube> tube;
  SetPoints(tube, line);
  tube->SetRadius(radius * scale.Size);
  const std::string wrong = tube->Update();
  check.That(wrong.empty(), "no error: " + wrong);
  const bool isClosed = line.front() == line.back();
  check.That(tube->IsPeriodic(0) && tube->IsPeriodic(1) == isClosed, "periodic");
  const auto distance = [&](const Vector& x)
  { return DistanceFromLine(line, x) - radius * scale.Size; };
  CheckDistance(tube, scale, distance, name, check);
  CheckLipschitz(tube, scale, name, check);
  CheckRoundTrip(tube, scale, 300, name, check);
  CheckNormals(tube, scale, name, check);
  CheckContinuity(tube, scale, radius, name, check);
  if (isClosed)
  {
    tube->CappedOn();
    check.Equal(tube->GetNumberOfParts(), 1, "a closed tube has no ends");
    return;
  }
  // Points slightly inside and outside each end.
  for (int end = 0; end < 2; ++end)
  {
    const Vector& tip = end ? line.back() : line.front();
    const Vector inward = (end ? line[line.size() - 2] : line[1]) - tip;
    for (double step : { -1e-3, 1e-3 })
    {
      Vector x;
      const double uv[2] = { 0.3, end ? 1.0 : 0.0 };
      check.That(tube->EvaluatePoint(0, uv, x.data()), "a point on the boundary edge exists");
      check.That(tube->IsOn(x.data()), "the boundary edge is on the surface");
      x += step * inward;
      check.That(tube->IsOn(x.data()) == (step > 0.0), "the ends are open");
    }
  }
  tube->CappedOn();
  check.Equal(tube->GetNumberOfParts(), 3, "number of parts with ends");
  CheckRoundTrip(tube, scale, 700, name + " with ends", check);
  CheckNormals(tube, scale, name + " with ends", check);
  CheckSamples(tube, scale, 80, 0.1 * scale.Size, name + " with ends", check);
  check.That(!tube->IsPeriodic(0, 1) && !tube->IsPeriodic(0, 2), "ends are not periodic");
  // The boundary of an end cap equals the boundary of the tube. The center of the cap is its tip.
  for (int end = 0; end < 2; ++end)
  {
    const double center[2] = { 0.5, 0.5 };
    const double quarter[2] = { 0.5, 1.0 };
    const double rim[2] = { 0.25, static_cast<double>(end) };
    Vector a;
    Vector b;
    const Vector& tip = end ? line.back() : line.front();
    const Vector outward = tip - (end ? line[line.size() - 2] : line[1]);
    tube->EvaluatePoint(1 + end, center, a.data());
    b = tip + radius * scale.Size / GetNorm(outward) * outward;
    check.Near(GetNorm(a - b), 0.0, 5.0 * scale.Rounding, "tip of an end", scale.Size);
    tube->EvaluatePoint(1 + end, quarter, a.data());
    tube->EvaluatePoint(0, rim, b.data());
    check.Near(GetNorm(a - b), 0.0, 5.0 * scale.Rounding, "boundary of an end", scale.Size);
  }
}

// A straight tube is a cylinder, regardless of the points on its line.
void CheckStraight(Check& check)
{
  check.SetContext("straight");
  const Vector start = { { -0.3, 0.1, -0.4 } };
  const Vector way = { { 0.7, 0.2, 0.9 } };
  vtkNew<vtkTerminationTube> tube;
  for (double t : { 0.0, 0.0, 0.1, 0.35, 0.35, 0.6, 1.0, 1.0 })
  {
    const Vector x = start + t * way;
    tube->AddPoint(x[0], x[1], x[2]);
  }
  tube->SetRadius(0.25);
  check.That(tube->Update().empty(), "no error");
  vtkNew<vtkTerminationCylinder> cylinder;
  const Vector end = start + way;
  cylinder->SetPoint1(start.data());
  cylinder->SetPoint2(end.data());
  cylinder->SetRadius(0.25);
  cylinder->Update();
  Random random(2);
  for (int i = 0; i < 500; ++i)
  {
    const double uv[2] = { random.Get(0.0, 1.0), random.Get(0.0, 1.0) };
    Vector x;
    Vector y;
    tube->EvaluatePoint(0, uv, x.data());
    cylinder->EvaluatePoint(0, uv, y.data());
    check.Near(GetNorm(x - y), 0.0, 1e-13, "point of the cylinder", 1.0);
  }
}

// A tube from the line of a dataset equals a tube from the same points.
void CheckData(Check& check)
{
  check.SetContext("dataset");
  const std::vector<Vector> line = MakeLine(OnHelix, 20, false);
  vtkNew<vtkTerminationTube> expected;
  SetPoints(expected, line);
  expected->Update();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(21);
  for (int i = 20; i >= 0; --i)
  {
    points->InsertNextPoint(line[i].data());
    lines->InsertCellPoint(i);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  vtkNew<vtkTerminationTube> tube;
  tube->SetLine(data);
  check.That(tube->Update().empty(), "no error");
  for (const Vector& x : MakeRandomPointsNear(SurfaceScale(), 300, 5))
  {
    double a[2];
    double b[2];
    tube->EvaluateParameters(x.data(), a);
    expected->EvaluateParameters(x.data(), b);
    check.That(a[0] == b[0] && a[1] == b[1], "parameters of the same points");
  }
  const vtkMTimeType before = tube->GetMTime();
  data->Modified();
  check.That(tube->GetMTime() > before, "a modified dataset is detected");
  const auto expectMessage = [&](const std::string& text)
  {
    const std::string wrong = tube->Update();
    check.Contains(wrong, text);
  };
  lines->InsertNextCell({ 0, 1 });
  data->SetLines(lines);
  expectMessage("has 2 lines, not one");
  data->SetLines(vtkNew<vtkCellArray>());
  expectMessage("has 0 lines, not one");
  vtkNew<vtkCellArray> invalidLine;
  invalidLine->InsertNextCell({ 0, 99 });
  data->SetLines(invalidLine);
  expectMessage("refers to point 99, which does not exist");
}

void CheckMessages(Check& check)
{
  check.SetContext("messages");
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  const std::pair<std::vector<Vector>, std::string> cases[] = {
    { {}, "fewer than two distinct points" },
    { { { { 1, 2, 3 } } }, "fewer than two distinct points" },
    { { { { 1, 2, 3 } }, { { 1, 2, 3 } } }, "fewer than two distinct points" },
    { { { { 1, 2, 3 } }, { { 1, notANumber, 3 } } }, "point 1 of the tube's line is not finite" },
    { { { { 0, 0, 0 } }, { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0.5, 0, 0 } } },
      "turns back on itself at point 2" },
  };
  for (const auto& one : cases)
  {
    vtkNew<vtkTerminationTube> tube;
    SetPoints(tube, one.first);
    const std::string wrong = tube->Update();
    check.Contains(wrong, one.second);
    const Vector x = { { 0.1, 0.2, 0.3 } };
    Vector y;
    double uv[2] = { 0.5, 0.5 };
    double bounds[6];
    tube->GetBounds(bounds);
    check.That(bounds[0] > bounds[1], "no bounds");
    check.That(!tube->IsOn(x.data()) && !tube->EvaluatePoint(0, uv, y.data()), "no surface");
    check.That(GetSurfaceDistance(tube, x) == VTK_DOUBLE_MAX && tube->EvaluatePart(x.data()) == 0,
      "no distance");
    tube->EvaluateParameters(x.data(), uv);
    tube->EvaluateNormal(x.data(), y.data());
  }
  vtkNew<vtkTerminationTube> tube;
  SetPoints(tube, { { { 0, 0, 0 } }, { { 1, 0, 0 } } });
  for (double radius : { 0.0, -1.0, notANumber, std::numeric_limits<double>::infinity() })
  {
    tube->SetRadius(radius);
    check.Contains(tube->Update(), "radius");
  }
  Vector point = { { 7.0, 7.0, 7.0 } };
  tube->GetPoint(2, point.data());
  tube->GetPoint(-1, point.data());
  check.Near(point[0], 7.0, 0.0, "the line has no such point");
  tube->GetPoint(1, point.data());
  check.Near(point[0], 1.0, 0.0, "the second point");
}

}

int TestTerminationTube(int, char*[])
{
  Check check;
  for (const SurfaceScale& scale : MakeSurfaceScales())
  {
    CheckTube(MakeLine(OnHelix, 24, false), 0.12, scale, "helix", check);
    CheckTube(MakeLine(OnRing, 60, true), 0.08, scale, "ring", check);
    CheckTube({ { { -0.5, 0, 0 } }, { { 0, 0, 0.1 } }, { { 0.1, 0.5, 0 } }, { { 0.6, 0.5, 0.3 } } },
      0.1, scale, "three bends", check);
  }
  CheckStraight(check);
  CheckData(check);
  CheckMessages(check);
  return check.Result();
}
