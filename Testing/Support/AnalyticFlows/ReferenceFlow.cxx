// SPDX-License-Identifier: BSD-3-Clause
#include "Support/AnalyticFlows/ReferenceFlow.h"

#include "Support/Arrays/ReferenceIndices.h"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace reference
{

Flow Flow::Uniform(const Position& velocity)
{
  Flow flow;
  flow.Velocity = [velocity](const double*, double* v)
  { std::copy(velocity.begin(), velocity.end(), v); };
  flow.Gradient = [](const double*, double* gradient) { std::fill(gradient, gradient + 9, 0.0); };
  return flow;
}

Flow Flow::Linear(const std::array<double, 9>& matrix, const Position& center)
{
  Flow flow;
  flow.Velocity = [matrix, center](const double* x, double* v)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      v[i] = matrix[3 * i] * (x[0] - center[0]) + matrix[3 * i + 1] * (x[1] - center[1]) +
        matrix[3 * i + 2] * (x[2] - center[2]);
    }
  };
  flow.Gradient = [matrix](const double*, double* gradient)
  { std::copy(matrix.begin(), matrix.end(), gradient); };
  return flow;
}

Flow Flow::Rotation(double rate)
{
  return Flow::Linear({ 0, -rate, 0, rate, 0, 0, 0, 0, 0 });
}

Flow Flow::PotentialAroundSphere()
{
  Flow flow;
  // v = e + e / (2 r^3) - 3 x (x . e) / (2 r^5), where e is the unit vector along x and r = |x|
  flow.Velocity = [](const double* x, double* v)
  {
    const double r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    const double r3 = r2 * std::sqrt(r2);
    for (int i = 0; i < 3; ++i)
    {
      v[i] = (i == 0 ? 1.0 + 0.5 / r3 : 0.0) - 1.5 * x[i] * x[0] / (r3 * r2);
    }
  };
  flow.Gradient = [](const double* x, double* gradient)
  {
    const double r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    const double r5 = r2 * r2 * std::sqrt(r2);
    for (const auto& [i, j] : AllIndices(3, 3))
    {
      gradient[3 * i + j] = -1.5 / r5 *
        ((i == 0 ? x[j] : 0.0) + (i == j ? x[0] : 0.0) + (j == 0 ? x[i] : 0.0) -
          5.0 * x[i] * x[j] * x[0] / r2);
    }
  };
  return flow;
}

Flow Flow::Beltrami(double a, double b, double c)
{
  Flow flow;
  flow.Velocity = [a, b, c](const double* x, double* v)
  {
    v[0] = a * std::sin(x[2]) + c * std::cos(x[1]);
    v[1] = b * std::sin(x[0]) + a * std::cos(x[2]);
    v[2] = c * std::sin(x[1]) + b * std::cos(x[0]);
  };
  flow.Gradient = [a, b, c](const double* x, double* gradient)
  {
    const double rows[9] = { 0.0, -c * std::sin(x[1]), a * std::cos(x[2]), b * std::cos(x[0]), 0.0,
      -a * std::sin(x[2]), -b * std::sin(x[0]), c * std::cos(x[1]), 0.0 };
    std::copy(rows, rows + 9, gradient);
  };
  return flow;
}

Flow Flow::ShearLayer(double thickness, const Position& drift)
{
  Flow flow;
  flow.Velocity = [thickness, drift](const double* x, double* v)
  {
    v[0] = std::tanh(x[1] / thickness) + drift[0];
    v[1] = drift[1];
    v[2] = drift[2];
  };
  flow.Gradient = [thickness](const double* x, double* gradient)
  {
    std::fill(gradient, gradient + 9, 0.0);
    const double value = std::tanh(x[1] / thickness);
    gradient[1] = (1.0 - value * value) / thickness;
  };
  return flow;
}

Flow Flow::Times(double factor) const
{
  Flow flow = *this;
  flow.Velocity = [factor, velocity = this->Velocity](const double* x, double* v)
  {
    velocity(x, v);
    std::for_each(v, v + 3, [factor](double& component) { component *= factor; });
  };
  flow.Gradient = [factor, gradient = this->Gradient](const double* x, double* matrix)
  {
    gradient(x, matrix);
    std::for_each(matrix, matrix + 9, [factor](double& component) { component *= factor; });
  };
  return flow;
}

Position Flow::Follow(const Position& start, double time) const
{
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>;
  State x(start.begin(), start.end());
  const double sign = time < 0.0 ? -1.0 : 1.0;
  const auto rate = [&](const State& at, State& v, double)
  {
    this->Velocity(at.data(), v.data());
    std::for_each(v.begin(), v.end(), [sign](double& component) { component *= sign; });
  };
  if (time != 0.0)
  {
    odeint::integrate_adaptive(
      odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<State>()), rate, x, 0.0,
      std::abs(time), 1e-3 * std::abs(time));
  }
  return { x[0], x[1], x[2] };
}

}
