// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchChart_h
#define BenchChart_h

class vtkChartXY;
struct BenchPlot;

/**
 * Fills an empty chart with \a plot: title, axes, series, legend. Each series has a colour and a
 * marker of its own, so that they can be told apart in grey; peers are dashed; the points of the
 * default are ringed. Positions on a logarithmic axis must be positive.
 */
void FillChart(vtkChartXY* chart, const BenchPlot& plot);

#endif
