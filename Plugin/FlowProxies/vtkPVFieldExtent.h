// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVFieldExtent_h
#define vtkPVFieldExtent_h

/**
 * Computes the ends of a termination surface that has a given length, or spans the flow field.
 */
namespace vtkPVFieldExtent
{
/**
 * Computes the two \a ends of a surface along the unit vector \a along, as signed distances from
 * \a center. Each end is half of \a length from the center. If \a length is 0, the ends are those
 * of the box \a bounds projected onto \a along; if the box is empty (lower above upper), a length
 * of 1 is used.
 */
void GetEnds(double length, const double bounds[6], const double center[3], const double along[3],
  double ends[2]);
}

#endif
