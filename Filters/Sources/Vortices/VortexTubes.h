// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VortexTubes_h
#define interlume_VortexTubes_h

#include <array>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   VortexTubes
 * @brief   field VORTEX of vtkAnalyticFieldSource at one time: bent tubes of vorticity
 *
 * The tubes drift, bend, grow and fade. Documentation/methods/sources.md describes the formula.
 */
class VortexTubes
{
public:
  static constexpr int NumberOfTubes = 11;

  explicit VortexTubes(double time);

  double operator()(const double x[3]) const;

private:
  /// A tube at the time passed to the constructor.
  struct State
  {
    glm::dvec3 Center;
    glm::dvec3 Along;
    glm::dvec3 Across[2];
    double HalfLength;
    double Radius;
    double Bend;
    double WaveNumber;
    double Phase;
    double Strength;
  };
  std::array<State, NumberOfTubes> Tubes;
};

}

#endif
