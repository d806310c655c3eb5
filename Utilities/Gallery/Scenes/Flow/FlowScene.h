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
#include <limits>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkFlowVolume;
class vtkTerminationSurface;
class vtkTexture;
class vtkVolume;

/**
 * Implicit flow fields, and what is drawn of them.
 */
namespace gallery
{
/**
 * Points of an image along the axes, and its bounds.
 */
struct FlowLattice
{
  std::array<int, 3> Dimensions;
  std::array<double, 6> Bounds;
};

/**
 * One of the fields of vtkAnalyticFlowSource on a lattice.
 */
vtkSmartPointer<vtkAnalyticFlowSource> MakeAnalyticFlow(int field, const FlowLattice& lattice);

/**
 * A hurricane around the z axis, as high as its lattice.
 */
vtkSmartPointer<vtkAnalyticFlowSource> MakeUprightHurricane();

/**
 * The points of a lattice advected back to the first of the surfaces that they meet, through the
 * active vectors of \a field, for no more than \a time.
 */
vtkSmartPointer<vtkDataSet> MakeImplicitFlow(vtkAlgorithm* field,
  const std::vector<vtkTerminationSurface*>& surfaces, const FlowLattice& samples,
  double time = std::numeric_limits<double>::max());

/**
 * The same with the points of a dataset as samples.
 */
vtkSmartPointer<vtkDataSet> MakeImplicitFlow(vtkAlgorithm* field,
  const std::vector<vtkTerminationSurface*>& surfaces, vtkDataSet* samples,
  double time = std::numeric_limits<double>::max());

/**
 * \a flow with the inflow of a formula of u, v and f, the surface's id.
 */
vtkSmartPointer<vtkDataSet> MapInflow(vtkDataSet* flow, const std::string& formula);

/**
 * The square with this middle, u along \a u and v along \a v, which are from its middle to its
 * edges.
 */
vtkSmartPointer<vtkTerminationPlane> MakeInflowPlane(const std::array<double, 3>& middle,
  const std::array<double, 3>& u, const std::array<double, 3>& v);

/// Ports of vtkFlowVolume.
constexpr int STREAM_SURFACES = 1;
constexpr int TIME_SURFACES = 2;

/**
 * Of the stream or the time surfaces of \a filter the one with this id.
 */
vtkSmartPointer<vtkUnstructuredGrid> GetFlowSurface(vtkFlowVolume* filter, int port, int id);

/**
 * An opaque surface of one colour, with its own normals, not those of its triangles.
 */
vtkSmartPointer<vtkActor> MakeFlowActor(vtkUnstructuredGrid* surface, const vtkColor3d& colour);

/**
 * An opaque surface with a texture over its active texture coordinates.
 */
vtkSmartPointer<vtkActor> MakeFlowActor(vtkUnstructuredGrid* surface, vtkTexture* texture);

/**
 * A termination surface with a texture over its parameters.
 */
vtkSmartPointer<vtkActor> MakeTerminationActor(vtkTerminationSurface* surface, vtkTexture* texture);

/**
 * A ball for orientation.
 */
vtkSmartPointer<vtkActor> MakeBall(
  const std::array<double, 3>& center, double radius, const vtkColor3d& colour);

/**
 * An upright cylinder for orientation, from \a bottom to \a top along the z axis.
 */
vtkSmartPointer<vtkActor> MakePillar(
  double radius, double bottom, double top, const vtkColor3d& colour);

/**
 * Gives stream surfaces texture coordinates for MakeStreamlineTexture(): the parameter \a component
 * (0 for u, 1 for v) times \a lines, and the middle of the surface's part of \a number equal ones.
 */
void SetStreamlineCoordinates(vtkUnstructuredGrid* surfaces, int component, int lines, int number);

/**
 * Draws translucent surfaces, whose points are those of the tetrahedra, with a texture between the
 * parts of the volume.
 */
void SetTexturedBoundary(vtkVolume* volume, vtkUnstructuredGrid* surfaces, vtkTexture* texture);
}

#endif
