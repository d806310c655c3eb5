// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceScatterer_h
#define interlume_SliceScatterer_h

#include "Draw/SliceScattering.h"
#include "Grid/MatterGrid.h"
#include "Scattering/PhaseFunction.h"

#include "vtkShadowedSliceReport.h"

#include "vtkShadowedSliceSettings.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace interlume
{

struct SliceFrame;

/**
 * @class   SliceScatterer
 * @brief   finds how light is scattered in a volume, and keeps it until something changes
 */
class SliceScatterer
{
public:
  /// Takes the way of scattering and the phase function from the settings. Returns what is wrong,
  /// or nothing.
  std::string SetPhase(const vtkShadowedSliceSettings& settings, SliceScattering& scattering);

  /// A volume whose matter is in the picture, the versions of its samples and material, and its
  /// setting ScatteringGridSize.
  struct Matter
  {
    const SliceFrame* Frame;
    std::array<int, 2> Versions;
    int GridSize;
  };

  /**
   * Finds the light that was scattered before, where settings ask for it and something has changed:
   * the matter of all volumes, what is left of them, their places, lights, the shadows of surfaces.
   * Where \a other has found the same for another volume it is taken from \a known, the scattering
   * of that one. Returns what is wrong, or nothing.
   */
  std::string Solve(vtkOpenGLRenderWindow* window, SliceFrame& frame,
    const std::vector<Matter>& matter, const vtkShadowedSliceSettings& settings,
    const SliceScatterer* other, const SliceScattering* known, vtkShadowedSliceReport& report);

  /// The cells that opaque surfaces block, of the last field.
  int GetBlockedCells() const { return this->BlockedCells; }
  /// A number that is another one when texels have changed; above 0.
  int GetVersion() const { return this->Version; }

private:
  std::string MakePhase(const vtkShadowedSliceSettings& settings, SliceScattering& scattering);
  std::string MakeField(vtkOpenGLRenderWindow* window, SliceFrame& frame,
    const std::vector<Matter>& matter, const vtkShadowedSliceSettings& settings);
  /// Makes the grid anew where its matter has changed. Returns whether there is any.
  bool MakeGrid(const std::vector<Matter>& matter);
  /// Whether the light is scattered by the same phase function.
  bool HasPhaseOf(const SliceScatterer& other) const;

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
