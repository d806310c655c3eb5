// SPDX-License-Identifier: BSD-3-Clause
#ifndef Clouds_h
#define Clouds_h

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkImageData;
class vtkSpatialObject;
class vtkVolumeProperty;

/**
 * Clouds by constructive volume geometry, as C. Zhang, dissertation, Ohio State 2006, section 2.6,
 * has them: a collection of spheres whose density Perlin's noise disturbs.
 */
namespace interlume
{

/// A cumulus: heaps of spheres on a flat base.
struct Cumulus
{
  /// The middle of the base.
  std::array<double, 3> Base{};
  double Radius = 0.5;
  /// Of the base over that of a circle, along y.
  double Depth = 0.8;
  double Height = 0.6;
  /// Of heaps on the base; each has smaller ones on it.
  int Heaps = 9;
  unsigned Seed = 1;
};

/// Returns the union of clouds with fractal edges, z up.
vtkSmartPointer<vtkSpatialObject> MakeClouds(const std::vector<Cumulus>& clouds);

/// Samples an object within bounds on cubic cells, so many along the longest edge, as `Density`, 0
/// to 1 in floats.
vtkSmartPointer<vtkImageData> SampleDensity(
  vtkSpatialObject* object, const std::array<double, 6>& bounds, int cells);

/// White matter that is not shaded, of an extinction per unit of length where the density is 1, and
/// in proportion below.
vtkSmartPointer<vtkVolumeProperty> MakeCloudMatter(double extinction);

}

#endif
