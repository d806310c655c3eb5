// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowGrid_h
#define ReferenceFlowGrid_h

#include "Support/Arrays/ReferenceVector.h" // for arithmetic
#include "Support/Checks/ReferenceRandom.h" // for the samples
#include "Support/Meshes/ReferenceMesh.h"   // for MeshKind

#include "vtkSmartPointer.h" // for the grids
#include "vtkType.h"         // for ids

#include <array>      // for vectors
#include <functional> // for the fields
#include <string>     // for the names of grids
#include <utility>    // for grids with names
#include <vector>     // for lists of grids

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkPointSet;
class vtkStructuredGrid;
class vtkTerminationPlane;
class vtkUnstructuredGrid;

/**
 * Grids and velocity fields for flow tests, and samples interpolated by VTK's cell classes.
 */
namespace reference
{

using Vector = std::array<double, 3>;
using VectorField = std::function<Vector(const Vector&)>;

/// Returns A x + b, where the rows of the matrix A are linearly independent.
Vector GetLinearVector(const Vector& x);
/// Returns the matrix A of GetLinearVector() in row-major order.
std::array<double, 9> GetLinearGradient();

/// Adds the three-component point array "velocity" with the values of a field at the points, and
/// makes it the active vectors.
vtkSmartPointer<vtkDataArray> AddVectors(
  vtkDataSet* data, const VectorField& field, int type = VTK_DOUBLE);
/// Like AddVectors(), but with random vector components from -1 to 1.
vtkSmartPointer<vtkDataArray> AddRandomVectors(
  vtkDataSet* data, unsigned int seed, int type = VTK_DOUBLE);

/// Moves every point x to position(x).
void MovePoints(vtkPointSet* grid, const VectorField& position);

/// Returns a map that displaces interior points of the box from 0 to \a cells by at most \a bend
/// along each axis. Points on the boundary stay in place.
VectorField MakeDisplacement(const std::array<int, 3>& cells, double bend);

/// Returns a grid of unit cubes that fills the box from 0 to \a cells.
vtkSmartPointer<vtkStructuredGrid> MakeStructuredGrid(const std::array<int, 3>& cells);

/// Returns a ring around the z-axis: i runs outward from radius 1 to 2, j around the axis, k along
/// the axis. The points of the seam are duplicated.
vtkSmartPointer<vtkStructuredGrid> MakeRing(const std::array<int, 3>& cells);

/// Returns the mesh kinds for which MakeFlowMesh() returns only tetrahedra, voxels, hexahedra,
/// wedges and pyramids.
const std::vector<MeshKind>& FlowMeshKinds();
/// Returns the mesh of MakeMesh() with polyhedra converted to wedges and voxels. If \a hasVoxels is
/// false, hexahedra replace all voxels.
vtkSmartPointer<vtkUnstructuredGrid> MakeFlowMesh(
  MeshKind kind, const std::array<int, 3>& cells, bool hasVoxels = true, unsigned int seed = 1);

/// Returns an image, a rectilinear grid, a structured grid with displaced interior points, and a
/// mesh of each kind in FlowMeshKinds(), each with a name. All cover the cube from 0 to 4 with 5
/// points along each axis.
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> MakeFlowGrids();

/// Returns an image of points^3 points over the cube from 0 to 4, with \a field sampled by
/// AddVectors().
vtkSmartPointer<vtkImageData> MakeFlowImage(int points, const VectorField& field);

/// Returns the square in the plane x = \a position with y and z from 0 to 4, u along y and v along
/// z.
vtkSmartPointer<vtkTerminationPlane> MakeFlowPlane(double position);

/// A position in a cell, with the velocity and velocity gradient that VTK's cell classes return
/// there.
struct CellSample
{
  vtkIdType Cell;
  Vector Position;
  Vector Velocity;
  /// Entry 3 i + j is dv_i/dx_j.
  std::array<double, 9> Gradient;
};
/// Returns a sample at a random position in a cell, at least 1 % of the cell width away from its
/// faces. The gradient is 0 unless \a hasGradient is true.
CellSample SampleCell(vtkDataSet* data, vtkDataArray* vectors, vtkIdType cell, Random& random,
  bool hasGradient = false);

}

#endif
