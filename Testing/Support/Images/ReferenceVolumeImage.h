// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceVolumeImage_h
#define ReferenceVolumeImage_h

#include "Support/Images/ReferenceMaterial.h" // for the arrays
#include "Support/Images/RgbaImage.h"         // for the image

#include "vtkType.h" // for cells

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
  /// Composites the segments front to back, in order of entry.
  Composite,
  /// Color and opacity (at most 1) where the argument of the opacity function is largest. With
  /// direct colors, the maximum of each premultiplied channel.
  MaximumIntensity,
  /// Sum of the premultiplied colors and opacities of the segments, at most 1 per channel.
  Additive,
  /// Renders each layer with OpticalDepth, and composites layers with higher priority in front.
  Priority,
  /// Opacity 1 - exp(-depth), and the mean color weighted by optical depth.
  OpticalDepth
};

/// Method that integrates a segment.
enum class Integration
{
  Exact,
  /// Uses the mean color and the mean extinction of both ends.
  AverageColor
};

/**
 * Settings of MakeReferenceImage() other than the grid, the property and the camera.
 */
struct CameraSettings
{
  std::array<int, 2> Size = { { 64, 64 } };
  Blend How = Blend::Composite;
  Integration Mode = Integration::Exact;
  MaterialArrays Arrays;
  /// Name of the cell array of layer numbers, for Blend::Priority.
  std::string Layers = "IntervalId";
  /// Priority of each layer number. By default, the priority of a layer is its number.
  std::map<int, double> Priorities;
  /// Distance to the nearest opaque surface along each pixel's view ray, bottom row first. Empty if
  /// there is none.
  std::vector<double> OpaqueDistance;
  /// For each pixel, whether to render it or leave it transparent, bottom row first. If empty, all
  /// pixels are rendered.
  std::vector<bool> Wanted;
};

/**
 * Renders the tetrahedra of a grid by integrating along the view ray of each pixel. Segments are
 * computed in long double and integrated in double, with an error of at most 1e-9. The near plane
 * of the camera clips the grid, the far plane does not. Tetrahedra with volume 0 or with values
 * that are not finite are skipped. Rows are computed in parallel, and the result is independent of
 * the number of threads.
 *
 * Throws std::invalid_argument if arrays are missing or transfer functions are not piecewise
 * linear.
 */
RgbaImage MakeReferenceImage(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  vtkCamera* camera, const CameraSettings& settings);

/// The part of a view ray in a tetrahedron.
struct RaySegment
{
  vtkIdType Cell;
  /// Distance from the origin of the ray.
  double Entry;
  double OpticalDepth;
  /// Larger argument of the opacity function at the two ends, and the opacity there.
  double Maximum;
  double OpacityAtMaximum;
};

/**
 * Returns the segments of each pixel's view ray, bottom row first. Segments are in order of entry;
 * for Blend::Priority, those of layers with higher priority come first. See MakeReferenceImage().
 */
std::vector<std::vector<RaySegment>> MakeReferenceSegments(vtkUnstructuredGrid* grid,
  vtkVolumeProperty* property, vtkCamera* camera, const CameraSettings& settings);

}

#endif
