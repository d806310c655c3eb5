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
 * @brief   where the velocity across an axis is 0, on planes across it
 *
 * There is a system for each plane: both components of the velocity in it, and the distance from
 * it.
 */
class CrossFlow : public ZeroSearch::Systems
{
public:
  /// Takes an axis of any length but 0, and a velocity that is subtracted.
  CrossFlow(const double axis[3], const double frameVelocity[3]);

  /// Places \a number planes, or for 0 as vtkVortexAxis documents.
  void PlacePlanes(vtkDataSet* data, int number);

  /// Returns the number of planes, which ascend by their coordinate along the axis.
  int GetNumberOfPlanes() const { return static_cast<int>(this->Planes.size()); }
  double GetPlane(int plane) const { return this->Planes[plane]; }

  double GetHeight(const double x[3]) const;
  /// Returns the distance of places along the planes.
  double GetDistance(const double a[3], const double b[3]) const;

  void GetRange(const MultilinearCell& cell, int& first, int& last) const override;
  void Evaluate(
    const MultilinearCell& cell, int plane, MultilinearCell::Values& values) const override;

  struct Vortex
  {
    int Plane;
    double Position[3];
    double CrossFlowSpeed;
    /// The strength of the swirl; 0 where the velocity does not turn.
    double SwirlStrength;
    double AxialVelocity;
    bool IsCounterclockwise;
    double CellLength;
  };
  Vortex MakeVortex(const ZeroSearch::Zero& zero) const;

private:
  bool PlaceByLayers(vtkDataSet* data, int& number);
  void PlaceEvenly(vtkDataSet* data, int number);

  double Normal[3];
  /// Two directions in the planes, of length 1; right-handed with the normal.
  double Directions[2][3];
  double FrameVelocity[3];
  std::vector<double> Planes;
};

}

#endif
