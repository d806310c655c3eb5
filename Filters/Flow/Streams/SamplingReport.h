// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SamplingReport_h
#define interlume_SamplingReport_h

#include "vtkType.h"

namespace interlume
{

/**
 * @class   SamplingReport
 * @brief   interpolation error between samples, measured with streamlines
 *
 * vtkImplicitFlowField measures the error at cell centers, where linear interpolation has its
 * largest error: the mean values of u, v and AdvectionTime at the corners are compared with the
 * result of a streamline from the center. If Checks is 0, nothing was compared.
 *
 * @sa vtkImplicitFlowField::SetSamplingChecks
 */
struct SamplingReport
{
  /// Mean, 99th percentile and maximum of the absolute error.
  struct Error
  {
    double Mean = 0.0;
    double Percentile99 = 0.0;
    double Largest = 0.0;
  };

  /// Number of cells whose centers were compared. Each has at least one corner in the field.
  vtkIdType Checks = 0;
  /// Number of compared cells whose corners differ in FlowStatus or TerminationId, or lie on both
  /// sides of a surface across which time is discontinuous. In renderings, the boundary between
  /// different values in such a cell is displaced by up to half a cell.
  vtkIdType SplitCells = 0;
  /// Number of centers whose status or surface differs from that of most corners.
  vtkIdType MismatchedCenters = 0;
  /// Number of the remaining centers that reached a surface. The members below are the errors at
  /// these centers, in u and v in units of TerminationUV, and in AdvectionTime. The error of a
  /// periodic parameter is at most half a period.
  vtkIdType Compared = 0;
  Error U;
  Error V;
  Error Time;
};

}

#endif
