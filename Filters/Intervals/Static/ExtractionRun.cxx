// SPDX-License-Identifier: BSD-3-Clause
#include "Static/ExtractionRun.h"

#include "Output/ProcessBalance.h"
#include "Pass/ExtractionIndex.h"
#include "Static/DataSetLeaves.h"
#include "Static/ExtractionInput.h"
#include "Static/GridSampling.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

namespace interlume
{

ExtractionRun::ExtractionRun(vtkAlgorithm* owner, const std::vector<std::string>& names,
  ExtractionIndex* index, vtkIdType previewCellLimit, vtkIdType sizeWarningLimit)
  : Owner(owner)
  , Index(index)
  , Stride(previewCellLimit > 0
        ? GridSampling::ChooseStride(
            DataSetLeaves::Get(owner->GetInputDataObject(0, 0)), previewCellLimit)
        : 0)
  , Conversion(owner, 1, names, index ? &index->GetConvertedArrays() : nullptr)
  , Size(owner, previewCellLimit > 0 ? 0 : sizeWarningLimit)
{
}

vtkDataArray* ExtractionRun::FindScalars(
  vtkDataSet*& input, const std::function<Error()>& findError)
{
  if (this->IsCoarse())
  {
    ExtractionIndex::CoarseGrid& coarse = this->Index->GetCoarseGrid(input);
    if (coarse.Stride != this->Stride)
    {
      coarse.Grid = GridSampling::Sample(input, this->Stride);
      coarse.Stride = this->Stride;
    }
    input = coarse.Grid ? coarse.Grid.GetPointer() : input;
  }
  const CellArrayConversion::Selection selection = this->Conversion.Select(input);
  input = selection.Data;
  const std::string wanted = ExtractionInput::DescribeArrayToProcess(this->Owner);
  if (const Error error =
        ExtractionInput::CheckScalars(input, selection.Array, selection.Association, wanted)
          .Then(findError))
  {
    vtkErrorWithObjectMacro(this->Owner, << error);
    this->Empty.SetExplained();
    return nullptr;
  }
  return vtkDataArray::SafeDownCast(selection.Array);
}

void ExtractionRun::Add(
  vtkDataSet* input, int dimension, int precision, const ExtractionReport& report)
{
  this->Report.Add(report);
  if (this->Stride > 0)
  {
    return;
  }
  for (const std::string& warning :
    ExtractionInput::GetWarnings(input, dimension, precision, report))
  {
    vtkWarningWithObjectMacro(this->Owner, << warning);
  }
}

void ExtractionRun::Finish(
  const Goal& goal, bool gathersBalance, bool warnsIfEmpty, vtkInterlumeReport* report)
{
  if (this->Stride == 0)
  {
    RefinementLevels::Count(
      this->Owner->GetInputDataObject(0, 0), goal.Intervals, this->Conversion, this->Report);
  }
  for (const std::string& warning : RefinementLevels::GetWarnings(this->Report))
  {
    vtkWarningWithObjectMacro(this->Owner, << warning);
  }
  if (gathersBalance)
  {
    ProcessBalance::Gather(this->Owner, this->Report);
  }
  this->Report.ConvertedCellArrays = this->Conversion.GetNames();
  this->Report.CopyTo(report);
  const std::string why = this->Empty.Explain(this->Owner, goal.Unset, goal.Sought);
  if (warnsIfEmpty && this->Stride == 0 && !why.empty())
  {
    vtkWarningWithObjectMacro(this->Owner, "The output is empty: " << why);
  }
}

}
