// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BeyondTrace_h
#define interlume_BeyondTrace_h

#include "Advection/AdvectionOptions.h"
#include "Samples/BeyondCorners.h"
#include "Streams/StageContext.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   BeyondTrace
 * @brief   follows what samples beside a surface would have on the surface's other side
 *
 * Streamlines that leave towards the surface are followed on through it, those that leave away from
 * it are followed back to it.
 */
class BeyondTrace
{
public:
  /// The result for one sample.
  struct Answer
  {
    /// Whether the sample stands still on the surface, so that no streamline tells of its other
    /// side.
    bool IsStill = false;
    /// The side as in TerminationSide, and 0 on the surface.
    signed char Side = 0;
    double Normal[3] = { 0.0, 0.0, 0.0 };
    /// The result beyond the surface. Status is not REACHED_SURFACE and Id is -1 where nothing
    /// would be reached.
    AdvectionResult Beyond;
  };

  /// The arguments must not change while this is used. The progress stays the same.
  BeyondTrace(const StageContext& context, vtkDataSet* samples)
    : Context(context)
    , Options(context.Options)
    , Samples(samples)
  {
  }

  /// Finds the answers of corners. Where processes have parts of the field, all of them call this.
  /// Returns false when the execution was aborted.
  bool Find(const std::vector<BeyondCorners::Corner>& corners, std::vector<Answer>& answers);

private:
  using Corners = std::vector<BeyondCorners::Corner>;
  using Rows = std::vector<std::size_t>;

  /// Turns a velocity to the streamlines' direction. Returns whether they move there.
  bool TurnToWay(Streamlines::Velocity& velocity) const;
  /// Describes a corner, given the velocity there, and adds it to those that are followed.
  void Describe(const Corners& corners, std::size_t row, Streamlines::Velocity velocity,
    Answer& answer, Rows& back, Rows& on) const;
  bool IsHit(const AdvectionResult& result, const BeyondCorners::Corner& corner) const;
  /// Follows corners' streamlines to the surface beside them, backward or forward in time.
  bool FollowTo(
    const Corners& corners, const Rows& rows, bool isBack, std::vector<AdvectionResult>& results);
  /// Follows streamlines on behind the surface, which \a before has brought them to.
  bool FollowOn(const Corners& corners, const Rows& rows,
    const std::vector<AdvectionResult>& before, std::vector<Answer>& answers);

  const StageContext& Context;
  const AdvectionOptions& Options;
  vtkDataSet* Samples;
};

}

#endif
