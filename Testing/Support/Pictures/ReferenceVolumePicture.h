// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceVolumePicture_h
#define ReferenceVolumePicture_h

#include "Support/Pictures/ReferenceMaterial.h" // for the arrays
#include "Support/Pictures/RgbaPicture.h"       // for the picture

#include <array>  // for the size
#include <map>    // for priorities
#include <string> // for array names
#include <vector> // for distances

class vtkCamera;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace reference
{

/// How the segments of a line of sight are put together.
enum class Blend
{
  /// In order of entry, front to back, exactly.
  Composite,
  /// Colour and opacity, at most 1, of the largest opacity argument on the line.
  MaximumIntensity,
  /// The sum over the segments, each as composite gives it alone; at most 1 a channel.
  Additive,
  /// Each layer as OpticalDepth, then the layers over each other: the higher priority in front.
  Priority,
  /// 1 - exp(-depth), and the mean of colour weighted by optical depth.
  OpticalDepth
};

/// How a segment is integrated.
enum class Integration
{
  Exact,
  /// The mean of colour and of extinction at its ends.
  AverageColor
};

/**
 * What a picture is made of, apart from grid, property and camera.
 */
struct PictureSettings
{
  std::array<int, 2> Size = { { 64, 64 } };
  Blend How = Blend::Composite;
  Integration Mode = Integration::Exact;
  MaterialArrays Arrays;
  /// Cell array of the layers.
  std::string Layers = "IntervalId";
  /// Priority of a layer; its number where it has none.
  std::map<int, double> Priorities;
  /// For each pixel the distance along its line of sight at which something opaque is, rows from
  /// the bottom; empty for nothing opaque.
  std::vector<double> OpaqueDistance;
  /// For each pixel whether it is wanted, rows from the bottom; the others stay transparent. Empty
  /// for all.
  std::vector<bool> Wanted;
};

/**
 * The picture of the tetrahedra of a grid by integration along the line of sight of each pixel, in
 * long double up to the segments and in double along them, to 1e-9 and better. Cut by the near
 * plane of the camera; the far plane is not looked at. Tetrahedra with no volume, NaN or infinity
 * are left out. By as many threads as vtkSMPTools has; the same for any number.
 *
 * std::invalid_argument for arrays that are missing and transfer functions without straight pieces.
 */
RgbaPicture MakeReferencePicture(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  vtkCamera* camera, const PictureSettings& settings);

}

#endif
