// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteringCases_h
#define ScatteringCases_h

#include "Scattering/ScatteringSolver.h"

namespace reference
{

/// Returns a homogeneous medium whose longest edge has length 1.
interlume::ScatteringMedium MakeMedium(
  const glm::ivec3& cells, double extinction, const glm::vec3& albedo, double g);
/// Returns a sphere with a soft, lumpy boundary in empty space. \a depth is the optical depth along
/// its diameter.
interlume::ScatteringMedium MakeCloud(int cells, double depth, const glm::vec3& albedo, double g);
/// Returns a directional light, with the direct light in the cells of \a medium.
interlume::ScatteringLight MakeLight(
  const interlume::ScatteringMedium& medium, const glm::dvec3& direction);
interlume::ScatteringLight MakeScatteringPointLight(
  const interlume::ScatteringMedium& medium, const glm::dvec3& position);

/// Result of the solver. On an error, the message is printed and the field is empty.
struct Solved
{
  interlume::ScatteredLight Field;
  interlume::ScatteringReport Report;
  interlume::Error Error;

  double GetSum() const
  {
    return this->Report.Absorbed + this->Report.Reflected + this->Report.Transmitted +
      this->Report.Dropped;
  }
};
Solved Solve(const interlume::ScatteringMedium& medium,
  const std::vector<interlume::ScatteringLight>& lights, interlume::ScatteringMode mode,
  const interlume::ScatteringSettings& settings = {});

/// An infinite slab of optical depth Depth along z. Cosine is the cosine between the light
/// direction and z. Mirrors at the lateral faces make the slab infinite.
struct Slab
{
  double G = 0.0;
  double Cosine = 1.0;
  double Depth = 1.0;
  double Albedo = 1.0;
  int Layers = 64;

  interlume::ScatteringMedium MakeMedium() const;
  /// Returns the light, with the exact mean of the direct light over each layer.
  interlume::ScatteringLight MakeLight(const interlume::ScatteringMedium& medium) const;
};

/// Fluxes of scattered light that leave a slab, divided by the incident flux. They are integrated
/// from the radiance along view rays.
struct SlabFlux
{
  double Reflected = 0.0;
  double Transmitted = 0.0;
};
/// Integrates the radiance over all directions. The radiance is computed from \a field and the
/// phase function. The direct light is computed in \a parts sublayers of each layer of the field.
SlabFlux IntegrateSlabFlux(const Slab& slab, const interlume::ScatteringMedium& medium,
  const interlume::ScatteredLight& field, int parts = 1);

}

#endif
