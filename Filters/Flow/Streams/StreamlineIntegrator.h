// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StreamlineIntegrator_h
#define interlume_StreamlineIntegrator_h

#include "Advection/SimdAdvection.h"
#include "Streams/SimdStepDispatch.h"

namespace interlume
{

/**
 * @class   StreamlineIntegrator
 * @brief   traces streamlines in one thread, four at once if the walker supports SIMD
 *
 * Results do not depend on how many streamlines are traced at once.
 */
template <typename Walker>
class StreamlineIntegrator
{
public:
  /**
   * Traces streamlines. The function begin(advection, isActive) calls Start or Resume, sets \a
   * isActive to the return value of this call, and returns the id of the streamline, or -1 if none
   * is left. The function end(id, advection) is called for each streamline, in any order, when it
   * ends or leaves the process.
   */
  template <typename Begin, typename End>
  static void Follow(
    const Walker& walker, const AdvectionOptions& options, Begin&& begin, End&& end)
  {
    if constexpr (Walker::HasSimdWalker)
    {
      using Group = SimdAdvection<Walker, SimdStepDispatch::Four>;
      Group advection(walker, options, SimdStepDispatch::Take);
      advection.Follow(begin, end);
    }
    else
    {
      Advection<Walker> advection(walker, options);
      bool isActive = false;
      for (vtkIdType id = begin(advection, isActive); id >= 0; id = begin(advection, isActive))
      {
        while (isActive)
        {
          isActive = advection.Advance();
        }
        end(id, advection);
      }
    }
  }
};

}

#endif
