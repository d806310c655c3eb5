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
 * The stream volume that starts at a disk perpendicular to x and is advected for a given time in a
 * divergence-free field.
 */
struct Tube
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Field;
  Disk Inflow;
  double Time = 0.0;
  /// Volume, which is the flux through the disk multiplied by the time.
  double Volume = 0.0;
  /// Returns the (y,z) coordinates at which the streamline through x starts in the disk's plane.
  std::function<std::array<double, 2>(const double x[3])> Origin;
  /// Returns true if no streamline from the disk's plane reaches x.
  std::function<bool(const double x[3])> IsShadow;

  /// Returns the distance from the disk's edge to the start of the streamline through x. It is
  /// negative if the streamline starts inside the disk.
  double GetExcess(const double x[3]) const;
};

/**
 * Returns tubes in fields sampled at \a points points along each axis: `contraction`, in the field
 * (x, -y/2, -z/2), which linear interpolation reproduces exactly; `beside` and `around`, in
 * potential flow of speed 1 around a sphere of radius 1, where the tube passes next to the sphere
 * or surrounds it.
 */
std::vector<Tube> MakeTubes(int points);
}

#endif
