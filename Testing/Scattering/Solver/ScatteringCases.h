// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteringCases_h
#define ScatteringCases_h

#include "Scattering/ScatteringSolver.h"

namespace reference
{

/// A medium that is the same in all cells, of size 1 along its longest side.
interlume::ScatteringMedium MakeMedium(
  const glm::ivec3& cells, double extinction, const glm::vec3& albedo, double g);
/// A ball of matter with a soft edge and lumps, in empty space, of that depth through its middle.
interlume::ScatteringMedium MakeCloud(int cells, double depth, const glm::vec3& albedo, double g);
/// The direct light of a direction, from the medium alone.
interlume::ScatteringLight MakeLight(
  const interlume::ScatteringMedium& medium, const glm::dvec3& direction);
interlume::ScatteringLight MakeLightAt(
  const interlume::ScatteringMedium& medium, const glm::dvec3& place);

/// The result of a solver. An error is printed and makes the field empty.
struct Solved
{
  interlume::ScatteringField Field;
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

/// A slab without end of depth along z, lit at the cosine mu; mirrors stand at its other sides.
struct Slab
{
  double G = 0.0;
  double Cosine = 1.0;
  double Depth = 1.0;
  double Albedo = 1.0;
  int Layers = 64;

  interlume::ScatteringMedium MakeMedium() const;
  /// The light, with the means over the layers exact.
  interlume::ScatteringLight MakeLight(const interlume::ScatteringMedium& medium) const;
};

/// The flux of scattered light out of a slab over that which comes in, as an eye sees it.
struct SlabFlux
{
  double Reflected = 0.0;
  double Transmitted = 0.0;
};
/// Integrates what cells send to all directions, by the formula of ScatteringField and the phase
/// function itself; the direct light in \a parts times as many layers as the field has.
SlabFlux GatherSlab(const Slab& slab, const interlume::ScatteringMedium& medium,
  const interlume::ScatteringField& field, int parts = 1);

}

#endif
