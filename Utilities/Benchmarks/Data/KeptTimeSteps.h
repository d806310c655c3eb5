// SPDX-License-Identifier: BSD-3-Clause
#ifndef KeptTimeSteps_h
#define KeptTimeSteps_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h"

#include <vector>

/**
 * @class   KeptTimeSteps
 * @brief   time steps that are held in memory, so that what they feed is timed alone
 *
 * Hands out shallow copies. Tells TIME_STEPS and TIME_RANGE; gives the step of the time asked for,
 * or the last one before it.
 */
class KeptTimeSteps : public vtkDataObjectAlgorithm
{
public:
  static KeptTimeSteps* New();
  vtkTypeMacro(KeptTimeSteps, vtkDataObjectAlgorithm);

  /**
   * Makes every time step of \a source, one after the other, and adds it.
   */
  void AddStepsOf(vtkAlgorithm* source);

  /**
   * Adds a step later than the ones before, of the same type.
   */
  void AddStep(double time, vtkDataObject* data);

  int GetNumberOfSteps() const { return static_cast<int>(this->Times.size()); }
  double GetTimeOf(int step) const { return this->Times[step]; }
  vtkDataObject* GetStep(int step) const { return this->Steps[step]; }

protected:
  KeptTimeSteps();
  ~KeptTimeSteps() override = default;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  KeptTimeSteps(const KeptTimeSteps&) = delete;
  void operator=(const KeptTimeSteps&) = delete;

  std::vector<double> Times;
  std::vector<vtkSmartPointer<vtkDataObject>> Steps;
};

#endif
