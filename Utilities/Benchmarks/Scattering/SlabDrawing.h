// SPDX-License-Identifier: BSD-3-Clause
#ifndef SlabDrawing_h
#define SlabDrawing_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Scattering/ScatteringModes.h"

#include <string>

namespace scattering
{
/// Matter that is the same everywhere between two planes, in parallel light.
struct Slab
{
  double Depth;
  double Albedo;
  double G;
  /// Of the light's angle to the normal.
  double Cosine;
};

/**
 * @class   SlabDrawing
 * @brief   what a drawn slab reflects and lets through, integrated over pictures of it
 *
 * The slab is a box of thickness 1 and as wide as it must be for its middle: light that goes
 * sideways leaves a thin one through its faces only after many thicknesses, a thick one after few.
 * Slices and the light's buffer resolve the free path of light and sight. So many cells are in the
 * grid along the box, as many as \a across through the slab, at most 128 along the box.
 */
class SlabDrawing
{
public:
  SlabDrawing(reference::VolumeStage& stage, const Slab& slab, const std::string& mode, int across);

  /// Flux of scattered light over incident flux on the light's side, or on the other one: the
  /// integral over Gauss's directions of cosine times radiance.
  double GetFlux(bool isReflected);
  /// A frame in which the light has moved.
  BenchWork GetLitFrame(int threads);
  /// The cells through the slab.
  int GetAcross() const { return GetAcross(this->Matter, this->Across); }
  /// The same for so many that are asked for.
  static int GetAcross(const Slab& slab, int across);

private:
  Slab Matter;
  int Across;
  reference::ShadowScene Scene;
  shadows::MethodPointer Drawn;
};
}

#endif
