// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EmptyResult_h
#define interlume_EmptyResult_h

#include "vtkIntervalList.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <limits>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;

namespace interlume
{

/**
 * @class   EmptyResult
 * @brief   explains why an execution has an empty output
 *
 * Follows one execution over all datasets of a composite input, so that it is said once for the
 * whole, and not for a dataset beside others that gave something. Costs nothing where there is
 * output: the ranges of values are looked at when the execution has ended without any.
 */
class EmptyResult
{
public:
  /// Notes a dataset and how many simplices came of it, before criteria. Each may be missing.
  void Add(vtkDataSet* input, vtkDataArray* scalars, vtkIdType simplices);

  /// Looks at the datasets and scalars so far, and lets go of them: for inputs that do not stay,
  /// such as time steps.
  void Look();

  /// Notes the simplices before and after a criterion on an array of the points before it; \a words
  /// name it, as in "the criterion on "p" from 1 to 2".
  void AddCriterion(std::size_t number, const std::string& words, vtkDataArray* array,
    vtkIdType before, vtkIdType after);

  /// Notes that a message has said what is wrong.
  void NoteMessage() { this->IsExplained = true; }

  /**
   * Returns why there is no output, or nothing where there is some, where a message has said it, or
   * where the user has aborted. A piece of a larger whole may well be empty: it gives no reason
   * that lies in the data, and the first piece alone gives the others.
   *
   * \a unset is the reason when nothing is sought, such as "no interval is set", else empty; \a
   * sought says what is sought, such as "the interval [1, 2]".
   */
  std::string Explain(vtkAlgorithm* owner, const std::string& unset, const std::string& sought);

  /// Returns whether there is no output, no message has said why, and this is not one piece of
  /// several.
  bool IsUnexplained(vtkAlgorithm* owner) const;

  /// Describes intervals in words: "the interval [1, 2]", or "the intervals [1, 2], [3, 4]".
  static std::string Describe(const std::vector<vtkIntervalList::Interval>& intervals);
  /// Describes single values in words: "the value 1".
  static std::string Describe(const std::vector<double>& values);

private:
  struct Range
  {
    double Least = std::numeric_limits<double>::infinity();
    double Largest = -std::numeric_limits<double>::infinity();

    bool IsEmpty() const { return !(this->Least <= this->Largest); }
    void Add(vtkDataArray* array);
  };

  // A criterion that left nothing, and what it was applied to.
  struct Criterion
  {
    std::string Words;
    Range Before;
  };

  // Returns whether the output is empty and nothing has been said of it.
  bool IsSilent(vtkAlgorithm* owner) const;
  std::string ExplainByData(const std::string& sought);

  std::vector<vtkSmartPointer<vtkDataSet>> Inputs;
  std::vector<vtkSmartPointer<vtkDataArray>> Scalars;
  std::string ScalarsName;
  // The range of the values that have been seen.
  Range Values;
  bool HasPoints = false;
  bool HasSolidCells = false;
  vtkIdType Cells = 0;
  std::vector<Criterion> Criteria;
  vtkIdType Simplices = 0;
  vtkIdType SimplicesLeft = 0;
  bool IsExplained = false;
};

}

#endif
