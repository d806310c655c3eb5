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
  /// Contours of the inflow on the termination surfaces, and those of them that are closed.
  vtkIdType Contours = 0;
  vtkIdType ClosedContours = 0;
  /// Points added where parameters jump: more than the input has.
  vtkIdType AddedPoints = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
