// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMeshing_h
#define ReferenceMeshing_h

#include "vtkSmartPointer.h" // for the meshes
#include "vtkType.h"         // for vtkIdType

#include <array> // for the blocks

class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * Measurements of tetrahedral meshes, and inputs for mesh generation, independent of the code under
 * test.
 */
namespace reference
{

/// Properties of a tetrahedral mesh: exact counts, and volumes in long double.
struct TetrahedraReport
{
  vtkIdType Tetrahedra = 0;
  vtkIdType NotPositive = 0;   ///< tetrahedra whose volume is not positive
  vtkIdType FacesOnce = 0;     ///< faces of a single tetrahedron: the boundary
  vtkIdType FacesTooOften = 0; ///< faces of more than two tetrahedra
  vtkIdType FacesTurned = 0;   ///< faces that two tetrahedra use with the same orientation
  vtkIdType UnusedPoints = 0;
  long double Volume = 0;
  long double BoundaryVolume = 0; ///< enclosed by the faces that occur once
  double LargestVolume = 0;
  double LargestRadiusEdgeRatio = 0;
};
TetrahedraReport Inspect(vtkUnstructuredGrid* grid);

/// Returns the volume enclosed by a closed surface of consistently oriented polygons, which are
/// split into triangle fans from their first points.
long double EnclosedVolume(vtkPolyData* surface);

/// Returns the largest difference between a point array and \a function, relative to the largest
/// magnitude of the function. Returns infinity if the array is missing.
double LinearError(vtkDataSet* data, const char* array, const struct LinearFunction& function);

/**
 * Returns a mesh of (2 * blocks[0]) x (2 * blocks[1]) x blocks[2] boxes of size 1. In every block
 * of 2 x 2 boxes, three boxes form a concave VTK_POLYHEDRON whose bottom and top are concave
 * polygons of eight points. The fourth box alternates between a hexahedron, two wedges, and six
 * pyramids. Interior points are moved by up to \a shift along each axis, so faces are not planar.
 * The cell array `kind` is 0 for polyhedra and 1 for other cells. Neighboring polyhedra list the
 * points of a common face starting from different points.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeConcaveMesh(
  const std::array<int, 3>& blocks, double shift, unsigned int seed = 1);

/// Appends the closed surface of the box from \a low to \a high, made of quadrilaterals. With \a
/// inward, the normals point inward.
void AppendBox(vtkPolyData* surface, const std::array<double, 3>& low,
  const std::array<double, 3>& high, bool inward = false);
vtkSmartPointer<vtkPolyData> MakeEmptySurface();

/// Returns a sphere of radius 1: an icosahedron in which each triangle is split into four, \a
/// levels times.
vtkSmartPointer<vtkPolyData> MakeGeodesicSphere(int levels);

/// Returns a torus around the z-axis with radii 1 and 0.4, made of 2 * \a around * \a across
/// triangles with outward normals.
vtkSmartPointer<vtkPolyData> MakeTorus(int around, int across);

}

#endif
