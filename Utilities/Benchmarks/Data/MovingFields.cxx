// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/MovingFields.h"

#include "Benchmarks/Measures/LevelDistance.h"

#include "vtkMath.h"

#include <array>
#include <cmath>

namespace interval4d
{
namespace
{
MovingField MakeField(
  const std::string& name, int field, const std::array<int, 3>& points, double lower, double upper)
{
  MovingField made;
  made.Name = name;
  made.Source = vtkSmartPointer<vtkAnalyticFieldSource>::New();
  made.Source->SetField(field);
  made.Source->SetOutputScalarType(VTK_DOUBLE);
  made.Source->SetDimensions(points[0], points[1], points[2]);
  made.Source->SetTimeRange(MovingField::FirstTime, MovingField::LastTime);
  made.Lower = lower;
  made.Upper = upper;
  return made;
}

MovingField MakeWave(const BenchOptions& options)
{
  // Fewer points suffice along y, where the wavelength is long, and z, where the field is linear.
  const std::array<int, 3> points =
    options.Pick<std::array<int, 3>>({ { 161, 31, 16 } }, { { 121, 21, 11 } }, { { 41, 11, 6 } });
  MovingField wave = MakeField("wave", vtkAnalyticFieldSource::WAVE, points, -0.15, 0.15);
  wave.Source->SetBounds(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0);
  wave.Volume = [](double) { return 4.0 * 2.0 * 0.3; };
  return wave;
}

MovingField MakeShell(const BenchOptions& options)
{
  const int points = options.Pick(65, 49, 13);
  MovingField ball = MakeField(
    "ball", vtkAnalyticFieldSource::SPHERE_DISTANCE, { { points, points, points } }, -0.1, 0.1);
  ball.Source->SetCenter(-0.5, 0.0, 0.0);
  ball.Source->SetVelocity(0.5, 0.0, 0.0);
  ball.Source->SetRadius(0.3);
  ball.Source->SetGrowth(0.025);
  ball.Volume = [](double time)
  {
    const double radius = 0.3 + 0.025 * time;
    return 4.0 / 3.0 * vtkMath::Pi() * (std::pow(radius + 0.1, 3) - std::pow(radius - 0.1, 3));
  };
  return ball;
}

MovingField MakeLinear(const BenchOptions& options)
{
  const int points = options.Pick(21, 11, 5);
  MovingField linear =
    MakeField("linear", vtkAnalyticFieldSource::LINEAR, { { points, points, points } }, -0.1, 0.1);
  // The planes that bound the region do not intersect the faces z = -1 and z = 1 of the box.
  linear.Source->SetGradient(0.5, 0.3, 1.0);
  linear.Source->SetConstant(-0.05);
  linear.Source->SetRate(0.05);
  linear.Volume = [](double) { return 2.0 * 2.0 * 0.2; };
  return linear;
}
}

double MovingField::GetDistance(const double point[3], double bound, double time) const
{
  const auto evaluate = [this, time](const double at[3], double gradient[3])
  {
    constexpr double step = 1e-5;
    for (int axis = 0; axis < 3; ++axis)
    {
      double below[3] = { at[0], at[1], at[2] };
      double above[3] = { at[0], at[1], at[2] };
      below[axis] -= step;
      above[axis] += step;
      gradient[axis] =
        (this->Source->Evaluate(above, time) - this->Source->Evaluate(below, time)) / (2.0 * step);
    }
    return this->Source->Evaluate(at, time);
  };
  return DistanceToLevel(evaluate, point, bound, 1.0);
}

std::vector<MovingField> MakeMovingFields(const BenchOptions& options)
{
  return { MakeWave(options), MakeShell(options), MakeLinear(options) };
}
}
