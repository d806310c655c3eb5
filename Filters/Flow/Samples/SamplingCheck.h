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
 * @brief   compares interpolation in the middles of some cells of samples with streamlines there
 *
 * The cells are chosen at random, always the same ones, one from each of as many equal parts of the
 * list of cells with a corner in the field.
 */
class SamplingCheck
{
public:
  /// Follows the streamlines of as many middles of cells as the options say, and adds the report
  /// and the arrays of vtkFlowStatus. Returns false if the execution was aborted.
  static bool Run(StageContext& context, vtkDataSet* samples);

private:
  /// Chooses \a most cells, or all if there are no more.
  SamplingCheck(vtkDataSet* samples, const ImplicitFlowArrays& arrays, vtkIdType most);

  /// Computes the middle of one of the cells, the mean of its corners.
  void GetMiddle(vtkIdType i, double x[3]) const;
  /// Takes the streamline of a middle; threads may do so for different ones.
  void Set(vtkIdType i, const AdvectionResult& result);
  /// Returns what was found, after all middles were set.
  SamplingReport GetReport() const;
  /// Adds the arrays of vtkFlowStatus that tell a report.
  static void AddArrays(const SamplingReport& report, vtkFieldData* data);

  static constexpr int MostCorners = 8;
  enum Quantities
  {
    U,
    V,
    TIME,
    NUMBER_OF_QUANTITIES
  };
  struct Cell
  {
    std::array<vtkIdType, MostCorners> Corners{};
    int NumberOfCorners = 0;
    bool IsSplit = false;
    bool IsDifferent = false;
    bool IsCompared = false;
    std::array<double, NUMBER_OF_QUANTITIES> Errors{};
  };

  /// Finds the cells that may be chosen.
  std::vector<vtkIdType> FindCells() const;
  bool IsSplit(const Cell& cell) const;
  /// Returns whether fewer corners ended as \a result did than in another way.
  bool IsDifferent(const Cell& cell, const AdvectionResult& result) const;
  /// Returns the error of the interpolation of u or v.
  double GetError(const Cell& cell, const AdvectionResult& result, int axis) const;
  SamplingReport::Error GetError(Quantities quantity) const;

  vtkDataSet* Samples;
  const ImplicitFlowArrays& Arrays;
  std::vector<Cell> Cells;
};

}

#endif
