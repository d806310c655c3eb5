// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointNames_h
#define PointNames_h

#include "Benchmarks/Results/BenchPlot.h"

#include "vtkContextItem.h"

/**
 * Writes the names of a plot's points beside them; an item of the plot's chart.
 */
class PointNames : public vtkContextItem
{
public:
  static PointNames* New();
  vtkTypeMacro(PointNames, vtkContextItem);

  void SetPlot(const BenchPlot& plot) { this->Plot = plot; }

  bool Paint(vtkContext2D* painter) override;

private:
  PointNames() = default;

  BenchPlot Plot;
};

#endif
