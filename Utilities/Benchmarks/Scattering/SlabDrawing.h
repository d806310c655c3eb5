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
  /// Cosine of the angle between the light and the normal.
  double Cosine;
};

/**
 * @class   SlabDrawing
 * @brief   flux reflected and transmitted by a slab, integrated from rendered images
 *
 * The slab is a box of thickness 1. It is wide enough for its center to behave like an infinite
 * slab: in optically thin slabs, light travels sideways by many thicknesses before it leaves; in
 * thick slabs, by only a few. The slice spacing and the light buffer resolve the mean free path of
 * light rays and view rays. The scattering grid has \a across cells across the slab, but at most
 * 128 cells along the box.
 */
class SlabDrawing
{
public:
  SlabDrawing(reference::VolumeStage& stage, const Slab& slab, const std::string& mode, int across);

  /// Returns the flux of scattered light divided by the incident flux, on the lit side if
  /// \a isReflected, otherwise on the far side. It is the integral of cosine times radiance, by
  /// Gauss quadrature over directions.
  double GetFlux(bool isReflected);
  /// Returns work that moves the light and renders a frame.
  BenchWork GetLitFrame(int threads);
  /// Returns the number of cells across the slab.
  int GetCellsAcross() const { return GetCellsAcross(this->Medium, this->Across); }
  /// Returns the number of cells across \a slab if \a across cells are requested.
  static int GetCellsAcross(const Slab& slab, int across);

private:
  Slab Medium;
  int Across;
  reference::ShadowScene Scene;
  shadows::MethodPointer Drawn;
};
}

#endif
