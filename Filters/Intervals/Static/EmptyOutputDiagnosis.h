// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EmptyOutputDiagnosis_h
#define interlume_EmptyOutputDiagnosis_h

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
 * @class   EmptyOutputDiagnosis
 * @brief   explains why an execution has an empty output
 *
 * Follows one execution over all datasets of a composite input, so that an empty output is reported
 * once, and only if all datasets have an empty output. Value ranges are computed only if the
 * execution has no output.
 */
class EmptyOutputDiagnosis
{
public:
  /// Sets the lowest dimension of cells with output. Default 3.
  void SetMinimumDimension(int dimension) { this->MinimumDimension = dimension; }

  /// Adds a dataset, and the number of simplices extracted from it before criteria are applied. \a
  /// input and \a scalars may be null.
  void Add(vtkDataSet* input, vtkDataArray* scalars, vtkIdType simplices);

  /// Examines the datasets and scalars added so far and releases them. Call this before the inputs
  /// are replaced, for example with the next time steps.
  void Look();

  /// Adds the number of simplices before and after a criterion on a point array. \a number is the
  /// index of the criterion. \a words describes it, such as: the criterion on "p" from 1 to 2.
  void AddCriterion(std::size_t number, const std::string& words, vtkDataArray* array,
    vtkIdType before, vtkIdType after);

  /// Records that a message has already reported the error.
  void SetExplained() { this->IsExplained = true; }

  /**
   * Returns the reason for an empty output. Returns an empty string if there is output, if a
   * message has reported the error, or if the user aborted. If one of several pieces is requested,
   * no reason that depends on the data is returned, since a piece may be empty. Other reasons are
   * returned for the first piece only. If nothing was requested, \a unset is the reason, such as
   * "no interval is set."; otherwise it is empty. \a sought describes the request, such as "the
   * interval [1, 2]".
   */
  std::string Explain(vtkAlgorithm* owner, const std::string& unset, const std::string& sought);

  /// Returns whether the output is empty, no message has reported an error, the user has not
  /// aborted, and there is only one piece.
  bool IsUnexplained(vtkAlgorithm* owner) const;

  /// Describes intervals, for example "the interval [1, 2]" or "the intervals [1, 2], [3, 4]".
  static std::string Describe(const std::vector<vtkIntervalList::Interval>& intervals);
  /// Describes isovalues, for example "the value 1".
  static std::string Describe(const std::vector<double>& values);

private:
  struct Range
  {
    double Minimum = std::numeric_limits<double>::infinity();
    double Maximum = -std::numeric_limits<double>::infinity();

    bool IsEmpty() const { return !(this->Minimum <= this->Maximum); }
    void Add(vtkDataArray* array);
  };

  // A criterion with an empty result, and the range of its array before it was applied.
  struct Criterion
  {
    std::string Words;
    Range Before;
  };

  // Returns whether the output is empty, no message has reported an error, and the user has not
  // aborted.
  bool IsUnreported(vtkAlgorithm* owner) const;
  std::string ExplainFromData(const std::string& sought);

  std::vector<vtkSmartPointer<vtkDataSet>> Inputs;
  std::vector<vtkSmartPointer<vtkDataArray>> Scalars;
  std::string ScalarsName;
  // Range of the scalars examined so far.
  Range Values;
  bool HasPoints = false;
  int MinimumDimension = 3;
  bool HasSuitableCells = false;
  vtkIdType Cells = 0;
  std::vector<Criterion> Criteria;
  vtkIdType Simplices = 0;
  vtkIdType SimplicesLeft = 0;
  bool IsExplained = false;
};

}

#endif
