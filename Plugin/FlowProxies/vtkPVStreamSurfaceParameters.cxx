// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVStreamSurfaceParameters.h"

#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkObjectFactory.h"
#include "vtkTerminationSurface.h"

vtkStandardNewMacro(vtkPVStreamSurfaceParameters);

namespace
{
/// Returns the nearest upstream \a Filter along the first connections of port 0, or null if there
/// is none. Skips other filters, such as those that ParaView inserts.
template <typename Filter>
Filter* FindUpstream(vtkAlgorithm* algorithm)
{
  while (algorithm && algorithm->GetNumberOfInputPorts() > 0 &&
    algorithm->GetNumberOfInputConnections(0) > 0)
  {
    algorithm = algorithm->GetInputAlgorithm(0, 0);
    if (Filter* found = Filter::SafeDownCast(algorithm))
    {
      return found;
    }
  }
  return nullptr;
}
}

vtkPVStreamSurfaceParameters::vtkPVStreamSurfaceParameters() = default;

vtkPVStreamSurfaceParameters::~vtkPVStreamSurfaceParameters() = default;

int vtkPVStreamSurfaceParameters::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInflowMapping* mapping = FindUpstream<vtkInflowMapping>(this);
  vtkImplicitFlowField* flow = FindUpstream<vtkImplicitFlowField>(mapping);
  if (!flow)
  {
    vtkErrorMacro(
      "There is no " << (mapping ? "vtkImplicitFlowField" : "vtkInflowMapping")
                     << " upstream. Connect the input to a pipeline with Implicit Flow Field, "
                        "Inflow Mapping and Flow Volume.");
    return 1;
  }
  this->SetMapping(mapping);
  this->RemoveAllTerminationSurfaces();
  for (int i = 0; i < flow->GetNumberOfUsedSurfaces(); ++i)
  {
    this->AddTerminationSurface(flow->GetUsedSurface(i), flow->GetUsedSurfaceId(i));
  }
  return this->Superclass::RequestData(request, inputs, outputs);
}
