// SPDX-License-Identifier: BSD-3-Clause
#include "Static/ExtractionRun.h"

#include "Output/ProcessBalance.h"
#include "Static/ExtractionInput.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <utility>

namespace interlume
{

ExtractionRun::ExtractionRun(vtkAlgorithm* owner, ArrayFinder findArray)
  : Owner(owner)
  , FindArray(std::move(findArray))
{
}

vtkDataArray* ExtractionRun::FindScalars(vtkDataSet* input, const std::function<Error()>& findError)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkAbstractArray* array = this->FindArray(input, association);
  const std::string wanted = ExtractionInput::DescribeArrayToProcess(this->Owner);
  if (const Error error =
        ExtractionInput::CheckScalars(input, array, association, wanted).Then(findError))
  {
    vtkErrorWithObjectMacro(this->Owner, << error);
    this->Empty.SetExplained();
    return nullptr;
  }
  return vtkDataArray::SafeDownCast(array);
}

void ExtractionRun::Add(vtkDataSet* input, int precision, const ExtractionReport& report)
{
  this->Report.Add(report);
  for (const std::string& warning : ExtractionInput::GetWarnings(input, precision, report))
  {
    vtkWarningWithObjectMacro(this->Owner, << warning);
  }
}

void ExtractionRun::Finish(
  const Goal& goal, bool gathersBalance, bool warnsIfEmpty, vtkInterlumeReport* report)
{
  RefinementLevels::Count(
    this->Owner->GetInputDataObject(0, 0), goal.Intervals, this->FindArray, this->Report);
  for (const std::string& warning : RefinementLevels::GetWarnings(this->Report))
  {
    vtkWarningWithObjectMacro(this->Owner, << warning);
  }
  if (gathersBalance)
  {
    ProcessBalance::Gather(this->Owner, this->Report);
  }
  this->Report.CopyTo(report);
  const std::string why = this->Empty.Explain(this->Owner, goal.Unset, goal.Sought);
  if (warnsIfEmpty && !why.empty())
  {
    vtkWarningWithObjectMacro(this->Owner, "The output is empty: " << why);
  }
}

}
