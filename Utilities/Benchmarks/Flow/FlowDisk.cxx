// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowDisk.h"

#include "vtkTerminationPlane.h"

#include <cmath>

namespace flow
{
double Disk::Integrate(const std::function<double(const double x[3])>& function) const
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
      const double position[3] = { this->X, this->Y + radius * std::cos(angle),
        this->Z + radius * std::sin(angle) };
      sum += radius * function(position);
    }
  }
  return sum * 2.0 * pi / sectors * this->Radius / rings;
}

DiskVolume::DiskVolume(const Disk& disk)
{
  // The parameters u and v are y and z relative to the center of the disk.
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(disk.X, disk.Y, disk.Z);
  plane->SetPoint1(disk.X, disk.Y + 1.0, disk.Z);
  plane->SetPoint2(disk.X, disk.Y, disk.Z + 1.0);
  plane->SetUnbounded(true);
  plane->SetId(0);
  this->Field->AddTerminationSurface(plane);
  this->Mapping->SetInputConnection(this->Field->GetOutputPort());
  this->Mapping->SetFormula(vtkInflowMapping::ALL, "sqrt(u^2+v^2)");
  this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
  this->Volume->SetInterval(0, -1.0, disk.Radius);
}
}
