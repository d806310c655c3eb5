// SPDX-License-Identifier: BSD-3-Clause
#ifndef VelocityInterpolation_h
#define VelocityInterpolation_h

#include "vtkAbstractInterpolatedVelocityField.h"
#include "vtkSmartPointer.h"

class vtkDataSet;

/**
 * VTK's velocity interpolators for vtkStreamTracer, with a choice of the method that searches for
 * the next cell.
 *
 * VTK 9.1 has a class for each method, vtkInterpolatedVelocityField and
 * vtkCellLocatorInterpolatedVelocityField. They were deprecated in 9.2 and removed in 9.4. Their
 * replacement is vtkCompositeInterpolatedVelocityField with a vtkFindCellStrategy.
 */
namespace flow
{
enum class CellSearch
{
  /// Finds the closest point and walks from its adjacent cells. The default of all VTK versions.
  CLOSEST_POINT,
  /// vtkStaticCellLocator.
  STATIC_CELL_LOCATOR
};

/// Returns a prototype interpolator without a dataset, for vtkStreamTracer.
vtkSmartPointer<vtkAbstractInterpolatedVelocityField> NewInterpolator(CellSearch search);

/// Returns an interpolator of the point vectors of \a field, which must outlive it. The
/// interpolator is not thread-safe.
vtkSmartPointer<vtkAbstractInterpolatedVelocityField> NewInterpolator(
  CellSearch search, vtkDataSet* field);
}

#endif
