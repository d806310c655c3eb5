// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FarSideTracer_h
#define interlume_FarSideTracer_h

#include "Advection/AdvectionOptions.h"
#include "Samples/FarSideCorners.h"
#include "Streams/StageContext.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   FarSideTracer
 * @brief   traces samples near a surface as if they were on its far side
 *
 * Streamlines that start toward the surface continue through it. Streamlines that start away from
 * it are traced back to it.
 */
class FarSideTracer
{
public:
  struct SampleResult
  {
    /// True if the sample stagnates on the surface, so that no streamline determines its far side.
    bool IsStagnant = false;
    /// Side as in TerminationSide, but 0 on the surface.
    signed char Side = 0;
    double Normal[3] = { 0.0, 0.0, 0.0 };
    /// Far-side result. If nothing is reached, Status is not REACHED_SURFACE and Id is -1.
    AdvectionResult FarSide;
  };

  /// The arguments must outlive this object and not change. No progress is reported.
  FarSideTracer(const StageContext& context, vtkDataSet* samples)
    : Context(context)
    , Options(context.Options)
    , Samples(samples)
  {
  }

  /// Computes the results of all corners. Collective if the field is distributed. Returns false if
  /// the execution was aborted.
  bool Find(
    const std::vector<FarSideCorners::Corner>& corners, std::vector<SampleResult>& sampleResults);

private:
  using Corners = std::vector<FarSideCorners::Corner>;
  using Rows = std::vector<std::size_t>;

  /// Negates a velocity if streamlines run backward. Returns true if its position is in the field
  /// and it is finite and faster than MinimumSpeed.
  bool OrientVelocity(Streamlines::Velocity& velocity) const;
  /// Computes the side and the normal of a corner from its velocity, and adds its row to \a back if
  /// its streamline must be traced back to the surface, or to \a on if it must be continued through
  /// the surface.
  void Describe(const Corners& corners, std::size_t row, Streamlines::Velocity velocity,
    SampleResult& sampleResult, Rows& back, Rows& on) const;
  bool ReachesSurfaceNearby(
    const AdvectionResult& result, const FarSideCorners::Corner& corner) const;
  /// Follows streamlines from corners to their surface, against the direction of integration if
  /// \a isBack is true.
  bool FollowTo(
    const Corners& corners, const Rows& rows, bool isBack, std::vector<AdvectionResult>& results);
  /// Continues streamlines on the far side of the surface. \a before contains their results at the
  /// surface.
  bool TraceBeyondSurface(const Corners& corners, const Rows& rows,
    const std::vector<AdvectionResult>& before, std::vector<SampleResult>& sampleResults);

  const StageContext& Context;
  const AdvectionOptions& Options;
  vtkDataSet* Samples;
};

}

#endif
