// SPDX-License-Identifier: BSD-3-Clause
#ifndef SlabDrawing_h
#define SlabDrawing_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Scattering/ScatteringModes.h"

#include <string>

namespace scattering
{
/// A homogeneous medium between two planes in parallel light.
struct Slab
{
  double Depth;
  double Albedo;
  double G;
  /// Cosine of the angle between the light direction and the normal of the planes.
  double Cosine;
};

/**
 * @class   SlabDrawing
 * @brief   flux reflected and transmitted by a slab, integrated from rendered images
 *
 * The slab is a box of thickness 1. It is wide enough for its center to behave like an infinite
 * slab: in optically thin slabs, light travels sideways by many thicknesses before it leaves the
 * slab; in thick slabs, by only a few. The slice spacing and the light buffer resolve the mean free
 * path. The scattering grid has \a across cells along the thickness, or fewer if it would otherwise
 * have more than 128 cells along the width.
 */
class SlabDrawing
{
public:
  SlabDrawing(reference::VolumeStage& stage, const Slab& slab, const std::string& mode, int across);

  /// Returns the flux of scattered light divided by the incident flux, on the lit side if
  /// \a isReflected is true, otherwise on the far side. The flux is the integral of cosine times
  /// radiance over all directions, computed by Gauss quadrature.
  double GetFlux(bool isReflected);
  /// Returns work that moves the light and then renders a frame.
  BenchWork MakeRelightingWork(int threads);
  /// Returns the number of grid cells along the thickness of the slab.
  int GetCellsAlongThickness() const { return GetCellsAlongThickness(this->Medium, this->Across); }
  /// Returns the number of grid cells along the thickness of \a slab if \a across are requested.
  static int GetCellsAlongThickness(const Slab& slab, int across);

private:
  Slab Medium;
  int Across;
  reference::ShadowScene Scene;
  shadows::MethodPointer Drawn;
};
}

#endif
