#ifndef vtkFlowPointCopies_h
#define vtkFlowPointCopies_h

#include "vtkType.h"

#include <vector>

class vtkPointData;
class vtkPoints;
class vtkPointSet;

/**
 * Points and their arrays with copies of some of them.
 */
namespace vtkFlowPointCopies
{
/**
 * Fills \a points and \a data, both empty, with those of \a input and, after them, copies of the
 * points \a sources.
 */
void Append(
  vtkPointSet* input, const std::vector<vtkIdType>& sources, vtkPoints* points, vtkPointData* data);
}

#endif
