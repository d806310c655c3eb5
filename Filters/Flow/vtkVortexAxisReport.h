// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkVortexAxisReport_h
#define vtkVortexAxisReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkVortexAxisReport
 * @brief   where an execution of vtkVortexAxis looked for the vortex
 *
 * @sa vtkVortexAxis
 */
struct INTERLUMEFLOW_EXPORT vtkVortexAxisReport
{
  /// The numbers of planes across Axis, and of places in them where the velocity across Axis is 0.
  int Planes = 0;
  vtkIdType Places = 0;
  /// The number of those places that belong to one vortex, which are the points of the line.
  vtkIdType PointsOnAxis = 0;
  /// The numbers of cells that were skipped because they are not finite, and because a point has
  /// fill values.
  vtkIdType NonFiniteCells = 0;
  vtkIdType FillValueCells = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
