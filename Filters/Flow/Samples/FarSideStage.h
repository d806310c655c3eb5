// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FarSideStage_h
#define interlume_FarSideStage_h

#include "Streams/StageContext.h"

class vtkDataSet;

namespace interlume
{

/**
 * Stage of an execution that computes the far-side values of samples near surfaces, after
 * SampleIntegration has determined the side of each sample.
 */
namespace FarSideStage
{
/// Writes the field arrays that FarSideSamples reads. If \a findsBoundary is true, includes samples
/// near the boundary of the reached region. Returns false if the execution was aborted.
bool Run(StageContext& context, vtkDataSet* samples, bool findsBoundary);
}

}

#endif
