#ifndef interlume_AbortCheck_h
#define interlume_AbortCheck_h

#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace interlume
{

/**
 * What an algorithm leaves when it was aborted.
 */
namespace AbortCheck
{
/// Its outputs are not up to date, so that the next update executes again. Returns what RequestData
/// is to.
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
