// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteringUpdater_h
#define interlume_ScatteringUpdater_h

#include "Common/Error.h"
#include "Grid/MatterGrid.h"
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
 * @brief   finds how light is scattered in a volume, and keeps it until something changes
 */
class ScatteringUpdater
{
public:
  /// Sets the mode of scattering and the phase function from the settings. Returns an error if the
  /// phase function is not valid.
  Error SetPhase(const vtkShadowedSliceSettings& settings, SliceScattering& scattering);

  /// A volume whose matter is in the picture, the versions of its samples and material, and its
  /// setting ScatteringGridSize.
  struct Volume
  {
    const VolumeRenderState* State;
    std::array<int, 2> Versions;
    int GridSize;
  };

  /**
   * Computes the light that was scattered before, if settings request it and something has changed:
   * the medium or the position of a volume, lights with the given number of samples each, the
   * shadows of surfaces. If \a other has computed the same for another volume, it is copied from
   * \a known, the scattering of that volume. Returns an error if the computation fails.
   */
  Error Solve(vtkOpenGLRenderWindow* window, VolumeRenderState& frame,
    const std::vector<Volume>& volumes, const vtkShadowedSliceSettings& settings, int lightSamples,
    const ScatteringUpdater* other, const SliceScattering* known);

  /// Sets the values of a report that describe the last result.
  void Fill(SliceReport& report) const;

  /// The cells that opaque surfaces block, of the last field.
  int GetBlockedCells() const { return this->BlockedCells; }
  /// A number that is another one when texels have changed; above 0.
  int GetVersion() const { return this->Version; }

private:
  Error MakePhase(const vtkShadowedSliceSettings& settings, SliceScattering& scattering);
  Error MakeField(vtkOpenGLRenderWindow* window, VolumeRenderState& frame,
    const std::vector<Volume>& volumes, const vtkShadowedSliceSettings& settings, int lightSamples);
  /// Rebuilds the grid if the medium of a volume has changed. Returns whether there is any.
  bool MakeGrid(const std::vector<Volume>& volumes);
  /// Whether the light is scattered by the same phase function.
  bool HasPhaseOf(const ScatteringUpdater& other) const;

  PhaseFunction Phase;
  /// What the phase function was made of.
  int Mode = vtkShadowedSliceSettings::NO_SCATTERING;
  int Kind = vtkShadowedSliceSettings::ISOTROPIC_PHASE;
  double Anisotropy = 0.0;
  vtkMTimeType TableTime = 0;
  /// All that the field depends on.
  std::vector<double> Key;
  /// The matter in cells and what it was made of: it stays where lights alone change.
  MatterGrid Grid;
  bool HasGrid = false;
  std::vector<double> GridKey;
  int Cells = 0;
  int BlockedCells = 0;
  /// How often it was found since it is asked for, and the seconds of the last time.
  int Solves = 0;
  double Seconds = 0.0;
  int Version = 1;
};

}

#endif
