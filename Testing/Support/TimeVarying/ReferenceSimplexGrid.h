// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSimplexGrid_h
#define ReferenceSimplexGrid_h

#include "vtkSmartPointer.h" // for the grids
#include "vtkType.h"         // for vtkIdType

#include <array>      // for points
#include <functional> // for the choice of cells
#include <vector>     // for the lists

class vtkUnstructuredGrid;

/**
 * 4-simplices in space and time, and their slices, made without the code under test.
 */
namespace reference
{

/// A point (x,y,z,t).
using Event = std::array<double, 4>;
using SimplexIds = std::array<vtkIdType, 5>;
using SimplexEvents = std::array<Event, 5>;

/// VTK_POLY_VERTEX cells of five points, in double, with a point array Time (double).
vtkSmartPointer<vtkUnstructuredGrid> MakeSimplexGrid(
  const std::vector<Event>& points, const std::vector<SimplexIds>& simplices);

/// What a cell of such a grid was made of.
SimplexIds GetSimplexIds(vtkUnstructuredGrid* grid, vtkIdType cell);
SimplexEvents GetSimplexEvents(vtkUnstructuredGrid* grid, vtkIdType cell);

/// 24 times the signed hypervolume.
long double Determinant(const SimplexEvents& simplex);

/**
 * The volume of the slice at t by Curry and Schoenberg: the hypervolume times the cubic M-spline
 * whose knots are the five times, which have to differ.
 */
long double SliceVolume(const SimplexEvents& simplex, double t);

/// How a lattice is filled.
struct KuhnOptions
{
  std::array<int, 4> Cells = { { 3, 3, 3, 3 } };
  /// By how much of a cell's size inner points are moved at most, in space and in time. Below 0.2
  /// every simplex keeps its orientation.
  double MovedInSpace = 0;
  double MovedInTime = 0;
  /// Whether times are multiples of 1/8, so that many are equal.
  bool HasEqualTimes = false;
  unsigned int Seed = 1;
  /// Whether the 24 simplices of a hypercube are there; empty: all are.
  std::function<bool(const std::array<int, 4>&)> IsKept;
};

/**
 * A lattice of hypercubes that fills [0,1]^3 x [0, Cells[3]], each cut into 24 positively oriented
 * simplices around its main diagonal. The numbers of points, and the order of simplices and of
 * their vertices, are random.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeKuhnGrid(const KuhnOptions& options);

/// The slice by the filter under test.
vtkSmartPointer<vtkUnstructuredGrid> SliceAt(vtkUnstructuredGrid* simplices, double t);

}

#endif
