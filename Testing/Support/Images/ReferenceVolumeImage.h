// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceVolumeImage_h
#define ReferenceVolumeImage_h

#include "Support/Images/ReferenceMaterial.h" // for the arrays
#include "Support/Images/RgbaImage.h"         // for the image

#include <array>  // for the size
#include <map>    // for priorities
#include <string> // for array names
#include <vector> // for distances

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace reference
{

/// Method that combines the segments of a view ray.
enum class Blend
{
  /// Composites exactly, front to back in order of entry.
  Composite,
  /// Color and opacity (at most 1) at the largest opacity argument on the ray.
  MaximumIntensity,
  /// Sum of the segments, each composited separately; at most 1 per channel.
  Additive,
  /// Renders each layer by OpticalDepth, and composites layers with higher priorities in front.
  Priority,
  /// 1 - exp(-depth), and the mean color weighted by optical depth.
  OpticalDepth
};

/// Integration of a segment.
enum class Integration
{
  Exact,
  /// Mean of color and extinction at both ends.
  AverageColor
};

/**
 * Settings of MakeReferenceImage() besides grid, property and camera.
 */
struct CameraSettings
{
  std::array<int, 2> Size = { { 64, 64 } };
  Blend How = Blend::Composite;
  Integration Mode = Integration::Exact;
  MaterialArrays Arrays;
  /// Cell array of the layers.
  std::string Layers = "IntervalId";
  /// Priorities of layers. A layer without an entry has its number as its priority.
  std::map<int, double> Priorities;
  /// Distance of an opaque surface along each pixel's view ray, with rows from the bottom. Empty if
  /// nothing is opaque.
  std::vector<double> OpaqueDistance;
  /// Whether to render each pixel, with rows from the bottom. Other pixels stay transparent. If
  /// empty, all are rendered.
  std::vector<bool> Wanted;
};

/**
 * Renders the tetrahedra of a grid by integration along the view ray of each pixel. Segments are
 * computed in long double and integrated in double, with an error of at most 1e-9. The near plane
 * of the camera clips the grid, the far plane does not. Tetrahedra without volume or with values
 * that are not finite are skipped. Rows are computed in parallel, and the result is independent of
 * the number of threads.
 *
 * Throws std::invalid_argument if arrays are missing or transfer functions are not piecewise
 * linear.
 */
RgbaImage MakeReferenceImage(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  vtkCamera* camera, const CameraSettings& settings);

}

#endif
