// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SamplingReport_h
#define interlume_SamplingReport_h

#include "vtkType.h"

namespace interlume
{

/**
 * @class   SamplingReport
 * @brief   holds the error of interpolation between samples, compared with streamlines
 *
 * vtkImplicitFlowField measures it at the centers of cells, where the interpolation between the
 * cell's corners has its largest error: u, v and AdvectionTime there are the means of the corners'
 * values. If Checks is 0, nothing was compared.
 *
 * @sa vtkImplicitFlowField::SetSamplingChecks
 */
struct SamplingReport
{
  /// The mean of the absolute errors, the smallest that 99 in 100 of them do not exceed, and the
  /// largest.
  struct Error
  {
    double Mean = 0.0;
    double Percentile99 = 0.0;
    double Largest = 0.0;
  };

  /// The number of cells whose centers were compared, each with at least one corner in the field.
  vtkIdType Checks = 0;
  /// The number of those whose corners differ in FlowStatus or TerminationId, or lie across their
  /// surface with a jump in time: when they are drawn, a border is off by up to half a cell.
  vtkIdType SplitCells = 0;
  /// The number of centers that came to another status or surface than most of the corners.
  vtkIdType MismatchedCenters = 0;
  /// The number of all other centers that reached a surface. The errors are theirs: those of u and
  /// v, in units of TerminationUV and never more than half a period, and of AdvectionTime.
  vtkIdType Compared = 0;
  Error U;
  Error V;
  Error Time;
};

}

#endif
