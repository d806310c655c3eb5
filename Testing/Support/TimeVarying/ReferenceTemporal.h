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
 * @class   TemporalGrids
 * @brief   hands out a list of time steps through the pipeline
 *
 * The step handed out is the last one whose time is not after the time asked for, or the first.
 * Every request gets a copy, so that it can be counted how many live at a time; the count is of the
 * first point array of the first data set, which lives as long as anything was kept of the step.
 */
class TemporalGrids : public vtkAlgorithm
{
public:
  static TemporalGrids* New();
  vtkTypeMacro(TemporalGrids, vtkAlgorithm);

  /// The steps, of any type. Times are told as they are, whatever their order.
  void SetSteps(const TimeSteps& steps);
  /// Whether TIME_STEPS is told at all. Default true.
  void SetTellsTimes(bool tells);

  /// The numbers of the steps that were handed out, in order.
  const std::vector<int>& GetRequests() const { return this->Requests; }
  void ClearRequests() { this->Requests.clear(); }
  /// How many steps were alive at most, since they were set.
  int GetMostAlive() const;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  TemporalGrids(const TemporalGrids&) = delete;
  void operator=(const TemporalGrids&) = delete;

protected:
  TemporalGrids();
  ~TemporalGrids() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  struct Population
  {
    int Alive = 0;
    int Most = 0;
  };

  void TellInformation(vtkInformation* info);
  void HandOut(vtkInformation* info);
  int FindStep(vtkInformation* info) const;
  void Count(vtkDataObject* data);

  TimeSteps Steps;
  bool TellsTimes = true;
  std::vector<int> Requests;
  std::shared_ptr<Population> Alive;
};

}

#endif
