// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StageContext_h
#define interlume_StageContext_h

#include "Advection/AdvectionOptions.h"
#include "Streams/FlowReport.h"
#include "Streams/Streamlines.h"

namespace interlume
{

/**
 * @class   StageContext
 * @brief   data shared by the stages of an execution of vtkImplicitFlowField
 *
 * SampleIntegration advects the samples. FarSideStage advects samples near a surface as if they
 * were on its far side. CellRefinement adds samples, after which both stages run again.
 * SamplingCheck measures the interpolation error between samples. Each stage writes its arrays to
 * the samples and can be aborted.
 */
struct StageContext
{
  Streamlines& Field;
  const AdvectionOptions& Options;
  FlowReport& Report;
  /// Length of the diagonal of the field's bounds.
  double FieldLength;
  /// Progress of the execution at the end of the last completed stage.
  double Progress;
  /// Search for the boundary of the reached region between two samples.
  struct BoundarySearch
  {
    int Bisections = 6;
    /// Maximum number of steps of each streamline. A longer one counts as not reached.
    int MaximumSteps = VTK_INT_MAX;
    /// If true, pairs of samples that are not on an edge are skipped if edges of other cells
    /// determine their distances from the boundary.
    bool PrefersEdges = false;
  };
  BoundarySearch Boundary = {};
};

}

#endif
