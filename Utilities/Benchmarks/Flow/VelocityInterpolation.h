// SPDX-License-Identifier: BSD-3-Clause
#ifndef VelocityInterpolation_h
#define VelocityInterpolation_h

#include "vtkAbstractInterpolatedVelocityField.h"
#include "vtkSmartPointer.h"

class vtkDataSet;

/**
 * VTK's velocity interpolation, as vtkStreamTracer uses it, with a choice of the search method for
 * the next cell.
 *
 * VTK 9.1 has a class for each method, vtkInterpolatedVelocityField and
 * vtkCellLocatorInterpolatedVelocityField. They are deprecated since 9.2 and removed in 9.4. Their
 * replacement is vtkCompositeInterpolatedVelocityField with a vtkFindCellStrategy.
 */
namespace flow
{
enum class CellSearch
{
  /// Walks from the cells around the closest point; the default in all VTK versions.
  CLOSEST_POINT,
  /// vtkStaticCellLocator.
  STATIC_CELL_LOCATOR
};

/// Returns a prototype without a dataset, for vtkStreamTracer.
vtkSmartPointer<vtkAbstractInterpolatedVelocityField> NewInterpolation(CellSearch search);

/// Returns an interpolation of the point vectors of \a field, which must outlive it. Not
/// thread-safe.
vtkSmartPointer<vtkAbstractInterpolatedVelocityField> NewInterpolation(
  CellSearch search, vtkDataSet* field);
}

#endif
