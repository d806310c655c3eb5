// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowTubes_h
#define FlowTubes_h

#include "Benchmarks/Flow/FlowDisk.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

/**
 * Stream volumes with closed-form solutions.
 */
namespace flow
{
/**
 * The stream volume of a divergence-free field, from a disk perpendicular to x, after a given time.
 */
struct Tube
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Field;
  Disk Inflow;
  double Time = 0.0;
  /// Volume, which is the flux through the disk multiplied by the time.
  double Volume = 0.0;
  /// Returns the point (y,z) of the disk's plane on the streamline through x.
  std::function<std::array<double, 2>(const double x[3])> Origin;
  /// Returns whether no streamline from the plane reaches x.
  std::function<bool(const double x[3])> IsShadow;

  /// Returns the distance from the disk's edge to the start of the streamline through x, negative
  /// for starts inside the disk.
  double GetExcess(const double x[3]) const;
};

/**
 * Returns tubes on images with \a points points along each axis: `contraction`, in the field (x,
 * -y/2, -z/2), which interpolation reproduces exactly; `beside` and `around`, in potential flow of
 * speed 1 around a sphere of radius 1, next to the sphere and around it.
 */
std::vector<Tube> MakeTubes(int points);
}

#endif
