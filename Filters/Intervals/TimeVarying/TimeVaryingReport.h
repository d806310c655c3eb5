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
  /// Number of requested time steps, and number of slabs between them that were not skipped.
  int TimeSteps = 0;
  int Slabs = 0;
  /// Number of 4-simplices.
  vtkIdType Simplices = 0;
  /// Number of degenerate 4-simplices: those whose projection has no volume, or that have no extent
  /// along the projection direction. They produce no tetrahedra. Counted only if tetrahedra are
  /// generated.
  vtkIdType FlatSimplices = 0;
  /// Number of negatively oriented 4-simplices. Counted only if tetrahedra are generated.
  vtkIdType InvertedSimplices = 0;
  /// Number of tetrahedra of each class (see SimplexProjection), in the order 1, 2, 3a, 3b, 4, 5.
  /// All 0 if tetrahedra are not requested.
  std::array<vtkIdType, 6> Tetrahedra{};
  /// Number of boundary cells of each kind. 0 if a kind is not requested.
  std::array<vtkIdType, 8> Boundaries{};
  /// Number of lookups in space-time tables, and number of cases that these lookups computed. If
  /// several filters in a process need a case at the same time, any of them may compute it.
  vtkIdType TableLookups = 0;
  vtkIdType TableCasesComputed = 0;

  /// Adds the numbers of 4-simplices, tetrahedra and boundary cells.
  void AddOutput(const TimeVaryingReport& other);
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif
