// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTetrahedra_h
#define ReferenceTetrahedra_h

#include "Mesh/TetrahedraMesh.h"

#include <array>      // for points
#include <functional> // for shapes
#include <string>     // for names

namespace reference
{

/// How a lattice of cubes becomes tetrahedra.
struct CubeMesh
{
  /// Cubes along each edge of [-0.5, 0.5]^3.
  int Cubes = 8;
  /// Tetrahedra of a cube: 5, mirrored from cube to cube, or 6 about a diagonal.
  int Pieces = 6;
  /// How far inner points may be moved, in parts of a cube's edge.
  double Jitter = 0.0;
  unsigned int Seed = 1;
  /// Whether a cube with this centre is there; all where empty.
  std::function<bool(const std::array<double, 3>&)> IsIn;
};

interlume::TetrahedraMesh MakeCubes(const CubeMesh& form);

/// Moves points within [-0.5, 0.5]^3, \a rounds times each and as far as \a reach along each axis
/// at once, wherever no tetrahedron turns inside out: a valid mesh of long and thin tetrahedra.
void Distort(interlume::TetrahedraMesh& mesh, double reach, int rounds, unsigned int seed);

/// The Delaunay tetrahedra of random points in a cube, as vtkDelaunay3D has them: its outside is
/// not quite convex.
interlume::TetrahedraMesh MakeDelaunay(int points, unsigned int seed);

/// The same tetrahedra, each with four points of its own.
interlume::TetrahedraMesh Separate(const interlume::TetrahedraMesh& mesh);
/// Appends a tetrahedron with four points of its own; returns its number.
std::uint32_t Append(
  interlume::TetrahedraMesh& mesh, const std::array<std::array<double, 3>, 4>& corners);
/// The same tetrahedra in another sequence and with other corners first.
interlume::TetrahedraMesh Shuffle(const interlume::TetrahedraMesh& mesh, unsigned int seed);

/// Shapes that are not convex, or of several pieces, by name.
struct Shape
{
  std::string Name;
  std::function<bool(const std::array<double, 3>&)> IsIn;
  /// A place in a hole of it.
  std::array<double, 3> Hole;
};
std::vector<Shape> GetShapes();

}

#endif
