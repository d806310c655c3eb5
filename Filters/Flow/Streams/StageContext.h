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
 * @brief   shares data between the stages of an execution of vtkImplicitFlowField
 *
 * SampleIntegration orders and integrates samples, FarSideStage finds what samples would have on
 * the far side of their surface, CellRefinement adds samples, for which both run again, and
 * SamplingCheck checks the interpolation between samples. Each stage writes its arrays into the
 * samples and can be aborted.
 */
struct StageContext
{
  Streamlines& Field;
  const AdvectionOptions& Options;
  FlowReport& Report;
  /// The diagonal of the bounds of the field.
  double FieldLength;
  /// The progress of the execution after the last stage.
  double Progress;
};

}

#endif
