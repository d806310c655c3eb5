// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMatching_h
#define ReferenceMatching_h

#include "Support/Checks/ReferenceCheck.h"          // for the result
#include "Support/Intervals/ReferenceExtraction.h"  // for the intervals
#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include <string> // for criteria and names
#include <vector> // for the intervals

class vtkDataSet;
class vtkImageData;

/**
 * Checks the documented behavior of the extraction filters where scalars equal interval bounds. The
 * checks are combinatorial: they compare oriented faces by point ids. They work for any data, even
 * for volumes in which millions of scalars equal a bound.
 */
namespace reference
{

/// Returns the file names of the 8-bit volumes in Data/, in which many scalars equal a bound.
const std::vector<std::string>& GetTiedVolumeFileNames();

/// Returns the block of points^3 points at the center of a volume, shifted by \a shift points along
/// x. The scalars are named "f".
vtkSmartPointer<vtkImageData> CropVolume(vtkDataSet& volume, int points, int shift);

/// Returns the minimum and maximum of the active scalars and up to three quantiles between them,
/// without duplicates. If the scalars are constant, the second value is 1 above the first.
std::vector<double> GetQuantiles(vtkDataSet& data);

/// A criterion of vtkIntervalVolume.
struct MatchingCriterion
{
  std::string Array;
  double Lower;
  double Upper;
};

/**
 * Extracts intervals and their boundary (port 1) from the active scalars of three-dimensional
 * cells, and checks each interval, and the region with IntervalId -1:
 * - No two tetrahedra have the same points and opposite orientation.
 * - Each face of the tetrahedra either cancels (another tetrahedron uses it with opposite
 *   orientation), is a triangle of port 1, or lies in a boundary face of the domain. In the region
 *   with IntervalId -1, a face where all values equal a bound may be none of these.
 * - Each triangle of port 1 is a face that does not cancel, with the same orientation, and occurs
 *   once. All its values equal the bound. Its origin cell is that of a tetrahedron with this face.
 * - An interval [a, a] consists of the cells whose corners all have the value a.
 * - Every point is used.
 *
 * \a operation is one of vtkIntervalVolume::CriteriaOperations.
 */
void CheckMatching(vtkDataSet* data, const std::vector<Interval>& intervals, Check& check,
  const std::vector<MatchingCriterion>& criteria = {}, int operation = 0);

/// Performs the checks of CheckMatching() for the adjacent intervals between \a bounds, which must
/// include all scalars. The signed volumes of all intervals must add up to the volume of the
/// domain.
void CheckMatchingTiling(vtkDataSet* data, const std::vector<double>& bounds, Check& check);

/**
 * Extracts a contour of the active scalars at a value below their maximum. Checks that no triangle
 * occurs more than once, that edges cancel except in boundary faces of the domain, and that the
 * triangles inside the domain are the lower boundary of the interval above the value.
 */
void CheckMatchingContour(vtkDataSet* data, double value, Check& check);

/**
 * Extracts intervals in space and time from a static grid that fills its bounding box, and checks
 * each interval:
 * - No two 4-simplices have the same points and opposite orientation.
 * - If all points of a 4-simplex are at one step, its AtStep is not FACES_AT_STEP.
 * - Each face of the 4-simplices either cancels, is on port 1, or lies in a side wall of the box.
 *   On port 1, it is part of the lower or upper surface in time, or of the volume at the first or
 *   last step.
 * - Each cell of a surface in time is a face that does not cancel, with the same orientation, and
 *   occurs once.
 * - At the first and last step, the volume on port 1 equals the output of vtkIntervalVolume for
 *   that step, and the surfaces equal port 1 of that filter.
 * - The slice at each step equals the output of vtkIntervalVolume, tetrahedron by tetrahedron.
 */
void CheckMatchingInTime(
  const TimeSteps& steps, const std::vector<Interval>& intervals, Check& check);

}

#endif
