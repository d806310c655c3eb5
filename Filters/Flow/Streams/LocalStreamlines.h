// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LocalStreamlines_h
#define interlume_LocalStreamlines_h

#include "Advection/AdvectionLanes.h"
#include "Streams/LatticeSteps.h"
#include "Streams/SampleStreams.h"
#include "Streams/Streamlines.h"

#include "vtkSMPTools.h"

namespace interlume
{

/**
 * @class   LocalStreamlines
 * @brief   streamlines of a field that the process has all of, by threads
 */
template <typename Walker>
class LocalStreamlines : public Streamlines
{
public:
  LocalStreamlines(const Walker& walker, vtkAlgorithm* owner)
    : Field(walker)
    , Owner(owner)
  {
  }

  bool Follow(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end) override
  {
    return SampleStreams::Run(number, this->Owner, begin, end,
      [&](auto&& next)
      {
        this->FollowEach(
          options,
          [&](double x[3])
          {
            const vtkIdType i = next();
            if (i >= 0)
            {
              start(i, x);
            }
            return i;
          },
          [&](vtkIdType i, const double*, const AdvectionResult& result) { take(i, result); });
      });
  }

  std::vector<Velocity> GetVelocities(vtkIdType number, const GetPosition& position) override
  {
    std::vector<Velocity> velocities(static_cast<std::size_t>(number));
    vtkSMPTools::For(0, number,
      [&](vtkIdType first, vtkIdType last)
      {
        Walker walker(this->Field);
        for (vtkIdType i = first; i < last; ++i)
        {
          double x[3];
          position(i, x);
          velocities[static_cast<std::size_t>(i)] = GetVelocity(walker, x);
        }
      });
    return velocities;
  }

  const FlowField& GetField() const override { return this->Field.GetField(); }

  static Velocity GetVelocity(Walker& walker, const double x[3])
  {
    double p[3];
    return walker.Locate(x, p) ? GetVelocityAt(walker, p) : Velocity();
  }
  /// Returns the velocity at a place in the cell that the walker stands in.
  static Velocity GetVelocityAt(const Walker& walker, const double p[3])
  {
    Velocity velocity;
    velocity.IsInField = true;
    double rate[3];
    walker.GetVelocity(p, rate);
    walker.GetWorldVector(p, rate, velocity.V);
    return velocity;
  }

private:
  /// Follows streamlines as AdvectionLanes does, where the walker has lanes.
  template <typename Begin, typename End>
  void FollowEach(const AdvectionOptions& options, Begin&& begin, End&& end) const
  {
    if constexpr (Walker::HasLanes)
    {
      using Group = AdvectionLanes<Walker, LatticeSteps::Four>;
      Group advection(this->Field, options, LatticeSteps::Take);
      advection.Follow(begin, end);
    }
    else
    {
      Advection<Walker> advection(this->Field, options);
      AdvectionResult result;
      double x[3];
      for (vtkIdType id = begin(x); id >= 0; id = begin(x))
      {
        advection.Follow(x, result);
        end(id, x, result);
      }
    }
  }

  Walker Field;
  vtkAlgorithm* Owner;
};

}

#endif
