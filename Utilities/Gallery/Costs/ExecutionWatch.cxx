// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Costs/ExecutionWatch.h"

#include "Gallery/Stopwatch.h"

#include "vtkCompositeDataPipeline.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>

namespace gallery
{
namespace
{
ExecutionWatch* Current = nullptr;

/// The executive that most algorithms have, which tells of executions.
class WatchedPipeline : public vtkCompositeDataPipeline
{
public:
  static WatchedPipeline* New();
  vtkTypeMacro(WatchedPipeline, vtkCompositeDataPipeline);

protected:
  int ExecuteData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const Stopwatch watch;
    const int result = this->Superclass::ExecuteData(request, inputs, outputs);
    ExecutionWatch::Note(this->GetAlgorithm(), watch.Seconds());
    return result;
  }
};
vtkStandardNewMacro(WatchedPipeline);
}

void ExecutionCosts::AddOutputs(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = algorithm->GetOutputDataObject(port);
    for (int type = 0; output && type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
    {
      vtkFieldData* arrays = output->GetAttributesAsFieldData(type);
      this->Arrays += arrays ? arrays->GetNumberOfArrays() : 0;
    }
    this->Bytes += output ? static_cast<vtkIdType>(1024 * output->GetActualMemorySize()) : 0;
  }
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

void ExecutionWatch::Note(vtkAlgorithm* algorithm, double seconds)
{
  if (!Current)
  {
    return;
  }
  ExecutionCosts& costs = Current->Classes[algorithm->GetClassName()];
  ++costs.Executions;
  costs.Seconds += seconds;
  costs.AddOutputs(algorithm);
  auto& kept = Current->Algorithms;
  if (std::find(kept.begin(), kept.end(), algorithm) == kept.end())
  {
    kept.emplace_back(algorithm);
  }
}
}
