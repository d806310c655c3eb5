#ifndef TexturedSurface_h
#define TexturedSurface_h

#include "vtkColor.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkActor;
class vtkDataSet;
class vtkPolyData;
class vtkStreamlineTexture;
class vtkUnstructuredGrid;

/**
 * Stream surfaces with lines on them, in the flow of a tornado.
 */
namespace gallery
{
/**
 * A tornado's flow, as an implicit flow field back to a cylinder around it: u the angle there, v
 * the height, which is the inflow. Stream surfaces are funnels, one for each height.
 */
vtkSmartPointer<vtkDataSet> MakeTornado();

/**
 * The stream surface of \a flow at this inflow, of streamlines from \a start to \a end of the time
 * since the termination surface. Texture coordinates: u, and the time, 1 for \a period.
 */
vtkSmartPointer<vtkPolyData> MakeStreamSurface(
  vtkDataSet* flow, double inflow, double start, double end, double period);

/**
 * The tetrahedra between two such surfaces.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeStreamVolume(
  vtkDataSet* flow, double lower, double upper, double start, double end);

/**
 * Streamlines by u, or timelines by the time; \a texels is how far apart they are, in pixels of a
 * picture that is drawn at twice its size.
 */
vtkSmartPointer<vtkStreamlineTexture> MakeStreamlines(int texels, const vtkColor3d& colour);
vtkSmartPointer<vtkStreamlineTexture> MakeTimelines(int texels, const vtkColor3d& colour);

/**
 * A surface of one colour with lines on it; one of both may be null.
 */
vtkSmartPointer<vtkActor> MakeLinedActor(vtkPolyData* surface, const vtkColor3d& colour,
  vtkStreamlineTexture* streamlines, vtkStreamlineTexture* timelines);

/**
 * Draws only what is on the side of the plane through the origin that \a normal points to.
 */
void CutOpen(vtkActor* actor, const std::array<double, 3>& normal);
}

#endif
