#ifndef vtkTimeVaryingReport_h
#define vtkTimeVaryingReport_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkExtractionReport.h"      // for the counts of cells

#include <array> // for the classes

/**
 * @class   vtkTimeVaryingReport
 * @brief   what the last execution of vtkTimeVaryingIntervalVolume did
 *
 * A plain value object. The counts of cells are summed over the slabs. CollapsedSimplices counts
 * 4-simplices.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
struct INTERLUMEINTERVALS_EXPORT vtkTimeVaryingReport : vtkExtractionReport
{
  /// Time steps requested, and slabs between them that were not left out.
  int TimeSteps = 0;
  int Slabs = 0;
  /// 4-simplices.
  vtkIdType Simplices = 0;
  /// Of these, where tetrahedra are made: without volume when projected, or without extent along
  /// the projection; they have no tetrahedra.
  vtkIdType FlatSimplices = 0;
  /// Of these, where tetrahedra are made: negatively oriented.
  vtkIdType InvertedSimplices = 0;
  /// Tetrahedra of the classes 1, 2, 3a, 3b, 4, 5, in this order; 0 when not asked for.
  std::array<vtkIdType, 6> Tetrahedra{};
  /// Boundary cells of each kind; 0 when not asked for.
  std::array<vtkIdType, 8> Boundaries{};
  /// Lookups in run-time tables, and cases that had to be made for them. (Which of several users in
  /// a process makes a case that both need is a matter of time.)
  vtkIdType TableLookups = 0;
  vtkIdType TableCasesMade = 0;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif
