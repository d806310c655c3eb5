// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CutGrid_h
#define interlume_CutGrid_h

#include "Samples/FarSideSamples.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <tuple>
#include <vector>

class vtkDataSet;
class vtkPointData;
class vtkUnstructuredGrid;

namespace interlume
{

class ImplicitFlowArrays;
class InterpolableCells;

/**
 * @class   CutGrid
 * @brief   grid of the cells that a surface cuts, with one copy of the whole cell for each part
 *
 * A cell that InterpolableCells excludes, and for which FarSideSamples has parts, is copied once
 * for each part. Each copy has the original corners on the side of the part, and duplicates of the
 * other corners. A duplicate has the values that the sample would have on the far side of the
 * surface. If these are unknown, for example where streamlines just miss the surface, it has the
 * values of a corner of the part, and its time to the surface is extrapolated in proportion to the
 * distances. Only the region of a copy with Gap >= 0 belongs to its part. Points have global ids so
 * that cell faces are split as in the input.
 */
class CutGrid
{
public:
  ///@{
  /**
   * Names of the point arrays (double) with the distance from the surface (negative for
   * duplicates), the gradient of that distance, and the time from the point to the surface
   * (negative behind the surface).
   */
  static const char* GapArray() { return "Gap"; }
  static const char* GradientArray() { return "GapGradient"; }
  static const char* NearTimeArray() { return "NearTime"; }
  ///@}
  /// Name of the array of global ids if the input has none.
  static const char* IdArray() { return "InputPoint"; }

  /// Builds the grid. Returns null if no cell is cut, for example if Inflow is unknown on the far
  /// side. \a numberOfCells is set to the number of input cells that are cut.
  vtkSmartPointer<vtkUnstructuredGrid> Make(vtkDataSet* input, const ImplicitFlowArrays& arrays,
    const InterpolableCells& cells, vtkIdType& numberOfCells);

  /// Returns the id of the input point of a grid point, or -1 for a duplicate.
  vtkIdType GetInputPoint(vtkIdType point) const
  {
    const Point& created = this->Points[static_cast<std::size_t>(point)];
    return created.Kind == FarSideSamples::OWN ? created.Sample : -1;
  }

private:
  struct Point
  {
    vtkIdType Sample;
    FarSideSamples::Roles Kind;
    /// A corner on the side of the part for which the point was created.
    vtkIdType Other;
    bool IsNear;
    /// Side of that part, 1 or -1, and whether the part ends at the boundary of the reached region
    /// instead of at a surface.
    int Side;
    bool IsBoundary;
  };
  vtkIdType GetOrAddPoint(const Point& point);
  void FindCells(vtkDataSet* input, const FarSideSamples& farSide, const ImplicitFlowArrays& arrays,
    const InterpolableCells& cells, vtkIdType& numberOfCells);
  void AddPoints(vtkDataSet* input, const FarSideSamples& farSide, const ImplicitFlowArrays& arrays,
    vtkUnstructuredGrid* grid) const;
  void SetValues(vtkDataSet* input, const FarSideSamples& farSide, const ImplicitFlowArrays& arrays,
    vtkPointData* to) const;

  std::vector<Point> Points;
  std::map<std::tuple<vtkIdType, int, int, bool>, vtkIdType> Known;
  // Input cell of each copy, and the point ids of all copies.
  std::vector<vtkIdType> Cells;
  std::vector<vtkIdType> Ids;
};

}

#endif
