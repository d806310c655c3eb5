#ifndef Props_h
#define Props_h

#include "vtkColor.h"
#include "vtkSmartPointer.h"
#include "vtkVector.h"

#include <string>

class vtkActor;
class vtkDataSet;
class vtkImageData;
class vtkPolyData;
class vtkScalarsToColors;
class vtkStructuredGrid;
class vtkUnstructuredGrid;

/**
 * What scenes put on stage: surfaces of extracted tetrahedra, boundary triangles, walls.
 */
namespace gallery
{
/**
 * The tetrahedra or triangles with cell array `IntervalId` equal to \a id.
 */
vtkSmartPointer<vtkUnstructuredGrid> SelectInterval(vtkUnstructuredGrid* grid, int id);

/**
 * The triangles with cell array `BoundarySide` equal to \a side (vtkIntervalVolume::BoundarySides).
 */
vtkSmartPointer<vtkUnstructuredGrid> SelectSide(vtkUnstructuredGrid* triangles, int side);

/**
 * The outer surface of \a cells with point normals; sharper edges than \a featureAngle degrees stay
 * sharp.
 */
vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataSet* cells, double featureAngle = 50.0);

/**
 * A smoothly shaded actor of one colour; \a opacity 0 to 1.
 */
vtkSmartPointer<vtkActor> MakeActor(
  vtkPolyData* surface, const vtkColor3d& colour, double opacity = 1.0);

/**
 * A smoothly shaded actor coloured by point array \a array.
 */
vtkSmartPointer<vtkActor> MakeColouredActor(
  vtkPolyData* surface, const std::string& array, vtkScalarsToColors* colours);

/**
 * Makes \a actor glossy, with white highlights.
 */
void SetGlossy(vtkActor* actor);

/**
 * Makes a translucent \a actor more opaque towards its silhouette, so that shells read as shells.
 */
void SetGlass(vtkActor* actor);

/**
 * Point normals of one side of an interval (vtkIntervalVolume::BoundarySides) from the gradient of
 * the field, smoother than those of the triangles; AddGradient() was applied before the extraction.
 */
void SetGradientNormals(vtkPolyData* surface, int side);

/**
 * \a data with the gradient of its active point scalars as point array `Gradient`.
 */
vtkSmartPointer<vtkDataSet> AddGradient(vtkDataSet* data);

/**
 * \a data with the length of a vector as point array \a magnitude.
 */
vtkSmartPointer<vtkDataSet> AddMagnitude(
  vtkDataSet* data, const std::string& vectors, const std::string& magnitude);

/**
 * \a surface and its image in the plane y = 0, for data that stop at their plane of symmetry.
 */
vtkSmartPointer<vtkPolyData> AddMirrorImage(vtkPolyData* surface);

/**
 * \a data without the part where both a point's offset from \a origin along \a first and along
 * \a second are positive: a wedge cut out to look inside.
 */
vtkSmartPointer<vtkUnstructuredGrid> CutOut(
  vtkDataSet* data, const vtkVector3d& origin, const vtkVector3d& first, const vtkVector3d& second);

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
