#ifndef interlume_ExtractionInput_h
#define interlume_ExtractionInput_h

#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataSet;

namespace interlume
{

/**
 * @class   ExtractionInput
 * @brief   says what is wrong with an input
 */
class ExtractionInput
{
public:
  /**
   * Why \a array cannot be the scalar of \a input, or nothing. \a association is that of the array;
   * \a wanted describes what was asked for.
   */
  static std::string CheckScalars(
    vtkDataSet* input, vtkAbstractArray* array, int association, const std::string& wanted);

  /// Why lower ... upper is not an interval, or nothing.
  static std::string CheckInterval(const std::string& name, double lower, double upper);

  /// The same of the first interval of a list that is none, by its index.
  static std::string CheckIntervals(const std::vector<std::array<double, 2>>& intervals);

  ///@{
  /**
   * What is not right with an extraction that goes on, in words, or nothing: points that single
   * precision moves by more than a hundredth of a cell, as of an image far from the origin;
   * polyhedra that are cut into parts that overlap.
   */
  static std::string CheckPrecision(vtkDataSet* input, int precision);
  static std::string CheckPolyhedra(vtkIdType numberOfConcave);
  ///@}

  /// The array that input 0 of \a owner is set to process, in words.
  static std::string DescribeArrayToProcess(vtkAlgorithm* owner);
};

}

#endif
