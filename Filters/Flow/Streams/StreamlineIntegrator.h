// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StreamlineIntegrator_h
#define interlume_StreamlineIntegrator_h

#include "Advection/AdvectionLanes.h"
#include "Streams/LatticeSteps.h"

namespace interlume
{

/**
 * @class   StreamlineIntegrator
 * @brief   follows streamlines in one thread: four at once where the walker has lanes, or each
 * alone
 *
 * Results are the same either way.
 */
template <typename Walker>
class StreamlineIntegrator
{
public:
  /**
   * Follows streamlines that begin(advection, goesOn) begins by Start or Resume. It sets \a goesOn
   * to what these return, and returns the id of the streamline, or -1 after the last. Calls end(id,
   * advection) for each, in any order, where the advection does not go on.
   */
  template <typename Begin, typename End>
  static void Follow(
    const Walker& walker, const AdvectionOptions& options, Begin&& begin, End&& end)
  {
    if constexpr (Walker::HasLanes)
    {
      using Group = AdvectionLanes<Walker, LatticeSteps::Four>;
      Group advection(walker, options, LatticeSteps::Take);
      advection.Follow(begin, end);
    }
    else
    {
      Advection<Walker> advection(walker, options);
      bool goesOn = false;
      for (vtkIdType id = begin(advection, goesOn); id >= 0; id = begin(advection, goesOn))
      {
        while (goesOn)
        {
          goesOn = advection.GoStep();
        }
        end(id, advection);
      }
    }
  }
};

}

#endif
