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
#include <vector>

/**
 * Stream surfaces with streamlines and timelines, in the flow of a tornado.
 */
namespace gallery
{
/**
 * An implicit flow field with inflow values, and its mapping and termination surface.
 */
struct MappedFlow
{
  vtkSmartPointer<vtkDataSet> Samples;
  vtkSmartPointer<vtkInflowMapping> Mapping;
  vtkSmartPointer<vtkTerminationSurface> Surface;
  /// Arc length at which the first texture coordinate is 1, for example a circumference.
  double Length;
  /// The arc length starts near these points. If there are none, its start is arbitrary.
  std::vector<std::array<double, 3>> StartPoints = {};
};

/**
 * Returns the flow of a tornado, traced back to a cylinder around it for at most \a time. The
 * inflow value is the height on the cylinder. Stream surfaces are funnels. \a fineness multiplies
 * the number of samples along each axis.
 */
MappedFlow MakeTornado(double time, int fineness = 1);

/**
 * Returns the stream surface with inflow value \a inflow, between the advection times \a start and
 * \a end.
 */
vtkSmartPointer<vtkPolyData> MakeStreamSurface(
  vtkDataSet* samples, double inflow, double start, double end);

/**
 * As above, with texture coordinates: the arc length along the inflow curve divided by
 * MappedFlow::Length, and the advection time divided by \a period.
 */
vtkSmartPointer<vtkPolyData> MakeTexturedSurface(
  const MappedFlow& flow, double inflow, double start, double end, double period);

/**
 * Returns the tetrahedra between the stream surfaces at two inflow values.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeStreamVolume(
  vtkDataSet* samples, double lower, double upper, double start, double end);

/**
 * Return textures of streamlines (lines of constant arc length) and of timelines (lines of constant
 * time). \a texels is the approximate distance between lines in pixels of the supersampled image.
 * \a lines, a power of two, is the maximum number of lines per unit of the texture coordinate.
 */
vtkSmartPointer<vtkStreamlineTexture> MakeArcLengthTexture(
  int texels, const vtkColor3d& color, int lines = 128);
vtkSmartPointer<vtkStreamlineTexture> MakeTimelineTexture(
  int texels, const vtkColor3d& color, int lines = 128);

/**
 * Returns an actor of one color with streamlines, timelines, or both. One of the two textures may
 * be null.
 */
vtkSmartPointer<vtkActor> MakeActorWithLines(vtkPolyData* surface, const vtkColor3d& color,
  vtkStreamlineTexture* streamlines, vtkStreamlineTexture* timelines);

/**
 * Clips the actor with the plane through the origin whose normal is \a normal.
 */
void ClipActor(vtkActor* actor, const std::array<double, 3>& normal);
}

#endif
