// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FacePlanarity_h
#define interlume_FacePlanarity_h

#include "TimeVarying/TimeVaryingCells.h"
#include "TimeVarying/TimeVaryingSlots.h"

namespace interlume
{

/**
 * @class   FacePlanarity
 * @brief   which faces of a cell are planar at all times of a slab
 *
 * Where points stay in place, points above one face of a cell lie in a plane, if the face is
 * planar: triangles, all faces of image data and rectilinear grids, and quadrilaterals whose
 * corners are.
 */
class FacePlanarity
{
public:
  FacePlanarity(const TimeStep& first, const TimeStep& second);

  /// Returns whether points stay in place.
  bool IsStatic() const { return this->Static; }

  /// Returns which faces are planar, with one bit for each face, in the order of TimeVaryingSlots.
  unsigned GetPlanar(const TimeVaryingCell& cell, const TimeVaryingSlots& slots) const;

private:
  bool IsPlanar(const TimeVaryingCell& cell, unsigned corners) const;

  vtkDataSet* Grid;
  bool Static;
  bool Flat;
};

}

#endif
