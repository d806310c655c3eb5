// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlotDrawer_h
#define PlotDrawer_h

#include "Benchmarks/Results/BenchPlot.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <string>
#include <vector>

/**
 * Draws plots with VTK's charts, off screen: a colour and a marker for each method, so that they
 * can be told apart in grey; peers dashed; the default's point ringed, the front dotted; machine
 * and conditions under the chart.
 */
class PlotDrawer
{
public:
  /**
   * \a folder is made where it is missing; \a caption are the lines under every chart. Throws
   * std::runtime_error where this VTK needs a display and there is none.
   */
  PlotDrawer(const std::string& folder, const std::string& caption);

  /**
   * Writes `<name>.png` of each plot that has points, and returns these plots. Throws
   * std::runtime_error where a file cannot be written.
   */
  std::vector<BenchPlot> Draw(const std::vector<BenchPlot>& plots) const;

private:
  void Draw(const BenchPlot& plot) const;

  std::string Folder;
  std::string Caption;
  /// One for all plots: each new window would be another connection to the display.
  vtkNew<vtkRenderWindow> Window;
};

#endif
