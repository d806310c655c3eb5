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
 * @brief   unwrapped parameters for simplices that an extraction made of cells across a seam
 */
class ParameterSeams
{
public:
  /**
   * Gives simplices of \a mesh, and of \a boundary where it is not null, that come from cells
   * across a seam points of their own with unwrapped parameters. Both share their points, are
   * outputs of vtkIntervalVolume with its origins, and get new arrays where these change. Points
   * of several kinds of cells keep their order in each, so that a further extraction cuts common
   * faces alike. Returns the number of points added.
   */
  static vtkIdType Unwrap(const InterpolableCells& cells, const ImplicitFlowArrays& arrays,
    vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* boundary);
};

}

#endif
