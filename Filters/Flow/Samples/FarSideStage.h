// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FarSideStage_h
#define interlume_FarSideStage_h

#include "Streams/StageContext.h"

class vtkDataSet;

namespace interlume
{

/**
 * The stage that finds what samples near surfaces would have on the far side, after their sides
 * were found.
 */
namespace FarSideStage
{
/// Writes the field arrays that BeyondSamples reads. If \a findsBoundary, does the same near the
/// boundary of what reaches a surface. Returns false if the execution was aborted.
bool Run(StageContext& context, vtkDataSet* samples, bool findsBoundary);
}

}

#endif
