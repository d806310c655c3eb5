// SPDX-License-Identifier: BSD-3-Clause
#ifndef VelocityInterpolation_h
#define VelocityInterpolation_h

#include "vtkAbstractInterpolatedVelocityField.h"
#include "vtkSmartPointer.h"

class vtkDataSet;

/**
 * VTK's interpolation of velocities, as vtkStreamTracer takes it, with a choice of how cells are
 * found where the last one is left.
 *
 * VTK 9.1 has a class for each way, vtkInterpolatedVelocityField and
 * vtkCellLocatorInterpolatedVelocityField; they are deprecated from 9.2 on and gone from 9.4 on.
 * vtkCompositeInterpolatedVelocityField with a vtkFindCellStrategy takes their place.
 */
namespace flow
{
enum class CellSearch
{
  /// Walks from the cells around the closest point: the default of both.
  CLOSEST_POINT,
  /// vtkStaticCellLocator.
  STATIC_CELL_LOCATOR
};

/// Of no dataset yet: a prototype for vtkStreamTracer.
vtkSmartPointer<vtkAbstractInterpolatedVelocityField> NewInterpolation(CellSearch search);

/// Of the point vectors of \a field, which must outlive it; for one thread.
vtkSmartPointer<vtkAbstractInterpolatedVelocityField> NewInterpolation(
  CellSearch search, vtkDataSet* field);
}

#endif
