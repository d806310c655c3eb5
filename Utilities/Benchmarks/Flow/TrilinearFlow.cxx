// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/TrilinearFlow.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>

/// The indices of a cell, and the velocities at its corners in cells per unit of time, x fastest.
struct TrilinearFlow::Cell
{
  std::array<int, 3> At{};
  std::array<Vector, 8> Corners{};

  /// Evaluates the trilinear polynomial of the cell. \a p may be outside the cell.
  Vector GetRate(const Vector& p) const
  {
    const double x = p[0] - this->At[0];
    const double y = p[1] - this->At[1];
    const double z = p[2] - this->At[2];
    const double weights[4] = { (1.0 - y) * (1.0 - z), y * (1.0 - z), (1.0 - y) * z, y * z };
    Vector rate{};
    for (std::size_t edge = 0; edge < 4; ++edge)
    {
      const Vector& low = this->Corners[2 * edge];
      const Vector& high = this->Corners[2 * edge + 1];
      for (std::size_t i = 0; i < 3; ++i)
      {
        rate[i] += weights[edge] * (low[i] + x * (high[i] - low[i]));
      }
    }
    return rate;
  }

  Vector Step(Vector p, double time) const
  {
    boost::numeric::odeint::runge_kutta_fehlberg78<Vector> stepper;
    stepper.do_step(
      [this](const Vector& at, Vector& rate, double) { rate = this->GetRate(at); }, p, 0.0, time);
    return p;
  }
};

namespace
{
/// The face through which a step first leaves its cell, and the fraction of the step before that.
/// Axis is -1 if the step ends inside the cell.
struct Exit
{
  int Axis = -1;
  int Side = 0;
  double Fraction = 1.0;
};

Exit FindExit(
  const std::array<double, 3>& p, const std::array<double, 3>& q, const std::array<int, 3>& at)
{
  Exit exit;
  for (int i = 0; i < 3; ++i)
  {
    const auto axis = static_cast<std::size_t>(i);
    const int side = q[axis] < at[axis] ? 0 : 1;
    const double outside = side == 0 ? at[axis] - q[axis] : q[axis] - at[axis] - 1.0;
    if (outside > 0.0)
    {
      const double fraction = std::max(0.0, 1.0 - outside / std::abs(q[axis] - p[axis]));
      if (exit.Axis < 0 || fraction < exit.Fraction)
      {
        exit = { i, side, fraction };
      }
    }
  }
  return exit;
}
}

TrilinearFlow::TrilinearFlow(vtkImageData* image)
  : Image(image)
{
}

TrilinearFlow::Vector TrilinearFlow::ToIndices(const double x[3]) const
{
  const double* origin = this->Image->GetOrigin();
  const double* spacing = this->Image->GetSpacing();
  Vector p;
  for (std::size_t i = 0; i < 3; ++i)
  {
    p[i] = (x[i] - origin[i]) / spacing[i];
  }
  return p;
}

void TrilinearFlow::ToWorld(const Vector& p, double x[3]) const
{
  const double* origin = this->Image->GetOrigin();
  const double* spacing = this->Image->GetSpacing();
  for (std::size_t i = 0; i < 3; ++i)
  {
    x[i] = origin[i] + p[i] * spacing[i];
  }
}

bool TrilinearFlow::Load(Cell& cell) const
{
  const int* points = this->Image->GetDimensions();
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (cell.At[i] < 0 || cell.At[i] > points[i] - 2)
    {
      return false;
    }
  }
  vtkDataArray* vectors = this->Image->GetPointData()->GetVectors();
  const double* spacing = this->Image->GetSpacing();
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkIdType point = cell.At[0] + (corner & 1) +
      points[0] *
        (cell.At[1] + (corner >> 1 & 1) +
          static_cast<vtkIdType>(points[1]) * (cell.At[2] + (corner >> 2)));
    Vector& rate = cell.Corners[static_cast<std::size_t>(corner)];
    vectors->GetTuple(point, rate.data());
    for (std::size_t i = 0; i < 3; ++i)
    {
      rate[i] /= spacing[i];
    }
  }
  return true;
}

bool TrilinearFlow::Locate(const Vector& p, Cell& cell) const
{
  const int* points = this->Image->GetDimensions();
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (!(p[i] >= 0.0 && p[i] <= points[i] - 1.0))
    {
      return false;
    }
    cell.At[i] = std::min(static_cast<int>(p[i]), points[i] - 2);
  }
  return this->Load(cell);
}

void TrilinearFlow::GetVelocity(const double x[3], double v[3]) const
{
  const Vector p = this->ToIndices(x);
  Cell cell;
  const Vector rate = this->Locate(p, cell) ? cell.GetRate(p) : Vector{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    v[i] = rate[i] * this->Image->GetSpacing()[i];
  }
}

void TrilinearFlow::Follow(double x[3], double time) const
{
  constexpr double longestStep = 0.05;
  constexpr int maximumSteps = 1000000;
  constexpr int maximumIterations = 6;
  Vector p = this->ToIndices(x);
  const double sign = time < 0.0 ? -1.0 : 1.0;
  double remaining = std::abs(time);
  Cell cell;
  bool isInside = this->Locate(p, cell);
  for (int step = 0; isInside && remaining > 0.0 && step < maximumSteps; ++step)
  {
    Vector rate = cell.GetRate(p);
    const double speed =
      std::max(std::max(std::abs(rate[0]), std::abs(rate[1])), std::abs(rate[2]));
    double duration = speed * remaining > longestStep ? longestStep / speed : remaining;
    Vector next = cell.Step(p, sign * duration);
    const Exit exit = FindExit(p, next, cell.At);
    if (exit.Axis >= 0)
    {
      const auto axis = static_cast<std::size_t>(exit.Axis);
      const double face = cell.At[axis] + exit.Side;
      duration *= exit.Fraction;
      for (int iteration = 0; iteration < maximumIterations; ++iteration)
      {
        next = cell.Step(p, sign * duration);
        rate = cell.GetRate(next);
        if (rate[axis] == 0.0)
        {
          break;
        }
        duration = std::max(0.0, duration - (next[axis] - face) / (sign * rate[axis]));
      }
      next[axis] = face;
      cell.At[axis] += exit.Side == 0 ? -1 : 1;
      isInside = this->Load(cell);
    }
    p = next;
    remaining -= duration;
  }
  this->ToWorld(p, x);
}
