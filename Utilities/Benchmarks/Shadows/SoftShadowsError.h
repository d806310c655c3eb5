// SPDX-License-Identifier: BSD-3-Clause
#ifndef SoftShadowsError_h
#define SoftShadowsError_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * What the suite `soft-shadows` measures.
 */
namespace shadows
{
/**
 * Pictures of one round area light, scattered evenly, against the same mapper's with each of 256
 * samples of the light as a light of its own (32 when quick), sixteen in a picture, slices at half
 * the default distance and a light buffer of 256^2 (128^2). processor_seconds are those of all
 * threads. Methods:
 * - `sample-layers`: the parameter is the number of samples; `sample-layers, buffer`: the size of
 *   the light's buffer, with the default number;
 * - `accumulated-convolution`: the parameter is the distance of slices over the default one;
 *   `accumulated-convolution, buffer`: the size of the light's buffer;
 * - `sampled-lights`: the parameter is the number of samples;
 * - `hard`: the light without its extent;
 * - `default`: all settings as they are; the peer is `hard`, and over_hard its processor time over
 *   that.
 *
 * Rows of method `equal-time`: the error of the default, and as peer the convolution's time at its
 * smallest error within the default's processor time, or of its fastest setting where that takes
 * longer; convolution_over_default is that error over the default's.
 */
void AddSoftShadowRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckSoftShadowClaims(const std::vector<BenchRow>& rows);
/// A plot for each case.
std::vector<BenchPlot> MakeSoftShadowPlots(const std::vector<BenchRow>& rows);
}

#endif
