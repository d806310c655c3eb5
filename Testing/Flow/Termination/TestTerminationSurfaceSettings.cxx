// SPDX-License-Identifier: BSD-3-Clause
// Errors that Update reports for invalid settings. Also tests ids, bounds and PrintSelf.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Flow/ReferenceTermination.h"
#include "Support/Flow/ReferenceTerminationMesh.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationTube.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace reference;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

void CheckMessage(vtkTerminationSurface* surface, const std::string& expected, Check& check)
{
  const std::string wrong = surface->Update();
  check.Contains(wrong, expected);
  // Evaluation of an invalid surface does not crash.
  const Vector x = { { 0.1, 0.2, 0.3 } };
  Vector y;
  double uv[2] = { 0.3, 0.7 };
  double bounds[6];
  surface->EvaluateDistance(x.data());
  surface->IsOn(x.data());
  surface->EvaluatePart(x.data());
  surface->EvaluatePoint(0, uv, y.data());
  surface->EvaluateParameters(x.data(), uv);
  surface->EvaluateNormal(x.data(), y.data());
  surface->GetBounds(bounds);
}

void CheckMessages(Check& check)
{
  check.SetContext("messages");
  for (double bad : { NotANumber, Infinity, -Infinity })
  {
    vtkNew<vtkTerminationPlane> plane;
    plane->SetOrigin(bad, 0.0, 0.0);
    CheckMessage(plane, "corner of the plane is not finite", check);
    vtkNew<vtkTerminationSphere> sphere;
    sphere->SetRadius(bad);
    CheckMessage(sphere, "radius must be finite and greater than 0", check);
    sphere->SetRadius(1.0);
    sphere->SetCenter(0.0, bad, 0.0);
    CheckMessage(sphere, "center is not finite", check);
    sphere->SetCenter(0.0, 0.0, 0.0);
    sphere->SetAxis(0.0, 0.0, bad);
    CheckMessage(sphere, "axis is not finite", check);
    vtkNew<vtkTerminationCylinder> cylinder;
    cylinder->SetRadius(bad);
    CheckMessage(cylinder, "radius must be finite and greater than 0", check);
    cylinder->SetPoint2(bad, 0.0, 0.0);
    CheckMessage(cylinder, "end of the cylinder's axis is not finite", check);
    vtkNew<vtkTerminationBox> box;
    box->SetBounds(0.0, 1.0, 0.0, bad, 0.0, 1.0);
    CheckMessage(box, "bound of the box is not finite", check);
  }
  vtkNew<vtkTerminationPlane> plane;
  plane->SetPoint1(plane->GetOrigin());
  CheckMessage(plane, "edge from Origin to Point1 has no length", check);
  plane->SetPoint1(1.0, 2.0, 3.0);
  plane->SetPoint2(plane->GetOrigin());
  CheckMessage(plane, "edge from Origin to Point2 has no length", check);
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint2(-2.0, -4.0, -6.0);
  CheckMessage(plane, "edges are parallel", check);
  plane->SetPoint2(-2.0, -4.0, -6.001);
  CheckMessage(plane, "", check);
  check.That(plane->Update().empty(), "almost parallel edges are not an error");
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetAxis(0.0, 0.0, 0.0);
  CheckMessage(sphere, "axis is not finite or has no length", check);
  for (double radius : { 0.0, -0.5 })
  {
    sphere->SetRadius(radius);
    CheckMessage(sphere, "radius must be finite and greater than 0", check);
    vtkNew<vtkTerminationCylinder> cylinder;
    cylinder->SetRadius(radius);
    CheckMessage(cylinder, "radius must be finite and greater than 0", check);
  }
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetPoint1(cylinder->GetPoint2());
  CheckMessage(cylinder, "no length", check);
  vtkNew<vtkTerminationBox> box;
  box->SetBounds(0.0, 1.0, 0.0, 1.0, 2.0, 2.0);
  CheckMessage(box, "lower bound in z is not less than its upper bound", check);
  box->SetBounds(3.0, 1.0, 0.0, 1.0, 0.0, 2.0);
  CheckMessage(box, "lower bound in x is not less than its upper bound", check);
}

// Results with default settings are the same before and after the first Update.
void CheckDefaults(vtkTerminationSurface* surface, Check& check)
{
  check.SetContext(surface->GetClassName());
  const double uv[2] = { 0.3, 0.6 };
  const Vector x = { { 0.31, -0.22, 0.4 } };
  Vector before;
  Vector after;
  const double distance = GetSurfaceDistance(surface, x);
  check.That(surface->EvaluatePoint(0, uv, before.data()), "EvaluatePoint succeeds before Update");
  check.That(surface->Update().empty(), "the defaults are valid");
  check.That(surface->EvaluatePoint(0, uv, after.data()), "EvaluatePoint succeeds after Update");
  check.That(
    before == after && distance == GetSurfaceDistance(surface, x), "both points are equal");
  check.Equal(surface->GetId(), -1, "id");
  surface->SetId(-7);
  check.Equal(surface->GetId(), -1, "the id is clamped");
  surface->SetId(2000000000);
  check.Equal(surface->GetId(), 1000000000, "the id is clamped");
  for (const auto& outside :
    { std::array<double, 2>{ { 0.5, 1.1 } }, std::array<double, 2>{ { 0.5, -0.1 } },
      std::array<double, 2>{ { 0.5, NotANumber } }, std::array<double, 2>{ { Infinity, 0.5 } } })
  {
    check.That(!surface->EvaluatePoint(0, outside.data(), after.data()),
      "no point outside the parameter range");
  }
  check.That(!surface->EvaluatePoint(surface->GetNumberOfParts(), uv, after.data()) &&
      !surface->EvaluatePoint(-1, uv, after.data()),
    "no point of a part that does not exist");
}

// Compares GetBounds() with the bounds of many points on the surface.
void CheckBounds(Check& check)
{
  check.SetContext("bounds");
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(1.0, 0.5, -0.25);
  plane->SetPoint2(-0.5, 1.0, 0.75);
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetCenter(1.0, 2.0, 3.0);
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetPoint1(1.0, -2.0, 0.5);
  cylinder->SetPoint2(-1.0, 0.0, 1.5);
  vtkNew<vtkTerminationBox> box;
  box->SetBounds(1.0, 2.0, -3.0, 4.0, 5.0, 6.0);
  vtkNew<vtkTerminationTube> tube;
  tube->AddPoint(0.0, 0.0, 0.0);
  tube->AddPoint(0.0, 0.0, 3.0);
  tube->CappedOn();
  vtkTerminationSurface* surfaces[] = { plane, sphere, cylinder, box, tube };
  for (vtkTerminationSurface* surface : surfaces)
  {
    surface->Update();
    double bounds[6];
    surface->GetBounds(bounds);
    double found[6] = { 1e9, -1e9, 1e9, -1e9, 1e9, -1e9 };
    const int number = 100;
    for (int i = 0; i < surface->GetNumberOfParts() * (number + 1) * (number + 1); ++i)
    {
      const double uv[2] = { static_cast<double>(i % (number + 1)) / number,
        static_cast<double>(i / (number + 1) % (number + 1)) / number };
      Vector x;
      if (surface->EvaluatePoint(i / ((number + 1) * (number + 1)), uv, x.data()))
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          found[2 * axis] = std::min(found[2 * axis], x[axis]);
          found[2 * axis + 1] = std::max(found[2 * axis + 1], x[axis]);
        }
      }
    }
    for (int i = 0; i < 6; ++i)
    {
      check.Near(found[i], bounds[i], 2e-3, std::string(surface->GetClassName()) + ": bound", 1.0);
    }
  }
}

void CheckPrinting(Check& check)
{
  check.SetContext("printed");
  vtkNew<vtkTerminationPlane> plane;
  plane->SetId(7);
  CheckPrinted(Print(plane),
    { "Id: 7", "NumberOfParts: 1", "Origin: -0.5 -0.5 0", "Point1: 0.5 -0.5 0",
      "Point2: -0.5 0.5 0", "Unbounded: 0" },
    check);
  CheckPrinted(Print(vtkNew<vtkTerminationSphere>()),
    { "Center: 0 0 0", "Radius: 0.5", "Axis: 0 0 1" }, check);
  CheckPrinted(Print(vtkNew<vtkTerminationCylinder>()),
    { "Point1: 0 0 -0.5", "Point2: 0 0 0.5", "Radius: 0.5", "Capped: 0" }, check);
  CheckPrinted(Print(vtkNew<vtkTerminationBox>()),
    { "NumberOfParts: 6", "Bounds: -0.5 0.5 -0.5 0.5 -0.5 0.5" }, check);
  CheckPrinted(Print(vtkNew<vtkTerminationTube>()),
    { "Points: 0", "Line: ", "Radius: 0.5", "Capped: 0" }, check);
  vtkNew<vtkTerminationMesh> mesh;
  mesh->SetMesh(MakeTetrahedron().MakeData());
  mesh->Update();
  CheckPrinted(Print(mesh),
    { "Mesh: ", "PeriodicU: 0", "PeriodicV: 0", "Tolerance: 1e-09", "Triangles: 4",
      "DegenerateTriangles: 0", "BorderEdges: 0", "BranchingEdges: 0" },
    check);
}

}

int TestTerminationSurfaceSettings(int, char*[])
{
  Check check;
  CheckMessages(check);
  CheckDefaults(vtkNew<vtkTerminationPlane>(), check);
  CheckDefaults(vtkNew<vtkTerminationSphere>(), check);
  CheckDefaults(vtkNew<vtkTerminationCylinder>(), check);
  CheckDefaults(vtkNew<vtkTerminationBox>(), check);
  CheckBounds(check);
  CheckPrinting(check);
  return check.Result();
}
