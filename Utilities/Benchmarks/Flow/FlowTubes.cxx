// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowTubes.h"

#include "Support/AnalyticFlows/ReferenceFlow.h"
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"

#include <algorithm>
#include <cmath>

namespace flow
{
namespace
{
using reference::FlowVector;

vtkSmartPointer<vtkImageData> MakeImage(
  int points, const std::array<double, 6>& bounds, const reference::FlowFunction& velocity)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  image->SetSpacing((bounds[1] - bounds[0]) / (points - 1), (bounds[3] - bounds[2]) / (points - 1),
    (bounds[5] - bounds[4]) / (points - 1));
  reference::SetVelocity(image, velocity);
  return image;
}

void SetVolume(Tube& tube, const reference::FlowFunction& velocity)
{
  tube.Volume = tube.Time *
    tube.Inflow.Integrate(
      [&velocity](const double x[3]) {
        return velocity({ { x[0], x[1], x[2] } })[0];
      });
}

Tube MakeContraction(int points)
{
  const reference::FlowFunction velocity = [](const FlowVector& x) {
    return FlowVector{ { x[0], -0.5 * x[1], -0.5 * x[2] } };
  };
  Tube tube;
  tube.Name = "contraction";
  tube.Field = MakeImage(points, { { 0.0, 1.0, -1.0, 1.0, -1.0, 1.0 } }, velocity);
  tube.Inflow = { 0.1, 0.05, 0.1, 0.6 };
  tube.Time = 2.0;
  const double first = tube.Inflow.X;
  // x r^2 is constant along a streamline, where r is the distance from the x axis.
  tube.Origin = [first](const double x[3])
  {
    const double factor = std::sqrt(std::max(0.0, x[0] / first));
    return std::array<double, 2>{ { factor * x[1], factor * x[2] } };
  };
  tube.IsShadow = [](const double*) { return false; };
  SetVolume(tube, velocity);
  return tube;
}

/// Returns Stokes' stream function divided by r^2 / 2, where r is the distance from the x axis.
/// \a distance is the distance from the center of the sphere.
double GetStreamFactor(double distance)
{
  return 1.0 - 1.0 / (distance * distance * distance);
}

Tube MakeRoundSphere(const std::string& name, const Disk& inflow, double time, int points)
{
  const reference::FlowFunction velocity = [flow = reference::Flow::PotentialAroundSphere()](
                                             const FlowVector& x)
  {
    // Extend the formula into the sphere, so that the field is continuous at the sphere's surface.
    constexpr double core = 0.6;
    const double factor = std::max(1.0, core / std::max(1e-12, std::hypot(x[0], x[1], x[2])));
    const double position[3] = { factor * x[0], factor * x[1], factor * x[2] };
    FlowVector v;
    flow.Velocity(position, v.data());
    return v;
  };
  Tube tube;
  tube.Name = name;
  tube.Field = MakeImage(points, { { -2.5, 2.5, -2.0, 2.0, -2.0, 2.0 } }, velocity);
  tube.Inflow = inflow;
  tube.Time = time;
  const double first = inflow.X;
  tube.Origin = [first](const double x[3])
  {
    const double across = std::hypot(x[1], x[2]);
    const double target =
      across * across * std::max(0.0, GetStreamFactor(std::hypot(x[0], across)));
    double radius = std::sqrt(target);
    for (int iteration = 0; iteration < 8 && radius > 0.0; ++iteration)
    {
      const double distance = std::hypot(first, radius);
      const double factor = GetStreamFactor(distance);
      const double slope =
        2.0 * radius * factor + 3.0 * std::pow(radius, 3) / std::pow(distance, 5);
      radius -= (radius * radius * factor - target) / slope;
    }
    const double scale = across > 0.0 ? radius / across : 0.0;
    return std::array<double, 2>{ { scale * x[1], scale * x[2] } };
  };
  tube.IsShadow = [](const double x[3]) { return std::hypot(x[0], x[1], x[2]) < 1.0; };
  SetVolume(tube, velocity);
  return tube;
}
}

double Tube::GetExcess(const double x[3]) const
{
  const std::array<double, 2> origin = this->Origin(x);
  return std::hypot(origin[0] - this->Inflow.Y, origin[1] - this->Inflow.Z) - this->Inflow.Radius;
}

std::vector<Tube> MakeTubes(int points)
{
  return { MakeContraction(points), MakeRoundSphere("beside", { -2.2, 1.0, 0.0, 0.5 }, 3.5, points),
    MakeRoundSphere("around", { -2.2, 0.2, 0.1, 0.6 }, 3.8, points) };
}
}
