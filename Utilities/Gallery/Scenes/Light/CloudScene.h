// SPDX-License-Identifier: BSD-3-Clause
#ifndef CloudScene_h
#define CloudScene_h

#include "vtkSmartPointer.h"
#include "vtkVector.h"
#include "vtkVolume.h"

#include <array>

class vtkSpatialObject;

/**
 * Support for scenes with clouds.
 */
namespace gallery
{
class Panel;

/// Scattering mode: single scattering, forward scattering, or full multiple scattering.
enum class Scattering
{
  SINGLE,
  FORWARD,
  FULL
};

/// Returns a volume of \a clouds within \a bounds, sampled with \a cells cells along the longest
/// edge. The phase function approximates that of water droplets. \a extinction is the extinction
/// per unit of length at the center of a cloud.
vtkSmartPointer<vtkVolume> MakeCloudVolume(vtkSpatialObject* clouds,
  const std::array<double, 6>& bounds, int cells, Scattering scattering, double extinction = 34.0);

/// Sets scattering with a Henyey-Greenstein phase function in a volume created by
/// MakeSlicedVolume(). \a cells is the number of cells of the scattering grid along its longest
/// edge.
void Scatter(vtkVolume* volume, Scattering scattering, double anisotropy, int cells = 64);

/// Lights the panel with sunlight from direction \a sun and blue skylight from direction \a sky, of
/// the given intensities, and sets its background to a sky gradient.
void UseSky(
  Panel& panel, const vtkVector3d& sun, const vtkVector3d& sky, double sunlight, double skylight);
}

#endif
