// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionInput_h
#define interlume_ExtractionInput_h

#include "Common/Error.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataSet;
class vtkIdList;

namespace interlume
{

struct ExtractionReport;

/**
 * @class   ExtractionInput
 * @brief   checks the input of an extraction, and hides cells of it
 */
class ExtractionInput
{
public:
  /**
   * Returns an error if \a array is not a valid scalar array of \a input, or if the arrays of
   * \a input are inconsistent. \a association is the association of \a array. \a wanted describes
   * the requested array.
   */
  static Error CheckScalars(
    vtkDataSet* input, vtkAbstractArray* array, int association, const std::string& wanted);

  /// Returns an error for the first invalid interval.
  static Error CheckIntervals(const std::vector<std::array<double, 2>>& intervals);

  ///@{
  /**
   * Return a warning, or an empty string. The checks find single-precision coordinates that are off
   * by more than a hundredth of a cell (for example in image data far from the origin), polyhedra
   * that are split into overlapping cells, and folded cells.
   */
  static std::string CheckPrecision(vtkDataSet* input, int precision);
  static std::string CheckPolyhedra(vtkIdType numberOfConcave);
  static std::string CheckFolding(vtkDataSet* input, vtkIdType numberOfFolded);
  ///@}

  /// Returns the number of cells of a rectilinear grid where coordinates are not strictly
  /// monotonic, or 0 for other datasets.
  static vtkIdType CountFoldedRectilinearCells(vtkDataSet* input);

  /// Returns the warnings of an extraction with the given report: skipped or simplified cells, and
  /// the results of the three checks above. \a dimension is the dimension of the cells that were
  /// extracted.
  static std::vector<std::string> GetWarnings(
    vtkDataSet* input, int dimension, int precision, const ExtractionReport& report);

  /// Returns a copy of a dataset in which the cells are hidden for which \a isHidden, called in
  /// parallel with the point ids of a cell, returns true.
  static vtkSmartPointer<vtkDataSet> HideCells(
    vtkDataSet* input, const std::function<bool(vtkIdList*)>& isHidden);

  /// Returns a description, for messages, of the input array that \a owner processes.
  static std::string DescribeArrayToProcess(vtkAlgorithm* owner);
};

}

#endif
