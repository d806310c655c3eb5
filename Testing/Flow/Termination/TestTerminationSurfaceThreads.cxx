// SPDX-License-Identifier: BSD-3-Clause
// Parallel evaluation is bit-identical to serial evaluation.
#include "Support/Checks/ReferenceCheck.h"
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

#include <cmath>
#include <thread>

namespace
{

using namespace reference;

// All results of evaluating a point.
using Evaluation = std::array<double, 11>;

Evaluation Evaluate(const vtkTerminationSurface* surface, const Vector& x)
{
  Evaluation result{};
  result[0] = GetSurfaceDistance(surface, x);
  result[1] = surface->IsOn(x.data()) ? 1.0 : 0.0;
  const int part = surface->EvaluatePart(x.data());
  result[2] = part;
  surface->EvaluateParameters(x.data(), &result[3]);
  surface->EvaluateNormal(x.data(), &result[5]);
  surface->EvaluatePoint(part, &result[3], &result[8]);
  return result;
}

void CheckSurface(vtkTerminationSurface* surface, const std::string& name, Check& check)
{
  check.SetContext(name);
  check.That(surface->Update().empty(), "no error");
  const std::vector<Vector> points = MakeRandomPointsNear(SurfaceScale(), 3000, 31);
  std::vector<Evaluation> expected;
  expected.reserve(points.size());
  for (const Vector& x : points)
  {
    expected.push_back(Evaluate(surface, x));
  }
  const int number = 8;
  std::vector<std::vector<Evaluation>> found(number, std::vector<Evaluation>(points.size()));
  std::vector<std::thread> threads;
  threads.reserve(number);
  for (int t = 0; t < number; ++t)
  {
    threads.emplace_back(
      [surface, &points, &found, t]
      {
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          // Each thread starts at a different point.
          const std::size_t k = (i + 377 * static_cast<std::size_t>(t)) % points.size();
          found[t][k] = Evaluate(surface, points[k]);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& evaluations : found)
  {
    check.That(evaluations == expected, "parallel and serial results are equal");
  }
}

}

int TestTerminationSurfaceThreads(int, char*[])
{
  Check check;
  CheckSurface(vtkNew<vtkTerminationPlane>(), "plane", check);
  CheckSurface(vtkNew<vtkTerminationSphere>(), "sphere", check);
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->CappedOn();
  CheckSurface(cylinder, "cylinder", check);
  CheckSurface(vtkNew<vtkTerminationBox>(), "box", check);
  vtkNew<vtkTerminationTube> tube;
  for (int i = 0; i < 50; ++i)
  {
    tube->AddPoint(0.5 * std::cos(0.2 * i), 0.5 * std::sin(0.2 * i), 0.02 * i - 0.5);
  }
  tube->SetRadius(0.1);
  tube->CappedOn();
  CheckSurface(tube, "tube", check);
  vtkNew<vtkTerminationMesh> mesh;
  mesh->SetMesh(MakeGridMesh(30, 20,
    [](double u, double v) {
      return Vector{ { u - 0.5, v - 0.5, 0.2 * std::sin(9.0 * u * v) } };
    }).MakeData());
  CheckSurface(mesh, "mesh", check);
  // Two surfaces of the same mesh yield equal results.
  vtkNew<vtkTerminationMesh> again;
  again->SetMesh(mesh->GetMesh());
  again->Update();
  for (const Vector& x : MakeRandomPointsNear(SurfaceScale(), 500, 3))
  {
    check.That(Evaluate(mesh, x) == Evaluate(again, x), "a second surface of the same mesh");
  }
  return check.Result();
}
