// SPDX-License-Identifier: BSD-3-Clause
#ifndef TexturedSurface_h
#define TexturedSurface_h

#include "vtkActor.h"
#include "vtkColor.h"
#include "vtkDataSet.h"
#include "vtkInflowMapping.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamlineTexture.h"
#include "vtkTerminationSurface.h"
#include "vtkUnstructuredGrid.h"

#include <array>

/**
 * Stream surfaces with lines on them, in the flow of a tornado.
 */
namespace gallery
{
/**
 * An implicit flow field with its inflow, and where both come from.
 */
struct MappedFlow
{
  vtkSmartPointer<vtkDataSet> Samples;
  vtkSmartPointer<vtkInflowMapping> Mapping;
  vtkSmartPointer<vtkTerminationSurface> Surface;
  /// Around the surface.
  double Length;
};

/**
 * A tornado's flow, as an implicit flow field back to a cylinder around it, for no more than \a
 * time; the inflow is the height there. Stream surfaces are funnels, one for each height.
 */
MappedFlow MakeTornado(double time);

/**
 * The stream surface of \a samples at this inflow, of streamlines from \a start to \a end of the
 * time since the termination surface.
 */
vtkSmartPointer<vtkPolyData> MakeStreamSurface(
  vtkDataSet* samples, double inflow, double start, double end);

/**
 * The same with texture coordinates: the length along the line where it flows in, 1 for all
 * around, and the time, 1 for \a period.
 */
vtkSmartPointer<vtkPolyData> MakeTexturedSurface(
  const MappedFlow& flow, double inflow, double start, double end, double period);

/**
 * The tetrahedra between two such surfaces.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeStreamVolume(
  vtkDataSet* samples, double lower, double upper, double start, double end);

/**
 * Streamlines by the length, or timelines by the time; \a texels is how far apart they are, in
 * pixels of a picture that is drawn at twice its size.
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
