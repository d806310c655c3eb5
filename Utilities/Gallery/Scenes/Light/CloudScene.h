// SPDX-License-Identifier: BSD-3-Clause
#ifndef CloudScene_h
#define CloudScene_h

#include "vtkSmartPointer.h"
#include "vtkVector.h"
#include "vtkVolume.h"

#include <array>

class vtkSpatialObject;

/**
 * What scenes of clouds share.
 */
namespace gallery
{
class Panel;

/// How often light is scattered before it is seen.
enum class Scattering
{
  SINGLE,
  FORWARD,
  FULL
};

/// Clouds within \a bounds, so many cells along the longest edge, in which light goes on as it does
/// in drops of water.
vtkSmartPointer<vtkVolume> MakeCloudVolume(
  vtkSpatialObject* clouds, const std::array<double, 6>& bounds, int cells, Scattering scattering);

/// Has light be scattered in a volume made by MakeSlicedVolume(), by Henyey and Greenstein's
/// function.
void Scatter(vtkVolume* volume, Scattering scattering, double anisotropy);

/// The sun out of a direction, weak blue light from above, both times exposure, and a sky behind
/// all.
void UseSky(Panel& panel, const vtkVector3d& sun, double exposure = 1.0);
}

#endif
