// SPDX-License-Identifier: BSD-3-Clause
// Plane, sphere, cylinder and box compared with formulas and samples, at all scales and far from
// the origin. Also tests boundaries and periodic parameters.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceTermination.h"

#include "vtkNew.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

void CheckAll(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::function<double(const Vector&)>& distance, const std::string& name, Check& check)
{
  CheckDistance(surface, scale, distance, name, check);
  CheckLipschitz(surface, scale, name, check);
  CheckRoundTrip(surface, scale, 230, name, check);
  CheckNormals(surface, scale, name, check);
}

Vector PointOf(const vtkTerminationSurface* surface, int part, double u, double v)
{
  const double uv[2] = { u, v };
  Vector x = { { 0.0, 0.0, 0.0 } };
  surface->EvaluatePoint(part, uv, x.data());
  return x;
}

void CheckPlane(const SurfaceScale& scale, Check& check)
{
  const Vector edges[2] = { { { 0.6, 0.2, -0.3 } }, { { 0.1, 0.9, 0.4 } } };
  const Vector origin = scale.Center + scale.Size * Vector{ { -0.3, -0.4, 0.1 } };
  const Vector point1 = origin + scale.Size * edges[0];
  const Vector point2 = origin + scale.Size * edges[1];
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetPoint1(point1.data());
  plane->SetPoint2(point2.data());
  check.That(plane->Update().empty(), "plane: no error");
  const Vector cross = Cross(edges[0], edges[1]);
  const Vector normal = 1.0 / GetNorm(cross) * cross;
  const auto distance = [&normal, &origin](const Vector& x) { return Dot(normal, x - origin); };
  CheckAll(plane, scale, distance, "plane", check);
  // Points at the boundary edges of the rectangle and slightly outside, in its plane and above it.
  for (double side : { -1e-6, 0.0, 1.0, 1.0 + 1e-6 })
  {
    for (double height : { 0.0, 0.01 })
    {
      const double reach = scale.Size * side;
      const bool isOn = side == 0.0 || side == 1.0;
      const Vector lifted = origin + height * scale.Size * normal;
      const Vector acrossU = lifted + reach * edges[0] + 0.5 * scale.Size * edges[1];
      const Vector acrossV = lifted + reach * edges[1] + 0.5 * scale.Size * edges[0];
      check.That(plane->IsOn(acrossU.data()) == isOn, "plane: boundary of u");
      check.That(plane->IsOn(acrossV.data()) == isOn, "plane: boundary of v");
      double uv[2];
      plane->EvaluateParameters(acrossU.data(), uv);
      check.That(uv[0] >= 0.0 && uv[0] <= 1.0, "plane: u is clamped");
    }
  }
  plane->UnboundedOn();
  const double beyond[2] = { -3.5, 7.25 };
  Vector x;
  check.That(plane->EvaluatePoint(0, beyond, x.data()), "unbounded plane: the point exists");
  check.That(plane->IsOn(x.data()), "unbounded plane: a distant point is on the plane");
  double again[2];
  plane->EvaluateParameters(x.data(), again);
  check.Near(again[0], beyond[0], 1e3 * scale.Rounding, "unbounded plane: u");
  check.Near(again[1], beyond[1], 1e3 * scale.Rounding, "unbounded plane: v");
  double bounds[6];
  plane->GetBounds(bounds);
  check.That(bounds[0] > bounds[1], "unbounded plane: no bounds");
}

void CheckSphere(const SurfaceScale& scale, Check& check)
{
  const Vector axes[3] = { { { 0.0, 0.0, 1.0 } }, { { 0.0, 0.0, -2.0 } }, { { 1.0, -2.0, 0.5 } } };
  for (const Vector& axis : axes)
  {
    vtkNew<vtkTerminationSphere> sphere;
    sphere->SetCenter(scale.Center.data());
    sphere->SetRadius(0.7 * scale.Size);
    sphere->SetAxis(axis.data());
    check.That(sphere->Update().empty(), "sphere: no error");
    CheckAll(
      sphere, scale,
      [&scale](const Vector& x) { return GetNorm(x - scale.Center) - 0.7 * scale.Size; }, "sphere",
      check);
    // Checks the poles, and that u increases counterclockwise around the axis.
    const double reach = 0.7 * scale.Size / GetNorm(axis);
    for (double v : { 0.0, 1.0 })
    {
      const Vector pole = scale.Center + (v == 0.0 ? -reach : reach) * axis;
      const Vector found = PointOf(sphere, 0, 0.3, v);
      check.Near(GetNorm(found - pole), 0.0, 2.0 * scale.Rounding, "sphere: a pole", scale.Size);
    }
    const Vector first = PointOf(sphere, 0, 0.1, 0.5) - scale.Center;
    const Vector second = PointOf(sphere, 0, 0.2, 0.5) - scale.Center;
    const Vector rotation = Cross(first, second);
    check.Near(Dot(rotation, axis) / (GetNorm(axis) * 0.49 * scale.Size * scale.Size),
      std::sin(0.2 * Pi), 1e-5, "sphere: a tenth of a rotation");
  }
}

// Checks the seam of u on part 0: u is close to 0 on one side and close to 1 on the other, and
// u = 0 and u = 1 yield the same position.
void CheckSeam(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::string& name, Check& check)
{
  for (double v : { 0.2, 0.7 })
  {
    const Vector position = PointOf(surface, 0, 0.0, v);
    check.Near(GetNorm(position - PointOf(surface, 0, 1.0, v)), 0.0, scale.Rounding,
      name + ": both sides of the seam", scale.Size);
    double low[2];
    double high[2];
    surface->EvaluateParameters(PointOf(surface, 0, 1e-4, v).data(), low);
    surface->EvaluateParameters(PointOf(surface, 0, -1e-4, v).data(), high);
    check.Near(low[0], 1e-4, 1e-5, name + ": after the seam", 1.0);
    check.Near(high[0], 1.0 - 1e-4, 1e-5, name + ": before the seam", 1.0);
  }
}

// If u is rounded to 1, it is set to 0, so that the seam has a single value.
void CheckRoundingAtSeam(Check& check)
{
  vtkNew<vtkTerminationSphere> sphere;
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetPoint1(0.0, 0.0, -1.0);
  cylinder->SetPoint2(0.0, 0.0, 1.0);
  for (vtkTerminationSurface* surface :
    { static_cast<vtkTerminationSurface*>(sphere), static_cast<vtkTerminationSurface*>(cylinder) })
  {
    check.That(surface->Update().empty(), "rounding at the seam: no error");
    const double x[3] = { 0.5, -1e-300, 0.0 };
    double uv[2];
    surface->EvaluateParameters(x, uv);
    check.Near(
      uv[0], 0.0, 0.0, std::string("rounding at the seam of a ") + surface->GetClassName(), 1.0);
  }
}

void CheckCylinder(const SurfaceScale& scale, Check& check)
{
  const Vector axis = { { 0.6, -0.48, 0.64 } };
  const double radius = 0.4;
  const double length = 1.3;
  const Vector point1 = scale.Center - 0.5 * length * scale.Size * axis;
  const Vector point2 = scale.Center + 0.5 * length * scale.Size * axis;
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetPoint1(point1.data());
  cylinder->SetPoint2(point2.data());
  cylinder->SetRadius(radius * scale.Size);
  check.That(cylinder->Update().empty(), "cylinder: no error");
  const auto wall = [&](const Vector& x)
  { return GetNorm(Cross(x - scale.Center, axis)) - radius * scale.Size; };
  const auto end = [&](const Vector& x)
  { return std::abs(Dot(x - scale.Center, axis)) - 0.5 * length * scale.Size; };
  CheckAll(cylinder, scale, wall, "cylinder", check);
  CheckSeam(cylinder, scale, "cylinder", check);
  for (double v : { -1e-6, 0.0, 0.5, 1.0, 1.0 + 1e-6 })
  {
    Vector x = PointOf(cylinder, 0, 0.35, 0.0);
    x += v * length * scale.Size * axis;
    check.That(cylinder->IsOn(x.data()) == (v >= 0.0 && v <= 1.0), "cylinder: its ends");
    double uv[2];
    cylinder->EvaluateParameters(x.data(), uv);
    check.Near(uv[1], std::max(0.0, std::min(v, 1.0)), 1e-8, "cylinder: v", 1.0);
  }
  cylinder->CappedOn();
  check.Equal(cylinder->GetNumberOfParts(), 3, "capped cylinder: parts");
  CheckAll(
    cylinder, scale,
    [&](const Vector& x)
    {
      const double a = wall(x);
      const double b = end(x);
      return a > 0.0 && b > 0.0 ? std::hypot(a, b) : std::max(a, b);
    },
    "capped cylinder", check);
  CheckSamples(cylinder, scale, 60, 0.05 * scale.Size, "capped cylinder", check);
  check.That(cylinder->IsPeriodic(0) && !cylinder->IsPeriodic(0, 1) && !cylinder->IsPeriodic(1),
    "capped cylinder: only the wall's angle is periodic");
  const Vector caps[2] = { point1, point2 };
  for (int cap = 0; cap < 2; ++cap)
  {
    check.Near(GetNorm(PointOf(cylinder, 1 + cap, 0.5, 0.5) - caps[cap]), 0.0, 2.0 * scale.Rounding,
      "capped cylinder: center of a cap", scale.Size);
    // The parameters (0.5, 1) of a cap and u = 0.25 of the wall are both a quarter of a rotation.
    const Vector edge = PointOf(cylinder, 0, 0.25, cap);
    check.Near(GetNorm(PointOf(cylinder, 1 + cap, 0.5, 1.0) - edge), 0.0, 2.0 * scale.Rounding,
      "capped cylinder: a quarter of a rotation", scale.Size);
    const double corner[2] = { 0.05, 0.05 };
    Vector x;
    check.That(!cylinder->EvaluatePoint(1 + cap, corner, x.data()), "no point outside a disk");
  }
}

void CheckBox(const SurfaceScale& scale, Check& check)
{
  const double half[3] = { 0.3, 0.5, 0.7 };
  double bounds[6];
  for (int i = 0; i < 3; ++i)
  {
    bounds[2 * i] = scale.Center[i] - half[i] * scale.Size;
    bounds[2 * i + 1] = scale.Center[i] + half[i] * scale.Size;
  }
  vtkNew<vtkTerminationBox> box;
  box->SetBounds(bounds);
  check.That(box->Update().empty(), "box: no error");
  CheckAll(
    box, scale,
    [&](const Vector& x)
    {
      double outside = 0.0;
      double inside = -1e300;
      for (int i = 0; i < 3; ++i)
      {
        const double q = std::abs(x[i] - scale.Center[i]) - half[i] * scale.Size;
        outside += q > 0.0 ? q * q : 0.0;
        inside = std::max(inside, q);
      }
      return outside > 0.0 ? std::sqrt(outside) : inside;
    },
    "box", check);
  CheckSamples(box, scale, 30, 0.05 * scale.Size, "box", check);
  for (int part = 0; part < 6; ++part)
  {
    const int axis = part / 2;
    const int u = axis == 0 ? 1 : 0;
    const int v = axis == 2 ? 1 : 2;
    const Vector x = PointOf(box, part, 0.25, 0.75);
    check.Near(x[axis], bounds[part], 1e-15, "box: plane of the face");
    check.Near(x[u] - scale.Center[u], -0.5 * half[u] * scale.Size, 10.0 * scale.Rounding, "box: u",
      scale.Size);
    check.Near(x[v] - scale.Center[v], 0.5 * half[v] * scale.Size, 10.0 * scale.Rounding, "box: v",
      scale.Size);
    Vector normal;
    box->EvaluateNormal(x.data(), normal.data());
    check.Near(normal[axis], part % 2 == 0 ? -1.0 : 1.0, 0.0, "box: normals point outward");
  }
}

}

int TestTerminationShapes(int, char*[])
{
  Check check;
  CheckRoundingAtSeam(check);
  std::vector<SurfaceScale> scales(5);
  scales[0].Size = 1e-9;
  scales[2].Size = 1e9;
  scales[3].Center = { { 1e6, -1e6, 2e6 } };
  scales[3].Rounding = 2e-9;
  scales[4].Center = { { 0.1, -0.2, 0.3 } };
  for (const SurfaceScale& scale : scales)
  {
    check.SetContext(
      "size " + std::to_string(scale.Size) + " at " + std::to_string(scale.Center[0]));
    CheckPlane(scale, check);
    CheckSphere(scale, check);
    CheckCylinder(scale, check);
    CheckBox(scale, check);
  }
  return check.Result();
}
