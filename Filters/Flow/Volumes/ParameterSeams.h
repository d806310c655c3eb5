// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ParameterSeams_h
#define interlume_ParameterSeams_h

#include "vtkType.h"

class vtkUnstructuredGrid;

namespace interlume
{

class ImplicitFlowArrays;
class InterpolableCells;

/**
 * @class   ParameterSeams
 * @brief   unwraps the parameters of simplices extracted from cells across a seam
 */
class ParameterSeams
{
public:
  /**
   * Duplicates the points of simplices of \a mesh that come from cells across a seam, and unwraps
   * the parameters of the duplicates. Does the same for \a boundary unless it is null. Both must
   * share their points and be outputs of vtkIntervalVolume with origin arrays; modified arrays are
   * replaced. Among the cells that cross the same seams, duplicated points keep their order, so
   * that another extraction splits common faces consistently. Returns the number of added points.
   */
  static vtkIdType Unwrap(const InterpolableCells& cells, const ImplicitFlowArrays& arrays,
    vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* boundary);
};

}

#endif
