// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RenderProgress_h
#define interlume_RenderProgress_h

#include "InterlumeSceneModule.h"

class vtkAlgorithm;
class vtkRenderWindow;

namespace interlume
{

/**
 * @class   RenderProgress
 * @brief   reports the progress of an image and checks if the window aborts it
 *
 * Mappers call IsAborted() between parts of an image: slabs, tiles or rows. An image that takes
 * less than EVENT_SECONDS has no progress events.
 */
class INTERLUMESCENE_EXPORT RenderProgress
{
public:
  static constexpr double EVENT_SECONDS = 0.1;

  /// Begins an image of \a mapper in \a window.
  RenderProgress(vtkRenderWindow* window, vtkAlgorithm* mapper);

  /**
   * Returns true if the image must not be completed. At most every EVENT_SECONDS, the mapper first
   * invokes vtkCommand::VolumeMapperRenderProgressEvent with \a fraction, a double from 0 to 1.
   * vtkRenderWindow limits its AbortCheckEvent to five per second.
   */
  bool IsAborted(double fraction);

  /// Returns the last result of IsAborted().
  bool WasAborted() const { return this->Aborted; }

private:
  vtkRenderWindow* Window;
  vtkAlgorithm* Mapper;
  double EventTime;
  bool Aborted = false;
};

}

#endif
