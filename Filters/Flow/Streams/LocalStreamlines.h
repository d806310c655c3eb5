// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LocalStreamlines_h
#define interlume_LocalStreamlines_h

#include "Streams/SampleQueue.h"
#include "Streams/StreamlineIntegrator.h"
#include "Streams/Streamlines.h"

#include "vtkSMPTools.h"

namespace interlume
{

/**
 * @class   LocalStreamlines
 * @brief   traces streamlines in parallel in a field that this process holds entirely
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
    return SampleQueue::Run(number, this->Owner, begin, end,
      [&](auto&& next)
      {
        AdvectionResult result;
        StreamlineIntegrator<Walker>::Follow(
          this->Field, options,
          [&](Advection<Walker>& advection, bool& isActive)
          {
            const vtkIdType i = next();
            double x[3];
            if (i >= 0)
            {
              start(i, x);
              isActive = advection.Start(x);
            }
            return i;
          },
          [&](vtkIdType i, Advection<Walker>& advection)
          {
            advection.Finish(result);
            take(i, result);
          });
      });
  }

  std::vector<Velocity> GetVelocities(
    vtkIdType number, const GetPosition& position, bool withVorticity) override
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
          velocities[static_cast<std::size_t>(i)] = GetVelocity(walker, x, withVorticity);
        }
      });
    return velocities;
  }

  const FlowField& GetField() const override { return this->Field.GetField(); }

  static Velocity GetVelocity(Walker& walker, const double x[3], bool withVorticity)
  {
    double p[3];
    return walker.Locate(x, p) ? GetVelocityAt(walker, p, withVorticity) : Velocity();
  }
  /// Returns the velocity at parametric coordinates in the current cell of the walker.
  static Velocity GetVelocityAt(const Walker& walker, const double p[3], bool withVorticity)
  {
    Velocity velocity;
    velocity.IsInField = true;
    double rate[3];
    walker.GetVelocity(p, rate);
    walker.GetWorldVector(p, rate, velocity.V);
    velocity.Vorticity = withVorticity ? PathIntegrals<Walker>::GetVorticity(walker, p) : 0.0;
    return velocity;
  }

private:
  Walker Field;
  vtkAlgorithm* Owner;
};

}

#endif
