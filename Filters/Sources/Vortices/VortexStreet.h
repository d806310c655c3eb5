// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VortexStreet_h
#define interlume_VortexStreet_h

#include <array>

namespace interlume
{

/**
 * @class   VortexStreet
 * @brief   density deficit of a von Karman vortex street behind a tapered cylinder, at one time
 *
 * The formula is in vtkTaperedCylinderSource.
 */
class VortexStreet
{
public:
  struct Shape
  {
    std::array<double, 2> Radii; ///< at z = 0 and z = Height
    double Height;
    double OuterRadius;
    double Speed;
    double StrouhalNumber;
  };

  static constexpr int NumberOfCells = 3;

  VortexStreet(const Shape& shape, double time)
    : Flow(shape)
    , Time(time)
  {
  }

  /// Returns the diameter of the cylinder at a height; beyond its ends, that of the end.
  double GetDiameter(double z) const;
  /// Returns the deficit at a point.
  double operator()(const double x[3]) const;

private:
  /// Returns the deficit of one cell's vortices, as if the cell reached along the whole cylinder.
  double GetDeficitOfCell(int cell, const double x[3]) const;

  Shape Flow;
  double Time;
};

}

#endif
