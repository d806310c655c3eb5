// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSimplices_h
#define ReferenceSimplices_h

#include "Support/Meshes/ReferenceChain.h" // for the faces

#include <array>  // for points
#include <vector> // for the lists

class vtkUnstructuredGrid;

/**
 * Reading the outputs of vtkTimeVaryingIntervalVolume.
 */
namespace reference
{

using FourSimplex = std::array<vtkIdType, 5>;

/// Every interval or every slab.
constexpr int Any = -1;

/// The 4-simplices of port 2 of an interval and a slab.
std::vector<FourSimplex> FourSimplicesOf(
  vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);

/// Whether every cell is a VTK_POLY_VERTEX of five points of the grid.
bool AreFourSimplices(vtkUnstructuredGrid* grid);

/// The oriented 3-faces of 4-simplices: of a positive one, those of its boundary.
std::vector<OrientedSimplex<4>> FacesOf(const std::vector<FourSimplex>& simplices);

/// The signed hypervolume of a 4-simplex with the array Time as its fourth coordinate.
long double HypervolumeOf(vtkUnstructuredGrid* grid, const FourSimplex& simplex);

/// Signed sums over the 4-simplices of port 2, and over the tetrahedra of port 0.
struct HypervolumeSum
{
  long double Sum = 0;
  long double SumOfAbsolute = 0;
  long long Count = 0;
};
HypervolumeSum MeasureSimplices(vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);
/// Of each tetrahedron, a quarter of its volume times the sum of DeltaT over its points.
HypervolumeSum MeasureWeighted(vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);

/// The cells of port 1 of an interval and a kind; N is 3 for triangles, 4 for tetrahedra.
template <size_t N>
std::vector<std::array<vtkIdType, N>> BoundaryCellsOf(
  vtkUnstructuredGrid* grid, int interval, int kind);

/// One tetrahedron of port 0.
struct WeightedTetrahedron
{
  Tetrahedron Points;
  int ThickPoints; ///< points with a DeltaT that is not 0
  vtkIdType Thick; ///< the last of them; -1 where there is none
  long double Hypervolume;
  int Class;
};
std::vector<WeightedTetrahedron> WeightedTetrahedraOf(
  vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);

/// The tetrahedra of port 0 that follow each other and share their one thick point: those of one
/// 4-simplex each.
std::vector<std::vector<WeightedTetrahedron>> GroupByThickPoint(
  const std::vector<WeightedTetrahedron>& tetrahedra);

/// The sum over all tetrahedra of port 0 that hold a point of DeltaT there, signed as they are
/// oriented. The point is taken to lie on no face.
long double DurationAt(
  vtkUnstructuredGrid* tetrahedra, const std::array<double, 3>& point, int interval = Any);

}

#endif
