// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceExtraction_h
#define ReferenceExtraction_h

#include "Support/Checks/ReferenceReport.h" // for the report

#include "vtkIntervalVolume.h" // for SurfaceCells
#include "vtkSmartPointer.h"   // for the output

#include <array>  // for intervals
#include <vector> // for intervals

class vtkDataSet;
class vtkUnstructuredGrid;

/**
 * Runs the extraction filters on the active scalars of a dataset, with double-precision output
 * points.
 */
namespace reference
{

using Interval = std::array<double, 2>;

struct Extraction
{
  vtkSmartPointer<vtkUnstructuredGrid> Volume;  ///< port 0
  vtkSmartPointer<vtkUnstructuredGrid> Surface; ///< port 1 with GenerateBoundaries on
  ReportCopy Report;
};

Extraction ExtractIntervals(vtkDataSet* data, const std::vector<Interval>& intervals,
  int surfaceCells = vtkIntervalVolume::WITHOUT_SOLIDS);

struct ContourExtraction
{
  vtkSmartPointer<vtkUnstructuredGrid> Surface;
  ReportCopy Report;
};

ContourExtraction ExtractContours(vtkDataSet* data, const std::vector<double>& values);

}

#endif
