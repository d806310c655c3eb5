// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowTubes_h
#define FlowTubes_h

#include "Benchmarks/Flow/FlowDisc.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

/**
 * Stream volumes that are known by formulas.
 */
namespace flow
{
/**
 * What a field without divergence carries from a disc across x in a time.
 */
struct Tube
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Field;
  Disc Inflow;
  double Time = 0.0;
  /// Its volume: what flows through the disc in that time.
  double Volume = 0.0;
  /// Where on the disc's plane, (y,z), the streamline through a place comes from.
  std::function<std::array<double, 2>(const double x[3])> Origin;
  /// Whether no streamline from the plane comes to a place.
  std::function<bool(const double x[3])> IsShadow;

  /// How far the streamline through a place begins from the disc, negative inside.
  double GetExcess(const double x[3]) const;
};

/**
 * On so many points a side: `contraction`, of the field (x, -y/2, -z/2), which interpolation keeps;
 * `beside` and `around`, in potential flow of speed 1 round a sphere of radius 1, beside the sphere
 * and around it.
 */
std::vector<Tube> MakeTubes(int points);
}

#endif
