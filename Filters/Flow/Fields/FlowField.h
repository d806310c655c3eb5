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
 * @brief   the data that walkers share: the vectors, further point arrays, and which cells are the
 * field's
 *
 * A field is constant once it is built, and read by any number of threads. A class for each kind of
 * dataset adds the geometry, and `Error Build(dataset, vectors, arrays, progress)`, which returns
 * an error if there can be no such field. An aborted progress is no error, but the field must not
 * be used then. The arrays may be of any type; they are kept for as long as the field.
 *
 * Cells that are hidden or refined, or that have a hidden point, are not part of the field.
 * Duplicates of another piece's cells are.
 */
class FlowField
{
public:
  /// Returns the error of a field of flat cells, whose message is a part of a sentence.
  static Error GetErrorWithoutCells()
  {
    return "the field has no three-dimensional cells. Flow in a plane needs two layers of points: "
           "append an image to itself along the third axis, extrude other grids";
  }

  bool IsCellIncluded(vtkIdType cell) const
  {
    return !this->HasExcludedCells() || !this->Excluded[cell];
  }

  void GetVector(vtkIdType point, double vector[3]) const { this->Vectors.Get<3>(point, vector); }
  const ArrayRows& GetVectorRows() const { return this->Vectors; }
  void PrefetchVector(vtkIdType point) const { this->Vectors.Prefetch<3>(point); }
  /// Returns a value of the point array with this number.
  double GetValue(int array, vtkIdType point) const
  {
    double value;
    this->Arrays[array].Get<1>(point, &value);
    return value;
  }
  int GetNumberOfArrays() const { return static_cast<int>(this->Arrays.size()); }

  /// Returns the largest length of a finite vector in a point of the field's cells; 0 without one.
  double GetMaximumSpeed() const { return this->MaximumSpeed; }
  /// Returns the largest length without fill values, and these values (SpeedScale).
  double GetSpeedScale() const { return this->Fill.Scale; }
  const FillValues& GetFillValues() const { return this->Fill; }
  /// Returns the number of points of the field's cells whose vector is not finite.
  vtkIdType GetNumberOfNonFiniteVectors() const { return this->NumberOfNonFiniteVectors; }
  /// Returns the lower and upper bounds of x, y, z of the dataset.
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
  /// Returns the number of cells of fewer than three dimensions, which are not part of the field.
  vtkIdType GetNumberOfFlatCells() const { return this->NumberOfFlatCells; }

protected:
  FlowField() = default;
  ~FlowField() = default;

  bool HasExcludedCells() const { return !this->Excluded.empty(); }

  /// A function that gives the points of a cell, at most eight, and returns how many.
  using CellPoints = std::function<int(vtkIdType cell, vtkIdType* points)>;

  /// Returns an error if the arrays cannot be used.
  Error SetArrays(
    vtkDataSet* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays);
  /// Finds the excluded cells.
  void SetBlanking(vtkDataSet* data, const CellPoints& cells);
  /// Replaces the number of flat cells by that of a whole that the dataset is a part of.
  void SetNumberOfFlatCells(vtkIdType number) { this->NumberOfFlatCells = number; }
  /// Leaves out a cell of fewer dimensions.
  void ExcludeFlat(vtkIdType cell);
  /// Finds the largest speed and the vectors that are not finite. \a hasOtherPoints tells whether
  /// there are points that no cell of the field has.
  void Measure(const CellPoints& cells, bool hasOtherPoints);
  /// Counts the speeds in those points of the field's cells that \a isCounted is true of.
  SpeedCount CountSpeeds(const CellPoints& cells, bool hasOtherPoints,
    const std::function<bool(vtkIdType)>& isCounted = {}) const;
  void SetSpeeds(const SpeedCount& count);
  /// Replaces the bounds by those of a whole that the dataset is a part of.
  void SetBounds(const double bounds[6]) { std::copy_n(bounds, 6, this->Bounds); }

private:
  FlowField(const FlowField&) = delete;
  void operator=(const FlowField&) = delete;

  ArrayRows Vectors;
  std::vector<ArrayRows> Arrays;
  // A mark for each cell that is left out; empty where none is.
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
