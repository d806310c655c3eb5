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
  /// Number of bisection steps that locate the boundary of the reached region between two samples.
  int Bisections = 6;
};

}

#endif
