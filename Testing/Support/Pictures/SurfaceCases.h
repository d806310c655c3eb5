// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceCases_h
#define SurfaceCases_h

#include "Support/Pictures/RgbaPicture.h"
#include "Support/Pictures/ShadowCases.h"

#include <functional>
#include <iosfwd>

/**
 * Sharp surfaces under light, and how far pictures of them are off.
 */
namespace reference
{

/// The red of a pixel; not a number where it is of no interest.
using PixelFunction = std::function<double(int, int)>;

/// A scene of one light, and what its picture is by a closed form.
struct SurfaceCase
{
  ShadowScene Scene;
  PixelFunction Expected;
};

/// A white cube that is opaque everywhere, by its faces' angles.
SurfaceCase MakeOpaqueCube(int cells);

/// A white plate through a cube of cells^3 whose opacity jumps from 0 to 1 half way between two
/// voxels, seen close: light falls and the eye looks at so many degrees from its normal, so many
/// degrees around it apart.
SurfaceCase MakePlate(int cells, Double3 normal, double light, double eye, double around);

struct SurfaceErrors
{
  double Mean = 0.0;
  double P95 = 0.0;
  double Max = 0.0;
  /// Over the mean of what is expected.
  double Rms = 0.0;
  /// The mean of the picture over that, less 1.
  double Bias = 0.0;
};

/// Over the pixels for which a number is expected.
SurfaceErrors MeasureSurface(const RgbaPicture& found, const PixelFunction& expected);

std::ostream& operator<<(std::ostream& os, const SurfaceErrors& errors);

}

#endif
