// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowCriticalPointsReport_h
#define vtkFlowCriticalPointsReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkFlowCriticalPointsReport
 * @brief   which cells an execution of vtkFlowCriticalPoints could not search
 *
 * @sa vtkFlowCriticalPoints
 */
struct INTERLUMEFLOW_EXPORT vtkFlowCriticalPointsReport
{
  /// The numbers of cells that are 0 throughout, that have zeros which are not isolated, that
  /// are not finite, and that have a point with fill values.
  vtkIdType ZeroCells = 0;
  vtkIdType DegenerateCells = 0;
  vtkIdType NonFiniteCells = 0;
  vtkIdType FillValueCells = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
