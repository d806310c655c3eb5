// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/TrilinearFlow.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>

/// Where it is, and the velocities of its corners in cells per unit of time, x fastest.
struct TrilinearFlow::Cell
{
  std::array<int, 3> At{};
  std::array<Vector, 8> Corners{};

  /// The polynomial of the cell, outside of it too.
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
/// How a step from \a p to \a q leaves the unit cell at \a at first: axis -1 where it does not.
struct Exit
{
  int Axis = -1;
  int Side = 0;
  double Part = 1.0;
};

Exit FindExit(
  const std::array<double, 3>& p, const std::array<double, 3>& q, const std::array<int, 3>& at)
{
  Exit exit;
  for (int i = 0; i < 3; ++i)
  {
    const auto axis = static_cast<std::size_t>(i);
    const int side = q[axis] < at[axis] ? 0 : 1;
    const double beyond = side == 0 ? at[axis] - q[axis] : q[axis] - at[axis] - 1.0;
    if (beyond > 0.0)
    {
      const double part = std::max(0.0, 1.0 - beyond / std::abs(q[axis] - p[axis]));
      if (exit.Axis < 0 || part < exit.Part)
      {
        exit = { i, side, part };
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

TrilinearFlow::Vector TrilinearFlow::ToLattice(const double x[3]) const
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
  const Vector p = this->ToLattice(x);
  Cell cell;
  const Vector rate = this->Locate(p, cell) ? cell.GetRate(p) : Vector{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    v[i] = rate[i] * this->Image->GetSpacing()[i];
  }
}

void TrilinearFlow::Follow(double x[3], double time) const
{
  constexpr double longest = 0.05;
  constexpr int mostSteps = 1000000;
  constexpr int mostIterations = 6;
  Vector p = this->ToLattice(x);
  const double sign = time < 0.0 ? -1.0 : 1.0;
  double left = std::abs(time);
  Cell cell;
  bool goesOn = this->Locate(p, cell);
  for (int step = 0; goesOn && left > 0.0 && step < mostSteps; ++step)
  {
    Vector rate = cell.GetRate(p);
    const double speed =
      std::max(std::max(std::abs(rate[0]), std::abs(rate[1])), std::abs(rate[2]));
    double part = speed * left > longest ? longest / speed : left;
    Vector next = cell.Step(p, sign * part);
    const Exit exit = FindExit(p, next, cell.At);
    if (exit.Axis >= 0)
    {
      const auto axis = static_cast<std::size_t>(exit.Axis);
      const double face = cell.At[axis] + exit.Side;
      part *= exit.Part;
      for (int iteration = 0; iteration < mostIterations; ++iteration)
      {
        next = cell.Step(p, sign * part);
        rate = cell.GetRate(next);
        if (rate[axis] == 0.0)
        {
          break;
        }
        part = std::max(0.0, part - (next[axis] - face) / (sign * rate[axis]));
      }
      next[axis] = face;
      cell.At[axis] += exit.Side == 0 ? -1 : 1;
      goesOn = this->Load(cell);
    }
    p = next;
    left -= part;
  }
  this->ToWorld(p, x);
}
