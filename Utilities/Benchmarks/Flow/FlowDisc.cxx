// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowDisc.h"

#include "vtkTerminationPlane.h"

#include <cmath>

namespace flow
{
double Disc::Integrate(const std::function<double(const double x[3])>& function) const
{
  constexpr double pi = 3.14159265358979323846;
  constexpr int rings = 1000;
  constexpr int sectors = 64;
  double sum = 0.0;
  for (int ring = 0; ring < rings; ++ring)
  {
    const double radius = this->Radius * (ring + 0.5) / rings;
    for (int sector = 0; sector < sectors; ++sector)
    {
      const double angle = 2.0 * pi * sector / sectors;
      const double place[3] = { this->X, this->Y + radius * std::cos(angle),
        this->Z + radius * std::sin(angle) };
      sum += radius * function(place);
    }
  }
  return sum * 2.0 * pi / sectors * this->Radius / rings;
}

DiscVolume::DiscVolume(const Disc& disc)
{
  // (u,v) are y and z from the centre.
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(disc.X, disc.Y, disc.Z);
  plane->SetPoint1(disc.X, disc.Y + 1.0, disc.Z);
  plane->SetPoint2(disc.X, disc.Y, disc.Z + 1.0);
  plane->SetUnbounded(true);
  plane->SetId(0);
  this->Field->AddTerminationSurface(plane);
  this->Mapping->SetInputConnection(this->Field->GetOutputPort());
  this->Mapping->SetFormula(vtkInflowMapping::ALL, "sqrt(u^2+v^2)");
  this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
  this->Volume->SetInterval(0, -1.0, disc.Radius);
}
}
