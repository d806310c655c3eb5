// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIntervalAlgorithm_h
#define vtkIntervalAlgorithm_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkIntervalList.h"          // for the intervals
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for why an output is empty

/**
 * @class   vtkIntervalAlgorithm
 * @brief   what filters of intervals of a scalar have in common: the intervals, and how they answer
 *
 * The scalar is SetInputArrayToProcess(0, ...), by default the active point scalars.
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
   * The intervals, in the units of the scalar: lower <= upper, both finite. They may touch, overlap
   * or leave gaps. Default none, which gives an empty output. Valid number: 0 to 10000. SetInterval
   * adds intervals where there are fewer; GetInterval leaves its arguments where there is none.
   */
  void SetNumberOfIntervals(int number);
  int GetNumberOfIntervals() const { return this->Intervals.GetNumber(); }
  void SetInterval(int i, double lower, double upper);
  void GetInterval(int i, double& lower, double& upper) const;
  ///@}

  ///@{
  /**
   * Precision of the output points: vtkAlgorithm::DEFAULT_PRECISION (that of the input's points;
   * float for image data), SINGLE_PRECISION or DOUBLE_PRECISION. Default DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Whether an execution that gives nothing warns, and says what is wrong and what the data have:
   * no interval, an interval outside the scalar's range, no three-dimensional cell, no points, and
   * what else a filter names. Said once for all datasets of a composite input. Of one piece of
   * several nothing is said that other pieces may have. Default on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  ///@{
  /**
   * If true, the processes of the global controller exchange the numbers of cells that gave output
   * at the end of an execution. They are in the field array `CellsOfProcesses` of the first output,
   * and their largest over their mean is in `LoadBalance`. Then all processes have to execute, each
   * asked for its piece; an empty piece, an error in here or an abort does not keep the others
   * waiting, an error of a filter before this one in some of them does. With one process, or other
   * pieces, nothing is done. Default off.
   */
  vtkSetMacro(ReportBalance, bool);
  vtkGetMacro(ReportBalance, bool);
  vtkBooleanMacro(ReportBalance, bool);
  ///@}

protected:
  vtkIntervalAlgorithm();
  ~vtkIntervalAlgorithm() override = default;

  const std::vector<vtkIntervalList::Interval>& GetIntervals() const
  {
    return this->Intervals.GetAll();
  }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /// Creates outputs that are unstructured grids or composite datasets, as the input is.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  /// Requests a layer of ghost cells where one of several pieces is requested.
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  /// Warns that the output is empty, where there is a reason, and a warning is wanted.
  void WarnOfEmptyOutput(const std::string& why);

private:
  vtkIntervalAlgorithm(const vtkIntervalAlgorithm&) = delete;
  void operator=(const vtkIntervalAlgorithm&) = delete;

  vtkIntervalList Intervals;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  bool WarnOnEmptyOutput = true;
  bool ReportBalance = false;
};

#endif
