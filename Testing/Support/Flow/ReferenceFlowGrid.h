// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlowGrid_h
#define ReferenceFlowGrid_h

#include "Support/Arrays/ReferenceVector.h" // for arithmetic
#include "Support/Checks/ReferenceRandom.h" // for the samples
#include "Support/Meshes/ReferenceMesh.h"   // for the kinds

#include "vtkSmartPointer.h" // for the grids
#include "vtkType.h"         // for ids

#include <array>      // for places
#include <functional> // for the fields
#include <string>     // for the names of grids
#include <utility>    // for grids with names
#include <vector>     // for the list of kinds

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkPointSet;
class vtkStructuredGrid;
class vtkTerminationPlane;
class vtkUnstructuredGrid;

/**
 * Grids and vectors for flow, and what VTK's own cells say of them.
 */
namespace reference
{

using Vector = std::array<double, 3>;
using VectorField = std::function<Vector(const Vector&)>;

/// v = A x + b with rows of A that are not alike.
Vector GetLinearVector(const Vector& x);
/// Its A, row by row.
std::array<double, 9> GetLinearGradient();

/// A point array of three components, of the type, with the values of a field; active vectors.
vtkSmartPointer<vtkDataArray> AddVectors(
  vtkDataSet* data, const VectorField& field, int type = VTK_DOUBLE);
/// The same with random numbers from -1 to 1.
vtkSmartPointer<vtkDataArray> AddRandomVectors(
  vtkDataSet* data, unsigned int seed, int type = VTK_DOUBLE);

/// Moves every point.
void MovePoints(vtkPointSet* grid, const VectorField& place);

/// Points in the box of \a sizes are moved by up to \a bend of a cell, those on its sides not.
VectorField MakeBend(const std::array<int, 3>& cells, double bend);

/// Cells of width 1, in the box from 0 to \a cells.
vtkSmartPointer<vtkStructuredGrid> MakeStructuredGrid(const std::array<int, 3>& cells);

/// A ring around z, i outward from 1 to 2, j around, k along; the seam's points are
/// there twice.
vtkSmartPointer<vtkStructuredGrid> MakeRing(const std::array<int, 3>& cells);

/// Kinds of tetrahedra, voxels, hexahedra, wedges and pyramids.
const std::vector<MeshKind>& FlowMeshKinds();
/// MakeMesh with voxels, or else hexahedra, and wedges for polyhedra.
vtkSmartPointer<vtkUnstructuredGrid> MakeFlowMesh(
  MeshKind kind, const std::array<int, 3>& cells, bool hasVoxels = true, unsigned int seed = 1);

/// An image, a rectilinear grid, a structured grid that is bent inside, and a mesh of each kind,
/// all over 0 ... 4 with 5 points along each axis, and their names.
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> MakeFlowGrids();

/// An image over 0 ... 4 along each axis, with a field.
vtkSmartPointer<vtkImageData> MakeFlowImage(int points, const VectorField& field);

/// The plane x = \a place over 0 ... 4 in y and z, u along y and v along z.
vtkSmartPointer<vtkTerminationPlane> MakeFlowPlane(double place);

/// A place in a cell, as VTK's cell interpolates.
struct CellSample
{
  vtkIdType Cell;
  Vector Position;
  Vector Velocity;
  /// dv_i/dx_j at 3 i + j.
  std::array<double, 9> Gradient;
};
/// At random, inside by a hundredth of the cell. The gradient is 0 unless asked for.
CellSample SampleCell(vtkDataSet* data, vtkDataArray* vectors, vtkIdType cell, Random& random,
  bool hasGradient = false);

}

#endif
