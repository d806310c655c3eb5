// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVStreamSurfaceParameters_h
#define vtkPVStreamSurfaceParameters_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkStreamSurfaceParameters.h"

/**
 * @class   vtkPVStreamSurfaceParameters
 * @brief   compute texture coordinates of stream surfaces from the filters upstream
 *
 * The mapping is the first vtkInflowMapping upstream of the input. The termination surfaces and
 * their ids are those of the last execution of the vtkImplicitFlowField upstream of the mapping.
 * The search follows the first connection of input port 0. Each execution replaces a mapping and
 * surfaces that were set directly in the superclass.
 *
 * Errors (vtkErrorMacro, empty output): one of these filters is missing upstream, for example
 * because the input was read from a file.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVStreamSurfaceParameters : public vtkStreamSurfaceParameters
{
public:
  static vtkPVStreamSurfaceParameters* New();
  vtkTypeMacro(vtkPVStreamSurfaceParameters, vtkStreamSurfaceParameters);

protected:
  vtkPVStreamSurfaceParameters();
  ~vtkPVStreamSurfaceParameters() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPVStreamSurfaceParameters(const vtkPVStreamSurfaceParameters&) = delete;
  void operator=(const vtkPVStreamSurfaceParameters&) = delete;
};

#endif
