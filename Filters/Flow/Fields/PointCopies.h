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
 * Fills the empty \a points and \a data from \a input, followed by copies of the points \a sources.
 */
void Append(
  vtkPointSet* input, const std::vector<vtkIdType>& sources, vtkPoints* points, vtkPointData* data);
}

}

#endif
