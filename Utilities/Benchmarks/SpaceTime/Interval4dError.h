// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dError_h
#define Interval4dError_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `interval4d` about error against run time.
 */
namespace interval4d
{
/**
 * The regions midway between every two of evenly spaced time steps, by one thread, warm. The
 * parameter is the time from step to step, which is halved. Methods:
 * - `slice`: vtkTimeVaryingIntervalVolume from step to step, then vtkSimplexTimeSlice;
 * - `interpolate`, the peer: the values of both steps averaged, then vtkIntervalVolume;
 * - `sampled`: the field itself at that time on the same grid, then vtkIntervalVolume (seconds
 *   without the sampling): the error that is left when time adds none.
 *
 * One row for each norm, each the mean over the regions:
 * - `symmetric difference, share of the volume`: with the analytic region, to first order: the
 *   distance of the result's surface from the analytic one, integrated over its area;
 * - `volume, relative`: of the volume of the analytic region.
 *
 * Rows with `order` in their counts: the exponent of the first norm against the time step, from the
 * errors that are more than four times that of `sampled`. Rows of method `slice-again`: one more
 * slice of 4-simplices that are there, against `interpolate` of one region.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckErrorClaims(const std::vector<BenchRow>& rows);
/// A plot for each field with an error, of the first norm.
std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows);
}

#endif
