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
    , Start(walker)
    , MinimumSpeed(minimumSpeed)
  {
  }

  /// Starts a streamline at \a x. The component of the velocity along \a normal, which is a unit
  /// vector or 0, is ignored. Returns false if \a x is outside the field.
  bool Begin(const double x[3], const glm::dvec3& normal)
  {
    this->Normal = normal;
    const bool isInside = this->Start.Locate(x, this->StartPoint);
    std::copy_n(x, 3, this->StartPosition);
    this->HasDirection =
      isInside && this->Evaluate(this->Start, this->StartPoint, this->StartDirection);
    this->Return();
    return isInside;
  }
  /// Returns to the start of the streamline.
  void Return()
  {
    this->Field = this->Start;
    std::copy_n(this->StartPoint, 3, this->Point);
    std::copy_n(this->StartPosition, 3, this->Position);
    std::copy_n(this->StartDirection, 3, this->Direction);
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
    return this->Field.LocateNearby(x, this->Point) &&
      this->Evaluate(this->Field, this->Point, direction) &&
      vtkMath::Dot(direction, this->Direction) >= 0.0;
  }

  /// Computes the direction of the velocity at \a p. Returns false if the velocity is too small or
  /// not finite.
  bool Evaluate(const Walker& field, const double p[3], double direction[3]) const
  {
    if (!field.IsFinite())
    {
      return false;
    }
    double rate[3];
    field.GetVelocity(p, rate);
    field.GetWorldVector(p, rate, direction);
    const double across = vtkMath::Dot(direction, glm::value_ptr(this->Normal));
    for (int i = 0; i < 3; ++i)
    {
      direction[i] -= across * this->Normal[i];
    }
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
  Walker Start;
  double MinimumSpeed;
  glm::dvec3 Normal{ 0.0 };
  /// Coordinates in the cells of Start and Field.
  double StartPoint[3] = { 0.0, 0.0, 0.0 };
  double Point[3] = { 0.0, 0.0, 0.0 };
  double StartPosition[3] = { 0.0, 0.0, 0.0 };
  double StartDirection[3] = { 0.0, 0.0, 0.0 };
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, 0.0 };
  bool HasDirection = false;
};

}

#endif
