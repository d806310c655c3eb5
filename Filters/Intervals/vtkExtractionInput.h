#ifndef vtkExtractionInput_h
#define vtkExtractionInput_h

#include <array>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataSet;

/**
 * @class   vtkExtractionInput
 * @brief   says what is wrong with an input
 */
class vtkExtractionInput
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

  /// The array that input 0 of \a owner is set to process, in words.
  static std::string DescribeArrayToProcess(vtkAlgorithm* owner);
};

#endif
