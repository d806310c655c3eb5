// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowScene_h
#define FlowScene_h

#include "vtkActor.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkColor.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkTerminationPlane.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkFlowVolume;
class vtkStructuredGrid;
class vtkTerminationSurface;
class vtkTexture;
class vtkVolume;

/**
 * Support for flow scenes: implicit flow fields, actors and volumes.
 */
namespace gallery
{
class Panel;

/**
 * A regular grid: number of points along each axis, and bounds.
 */
struct FlowGrid
{
  std::array<int, 3> Dimensions;
  std::array<double, 6> Bounds;
};

/**
 * Returns a source of the analytic flow \a field (see vtkAnalyticFlowSource::Fields) on \a grid.
 */
vtkSmartPointer<vtkAnalyticFlowSource> MakeAnalyticFlow(int field, const FlowGrid& grid);

/**
 * Rings of points around the axis of a vortex.
 */
struct RingGrid
{
  /// Number of points along the radius, around the axis, and along the axis.
  std::array<int, 3> Dimensions;
  /// z of the lowest and the highest ring.
  std::array<double, 2> Heights;
  /// Angles of the first and the last point of a ring, counterclockwise from the x axis. 1 is a
  /// full turn.
  std::array<double, 2> Turns;
  /// Radius of a ring. \a outward is 0 for the innermost ring and 1 for the outermost ring.
  std::function<double(double outward, double z)> Radius;
};

/**
 * Returns the point at height \a z on the axis of a hurricane or tornado.
 */
std::array<double, 3> GetVortexAxisPoint(vtkAnalyticFlowSource* vortex, double z);

/**
 * Returns rings around the axis of \a vortex, a hurricane or tornado, or around the z axis if
 * \a vortex is null. The rings match the flow better than a regular grid, and the boundary of the
 * samples is smooth.
 */
vtkSmartPointer<vtkStructuredGrid> MakeRings(vtkAnalyticFlowSource* vortex, const RingGrid& grid);

/**
 * Returns rings around the z axis whose radii follow arcs from z = -0.5 to 0.5, like the flow
 * between two charges. \a dimensions and \a turns are as in RingGrid.
 */
vtkSmartPointer<vtkStructuredGrid> MakeArcs(
  const std::array<int, 3>& dimensions, const std::array<double, 2>& turns);

/**
 * Returns a hurricane whose axis is z. The grid covers its full height.
 */
vtkSmartPointer<vtkAnalyticFlowSource> MakeUprightHurricane();

/**
 * Traces the points of a grid backward through the active vectors of \a field, to the first of
 * \a surfaces that each streamline reaches. \a time is the maximum advection time.
 */
vtkSmartPointer<vtkDataSet> MakeImplicitFlow(vtkAlgorithm* field,
  const std::vector<vtkTerminationSurface*>& surfaces, const FlowGrid& samples,
  double time = std::numeric_limits<double>::max());

/**
 * As above, but traces the points of the dataset \a samples.
 */
vtkSmartPointer<vtkDataSet> MakeImplicitFlow(vtkAlgorithm* field,
  const std::vector<vtkTerminationSurface*>& surfaces, vtkDataSet* samples,
  double time = std::numeric_limits<double>::max());

/**
 * Returns \a flow with inflow values from a formula of u, v and f. f is the id of the termination
 * surface.
 */
vtkSmartPointer<vtkDataSet> MapInflow(vtkDataSet* flow, const std::string& formula);

/**
 * Returns a rectangle. \a u and \a v are the vectors from \a center to the midpoints of two edges,
 * in the directions of the parameters u and v.
 */
vtkSmartPointer<vtkTerminationPlane> MakeInflowPlane(const std::array<double, 3>& center,
  const std::array<double, 3>& u, const std::array<double, 3>& v);

/// Ports of vtkFlowVolume.
constexpr int STREAM_SURFACES = 1;
constexpr int TIME_SURFACES = 2;

/**
 * Returns the surface \a id of \a filter. \a port selects stream surfaces or time surfaces.
 */
vtkSmartPointer<vtkUnstructuredGrid> GetFlowSurface(vtkFlowVolume* filter, int port, int id);

/**
 * As above, with normals from the gradient that AddGradient() added to the input of \a filter.
 * These are smoother than the normals of \a filter, but do not take termination surfaces into
 * account.
 */
vtkSmartPointer<vtkUnstructuredGrid> GetSmoothFlowSurface(vtkFlowVolume* filter, int port, int id);

/**
 * Returns an opaque actor of one color. It uses the point normals of \a surface.
 */
vtkSmartPointer<vtkActor> MakeFlowActor(vtkUnstructuredGrid* surface, const vtkColor3d& color);

/**
 * Returns an opaque actor with \a texture, which uses the active texture coordinates of \a surface.
 */
vtkSmartPointer<vtkActor> MakeFlowActor(vtkUnstructuredGrid* surface, vtkTexture* texture);

/**
 * Returns an actor of a termination surface. The texture coordinates are the parameters of the
 * surface.
 */
vtkSmartPointer<vtkActor> MakeTerminationActor(vtkTerminationSurface* surface, vtkTexture* texture);

vtkSmartPointer<vtkActor> MakeSphere(
  const std::array<double, 3>& center, double radius, const vtkColor3d& color);

/**
 * Returns an upright cylinder around the z axis, from z = \a bottom to \a top.
 */
vtkSmartPointer<vtkActor> MakePillar(
  double radius, double bottom, double top, const vtkColor3d& color);

/**
 * Replaces the lights of \a panel with lights from the camera and from all sides, so that the
 * undersides of surfaces are not dark. The lights move with the camera.
 */
void LightFromAllSides(Panel& panel);

/**
 * Draws translucent textured surfaces inside the volume. The surfaces must share the points of the
 * tetrahedra. textures[i] applies to triangles whose cell array \a ids is i; null hides them.
 */
void SetTexturedBoundary(vtkVolume* volume, vtkUnstructuredGrid* surfaces, const char* ids,
  const std::vector<vtkSmartPointer<vtkTexture>>& textures);
}

#endif
