// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointCopies_h
#define interlume_PointCopies_h

#include "vtkType.h"

#include <vector>

class vtkPointData;
class vtkPoints;
class vtkPointSet;

namespace interlume
{

/**
 * Appends copies of points and their attributes.
 */
namespace PointCopies
{
/**
 * Copies the points and point data of \a input to the empty \a points and \a data, and appends
 * copies of the points with the ids \a sources.
 */
void Append(
  vtkPointSet* input, const std::vector<vtkIdType>& sources, vtkPoints* points, vtkPointData* data);
}

}

#endif
