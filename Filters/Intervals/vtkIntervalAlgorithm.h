// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIntervalAlgorithm_h
#define vtkIntervalAlgorithm_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkIntervalList.h"          // for the intervals
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for messages
#include <vector> // for the criteria

class vtkDataSet;

namespace interlume
{
class Error;
}

/**
 * @class   vtkIntervalAlgorithm
 * @brief   common superclass of filters that process intervals of a scalar
 *
 * Select the scalar, a one-component array, with SetInputArrayToProcess(0, ...). The default is the
 * active scalars. If the dataset has no such array of the given association, an array of the same
 * name or attribute type with the other association (points or cells) is selected.
 *
 * A cell array is averaged at the points by vtkCellDataToPointData. The averages are then processed
 * like a point array, and replace a point array of the same name in the output. Datasets of a
 * composite dataset are averaged separately. Integers remain integers. A NaN extends to all points
 * of its cell. Blanked cells of vtkUniformGrid and vtkStructuredGrid are excluded from averages.
 * Ghost cells are included, so that pieces have the averages of the full grid. For this purpose,
 * another layer of ghost cells is requested if the given association is not points.
 *
 * @sa vtkIntervalVolume vtkTimeVaryingIntervalVolume
 */
class INTERLUMEINTERVALS_EXPORT vtkIntervalAlgorithm : public vtkUnstructuredGridAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkIntervalAlgorithm, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/get the intervals, in the units of the scalar: lower <= upper, both finite. Intervals may
   * touch, overlap or leave gaps. Default: no intervals, so the output is empty. Valid number of
   * intervals: 0 to 10000. SetInterval extends the list if needed. GetInterval leaves its arguments
   * unchanged if \a i is out of range.
   */
  void SetNumberOfIntervals(int number);
  int GetNumberOfIntervals() const { return this->Intervals.GetNumber(); }
  void SetInterval(int i, double lower, double upper);
  void GetInterval(int i, double& lower, double& upper) const;
  ///@}

  ///@{
  /**
   * Add criteria: combine the intervals with the region lower <= array <= upper, see
   * CriteriaOperation, where array is another point array, or a cell array if no point array has
   * this name. Each criterion adds a pass over the simplices, or two with UNION. The orientation of
   * simplices is preserved, so signed volumes still add up if some are inverted. Simplices are
   * dropped if the array is NaN or infinite at a corner. The array must have one component, and not
   * contain ids. For ranges of the array of the intervals, use intervals: values of floating-point
   * arrays at cuts differ from the bound by rounding error, so a criterion with the same bound may
   * cut off slivers. Default: none. AddCriterionAsText parses the bounds from text. If a bound is
   * not a number, the range contains NaN and the next execution reports the text as an error. For
   * an invalid index, GetCriterionArrayName returns null and GetCriterionRange leaves its arguments
   * unchanged.
   */
  void AddCriterion(const char* arrayName, double lower, double upper);
  void AddCriterionAsText(const char* arrayName, const char* lower, const char* upper);
  void RemoveAllCriteria();
  int GetNumberOfCriteria() const { return static_cast<int>(this->Criteria.size()); }
  const char* GetCriterionArrayName(int i) const;
  void GetCriterionRange(int i, double& lower, double& upper) const;
  ///@}

  ///@{
  /**
   * How criteria change the result:
   * - INTERSECTION: the part of the intervals that satisfies all criteria
   * - UNION: the intervals, and the region outside of them that satisfies any criterion. This
   *   region has the `IntervalId` -1. Its cells are last in the output, sorted by criterion. They
   *   share no points with the intervals, and those of different criteria share none. Cells are
   *   skipped where the scalar is NaN or infinite. At least one interval must be set. Warnings and
   *   the counts of input cells in the report describe the extraction of the intervals.
   * - DIFFERENCE: the part of the intervals that satisfies no criterion
   *
   * Default INTERSECTION.
   */
  enum CriteriaOperations
  {
    INTERSECTION,
    UNION,
    DIFFERENCE
  };
  vtkSetClampMacro(CriteriaOperation, int, INTERSECTION, DIFFERENCE);
  int GetCriteriaOperation() const { return this->CriteriaOperation; }
  ///@}

  ///@{
  /**
   * Set/get the precision of the output points: vtkAlgorithm::DEFAULT_PRECISION (the precision of
   * the input's points; float for image data), SINGLE_PRECISION or DOUBLE_PRECISION. Default
   * DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * If true, an execution with an empty output warns and reports the reason: no interval is set,
   * the intervals are outside the scalar range, or the input has no points or only cells whose
   * dimension is too low. The warning is issued once for all datasets of a composite input. If one
   * of several pieces is requested, reasons that may not apply to other pieces are not reported.
   * Default on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  ///@{
  /**
   * Set/get the number of output tetrahedra or triangles above which an execution warns before it
   * allocates them. The warning reports the number, the memory, and how to reduce them. It is also
   * issued if the output needs more than a quarter of the memory that the process can use. Each
   * process warns at most once per execution, about its part of the output. The limit does not
   * change the output. 0 turns the warning off. Default 5 million.
   */
  vtkSetClampMacro(SizeWarningLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(SizeWarningLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * Set/get the number of cells up to which a preview is exact. Applications set it while a user
   * drags a bound. If the structured grids of the input have more cells, a coarse copy of each is
   * extracted instead: every n-th point along each axis and the last one, with the lowest n for
   * which all copies together have at most this number of cells. A coarse cell has the arrays and
   * the blanking of its first cell. Grids of other types are extracted exactly. The copies and
   * their value index remain in memory until an execution without preview.
   *
   * Previews issue no warnings, their report refers to coarse cells, and coarse previews have no
   * origin arrays. Each process applies the limit to its piece. Default 0: no preview.
   */
  vtkSetClampMacro(PreviewCellLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(PreviewCellLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * If true, each process of the global controller tells the others, at the end of an execution,
   * how many of its cells have output. The first output gets the field arrays `CellsOfProcesses`,
   * with these numbers, and `LoadBalance`, their maximum divided by their mean. All processes must
   * then execute, each for its own piece. An empty piece, an error in this filter or an abort does
   * not block the other processes, but an upstream error in only some processes does. Ignored if
   * there is one process, or if the processes do not request one piece each. Default off.
   */
  vtkSetMacro(ReportBalance, bool);
  vtkGetMacro(ReportBalance, bool);
  vtkBooleanMacro(ReportBalance, bool);
  ///@}

protected:
  struct Criterion
  {
    std::string ArrayName;
    double Lower;
    double Upper;
    /// The text of the first bound that is not a number. Empty if there is none.
    std::string InvalidBound;
  };

  vtkIntervalAlgorithm();
  ~vtkIntervalAlgorithm() override = default;

  const std::vector<vtkIntervalList::Interval>& GetIntervals() const
  {
    return this->Intervals.GetAll();
  }
  const std::vector<Criterion>& GetCriteria() const { return this->Criteria; }
  std::vector<std::string> GetCriteriaArrayNames() const;
  /// Returns an error if a criterion is invalid for a dataset.
  interlume::Error CheckCriteria(vtkDataSet* input) const;
  /// Returns a description of the requested region for messages, such as "the interval [1, 2]".
  std::string DescribeIntervals() const;
  /// Returns a description of a criterion for messages.
  std::string DescribeCriterion(int number) const;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /// Creates unstructured grids for a dataset, or composite datasets for a composite input.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  /// Requests a layer of ghost cells if one of several pieces is requested.
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  /// Warns that the output is empty, unless \a why is empty or WarnOnEmptyOutput is off.
  void WarnOfEmptyOutput(const std::string& why);

private:
  vtkIntervalAlgorithm(const vtkIntervalAlgorithm&) = delete;
  void operator=(const vtkIntervalAlgorithm&) = delete;

  vtkIntervalList Intervals;
  std::vector<Criterion> Criteria;
  int CriteriaOperation = INTERSECTION;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  bool WarnOnEmptyOutput = true;
  vtkIdType SizeWarningLimit = 5000000;
  vtkIdType PreviewCellLimit = 0;
  bool ReportBalance = false;
};

#endif
