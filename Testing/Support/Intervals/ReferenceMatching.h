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
 * What the headers of the filters promise where values equal bounds, checked by the orientation of
 * faces alone: counted with their signs, with no tolerance. It takes any data, so that volumes with
 * millions of ties can be asked.
 */
namespace reference
{

/// The volumes of 8 bits in Data/, whose values equal bounds in many points.
const std::vector<std::string>& GetTiedVolumes();

/// A cube of points out of the middle of a volume, moved along x, as an image with the scalars "f".
vtkSmartPointer<vtkImageData> CropVolume(vtkDataSet& volume, int points, int shift);

/// Values of the active scalars between which there are about as many: the least and the greatest,
/// and up to three between them. At least two.
std::vector<double> GetQuantiles(vtkDataSet& data);

/// A criterion of vtkIntervalVolume.
struct MatchingCriterion
{
  std::string Array;
  double Lower;
  double Upper;
};

/**
 * Extracts intervals from the active scalars of three-dimensional cells, with port 1, and checks
 * for each interval:
 * - no two tetrahedra have the same points and opposite orientation;
 * - a face of the tetrahedra cancels, or is a triangle of port 1, or lies in a face of the domain,
 * or (with criteria) has a criterion's array equal to its bound throughout;
 * - each triangle of port 1 is such a face, once, turned as that is, equal to its bound throughout,
 *   and of the cell of the tetrahedron that it is a face of; none is there twice or both ways
 * round;
 * - an interval [a, a] is the cells whose corners are all equal to a;
 * - every point is used.
 */
void CheckMatching(vtkDataSet* data, const std::vector<Interval>& intervals, Check& check,
  const std::vector<MatchingCriterion>& criteria = {});

/// The same, and that the signed volumes of the adjacent intervals between \a bounds, which hold
/// all values, add up to the domain's.
void CheckMatchingTiling(vtkDataSet* data, const std::vector<double>& bounds, Check& check);

/**
 * Extracts the contour of a value of the active scalars, which some exceed, and checks that no
 * triangle is there twice or both ways round, that its edges cancel but in faces of the domain, and
 * that its triangles inside are those that bound the interval above.
 */
void CheckMatchingContour(vtkDataSet* data, double value, Check& check);

/**
 * Extracts intervals in space and time from a grid that does not move and fills its box, and checks
 * for each interval:
 * - no two 4-simplices have the same points and opposite orientation;
 * - of those that lie in one step, AtStep says that they are nothing there;
 * - a face of the 4-simplices cancels, or is a surface in time or a volume at the first or last
 * step of port 1, or lies in a wall of the box;
 * - surfaces in time are such faces, once, turned as those are;
 * - the volume at the first and last step is the interval volume of that step, and the surfaces
 *   there are its port 1;
 * - the slice at each step is the interval volume of that step, tetrahedron by tetrahedron.
 */
void CheckMatchingInTime(
  const TimeSteps& steps, const std::vector<Interval>& intervals, Check& check);

}

#endif
