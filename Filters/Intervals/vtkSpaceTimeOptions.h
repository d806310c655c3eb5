#ifndef vtkSpaceTimeOptions_h
#define vtkSpaceTimeOptions_h

#include "vtkAlgorithm.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <array>
#include <cmath>

/**
 * @class   vtkSpaceTimeOptions
 * @brief   what a filter wants made of 4-simplices
 */
class vtkSpaceTimeOptions
{
public:
  static constexpr int NumberOfBoundaries = vtkTimeVaryingIntervalVolume::NUMBER_OF_BOUNDARY_KINDS;

  bool Tetrahedra = true;
  bool Simplices = false;
  std::array<bool, NumberOfBoundaries> Boundaries{};
  int Precision = vtkAlgorithm::DEFAULT_PRECISION;
  /// Whether steps are copied, since the input writes each over the one before.
  bool CopiesSteps = false;

  /// The direction of projection in (x,y,z,t), not zero.
  void SetDirection(const double direction[4])
  {
    double length = 0.0;
    for (int axis = 0; axis < 4; ++axis)
    {
      length = std::hypot(length, direction[axis]);
    }
    // The same line, never away from time.
    length = direction[3] < 0.0 ? -length : length;
    for (int axis = 0; axis < 4; ++axis)
    {
      this->Direction[axis] = direction[axis] / length;
    }
  }

  bool IsAlongTime() const { return this->Direction[3] == 1.0; }

  /**
   * A place in space and time in the axes of the projection, of which the last is along it: those
   * of x, y, z, t turned by the smallest rotation that takes t to the direction.
   */
  void Project(double x[4]) const
  {
    double along = 0.0;
    for (int axis = 0; axis < 4; ++axis)
    {
      along += x[axis] * this->Direction[axis];
    }
    const double shift = (x[3] + along) / (1.0 + this->Direction[3]);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] -= this->Direction[axis] * shift;
    }
    x[3] = along;
  }

private:
  std::array<double, 4> Direction{ { 0.0, 0.0, 0.0, 1.0 } };
};

#endif
