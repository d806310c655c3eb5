// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SamplingCheck_h
#define interlume_SamplingCheck_h

#include "Streams/SamplingReport.h"

#include <array>
#include <vector>

class vtkDataSet;
class vtkFieldData;

namespace interlume
{

class ImplicitFlowArrays;
struct AdvectionResult;
struct StageContext;

/**
 * @class   SamplingCheck
 * @brief   compares interpolation at the centers of sample cells with streamlines
 *
 * The list of cells with a corner in the field is divided into equal parts, and one cell is chosen
 * at random from each. The choice is the same in each execution.
 */
class SamplingCheck
{
public:
  /// Advects as many cell centers as the options request. Stores the errors in the report and in
  /// the field arrays of vtkFlowStatus. Returns false if the execution was aborted.
  static bool Run(StageContext& context, vtkDataSet* samples);

private:
  /// Chooses \a maximum cells, or all cells if there are fewer.
  SamplingCheck(vtkDataSet* samples, const ImplicitFlowArrays& arrays, vtkIdType maximum);

  /// Computes the center of a chosen cell, the mean of its corners.
  void GetCenter(vtkIdType i, double x[3]) const;
  /// Stores the result for a center. Threads may call it concurrently for different centers.
  void Set(vtkIdType i, const AdvectionResult& result);
  /// Returns the report. Call it after Set for all centers.
  SamplingReport GetReport() const;
  /// Adds the field arrays SamplingChecks and SamplingErrors of vtkFlowStatus.
  static void AddArrays(const SamplingReport& report, vtkFieldData* data);

  static constexpr int MaximumCorners = 8;
  enum Quantities
  {
    U,
    V,
    TIME,
    NUMBER_OF_QUANTITIES
  };
  struct Cell
  {
    std::array<vtkIdType, MaximumCorners> Corners{};
    int NumberOfCorners = 0;
    bool IsSplit = false;
    bool IsDifferent = false;
    bool IsCompared = false;
    std::array<double, NUMBER_OF_QUANTITIES> Errors{};
  };

  /// Returns the ids of the cells with a corner in the field.
  std::vector<vtkIdType> FindCells() const;
  bool IsSplit(const Cell& cell) const;
  /// Returns true if the status and id of \a result are not the most frequent ones among the
  /// corners.
  bool IsDifferent(const Cell& cell, const AdvectionResult& result) const;
  /// Returns the interpolation error of u (\a axis 0) or v (1) at the center of a cell.
  double GetError(const Cell& cell, const AdvectionResult& result, int axis) const;
  SamplingReport::Error GetError(Quantities quantity) const;

  vtkDataSet* Samples;
  const ImplicitFlowArrays& Arrays;
  std::vector<Cell> Cells;
};

}

#endif
