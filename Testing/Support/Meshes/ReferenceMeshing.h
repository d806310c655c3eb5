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
 * Measures of a mesh of tetrahedra and inputs for a mesher, made without the code under test.
 */
namespace reference
{

/// What a mesh of tetrahedra is like, in exact counts and in long double.
struct TetrahedraReport
{
  vtkIdType Tetrahedra = 0;
  vtkIdType NotPositive = 0;   ///< tetrahedra whose volume is not above 0
  vtkIdType FacesOnce = 0;     ///< faces of one tetrahedron: the boundary
  vtkIdType FacesTooOften = 0; ///< faces of more than two
  vtkIdType FacesTurned = 0;   ///< faces that both tetrahedra have on the same side
  vtkIdType UnusedPoints = 0;
  long double Volume = 0;
  long double BoundaryVolume = 0; ///< within the faces that occur once
  double LargestVolume = 0;
  double LargestRadiusEdgeRatio = 0;
};
TetrahedraReport Inspect(vtkUnstructuredGrid* grid);

/// The volume within a closed surface of consistently oriented polygons: fans from their first
/// points.
long double EnclosedVolume(vtkPolyData* surface);

/// The largest difference between a point array and what \a function says, in parts of the
/// array's largest magnitude; infinity where the array is missing.
double LinearError(vtkDataSet* data, const char* array, const struct LinearFunction& function);

/**
 * A block of 2 blocks[0] x 2 blocks[1] x blocks[2] boxes of size 1. In every block of 2 x 2 boxes
 * three are one concave VTK_POLYHEDRON, whose bottom and top are concave polygons of eight points;
 * the fourth is a hexahedron, two wedges, six pyramids or six tetrahedra in turn. Inner points are
 * moved by up to \a shift, so that no face stays planar. Cell array `kind`: 0 polyhedron, 1 other.
 * Each polyhedron lists its faces from other starts than its neighbours.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeConcaveMesh(
  const std::array<int, 3>& blocks, double shift, unsigned int seed = 1);

/// A closed surface of the box from \a low to \a high, of quads. With \a inward they face inside.
void AppendBox(vtkPolyData* surface, const std::array<double, 3>& low,
  const std::array<double, 3>& high, bool inward = false);
vtkSmartPointer<vtkPolyData> MakeBoxes();

/// A sphere of radius 1: an icosahedron whose triangles are cut in four \a levels times.
vtkSmartPointer<vtkPolyData> MakeGeodesic(int levels);

/// A torus of radii 1 and 0.4 around z, of 2 \a around x \a across triangles that face outward.
vtkSmartPointer<vtkPolyData> MakeTorus(int around, int across);

}

#endif
