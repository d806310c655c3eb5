// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeStepsInformation_h
#define vtkTimeStepsInformation_h

#include "InterlumeDomainsModule.h" // for the export macro
#include "vtkPVInformation.h"

#include <string> // for the array
#include <vector> // for the intervals

/**
 * @class   vtkTimeStepsInformation
 * @brief   proposes the time steps of a time-varying interval volume
 *
 * Pass it to GatherInformation of the source proxy of the input. It calls
 * vtkTimeVaryingIntervalVolume::LimitTimeSteps in each process. The result has the largest stride
 * and the shortest range of all processes, and the sum of their estimates.
 */
class INTERLUMEDOMAINS_EXPORT vtkTimeStepsInformation : public vtkPVInformation
{
public:
  static vtkTimeStepsInformation* New();
  vtkTypeMacro(vtkTimeStepsInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The input and the settings of the filter.
  struct Request
  {
    int Port = 0;
    int Association = 0;
    std::string Array;
    /// Lower and upper value of each interval.
    std::vector<double> Intervals;
    /// First and last time step.
    int Range[2] = { 0, 0 };
    /// SizeWarningLimit.
    double Limit = 0.0;
  };
  void Initialize(const Request& request) { this->Settings = request; }

  ///@{
  /**
   * Return the proposed stride, the last time step and the estimated number of tetrahedra.
   */
  int GetStride() const { return this->Stride; }
  int GetLastStep() const { return this->LastStep; }
  double GetTetrahedra() const { return this->Tetrahedra; }
  ///@}

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkTimeStepsInformation() = default;
  ~vtkTimeStepsInformation() override = default;

private:
  vtkTimeStepsInformation(const vtkTimeStepsInformation&) = delete;
  void operator=(const vtkTimeStepsInformation&) = delete;

  Request Settings;
  int Stride = 1;
  int LastStep = VTK_INT_MAX;
  double Tetrahedra = 0.0;
};

#endif
