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
  /// Variance added per unit of scattering optical depth to the angle along each of two transverse
  /// axes, in square radians, for mode Forward. If negative, PhaseFunction::ForwardVariance is
  /// used.
  double AngleVariance = -1.0;
  /// Number of cell layers behind a position, away from the light, from which light returns to it
  /// in mode Full; 0 means all. Light from farther layers is dropped by a sink of 1 / (3 extinction
  /// (layers times cell size)^2). The cutoff is gradual: even many layers lose part of the returned
  /// light.
  int BackwardLayers = 0;
  /// Relative residual at which mode Full stops, and the maximum number of cycles.
  double Tolerance = 1e-3;
  int MaximumCycles = 100;
};

/// Statistics of a solution. Energies are fluence times area in world units, averaged over the
/// color channels.
struct ScatteringReport
{
  /// Layers of mode Forward, summed over all lights, and cycles of mode Full, summed over the color
  /// channels.
  int Layers = 0;
  int Cycles = 0;
  /// Relative residual of mode Full, the maximum over the color channels.
  double Residual = 0.0;
  /// Number of cells with non-finite extinction, albedo or light, which are treated as 0.
  std::size_t BadCells = 0;
  /// Energy that the medium removes from the direct light.
  double Taken = 0.0;
  /// The parts of Taken: energy absorbed by the medium and blocked cells, energy that leaves toward
  /// the lights' side, energy that leaves toward the other side, and dropped energy. BackwardLayers
  /// drops energy, and mode Forward drops all that is not scattered forward.
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
  /// Returns an error if the medium or a light is invalid; \a field is empty then.
  static Error Solve(const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights,
    ScatteringMode mode, const ScatteringSettings& settings, ScatteredLight& field,
    ScatteringReport& report);
};

}

#endif
