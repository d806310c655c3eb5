// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkStreamSurfaceParametersReport_h
#define vtkStreamSurfaceParametersReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkStreamSurfaceParametersReport
 * @brief   what an execution of vtkStreamSurfaceParameters followed
 *
 * @sa vtkStreamSurfaceParameters
 */
struct INTERLUMEFLOW_EXPORT vtkStreamSurfaceParametersReport
{
  /// The numbers of contours of the inflow on the termination surfaces, and of closed ones among
  /// them.
  vtkIdType Contours = 0;
  vtkIdType ClosedContours = 0;
  /// The number of points that were added where parameters jump.
  vtkIdType AddedPoints = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
