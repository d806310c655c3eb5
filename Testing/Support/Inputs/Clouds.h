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
 * Clouds made by constructive volume geometry, following section 2.6 of C. Zhang's dissertation
 * (Ohio State University, 2006): unions of spheres whose density is perturbed by Perlin noise.
 */
namespace interlume
{

/// A cumulus cloud: heaps of spheres on a flat base.
struct Cumulus
{
  /// Center of the base.
  std::array<double, 3> Base{};
  double Radius = 0.5;
  /// Extent of the base along y as a fraction of its extent along x.
  double Depth = 0.8;
  double Height = 0.6;
  /// Number of heaps on the base. A heap is a large sphere covered with smaller spheres.
  int Heaps = 9;
  unsigned Seed = 1;
};

/// Returns the union of clouds with fractal edges. The z-axis points up.
vtkSmartPointer<vtkSpatialObject> MakeClouds(const std::vector<Cumulus>& clouds);

/// Samples an object on a grid of cubic cells, with \a cells cells along the longest edge of the
/// bounds. The values of the float array `Density` are in [0, 1].
vtkSmartPointer<vtkImageData> SampleDensity(
  vtkSpatialObject* object, const std::array<double, 6>& bounds, int cells);

/// Returns a white, unshaded medium whose extinction per unit length is proportional to the density
/// and equals \a extinction at density 1.
vtkSmartPointer<vtkVolumeProperty> MakeCloudProperty(double extinction);

}

#endif
