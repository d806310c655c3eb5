// SPDX-License-Identifier: BSD-3-Clause
#ifndef Props_h
#define Props_h

#include "vtkActor.h"
#include "vtkColor.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>

class vtkIntervalVolume;
class vtkPointData;
class vtkScalarsToColors;
class vtkStructuredGrid;

/**
 * Functions that create actors, surfaces and data for scenes.
 */
namespace gallery
{
/**
 * Returns those cells of \a triangles for which the cell array \a array equals \a value. All points
 * are retained.
 */
vtkSmartPointer<vtkUnstructuredGrid> SelectTriangles(
  vtkUnstructuredGrid* triangles, const std::string& array, int value);

/**
 * Computes point normals from the gradient that AddGradient() added to the input of an extraction.
 * On the LOWER_SIDE of an interval (see vtkIntervalVolume::BoundarySides), the normals point
 * against the gradient.
 */
void SetGradientNormals(vtkPointData* pointData, int side);

/**
 * Returns the boundary triangles of an extraction for which the cell array `BoundarySide` equals
 * \a side (see vtkIntervalVolume::BoundarySides). All points are retained. Point normals are
 * computed from the gradient of the field, since they are smoother than triangle normals. The input
 * of the extraction must be a result of AddGradient().
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeBoundary(vtkIntervalVolume* filter, int side);

/**
 * Returns the outer surface of \a cells with point normals. Edges sharper than \a featureAngle
 * degrees remain sharp.
 */
vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataSet* cells, double featureAngle = 50.0);

/**
 * Returns an actor of one color with smooth shading.
 */
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* surface, const vtkColor3d& color);

/**
 * Returns an actor with smooth shading, colored by the point array \a array.
 */
vtkSmartPointer<vtkActor> MakeColoredActor(
  vtkPolyData* surface, const std::string& array, vtkScalarsToColors* colors);

/**
 * Returns a copy of \a data with an additional point array `Gradient`, the gradient of the point
 * array \a array.
 */
vtkSmartPointer<vtkDataSet> AddGradient(vtkDataSet* data, const std::string& array);

/**
 * Returns the grid surface with the index \a index along \a axis (0 to 2), such as a wall.
 */
vtkSmartPointer<vtkPolyData> MakeGridSurface(vtkStructuredGrid* grid, int axis, int index);

/**
 * Returns a copy of \a image in which the cells below both \a x and \a y are hidden. This cuts a
 * quarter out of the image.
 */
vtkSmartPointer<vtkImageData> HideQuarter(vtkImageData* image, double x, double y);

/**
 * Returns \a image reduced by \a factor along each axis. Each value is the mean of its block.
 */
vtkSmartPointer<vtkImageData> Reduce(vtkImageData* image, int factor);
}

#endif
