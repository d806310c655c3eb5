// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTetrahedra_h
#define ReferenceTetrahedra_h

#include "Mesh/TetrahedraMesh.h"

#include <array>      // for points
#include <functional> // for shapes
#include <string>     // for names

namespace reference
{

/// Settings of a tetrahedral mesh that is built from a grid of cubes.
struct CubeMeshSettings
{
  /// Number of cubes along each edge of [-0.5, 0.5]^3.
  int Cubes = 8;
  /// Number of tetrahedra per cube: 5 (mirrored in adjacent cubes) or 6 (around a diagonal).
  int Pieces = 6;
  /// Maximum displacement of interior points along each axis, as a fraction of a cube's edge.
  double Jitter = 0.0;
  unsigned int Seed = 1;
  /// Returns whether the cube with this center is part of the mesh. If empty, all cubes are.
  std::function<bool(const std::array<double, 3>&)> IsIn;
};

interlume::TetrahedraMesh MakeCubeMesh(const CubeMeshSettings& form);

/// Moves each point inside [-0.5, 0.5]^3 \a rounds times, by up to \a reach along each axis. Moves
/// that invert a tetrahedron are undone. The result is a valid mesh with long, thin tetrahedra.
void Distort(interlume::TetrahedraMesh& mesh, double reach, int rounds, unsigned int seed);

/// Returns the Delaunay tetrahedra of random points in a cube, computed by vtkDelaunay3D. The
/// boundary is not quite convex.
interlume::TetrahedraMesh MakeDelaunay(int points, unsigned int seed);

/// Returns a copy of \a mesh in which tetrahedra do not share points.
interlume::TetrahedraMesh SeparateTetrahedra(const interlume::TetrahedraMesh& mesh);
/// Appends a tetrahedron with four new points. Returns its index.
std::uint32_t Append(
  interlume::TetrahedraMesh& mesh, const std::array<std::array<double, 3>, 4>& corners);
/// Returns \a mesh with its tetrahedra, and the corners of each tetrahedron, in random order.
interlume::TetrahedraMesh Shuffle(const interlume::TetrahedraMesh& mesh, unsigned int seed);

/// A named region that is not convex or has several components.
struct Shape
{
  std::string Name;
  std::function<bool(const std::array<double, 3>&)> IsIn;
  /// A point in a hole of the region.
  std::array<double, 3> Hole;
};
std::vector<Shape> GetShapes();

}

#endif
