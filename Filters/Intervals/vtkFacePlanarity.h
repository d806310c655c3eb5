#ifndef vtkFacePlanarity_h
#define vtkFacePlanarity_h

#include "vtkSpaceTimeCells.h"
#include "vtkSpaceTimeSlots.h"

/**
 * @class   vtkFacePlanarity
 * @brief   which faces of a cell are planar at all times of a slab
 *
 * Where points stay in place, points above one face of a cell lie in a plane, if the face is
 * planar: triangles, all faces of image data and rectilinear grids, and quadrilaterals whose
 * corners are.
 */
class vtkFacePlanarity
{
public:
  vtkFacePlanarity(const vtkSpaceTimeStep& first, const vtkSpaceTimeStep& second);

  /// Whether points stay in place.
  bool IsStatic() const { return this->Static; }

  /// One bit for each face, in the order of vtkSpaceTimeSlots.
  unsigned GetPlanar(const vtkSpaceTimeCell& cell, const vtkSpaceTimeSlots& slots) const;

private:
  bool IsPlanar(const vtkSpaceTimeCell& cell, unsigned corners) const;

  vtkDataSet* Grid;
  bool Static;
  bool Flat;
};

#endif
