// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FacePlanarity_h
#define interlume_FacePlanarity_h

#include "TimeVarying/TimeVaryingCells.h"
#include "TimeVarying/SpaceTimeSlots.h"

namespace interlume
{

/**
 * @class   FacePlanarity
 * @brief   finds the planar cell faces of a grid that does not move between two time steps
 *
 * Output points whose spatial positions lie in a planar face are coplanar at all times. Planar
 * faces are triangles, all faces of image data and rectilinear grids, and quadrilaterals with
 * coplanar points.
 */
class FacePlanarity
{
public:
  FacePlanarity(const TimeStep& first, const TimeStep& second);

  /// Returns true if the grid points do not move.
  bool IsStatic() const { return this->Static; }

  /// Returns the planar faces as a bit mask, in the face order of SpaceTimeSlots.
  unsigned GetPlanarFaces(const TimeVaryingCell& cell, const SpaceTimeSlots& slots) const;

private:
  bool IsPlanar(const TimeVaryingCell& cell, unsigned corners) const;

  vtkDataSet* Grid;
  bool Static;
  bool Flat;
};

}

#endif
