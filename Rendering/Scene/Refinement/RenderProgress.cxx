// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement/RenderProgress.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkTimerLog.h"

namespace interlume
{

RenderProgress::RenderProgress(vtkRenderWindow* window, vtkAlgorithm* mapper)
  : Window(window)
  , Mapper(mapper)
  , EventTime(vtkTimerLog::GetUniversalTime())
{
}

bool RenderProgress::IsAborted(double fraction)
{
  const double now = vtkTimerLog::GetUniversalTime();
  if (now - this->EventTime > EVENT_SECONDS)
  {
    this->EventTime = now;
    this->Mapper->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &fraction);
  }
  this->Aborted = this->Window->CheckAbortStatus() != 0;
  return this->Aborted;
}

}
