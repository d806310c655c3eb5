// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowSamplingReport_h
#define vtkFlowSamplingReport_h

#include "vtkType.h"

/**
 * @class   vtkFlowSamplingReport
 * @brief   how far what is interpolated between samples is from streamlines of its own
 *
 * Holds what vtkImplicitFlowField found in the middles of cells, where the interpolation of the
 * cell's corners has its largest error: u, v and AdvectionTime there are the means of those of the
 * corners. Nothing was compared where Checks is 0.
 *
 * @sa vtkImplicitFlowField::SetSamplingChecks
 */
struct vtkFlowSamplingReport
{
  /// The mean of the absolute errors, the smallest that 99 in 100 of them do not exceed, and the
  /// largest.
  struct Error
  {
    double Mean = 0.0;
    double Percentile99 = 0.0;
    double Largest = 0.0;
  };

  /// The number of cells whose middles were compared, each with a corner in the field at least.
  vtkIdType Checks = 0;
  /// The number of those whose corners differ in FlowStatus or TerminationId, or lie across their
  /// surface with a jump in time: where they are drawn, a border is off by up to half a cell.
  vtkIdType SplitCells = 0;
  /// The number of middles that came to another status or surface than most of the corners.
  vtkIdType DifferentMiddles = 0;
  /// The number of all other middles that reached a surface. The errors are theirs: those of u and
  /// v, in units of TerminationUV and never more than half a period, and of AdvectionTime.
  vtkIdType Compared = 0;
  Error U;
  Error V;
  Error Time;
};

#endif
