// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSimplices_h
#define ReferenceSimplices_h

#include "Support/Meshes/ReferenceChain.h" // for the faces

#include <array>  // for points
#include <vector> // for the lists

class vtkUnstructuredGrid;

/**
 * Access to the outputs of vtkTimeVaryingIntervalVolume.
 */
namespace reference
{

using FourSimplex = std::array<vtkIdType, 5>;

/// Selects every interval or every slab.
constexpr int Any = -1;

/// Returns the 4-simplices of port 2 in an interval and a slab.
std::vector<FourSimplex> FourSimplicesOf(
  vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);

/// Returns whether every cell is a VTK_POLY_VERTEX of five valid points.
bool AreFourSimplices(vtkUnstructuredGrid* grid);

/// Returns the 3-faces of 4-simplices, with the orientation that each simplex induces on its
/// boundary.
std::vector<OrientedSimplex<4>> FacesOf(const std::vector<FourSimplex>& simplices);

/// Returns the signed hypervolume of a 4-simplex. The array Time is the fourth coordinate.
long double HypervolumeOf(vtkUnstructuredGrid* grid, const FourSimplex& simplex);

/// Sums of the hypervolumes of the 4-simplices of port 2 or of the tetrahedra of port 0.
struct HypervolumeSum
{
  long double Sum = 0;
  long double SumOfAbsolute = 0;
  long long Count = 0;
};
HypervolumeSum MeasureSimplices(vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);
/// Sums each tetrahedron's volume times the mean of DeltaT over its points.
HypervolumeSum MeasureWeightedTetrahedra(
  vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);

/// Returns the cells of port 1 with the given interval and boundary kind. N is 3 for triangles and
/// 4 for tetrahedra.
template <size_t N>
std::vector<std::array<vtkIdType, N>> BoundaryCellsOf(
  vtkUnstructuredGrid* grid, int interval, int kind);

/// A tetrahedron of port 0.
struct WeightedTetrahedron
{
  Tetrahedron Points;
  int ThickPoints; ///< number of points with a nonzero DeltaT
  vtkIdType Thick; ///< last point with a nonzero DeltaT, or -1
  long double Hypervolume;
  int Class;
};
std::vector<WeightedTetrahedron> WeightedTetrahedraOf(
  vtkUnstructuredGrid* grid, int interval = Any, int slab = Any);

/// Groups consecutive tetrahedra of port 0 that have the same value of Thick. Each group belongs to
/// one 4-simplex.
std::vector<std::vector<WeightedTetrahedron>> GroupByThickPoint(
  const std::vector<WeightedTetrahedron>& tetrahedra);

/// Returns DeltaT interpolated at a point, summed over all tetrahedra of port 0 that contain the
/// point. Tetrahedra with negative volume count negatively. The point must not lie on a face.
long double DurationAt(
  vtkUnstructuredGrid* tetrahedra, const std::array<double, 3>& point, int interval = Any);

}

#endif
