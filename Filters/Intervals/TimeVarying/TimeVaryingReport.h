// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeVaryingReport_h
#define vtkTimeVaryingReport_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkExtractionReport.h"      // for the counts of cells

#include <array> // for the classes

/**
 * @class   vtkTimeVaryingReport
 * @brief   what the last execution of vtkTimeVaryingIntervalVolume did
 *
 * This is a plain value object. The counts of cells are summed over the slabs. CollapsedSimplices
 * counts 4-simplices.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
struct INTERLUMEINTERVALS_EXPORT vtkTimeVaryingReport : vtkExtractionReport
{
  /// The numbers of time steps requested, and of slabs between them that were not left out.
  int TimeSteps = 0;
  int Slabs = 0;
  /// The number of 4-simplices.
  vtkIdType Simplices = 0;
  /// The number of these 4-simplices that have no volume when projected, or no extent along the
  /// projection, counted where tetrahedra are made; they have no tetrahedra.
  vtkIdType FlatSimplices = 0;
  /// The number of these 4-simplices that are negatively oriented, counted where tetrahedra are
  /// made.
  vtkIdType InvertedSimplices = 0;
  /// The numbers of tetrahedra of the classes 1, 2, 3a, 3b, 4, 5, in this order; 0 when not asked
  /// for.
  std::array<vtkIdType, 6> Tetrahedra{};
  /// The numbers of boundary cells of each kind; 0 when not asked for.
  std::array<vtkIdType, 8> Boundaries{};
  /// The numbers of lookups in run-time tables, and of cases that had to be made for them. (Which
  /// of several users in a process makes a case that both need is a matter of time.)
  vtkIdType TableLookups = 0;
  vtkIdType TableCasesMade = 0;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif
