// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVFieldExtent_h
#define vtkPVFieldExtent_h

/**
 * Computes the ends of termination surfaces. A length of 0 selects the size of the field.
 */
namespace vtkPVFieldExtent
{
/**
 * Computes the positions \a ends of both ends of a surface along the unit vector \a along, relative
 * to \a center. Each end is half of \a length from the center. With a length of 0, the ends are
 * those of the projection of the box \a bounds, or half a unit from the center if the box is empty
 * (lower above upper).
 */
void GetEnds(double length, const double bounds[6], const double center[3], const double along[3],
  double ends[2]);
}

#endif
