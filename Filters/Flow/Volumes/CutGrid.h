// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CutGrid_h
#define interlume_CutGrid_h

#include "Samples/BeyondSamples.h"

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
 * @brief   the cells of an implicit flow field that are cut at a surface, each part as a whole cell
 *
 * A cell that InterpolableCells leaves out and BeyondSamples has parts of is there once for each
 * part, whole: with its corners on the part's own side, and copies of the others. A copy has the
 * values that the sample would have beyond the surface; where these are not known, as where
 * streamlines only just miss the surface, those of a corner of the part, but for the time to the
 * surface, which goes on by the distances. What is to be kept of a cell is where Gap is not below
 * 0. Points have global ids, so that faces of the input's cells are cut as in the input.
 */
class CutGrid
{
public:
  ///@{
  /**
   * The names of point arrays (double): the distance from the surface, below 0 for copies, and its
   * gradient; the time that a streamline takes from a point to the surface, below 0 behind it.
   */
  static const char* GapArray() { return "Gap"; }
  static const char* GradientArray() { return "GapGradient"; }
  static const char* NearTimeArray() { return "NearTime"; }
  ///@}
  /// The name of the array of global ids where the input has none.
  static const char* IdArray() { return "InputPoint"; }

  /// Makes the grid; null where nothing is cut, as where Inflow is not known beyond. \a
  /// numberOfCells becomes the number of the input's cells that are cut.
  vtkSmartPointer<vtkUnstructuredGrid> Make(vtkDataSet* input, const ImplicitFlowArrays& arrays,
    const InterpolableCells& cells, vtkIdType& numberOfCells);

  /// Returns the input's point of a point of the grid; -1 for a copy.
  vtkIdType GetInputPoint(vtkIdType point) const
  {
    const Point& made = this->Points[static_cast<std::size_t>(point)];
    return made.Kind == BeyondSamples::OWN ? made.Sample : -1;
  }

private:
  struct Point
  {
    vtkIdType Sample;
    BeyondSamples::Roles Kind;
    /// A corner of the part that the point was made for.
    vtkIdType Other;
    bool IsNear;
    /// The side of that part, 1 or -1, and whether the boundary of what reaches a surface parts it.
    int Side;
    bool IsBoundary;
  };
  vtkIdType Take(const Point& point);
  void FindCells(vtkDataSet* input, const BeyondSamples& beyond, const ImplicitFlowArrays& arrays,
    const InterpolableCells& cells, vtkIdType& numberOfCells);
  void AddPoints(vtkDataSet* input, const BeyondSamples& beyond, const ImplicitFlowArrays& arrays,
    vtkUnstructuredGrid* grid) const;
  void SetValues(vtkDataSet* input, const BeyondSamples& beyond, const ImplicitFlowArrays& arrays,
    vtkPointData* to) const;

  std::vector<Point> Points;
  std::map<std::tuple<vtkIdType, int, int, bool>, vtkIdType> Known;
  // The input's cells of all parts, and the ids of the points.
  std::vector<vtkIdType> Cells;
  std::vector<vtkIdType> Ids;
};

}

#endif
