// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSimplexGrid_h
#define ReferenceSimplexGrid_h

#include "vtkSmartPointer.h" // for the grids
#include "vtkType.h"         // for vtkIdType

#include <array>      // for points
#include <functional> // for the selection of cells
#include <vector>     // for the lists

class vtkUnstructuredGrid;

/**
 * 4-simplices in space and time and their slices, independent of the code under test.
 */
namespace reference
{

/// A point (x,y,z,t).
using Event = std::array<double, 4>;
using SimplexIds = std::array<vtkIdType, 5>;
using SimplexEvents = std::array<Event, 5>;

/// Returns a grid of VTK_POLY_VERTEX cells with five points each. The points and the point array
/// Time are in double precision.
vtkSmartPointer<vtkUnstructuredGrid> MakeSimplexGrid(
  const std::vector<Event>& points, const std::vector<SimplexIds>& simplices);

/// Return the ids or the coordinates of the five points of a cell.
SimplexIds GetSimplexIds(vtkUnstructuredGrid* grid, vtkIdType cell);
SimplexEvents GetSimplexEvents(vtkUnstructuredGrid* grid, vtkIdType cell);

/// Returns 24 times the signed hypervolume.
long double Determinant(const SimplexEvents& simplex);

/**
 * Returns the volume of the slice at time t by the formula of Curry and Schoenberg: the hypervolume
 * times the cubic M-spline whose knots are the five times. The times must differ.
 */
long double SliceVolume(const SimplexEvents& simplex, double t);

/// Settings of a grid of hypercubes that are split into simplices.
struct KuhnOptions
{
  std::array<int, 4> Cells = { { 3, 3, 3, 3 } };
  /// Maximum displacement of interior points in space and in time, as a fraction of the cell size.
  /// Below 0.2 every simplex keeps its orientation.
  double MovedInSpace = 0;
  double MovedInTime = 0;
  /// If true, times are multiples of 1/8, so that many points have equal times.
  bool HasEqualTimes = false;
  unsigned int Seed = 1;
  /// Returns whether to include the 24 simplices of a hypercube. If empty, all are included.
  std::function<bool(const std::array<int, 4>&)> IsRetained;
};

/**
 * Returns a grid of hypercubes that fills [0,1]^3 x [0, Cells[3]]. Each hypercube is split into 24
 * positively oriented simplices around its main diagonal. Point ids and the order of simplices and
 * vertices are random.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeKuhnGrid(const KuhnOptions& options);

/// Returns the slice at time \a t, computed by vtkSimplexTimeSlice, which is the filter under test.
vtkSmartPointer<vtkUnstructuredGrid> SliceAt(vtkUnstructuredGrid* simplices, double t);

}

#endif
