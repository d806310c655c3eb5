// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchChart_h
#define BenchChart_h

class vtkChartXY;
struct BenchPlot;

/**
 * Fills an empty chart with \a plot: title, axes, series, legend. Each series has a colour and one
 * of the marks of PlotMarks.h, by which as many can be told apart in grey, bars by their greys;
 * peers are dashed; the points of the default are ringed. Positions on a logarithmic axis must be
 * positive.
 */
void FillChart(vtkChartXY* chart, const BenchPlot& plot);

#endif
