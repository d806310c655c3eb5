// SPDX-License-Identifier: BSD-3-Clause
#include "Vortices/VortexTubes.h"

#include "Common/Vectors.h"
#include "Vortices/BentAxis.h"

#include "vtkMath.h"

#include <cmath>

namespace interlume
{

namespace
{
struct Tube
{
  glm::dvec3 Center; ///< at time 0
  glm::dvec3 Velocity;
  glm::dvec3 Along; ///< direction, not normalized
  double HalfLength;
  double Radius;
  double Bend;       ///< amplitude of the bent axis
  double WaveNumber; ///< of the axis, radians per unit of length
  double Phase;      ///< of the axis at time 0, radians
  double PhaseSpeed; ///< radians per unit of time
  double PeakTime;   ///< time of maximum strength
  double LifeTime;   ///< time from PeakTime until the strength falls to 1/e
};

const std::array<Tube, VortexTubes::NumberOfTubes> Table = { {
  { { -0.55, -0.50, 0.45 }, { 0.068, 0.022, -0.015 }, { 1.0, 0.5, 0.2 }, 0.42, 0.052, 0.1, 5.0, 0.3,
    0.35, 1.0, 9.0 },
  { { 0.50, -0.55, -0.40 }, { -0.038, 0.06, 0.022 }, { 0.3, 1.0, 0.5 }, 0.4, 0.054, 0.09, 5.5, 1.9,
    -0.3, 1.0, 9.0 },
  { { -0.45, 0.50, -0.45 }, { 0.053, -0.045, 0.022 }, { 0.4, -0.3, 1.0 }, 0.42, 0.050, 0.12, 4.5,
    4.0, 0.3, 1.0, 9.0 },
  { { 0.45, 0.45, 0.40 }, { -0.022, -0.03, 0.068 }, { 1.0, -0.8, 0.1 }, 0.38, 0.057, 0.08, 6.0, 5.2,
    0.25, 1.0, 9.0 },
  { { 0.05, 0.00, 0.00 }, { 0.038, 0.068, 0.015 }, { 0.2, 0.4, 1.0 }, 0.45, 0.054, 0.12, 4.5, 2.6,
    0.4, 1.0, 9.0 },
  { { -0.10, 0.15, -0.68 }, { 0.04, 0.05, 0.04 }, { 1.0, 0.5, 0.1 }, 0.36, 0.049, 0.09, 5.5, 2.2,
    0.3, 1.0, 9.0 },
  { { 0.62, 0.10, -0.05 }, { 0.015, 0.038, -0.06 }, { 0.1, 1.0, -0.6 }, 0.3, 0.052, 0.07, 6.5, 0.9,
    0.3, -0.1, 1.0 },
  { { -0.15, -0.65, -0.55 }, { 0.053, 0.03, 0.03 }, { 1.0, 0.1, -0.3 }, 0.34, 0.050, 0.09, 5.5, 3.3,
    -0.35, 0.2, 1.4 },
  { { -0.70, 0.05, -0.05 }, { 0.03, 0.053, 0.03 }, { -0.2, 0.9, 0.7 }, 0.34, 0.052, 0.08, 6.0, 1.3,
    0.3, 2.2, 1.3 },
  { { 0.10, 0.65, 0.60 }, { 0.045, -0.038, -0.038 }, { 1.0, 0.3, -0.5 }, 0.34, 0.050, 0.08, 5.5,
    5.8, 0.35, 2.0, 0.9 },
  { { -0.50, 0.62, 0.55 }, { 0.03, -0.038, 0.038 }, { 0.8, 1.0, -0.5 }, 0.34, 0.050, 0.08, 5.5, 4.4,
    -0.3, 0.0, 1.1 },
} };
}

VortexTubes::VortexTubes(double time)
{
  for (std::size_t i = 0; i < Table.size(); ++i)
  {
    const Tube& tube = Table[i];
    State& state = this->Tubes[i];
    state.Along = tube.Along / glm::length(tube.Along);
    vtkMath::Perpendiculars(glm::value_ptr(state.Along), glm::value_ptr(state.Across[0]),
      glm::value_ptr(state.Across[1]), 0.0);
    state.Center = tube.Center + tube.Velocity * time;
    state.HalfLength = tube.HalfLength;
    state.Radius = tube.Radius;
    state.Bend = tube.Bend;
    state.WaveNumber = tube.WaveNumber;
    state.Phase = tube.Phase + tube.PhaseSpeed * time;
    const double age = (time - tube.PeakTime) / tube.LifeTime;
    state.Strength = std::exp(-age * age);
  }
}

double VortexTubes::operator()(const double x[3]) const
{
  double sum = 0.0;
  for (const State& tube : this->Tubes)
  {
    const glm::dvec3 from = glm::make_vec3(x) - tube.Center;
    const double along = glm::dot(from, tube.Along);
    const double angle = tube.WaveNumber * along + tube.Phase;
    const double offset[2] = { glm::dot(from, tube.Across[0]) - tube.Bend * std::sin(angle),
      glm::dot(from, tube.Across[1]) - 0.5 * tube.Bend * std::cos(1.6 * angle) };
    const double slope[2] = { tube.Bend * tube.WaveNumber * std::cos(angle),
      -0.8 * tube.Bend * tube.WaveNumber * std::sin(1.6 * angle) };
    const double relative = along / tube.HalfLength;
    sum += tube.Strength *
      std::exp(-BentAxis::SquaredDistance(offset, slope) / (tube.Radius * tube.Radius) -
        relative * relative * relative * relative);
  }
  return sum;
}

}
