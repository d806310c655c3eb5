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
 * Points and their arrays with copies of some of them.
 */
namespace PointCopies
{
/**
 * Fills \a points and \a data, both empty, with those of \a input and, after them, copies of the
 * points \a sources.
 */
void Append(
  vtkPointSet* input, const std::vector<vtkIdType>& sources, vtkPoints* points, vtkPointData* data);
}

}

#endif
