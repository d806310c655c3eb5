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
  /// The number of points of the output.
  vtkIdType Points = 0;
  /// The number of points outside of the field, whose value is 0.
  vtkIdType PointsOutside = 0;
  /// The number of points inside with a velocity that is not finite, or less than 1e-9 of the
  /// largest.
  vtkIdType PointsAtRest = 0;
  /// The number of points inside that move and whose streamline ends before Length on one side or
  /// on both.
  vtkIdType PointsWithShortLines = 0;
  /// The number of steps each way of a full streamline, and the lengths in use, which tell what was
  /// taken for automatic ones.
  int Steps = 0;
  double StepLength = 0.0;
  double Length = 0.0;
  double NoiseScale = 0.0;
  /// The number of points of the field with vectors that look like fill values.
  vtkIdType FillValues = 0;
  /// The number of points of the field's cells with vectors that are NaN or infinite.
  vtkIdType NonFiniteVectors = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
