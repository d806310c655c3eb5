// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AbortCheck_h
#define interlume_AbortCheck_h

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace interlume
{

/**
 * Ends the execution of an aborted algorithm.
 */
namespace AbortCheck
{
/// Marks the outputs as not generated, so that the next update executes the algorithm again.
/// Returns 1, which RequestData should return.
inline int Leave(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  }
  return 1;
}
}

}

#endif
