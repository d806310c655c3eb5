// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowField_h
#define interlume_FlowField_h

#include "Common/ArrayRows.h"
#include "Common/Error.h"
#include "Common/StageProgress.h"
#include "Numerics/SpeedScale.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace interlume
{

/**
 * @class   FlowField
 * @brief   data shared by walkers: the vectors, other point arrays, and the cells of the field
 *
 * A field is constant after it is built, and any number of threads may read it. Subclasses for the
 * dataset types add the geometry and `Error Build(dataset, vectors, arrays, progress)`, which
 * returns an error if the field is invalid. An abort is not an error, but the field must not be
 * used afterward. Arrays may have any type. The field keeps them alive.
 *
 * Cells that are hidden or refined, or that have a hidden point, are excluded. Duplicate cells,
 * whose originals are in another piece, are included.
 */
class FlowField
{
public:
  /// Returns the error for a field without three-dimensional cells, as a clause.
  static Error GetErrorWithoutCells()
  {
    return "the field has no three-dimensional cells. Flow in a plane needs two layers of points: "
           "append an image to itself along the third axis, or extrude other grids";
  }

  bool IsCellIncluded(vtkIdType cell) const
  {
    return !this->HasExcludedCells() || !this->Excluded[cell];
  }

  void GetVector(vtkIdType point, double vector[3]) const { this->Vectors.Get<3>(point, vector); }
  const ArrayRows& GetVectorRows() const { return this->Vectors; }
  void PrefetchVector(vtkIdType point) const { this->Vectors.Prefetch<3>(point); }
  /// Returns the value of the array with index \a array at a point.
  double GetValue(int array, vtkIdType point) const
  {
    double value;
    this->Arrays[array].Get<1>(point, &value);
    return value;
  }
  int GetNumberOfArrays() const { return static_cast<int>(this->Arrays.size()); }

  /// Returns the largest finite vector length at a point of the field's cells, or 0 if there is
  /// none.
  double GetMaximumSpeed() const { return this->MaximumSpeed; }
  /// Returns the largest vector length, ignoring fill values.
  double GetSpeedScale() const { return this->Fill.Scale; }
  const FillValues& GetFillValues() const { return this->Fill; }
  /// Returns the number of points of the field's cells with a non-finite vector.
  vtkIdType GetNumberOfNonFiniteVectors() const { return this->NumberOfNonFiniteVectors; }
  /// Returns the bounds of the dataset as xmin, xmax, ymin, ymax, zmin, zmax.
  const double* GetBounds() const { return this->Bounds; }
  double GetLargestCoordinate() const
  {
    double largest = 0.0;
    for (const double bound : this->Bounds)
    {
      largest = std::max(largest, std::abs(bound));
    }
    return largest;
  }
  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }
  /// Returns the number of cells with fewer than three dimensions, which are excluded.
  vtkIdType GetNumberOfFlatCells() const { return this->NumberOfFlatCells; }

protected:
  FlowField() = default;
  ~FlowField() = default;

  bool HasExcludedCells() const { return !this->Excluded.empty(); }

  /// Callback that writes the point ids of a cell, at most eight, to \a points and returns their
  /// number.
  using CellPoints = std::function<int(vtkIdType cell, vtkIdType* points)>;

  /// Returns an error if the arrays are invalid.
  Error SetArrays(
    vtkDataSet* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays);
  /// Excludes the cells that are hidden, or have hidden points, according to the ghost arrays of a
  /// dataset.
  void SetBlanking(vtkDataSet* data, const CellPoints& cells);
  /// Sets the number of flat cells to the number in the full grid, which includes the partitions of
  /// all processes.
  void SetNumberOfFlatCells(vtkIdType number) { this->NumberOfFlatCells = number; }
  /// Excludes a cell with fewer than three dimensions.
  void ExcludeFlatCell(vtkIdType cell);
  /// Computes the maximum speed, and finds fill values and non-finite vectors. Set
  /// \a hasOtherPoints if some points may not belong to a cell of the field.
  void Measure(const CellPoints& cells, bool hasOtherPoints);
  /// Collects the speeds at those points of the field's cells for which isCounted(point) returns
  /// true.
  SpeedCount CountSpeeds(const CellPoints& cells, bool hasOtherPoints,
    const std::function<bool(vtkIdType)>& isCounted = {}) const;
  void SetSpeeds(const SpeedCount& count);
  /// Sets the bounds to the bounds of the full grid, which includes the partitions of all
  /// processes.
  void SetBounds(const double bounds[6]) { std::copy_n(bounds, 6, this->Bounds); }

private:
  FlowField(const FlowField&) = delete;
  void operator=(const FlowField&) = delete;

  ArrayRows Vectors;
  std::vector<ArrayRows> Arrays;
  // 1 for each excluded cell, 0 for other cells. Empty if no cell is excluded.
  std::vector<unsigned char> Excluded;
  double Bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfFlatCells = 0;
  double MaximumSpeed = 0.0;
  FillValues Fill;
  vtkIdType NumberOfNonFiniteVectors = 0;
};

}

#endif
