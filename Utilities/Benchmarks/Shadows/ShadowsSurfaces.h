// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsSurfaces_h
#define ShadowsSurfaces_h

#include "Benchmarks/Suites/BenchOptions.h"
#include "Benchmarks/Results/BenchRow.h"

/**
 * The part of the suite `shadows` about sharp surfaces.
 */
namespace shadows
{
/**
 * Method `surfaces`, at the mapper's own settings: an opaque cube and a plate whose opacity jumps,
 * under light from 0 to 60 degrees, against closed forms; a ball of steps of opacity, a thin shell,
 * a sheet of one voxel and three CT volumes, with ramps and with steps of opacity, by scattered
 * light, against the ray marcher. The error is the mean difference of a pixel's red, over the
 * pixels that show anything; p95, largest and rms are of the same, rms over the mean of what is
 * expected, and brightness is the picture's mean over that, less 1. Seconds are those of a frame of
 * 512^2; the peer is `shadows-off`.
 */
void AddSurfaceRows(const BenchOptions& options, BenchRows& rows);
}

#endif
