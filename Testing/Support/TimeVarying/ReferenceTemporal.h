// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTemporal_h
#define ReferenceTemporal_h

#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include "vtkAlgorithm.h"

#include <memory> // for the count
#include <vector> // for the requests

namespace reference
{

/**
 * @class   TimeStepSource
 * @brief   temporal source that returns given time steps
 *
 * Returns the last step whose time is not after the requested time, or the first step if there is
 * none. Every request returns a copy, so that the number of copies in memory can be counted. A copy
 * is counted until the first point array of its first dataset is deleted, which happens when the
 * copy's data is no longer referenced. Named point arrays that two steps share are not copied.
 */
class TimeStepSource : public vtkAlgorithm
{
public:
  static TimeStepSource* New();
  vtkTypeMacro(TimeStepSource, vtkAlgorithm);

  /// Sets the steps, whose data may be of any type. Their times are reported in the given order,
  /// even if it is not increasing.
  void SetSteps(const TimeSteps& steps);
  /// Sets whether TIME_STEPS is reported. Default: true.
  void SetReportTimeSteps(bool isReported);

  /// Returns the index of the step returned by each request, in order of the requests.
  const std::vector<int>& GetRequests() const { return this->Requests; }
  void ClearRequests() { this->Requests.clear(); }
  /// Returns the maximum number of steps in memory at the same time since SetSteps().
  int GetMaximumStepsInMemory() const;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  TimeStepSource(const TimeStepSource&) = delete;
  void operator=(const TimeStepSource&) = delete;

protected:
  TimeStepSource();
  ~TimeStepSource() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  struct Population
  {
    int Alive = 0;
    int Maximum = 0;
  };

  void ReportInformation(vtkInformation* info);
  void ReturnStep(vtkInformation* info);
  /// Replaces copies of arrays that the step shares with another step.
  void ShareArrays(int step, vtkDataObject* copy) const;
  int FindStep(vtkInformation* info) const;
  void Count(vtkDataObject* data);

  TimeSteps Steps;
  bool ReportsTimes = true;
  std::vector<int> Requests;
  std::shared_ptr<Population> Alive;
};

}

#endif
