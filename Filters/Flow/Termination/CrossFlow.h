// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CrossFlow_h
#define interlume_CrossFlow_h

#include "Topology/ZeroSearch.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   CrossFlow
 * @brief   finds where the in-plane velocity is 0, on planes perpendicular to an axis
 *
 * Each plane defines a system of three equations: the two in-plane components of the velocity and
 * the distance from the plane are 0.
 */
class CrossFlow : public ZeroSearch::Systems
{
public:
  /// Sets an axis of any nonzero length, and a frame velocity to subtract.
  CrossFlow(const double axis[3], const double frameVelocity[3]);

  /// Places \a number planes, or the default planes of vtkVortexAxis if \a number is 0.
  void PlacePlanes(vtkDataSet* data, int number);

  /// Returns the number of planes, which are in ascending order along the axis.
  int GetNumberOfPlanes() const { return static_cast<int>(this->Planes.size()); }
  double GetPlane(int plane) const { return this->Planes[plane]; }

  double GetHeight(const double x[3]) const;
  /// Returns the distance between two points, both projected onto one of the planes.
  double GetDistance(const double a[3], const double b[3]) const;

  void GetRange(const MultilinearCell& cell, int& first, int& last) const override;
  void Evaluate(
    const MultilinearCell& cell, int plane, MultilinearCell::Values& values) const override;

  struct Vortex
  {
    int Plane;
    double Position[3];
    double CrossFlowSpeed;
    /// Swirl strength, or 0 if the velocity does not swirl.
    double SwirlStrength;
    double AxialVelocity;
    bool IsCounterclockwise;
    double CellLength;
  };
  Vortex MakeVortex(const ZeroSearch::Zero& zero) const;

private:
  bool PlacePlanesByLayer(vtkDataSet* data, int& number);
  void PlacePlanesEvenly(vtkDataSet* data, int number);

  double Normal[3];
  /// Two in-plane unit vectors, right-handed with the normal.
  double Directions[2][3];
  double FrameVelocity[3];
  std::vector<double> Planes;
};

}

#endif
