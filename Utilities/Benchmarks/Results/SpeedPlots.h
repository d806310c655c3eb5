// SPDX-License-Identifier: BSD-3-Clause
#ifndef SpeedPlots_h
#define SpeedPlots_h

#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"

#include <string>
#include <vector>

/**
 * Returns bar plots of the baseline's time divided by the time of \a method: a plot for each
 * baseline, with a group of bars for each case and a bar for each parameter. The names of the plots
 * are `<suite>-ratio-<baseline>`.
 */
std::vector<BenchPlot> MakeRatioPlots(
  const std::string& suite, const std::string& method, const std::vector<BenchRow>& rows);

#endif
