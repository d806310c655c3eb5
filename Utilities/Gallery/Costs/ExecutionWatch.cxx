// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Costs/ExecutionWatch.h"

#include "vtkCompositeDataPipeline.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>

namespace gallery
{
namespace
{
ExecutionWatch* Current = nullptr;

/// The default executive of VTK, extended to report each execution.
class WatchedPipeline : public vtkCompositeDataPipeline
{
public:
  static WatchedPipeline* New();
  vtkTypeMacro(WatchedPipeline, vtkCompositeDataPipeline);

protected:
  int ExecuteData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const int result = this->Superclass::ExecuteData(request, inputs, outputs);
    ExecutionWatch::RecordExecution(this->GetAlgorithm());
    return result;
  }
};
vtkStandardNewMacro(WatchedPipeline);
}

ExecutionWatch::ExecutionWatch()
{
  Current = this;
  vtkNew<WatchedPipeline> prototype;
  vtkAlgorithm::SetDefaultExecutivePrototype(prototype);
}

ExecutionWatch::~ExecutionWatch()
{
  vtkAlgorithm::SetDefaultExecutivePrototype(nullptr);
  Current = nullptr;
}

void ExecutionWatch::RecordExecution(vtkAlgorithm* algorithm)
{
  if (Current)
  {
    auto& found = Current->Algorithms;
    if (std::find(found.begin(), found.end(), algorithm) == found.end())
    {
      found.emplace_back(algorithm);
    }
  }
}
}
