// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVFieldExtent_h
#define vtkPVFieldExtent_h

/**
 * Computes sizes of termination surfaces, which are those of the field where they are given as 0.
 */
namespace vtkPVFieldExtent
{
/**
 * Computes where something of a length begins and ends along a unit vector, from \a center: half of
 * the length on each side. A length of 0 is as long as the box \a bounds there, and 1 where that is
 * empty (lower above upper).
 */
void GetEnds(double length, const double bounds[6], const double center[3], const double along[3],
  double ends[2]);
}

#endif
