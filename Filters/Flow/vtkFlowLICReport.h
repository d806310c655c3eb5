// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowLICReport_h
#define vtkFlowLICReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkFlowLICReport
 * @brief   what an execution of vtkFlowLIC found, and the lengths that it took
 *
 * @sa vtkFlowLIC
 */
struct INTERLUMEFLOW_EXPORT vtkFlowLICReport
{
  vtkIdType Points = 0;
  /// Outside of the field: 0.
  vtkIdType PointsOutside = 0;
  /// Inside, at a velocity that is not finite, or less than 1e-9 of the largest.
  vtkIdType PointsAtRest = 0;
  /// Others whose streamline ends before Length on one side or on both.
  vtkIdType PointsWithShortLines = 0;
  /// Each way, of a full streamline, and what was taken for the values of 0 above.
  int Steps = 0;
  double StepLength = 0.0;
  double Length = 0.0;
  double NoiseScale = 0.0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
