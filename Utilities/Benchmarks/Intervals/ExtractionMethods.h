// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExtractionMethods_h
#define ExtractionMethods_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkDataSet;
class vtkImageData;
class vtkIntervalVolume;

/**
 * The ways compared with each other, each made anew so that nothing is kept from run to run. All
 * take the active point scalars, one thread or several as vtkSMPTools is set.
 */
namespace methods
{
/**
 * vtkIntervalVolume of one interval, not yet run.
 */
vtkSmartPointer<vtkIntervalVolume> NewIntervalVolume(vtkDataSet* data, double lower, double upper);

/**
 * vtkIntervalVolume: tetrahedra.
 */
vtkSmartPointer<vtkUnstructuredGrid> IntervalVolume(vtkDataSet* data, double lower, double upper);

/**
 * vtkTableBasedClipDataSet by lower, then by upper: mixed cells. \a precision as that of the
 * filter's output points.
 */
vtkSmartPointer<vtkUnstructuredGrid> ClipTwice(
  vtkDataSet* data, double lower, double upper, int precision);

/**
 * vtkDataSetTriangleFilter: the three-dimensional cells of \a grid as tetrahedra.
 */
vtkSmartPointer<vtkUnstructuredGrid> ToTetrahedra(vtkUnstructuredGrid* grid);

/**
 * vtkIsotableContour with or without merged points.
 */
vtkSmartPointer<vtkUnstructuredGrid> IsotableContour(
  vtkDataSet* data, double value, bool mergePoints);

/**
 * vtkContour3DLinearGrid with or without merged points; neither normals nor attributes.
 */
vtkSmartPointer<vtkPolyData> Contour3DLinearGrid(
  vtkUnstructuredGrid* grid, double value, bool mergePoints);

/**
 * vtkFlyingEdges3D without normals and gradients.
 */
vtkSmartPointer<vtkPolyData> FlyingEdges(vtkImageData* image, double value);
}

#endif
