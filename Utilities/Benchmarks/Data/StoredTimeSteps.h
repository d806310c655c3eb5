// SPDX-License-Identifier: BSD-3-Clause
#ifndef StoredTimeSteps_h
#define StoredTimeSteps_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h"

#include <vector>

/**
 * @class   StoredTimeSteps
 * @brief   time steps held in memory, so that only the downstream filter is timed
 *
 * Provides TIME_STEPS and TIME_RANGE. The output is a shallow copy of the step at the requested
 * time, or of the last step before it.
 */
class StoredTimeSteps : public vtkDataObjectAlgorithm
{
public:
  static StoredTimeSteps* New();
  vtkTypeMacro(StoredTimeSteps, vtkDataObjectAlgorithm);

  /**
   * Computes all time steps of \a source and adds them.
   */
  void AddStepsFrom(vtkAlgorithm* source);

  /**
   * Adds a step. Steps must be of the same type and in ascending time order.
   */
  void AddStep(double time, vtkDataObject* data);

  int GetNumberOfSteps() const { return static_cast<int>(this->Times.size()); }
  double GetStepTime(int step) const { return this->Times[step]; }
  vtkDataObject* GetStep(int step) const { return this->Steps[step]; }

protected:
  StoredTimeSteps();
  ~StoredTimeSteps() override = default;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  StoredTimeSteps(const StoredTimeSteps&) = delete;
  void operator=(const StoredTimeSteps&) = delete;

  std::vector<double> Times;
  std::vector<vtkSmartPointer<vtkDataObject>> Steps;
};

#endif
