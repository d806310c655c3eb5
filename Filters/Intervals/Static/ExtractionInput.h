// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionInput_h
#define interlume_ExtractionInput_h

#include "Common/Error.h"

#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataSet;

namespace interlume
{

struct ExtractionReport;

/**
 * @class   ExtractionInput
 * @brief   checks the input of an extraction
 */
class ExtractionInput
{
public:
  /**
   * Returns an error if \a array cannot be the scalar of \a input, or if the arrays of \a input
   * contradict each other. \a association is that of the array; \a wanted describes the requested
   * array.
   */
  static Error CheckScalars(
    vtkDataSet* input, vtkAbstractArray* array, int association, const std::string& wanted);

  /// Returns an error for the first invalid interval.
  static Error CheckIntervals(const std::vector<std::array<double, 2>>& intervals);

  ///@{
  /**
   * Return what is not right with an extraction that goes on, in words, or nothing: points that
   * single precision moves by more than a hundredth of a cell, as of an image far from the origin;
   * polyhedra that are cut into parts that overlap; cells that are folded.
   */
  static std::string CheckPrecision(vtkDataSet* input, int precision);
  static std::string CheckPolyhedra(vtkIdType numberOfConcave);
  static std::string CheckFolding(vtkDataSet* input, vtkIdType numberOfFolded);
  ///@}

  /// Returns the number of cells where coordinates of a rectilinear grid turn back or repeat, and 0
  /// for other datasets.
  static vtkIdType CountFoldedInRows(vtkDataSet* input);

  /// Returns what an extraction of that \a report is to warn of, each in words: what is left
  /// out or taken as something else, and the two above.
  static std::vector<std::string> GetWarnings(
    vtkDataSet* input, int precision, const ExtractionReport& report);

  /// Describes the array that input 0 of \a owner is set to process.
  static std::string DescribeArrayToProcess(vtkAlgorithm* owner);
};

}

#endif
