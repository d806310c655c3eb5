// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceCases_h
#define SurfaceCases_h

#include "Support/Images/RgbaImage.h"
#include "Support/Images/ShadowCases.h"

#include <functional>
#include <iosfwd>

/**
 * Volumes with sharp surfaces of known brightness, and the errors of rendered images of them.
 */
namespace reference
{

/// Returns the red value of a pixel, or NaN if it is to be ignored.
using PixelFunction = std::function<double(int, int)>;

/// A scene with one light and the exact brightness of its pixels.
struct SurfaceCase
{
  ShadowScene Scene;
  PixelFunction Expected;
};

/// Returns an opaque white cube. The brightness of a face depends on its angles to the light and
/// the view.
SurfaceCase MakeOpaqueCube(int cells);

/// Returns a cube of cells^3 voxels in which all points on one side of a plane are opaque and
/// white. The angles of the light and the view to the plane's normal, and the azimuth between them,
/// are in degrees.
SurfaceCase MakePlate(int cells, Double3 normal, double light, double eye, double around);

struct SurfaceErrors
{
  double Mean = 0.0;
  double P95 = 0.0;
  double Max = 0.0;
  /// Root-mean-square error, relative to the mean of the expected values.
  double Rms = 0.0;
  /// Mean of the image divided by the mean of the expected values, minus 1.
  double Bias = 0.0;
};

/// Computes the errors over the pixels with an expected value.
SurfaceErrors MeasureSurface(const RgbaImage& found, const PixelFunction& expected);

std::ostream& operator<<(std::ostream& os, const SurfaceErrors& errors);

}

#endif
