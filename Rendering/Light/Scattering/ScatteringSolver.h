// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteringSolver_h
#define interlume_ScatteringSolver_h

#include "Common/Error.h"
#include "Scattering/ScatteredLight.h"
#include "Scattering/ScatteringLight.h"
#include "Scattering/ScatteringMedium.h"

#include <cstddef>
#include <vector>

namespace interlume
{

enum class ScatteringMode
{
  /// Forward scattering, layer by layer along each light.
  Forward,
  /// Scattering in all directions.
  Full
};

/// Settings of the solver.
struct ScatteringSettings
{
  /// Variance added to the angle along each of two transverse axes, per unit of scattering optical
  /// depth, in squared radians, for mode Forward. If negative, PhaseFunction::ForwardVariance is
  /// used.
  double AngleVariance = -1.0;
  /// In mode Full, light returns to a position only from this many cell layers behind it, as seen
  /// from the light; 0 means all layers. Light from farther layers is dropped by a sink of
  /// 1 / (3 extinction (layers times cell size)^2). The cutoff is gradual: even with many layers,
  /// part of the returning light is lost.
  int BackwardLayers = 0;
  /// Relative residual at which the diffusion solver of mode Full stops, and its maximum number of
  /// iterations per color channel.
  double Tolerance = 1e-3;
  int MaximumCycles = 100;
};

/// Statistics of a solution. Energies are fluence times area in world units, averaged over the
/// color channels.
struct ScatteringReport
{
  /// Number of layers of forward light, summed over all lights, and number of iterations of the
  /// diffusion solver, summed over the color channels.
  int Layers = 0;
  int Cycles = 0;
  /// Maximum relative residual over the color channels, in mode Full.
  double Residual = 0.0;
  /// Number of cells with non-finite extinction, albedo or light, which are treated as 0.
  std::size_t BadCells = 0;
  /// Energy that the medium removes from the direct light.
  double Taken = 0.0;
  /// The parts of Taken: energy absorbed by the medium and by blocked cells, energy that leaves the
  /// box toward the lights, energy that leaves away from the lights, and dropped energy.
  /// BackwardLayers drops energy, and mode Forward drops all light that is not scattered forward.
  double Absorbed = 0.0;
  double Reflected = 0.0;
  double Transmitted = 0.0;
  double Dropped = 0.0;
};

/**
 * @class   ScatteringSolver
 * @brief   computes multiple scattering in a medium
 *
 * Needs no OpenGL and does not depend on the camera. Runs in parallel with vtkSMPTools; the result
 * is bit-identical for any number of threads. See Documentation/methods/scattering.md.
 */
class ScatteringSolver
{
public:
  /// Returns an error if the medium or a light is invalid; \a field is then empty.
  static Error Solve(const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights,
    ScatteringMode mode, const ScatteringSettings& settings, ScatteredLight& field,
    ScatteringReport& report);
};

}

#endif
