// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVStreamSurfaceParameters_h
#define vtkPVStreamSurfaceParameters_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkStreamSurfaceParameters.h"

/**
 * @class   vtkPVStreamSurfaceParameters
 * @brief   texture coordinates of stream surfaces by the mapping and the termination surfaces
 * upstream
 *
 * The mapping is the first vtkInflowMapping upstream of the input, along first connections; the
 * surfaces are those that the vtkImplicitFlowField upstream of it used last, with its ids. A
 * mapping and surfaces that the base class was given directly are replaced in each execution.
 *
 * Errors (vtkErrorMacro, empty output): no such filters upstream, as behind a reader of a file.
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
