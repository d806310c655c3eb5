// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteringUpdater_h
#define interlume_ScatteringUpdater_h

#include "Common/Error.h"
#include "Grid/ExtinctionGrid.h"
#include "Scattering/PhaseFunction.h"
#include "Shaders/SliceScattering.h"

#include "vtkShadowedSliceSettings.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkOpenGLRenderWindow;

namespace interlume
{

struct SliceReport;
struct VolumeRenderState;

/**
 * @class   ScatteringUpdater
 * @brief   computes multiple scattering in a volume and caches it until an input changes
 */
class ScatteringUpdater
{
public:
  /// Sets the scattering mode and the phase function. Returns an error if the phase function is
  /// invalid.
  Error SetPhase(const vtkShadowedSliceSettings& settings, SliceScattering& scattering);

  /// A volume of the image, the versions of its samples and material, and its ScatteringGridSize.
  struct Volume
  {
    const VolumeRenderState* State;
    std::array<int, 2> Versions;
    int GridSize;
  };

  /**
   * Computes multiple scattering if the settings request it and an input has changed: a setting,
   * the medium or position of a volume, a light, the number of light samples, or the shadows of
   * surfaces. If \a other has already computed the scattering of another volume, \a known, from the
   * same inputs, copies \a known instead. Returns an error if the computation fails.
   */
  Error Solve(vtkOpenGLRenderWindow* window, VolumeRenderState& frame,
    const std::vector<Volume>& volumes, const vtkShadowedSliceSettings& settings, int lightSamples,
    const ScatteringUpdater* other, const SliceScattering* known);

  /// Writes the statistics of the last result to \a report.
  void Fill(SliceReport& report) const;

  /// Returns the number of cells blocked by opaque surfaces in the last result.
  int GetBlockedCells() const { return this->BlockedCells; }
  /// Returns a version number above 0 that changes whenever the data of SliceScattering change.
  int GetVersion() const { return this->Version; }

private:
  Error MakePhaseFunction(const vtkShadowedSliceSettings& settings, SliceScattering& scattering);
  Error MakeField(vtkOpenGLRenderWindow* window, VolumeRenderState& frame,
    const std::vector<Volume>& volumes, const vtkShadowedSliceSettings& settings, int lightSamples);
  /// Rebuilds the grid if the medium of a volume has changed. Returns false if there is no medium.
  bool MakeGrid(const std::vector<Volume>& volumes);
  /// Returns true if \a other uses the same phase function.
  bool HasSamePhaseFunction(const ScatteringUpdater& other) const;

  PhaseFunction Phase;
  /// Inputs of the phase function.
  int Mode = vtkShadowedSliceSettings::NO_SCATTERING;
  int Kind = vtkShadowedSliceSettings::ISOTROPIC_PHASE;
  double Anisotropy = 0.0;
  vtkMTimeType TableTime = 0;
  /// Inputs of the scattered light.
  std::vector<double> Key;
  /// The medium, sampled on a grid, and the inputs of the grid. The grid is reused if only lights
  /// change.
  ExtinctionGrid Grid;
  bool HasGrid = false;
  std::vector<double> GridKey;
  int Cells = 0;
  int BlockedCells = 0;
  /// Number of computations since scattering was enabled, and the duration of the last one in
  /// seconds.
  int Solves = 0;
  double Seconds = 0.0;
  int Version = 1;
};

}

#endif
