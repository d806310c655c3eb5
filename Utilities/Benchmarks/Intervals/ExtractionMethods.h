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
 * Extraction methods that the suites compare. Each call creates a new filter, so that no memory is
 * reused between runs. All methods use the active point scalars and the number of threads set in
 * vtkSMPTools.
 */
namespace methods
{
/**
 * Returns a vtkIntervalVolume with one interval. The caller must update it.
 */
vtkSmartPointer<vtkIntervalVolume> NewIntervalVolume(vtkDataSet* data, double lower, double upper);

/**
 * Returns the tetrahedra that vtkIntervalVolume extracts.
 */
vtkSmartPointer<vtkUnstructuredGrid> IntervalVolume(vtkDataSet* data, double lower, double upper);

/**
 * Clips with vtkTableBasedClipDataSet at \a lower, then at \a upper. The result has cells of
 * several types. \a precision is the precision of the output points.
 */
vtkSmartPointer<vtkUnstructuredGrid> ClipTwice(
  vtkDataSet* data, double lower, double upper, int precision);

/**
 * Splits the three-dimensional cells of \a grid into tetrahedra with vtkDataSetTriangleFilter.
 */
vtkSmartPointer<vtkUnstructuredGrid> ToTetrahedra(vtkUnstructuredGrid* grid);

/**
 * Returns the output of vtkIsotableContour with or without merged points.
 */
vtkSmartPointer<vtkUnstructuredGrid> IsotableContour(
  vtkDataSet* data, double value, bool mergePoints);

/**
 * Returns the output of vtkContour3DLinearGrid with or without merged points, without normals and
 * attributes.
 */
vtkSmartPointer<vtkPolyData> Contour3DLinearGrid(
  vtkUnstructuredGrid* grid, double value, bool mergePoints);

/**
 * Returns the output of vtkFlyingEdges3D without normals and gradients.
 */
vtkSmartPointer<vtkPolyData> FlyingEdges(vtkImageData* image, double value);
}

#endif
