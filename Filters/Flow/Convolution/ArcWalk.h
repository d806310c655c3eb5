// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArcWalk_h
#define interlume_ArcWalk_h

#include "Common/Vectors.h"

#include "vtkMath.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

/**
 * @class   ArcWalk
 * @brief   traces a streamline by arc length, with fixed steps of the classical Runge-Kutta method
 *
 * Solves dx/ds = +-v / |v| in world space. Tracing stops if a step would leave the field, if the
 * velocity is not finite, if the speed is at most MinimumSpeed, or if the direction changes by more
 * than 90 degrees in a step, for example at a sink.
 */
template <typename Walker>
class ArcWalk
{
public:
  ArcWalk(const Walker& walker, double minimumSpeed)
    : Field(walker)
    , MinimumSpeed(minimumSpeed)
  {
  }

  /// Returns whether \a x is inside the field.
  bool IsInside(const double x[3])
  {
    double p[3];
    return this->Field.Locate(x, p);
  }

  /// Starts a streamline at \a x.
  void Begin(const double x[3])
  {
    std::copy_n(x, 3, this->Position);
    this->HasDirection = this->GetDirection(x, this->Direction);
  }
  /// Returns whether the start is inside the field and its velocity is finite and large enough.
  bool CanAdvance() const { return this->HasDirection; }

  /// Advances by the arc length \a step, upstream if \a step is negative. At the end of the
  /// streamline, returns false without moving.
  bool Advance(double step)
  {
    if (!this->HasDirection)
    {
      return false;
    }
    double sum[3];
    double rate[3];
    std::copy_n(this->Direction, 3, rate);
    std::copy_n(this->Direction, 3, sum);
    constexpr double nodes[3] = { 0.5, 0.5, 1.0 };
    constexpr double weights[3] = { 2.0, 2.0, 1.0 };
    for (int stage = 0; stage < 3; ++stage)
    {
      double x[3];
      for (int i = 0; i < 3; ++i)
      {
        x[i] = this->Position[i] + nodes[stage] * step * rate[i];
      }
      if (!this->CanContinue(x, rate))
      {
        return false;
      }
      for (int i = 0; i < 3; ++i)
      {
        sum[i] += weights[stage] * rate[i];
      }
    }
    double end[3];
    for (int i = 0; i < 3; ++i)
    {
      end[i] = this->Position[i] + step * sum[i] / 6.0;
    }
    if (!this->CanContinue(end, rate))
    {
      return false;
    }
    std::copy_n(end, 3, this->Position);
    std::copy_n(rate, 3, this->Direction);
    return true;
  }

  const double* GetPosition() const { return this->Position; }

private:
  bool CanContinue(const double x[3], double direction[3])
  {
    return this->GetDirection(x, direction) && vtkMath::Dot(direction, this->Direction) >= 0.0;
  }

  bool GetDirection(const double x[3], double direction[3])
  {
    double p[3];
    if (!this->Field.Locate(x, p) || !this->Field.IsFinite())
    {
      return false;
    }
    double rate[3];
    this->Field.GetVelocity(p, rate);
    this->Field.GetWorldVector(p, rate, direction);
    // Squares of very large or small speeds would overflow or underflow.
    const double speed = Vectors::SafeLength(glm::make_vec3(direction));
    if (!(speed > this->MinimumSpeed && std::isfinite(speed)))
    {
      return false;
    }
    for (int i = 0; i < 3; ++i)
    {
      direction[i] /= speed;
    }
    return true;
  }

  Walker Field;
  double MinimumSpeed;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, 0.0 };
  bool HasDirection = false;
};

}

#endif
