// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingReport_h
#define interlume_TimeVaryingReport_h

#include "Output/ExtractionReport.h"

#include <array>

namespace interlume
{

/**
 * @class   TimeVaryingReport
 * @brief   report of vtkTimeVaryingIntervalVolume
 *
 * The counts of cells are summed over the slabs. CollapsedSimplices counts 4-simplices.
 */
struct TimeVaryingReport : ExtractionReport
{
  /// The numbers of time steps requested, and of slabs between them that were not skipped.
  int TimeSteps = 0;
  int Slabs = 0;
  /// The number of 4-simplices.
  vtkIdType Simplices = 0;
  /// The number of these 4-simplices that have no volume when projected, or no extent along the
  /// projection, counted if tetrahedra are generated. They have no tetrahedra.
  vtkIdType FlatSimplices = 0;
  /// The number of these 4-simplices that are negatively oriented, counted if tetrahedra are
  /// generated.
  vtkIdType InvertedSimplices = 0;
  /// The numbers of tetrahedra of the classes 1, 2, 3a, 3b, 4, 5, in this order; 0 if not
  /// requested.
  std::array<vtkIdType, 6> Tetrahedra{};
  /// The numbers of boundary cells of each kind; 0 if not requested.
  std::array<vtkIdType, 8> Boundaries{};
  /// The numbers of lookups in run-time tables, and of cases computed for them. (If several users
  /// in a process need a case at once, either of them may compute it.)
  vtkIdType TableLookups = 0;
  vtkIdType TableCasesComputed = 0;

  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
