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
class vtkScalarsToColors;
class vtkStructuredGrid;

/**
 * What scenes put on stage: surfaces of extracted tetrahedra, boundary triangles, walls.
 */
namespace gallery
{
/**
 * The cells of \a triangles with cell array \a array equal to \a value, over the points of all.
 */
vtkSmartPointer<vtkUnstructuredGrid> SelectTriangles(
  vtkUnstructuredGrid* triangles, const std::string& array, int value);

/**
 * The boundary triangles of an extraction with cell array `BoundarySide` equal to \a side
 * (vtkIntervalVolume::BoundarySides), over the points of all. Point normals come from the gradient
 * of the field, smoother than those of the triangles; AddGradient() was applied before the
 * extraction.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeBoundary(vtkIntervalVolume* filter, int side);

/**
 * The outer surface of \a cells with point normals; sharper edges than \a featureAngle degrees stay
 * sharp.
 */
vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataSet* cells, double featureAngle = 50.0);

/**
 * A smoothly shaded actor of one colour.
 */
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* surface, const vtkColor3d& colour);

/**
 * A smoothly shaded actor coloured by point array \a array.
 */
vtkSmartPointer<vtkActor> MakeColouredActor(
  vtkPolyData* surface, const std::string& array, vtkScalarsToColors* colours);

/**
 * \a data with the gradient of point array \a array as point array `Gradient`.
 */
vtkSmartPointer<vtkDataSet> AddGradient(vtkDataSet* data, const std::string& array);

/**
 * \a data with the length of a vector as point array \a magnitude.
 */
vtkSmartPointer<vtkDataSet> AddMagnitude(
  vtkDataSet* data, const std::string& vectors, const std::string& magnitude);

/**
 * One grid surface of a structured grid, \a axis 0 to 2 at \a index: a wall for orientation.
 */
vtkSmartPointer<vtkPolyData> MakeWall(vtkStructuredGrid* grid, int axis, int index);

/**
 * \a image with the cells hidden that lie where both x < \a x and y < \a y: a quarter taken away to
 * look inside.
 */
vtkSmartPointer<vtkImageData> HideQuarter(vtkImageData* image, double x, double y);

/**
 * \a image with each axis reduced by \a factor, each value the mean of its block.
 */
vtkSmartPointer<vtkImageData> Reduce(vtkImageData* image, int factor);
}

#endif
