// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingRun.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/ArrayMatch.h"
#include "Static/DataSetLeaves.h"
#include "Static/ExtractionInput.h"
#include "Static/SurfaceCells.h"
#include "TimeVarying/CriterionCut.h"
#include "TimeVarying/ProjectedTetrahedra.h"
#include "TimeVarying/TimeVaryingExtraction.h"
#include "TimeVarying/TimeVaryingOutput.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace interlume
{

namespace
{
// Fraction of the progress assigned to the extraction. The rest is assigned to generating the
// outputs.
constexpr double ExtractionFraction = 0.7;

std::vector<std::string> GetNames(const std::vector<TimeVaryingOptions::Criterion>& criteria)
{
  std::vector<std::string> names;
  for (const TimeVaryingOptions::Criterion& criterion : criteria)
  {
    names.push_back(criterion.ArrayName);
  }
  return names;
}

// Appends a part of a union, which no interval contains, to an output.
void AppendGrid(vtkDataSet* part, vtkDataSet* output)
{
  vtkUnstructuredGrid* const grid = vtkUnstructuredGrid::SafeDownCast(part);
  if (!grid || grid->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (vtkDataArray* ids = grid->GetCellData()->GetArray("IntervalId"))
  {
    ids->Fill(-1);
  }
  SurfaceCells::Append({ grid }, vtkUnstructuredGrid::SafeDownCast(output));
}
}

TimeVaryingRun::TimeVaryingRun(vtkAlgorithm* owner,
  const std::vector<vtkIntervalList::Interval>& intervals, const TimeVaryingOptions& options,
  const std::vector<int>& steps, const std::vector<double>& times, vtkIdType sizeWarningLimit,
  std::function<Error(vtkDataSet*)> checkCriteria)
  : Owner(owner)
  , Conversion(owner, 1, GetNames(options.Criteria))
  , Intervals(intervals)
  , Options(options)
  , Values(this->MakeValues())
  , Steps(steps)
  , Times(times)
  , Size(owner, sizeWarningLimit)
  , CheckCriteria(std::move(checkCriteria))
{
  for (std::size_t i = 0; options.IsUnion() && options.Part == 0 && i < options.Criteria.size();
       ++i)
  {
    TimeVaryingOptions part = options;
    part.Part = static_cast<int>(i) + 1;
    this->Parts.push_back(
      std::make_unique<TimeVaryingRun>(owner, intervals, part, steps, times, 0));
  }
}

ExtractionValues TimeVaryingRun::MakeValues()
{
  if (this->Options.Part == 0)
  {
    return ExtractionValues::ForIntervals(this->Intervals);
  }
  std::vector<vtkIntervalList::Interval> intervals = this->Intervals;
  this->Options.SkippedConstants = ExtractionValues::TakeConstants(intervals);
  return ExtractionValues::ForComplement(intervals);
}

void TimeVaryingRun::CopyStructure(vtkDataObject* input, vtkDataObject* output)
{
  if (vtkDataObjectTree* tree = vtkDataObjectTree::SafeDownCast(input))
  {
    vtkDataObjectTree::SafeDownCast(output)->CopyStructure(tree);
  }
  else if (vtkMultiBlockDataSet* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
  {
    blocks->SetNumberOfBlocks(static_cast<unsigned int>(DataSetLeaves::Get(input).size()));
  }
}

std::string TimeVaryingRun::DescribeStep() const
{
  std::ostringstream words;
  words << "Time step " << this->Steps[this->NextStep] << " (time " << this->Times[this->NextStep]
        << ")";
  return words.str();
}

void TimeVaryingRun::Warn(const std::string& what)
{
  if (!what.empty() &&
    std::find(this->Warnings.begin(), this->Warnings.end(), what) == this->Warnings.end())
  {
    this->Warnings.push_back(what);
  }
}

Error TimeVaryingRun::FindScalars(vtkDataSet*& input, vtkDataArray*& scalars)
{
  const CellArrayConversion::Selection selection = this->Conversion.Select(input);
  input = selection.Data;
  scalars = vtkDataArray::SafeDownCast(selection.Array);
  return ExtractionInput::CheckScalars(input, selection.Array, selection.Association,
    ExtractionInput::DescribeArrayToProcess(this->Owner))
    .Then([this, input] { return this->CheckCriteria ? this->CheckCriteria(input) : Error(); });
}

Error TimeVaryingRun::AddStep(vtkDataObject* input, Results& result)
{
  result = ABORTED;
  const std::vector<vtkDataSet*> leaves = DataSetLeaves::Get(input);
  if (this->NextStep == 0)
  {
    for (std::size_t number = 0; number < leaves.size(); ++number)
    {
      this->Leaves.push_back(std::make_unique<Leaf>(this->Options));
    }
  }
  if (leaves.size() != this->Leaves.size())
  {
    std::ostringstream why;
    why << this->DescribeStep() << ": the number of datasets is " << leaves.size() << " but was "
        << this->Leaves.size()
        << " at the previous time step. The cells must be the same at all time steps.";
    return why.str();
  }
  this->Owner->SetProgressText(
    (this->DescribeStep() + " of " + std::to_string(this->Times.size())).c_str());
  const bool hasSlab =
    this->NextStep > 0 && this->Times[this->NextStep] > this->Times[this->NextStep - 1];
  Error error;
  result = DONE;
  for (std::size_t number = 0; number < leaves.size() && result == DONE; ++number)
  {
    error = this->AddLeafStep(leaves[number], *this->Leaves[number], number, result);
  }
  for (std::size_t i = 0; i < this->Parts.size() && result == DONE; ++i)
  {
    error = this->Parts[i]->AddStep(input, result);
  }
  error = error.Within(this->DescribeStep() + ": ");
  if (this->NextStep > 0 && !hasSlab)
  {
    this->Warn(this->DescribeStep() +
      " has the same time as the previous step. The slab between them is skipped.");
  }
  this->UpdateEmptyDiagnosis();
  if (hasSlab)
  {
    RefinementLevels::Count(input, this->Intervals, this->Conversion, this->Report);
  }
  this->Report.ConvertedCellArrays = this->Conversion.GetNames();
  // The mesh and the step hold the arrays that they still need.
  this->Conversion.Clear();
  this->IsJoined = hasSlab;
  this->Report.Slabs += hasSlab;
  ++this->NextStep;
  this->Report.TimeSteps = this->NextStep;
  if (hasSlab && result == DONE)
  {
    this->CheckSize();
  }
  return error;
}

void TimeVaryingRun::AddSize(SizeWarning::Size& size)
{
  for (const std::unique_ptr<Leaf>& leaf : this->Leaves)
  {
    if (leaf->Before)
    {
      leaf->Tetrahedra += ProjectedTetrahedra::EstimateNumber(leaf->Mesh);
      size.Tetrahedra += leaf->Tetrahedra;
      size.Bytes += TimeVaryingOutput::EstimateBytes(leaf->Mesh, leaf->Tetrahedra);
    }
  }
}

void TimeVaryingRun::CheckSize()
{
  if (!this->Size.IsPending())
  {
    return;
  }
  SizeWarning::Size size;
  this->AddSize(size);
  for (const std::unique_ptr<TimeVaryingRun>& part : this->Parts)
  {
    part->AddSize(size);
  }
  const int slabs = static_cast<int>(this->Steps.size()) - 1;
  const double scale = static_cast<double>(slabs) / this->Report.Slabs;
  size.Tetrahedra *= scale;
  size.Bytes *= scale;
  size.Qualifier = "about ";
  std::ostringstream advice;
  advice << "Use ";
  if (slabs > 1)
  {
    const int stride = this->Options.Settings.TimeStepStride;
    const double sufficient = std::ceil(stride * this->Size.GetExcess(size.Tetrahedra, size.Bytes));
    advice << "fewer time steps (increase TimeStepStride, now " << stride << ", ";
    if (sufficient < static_cast<double>(stride) * slabs)
    {
      advice << "to about " << sufficient << ", ";
    }
    advice << "or call LimitTimeSteps), ";
    size.Basis = " (estimated from " + std::to_string(this->Report.Slabs) + " of " +
      std::to_string(slabs) + " time slabs)";
  }
  advice << "narrower intervals or a coarser input, or write the slabs to files with "
            "vtkTimeSlabWriter.";
  size.Advice = advice.str();
  this->Size.Check(size);
}

void TimeVaryingRun::WarnAboutNonFinitePoints(const TimeStep& step, vtkDataSet* input)
{
  const std::string warning =
    this->HasNonFiniteWarning ? std::string() : step.DescribeNonFinite(input);
  if (!warning.empty())
  {
    this->Warn(this->DescribeStep() + ": " + warning);
    this->HasNonFiniteWarning = true;
  }
}

void TimeVaryingRun::UpdateEmptyDiagnosis()
{
  if (this->Report.Simplices > 0)
  {
    this->Empty.Add(nullptr, nullptr, this->Report.Simplices - this->DiagnosedSimplices);
    this->DiagnosedSimplices = this->Report.Simplices;
  }
  else if (this->NextStep > 0)
  {
    // Examine the steps now because at most two of them remain in memory.
    this->Empty.Look();
  }
}

ExtractionContext TimeVaryingRun::MakeContext()
{
  ExtractionContext context;
  context.Owner = this->Owner;
  context.Values = &this->Values;
  context.Report = &this->Report;
  return context;
}

void TimeVaryingRun::SetProgressRange(double begin, double end, std::size_t leaf)
{
  const std::size_t parts = this->Options.IsUnion() ? this->Options.Criteria.size() + 1 : 1;
  const std::size_t leaves = this->Leaves.size();
  const double share = (end - begin) / static_cast<double>(parts * leaves);
  const std::size_t before = static_cast<std::size_t>(this->Options.Part) * leaves + leaf;
  this->Owner->SetProgressShiftScale(begin + static_cast<double>(before) * share, share);
}

Error TimeVaryingRun::AddLeafStep(
  vtkDataSet* input, Leaf& leaf, std::size_t number, Results& result)
{
  result = ABORTED;
  const bool isEmpty = !input || input->GetNumberOfPoints() == 0;
  if (this->NextStep > 0 && isEmpty != !leaf.Before)
  {
    return "a dataset is empty at this time step but not at the previous one, or vice versa. The "
           "cells must be the same at all time steps.";
  }
  if (isEmpty)
  {
    result = DONE;
    return {};
  }
  vtkDataArray* scalars = nullptr;
  if (Error error = this->FindScalars(input, scalars))
  {
    return error;
  }
  // Use the dataset of the second step for the diagnosis, because the source may have overwritten
  // the dataset of the first step. Both have the same cells.
  this->Empty.Add(this->NextStep == 1 ? input : nullptr, scalars, 0);
  leaf.ScalarsKey = ArrayMatch::GetKey(input->GetPointData(), scalars);
  if (leaf.Before && leaf.Before->IsOverwritten(input, scalars))
  {
    result = OVERWRITTEN;
    return {};
  }
  auto step = std::make_unique<TimeStep>(
    input, scalars, this->Times[this->NextStep], this->Options.CopiesSteps);
  if (this->NextStep == 0)
  {
    this->Report.ConcavePolyhedra += step->GetNumberOfConcave();
    this->Warn(ExtractionInput::CheckPolyhedra(step->GetNumberOfConcave()));
    this->Warn(ExtractionInput::CheckPrecision(input, this->Options.Precision));
  }
  this->WarnAboutNonFinitePoints(*step, input);
  const ExtractionContext context = this->MakeContext();
  const double fraction = ExtractionFraction / (static_cast<double>(this->Times.size()) - 1.0);
  const double slab = std::max(this->NextStep - 1, 0);
  this->SetProgressRange(slab * fraction, (slab + 1.0) * fraction, number);
  if (const Error error = leaf.Before ? step->FindDifference(*leaf.Before) : Error())
  {
    return error.Within("", ". The cells must be the same at all time steps.");
  }
  if (leaf.Before && step->GetTime() > leaf.Before->GetTime())
  {
    this->Report.Cells += step->GetNumberOfInputCells();
    const vtkIdType foldedInRows = ExtractionInput::CountFoldedRectilinearCells(step->GetGrid());
    this->FoldedInRows += foldedInRows;
    this->Report.FoldedCells += foldedInRows;
    this->Warn(ExtractionInput::CheckFolding(step->GetGrid(), foldedInRows));
    if (!leaf.Before->MakeCodes(context, 0.0, 0.05) || !step->MakeCodes(context, 0.05, 0.1))
    {
      return {};
    }
    leaf.Mesh.BeginSlab(this->NextStep - 1, this->NextStep == 1,
      this->NextStep + 1 == static_cast<int>(this->Times.size()), this->IsJoined,
      leaf.Before->HasTies() || step->HasTies());
    if (!TimeVaryingExtraction::Execute(context, *leaf.Before, *step, leaf.Mesh, this->Report))
    {
      return {};
    }
  }
  leaf.Before = std::move(step);
  result = DONE;
  return {};
}

bool TimeVaryingRun::ApplyCriterion(std::size_t number, TimeVaryingMesh& mesh)
{
  using Settings = vtkTimeVaryingSettings;
  const TimeVaryingOptions::Criterion& criterion = this->Options.Criteria[number];
  this->Owner->SetProgressText(("Cutting at " + criterion.Words).c_str());
  CriterionCut cut(mesh, criterion.ArrayName);
  if (!cut.GetArray())
  {
    this->Warn("The output is empty, since the array \"" + criterion.ArrayName +
      "\" of a criterion cannot be interpolated between the time steps. Convert it to one type.");
    return false;
  }
  const bool isExcluded = this->Options.IsExcluded(number);
  // The bounds of a criterion that excludes a part of a union are inside the union.
  const bool isInside = isExcluded && this->Options.IsUnion();
  const int kind = Settings::NUMBER_OF_BOUNDARY_KINDS + 2 * static_cast<int>(number);
  const auto getKind = [&](int side)
  {
    return !isInside &&
        this->Options.Settings.GenerateBoundary[Settings::LOWER_SURFACE_IN_TIME + side]
      ? kind + side
      : -1;
  };
  const CriterionCut::Half lower = { criterion.Lower, !isExcluded, isExcluded, getKind(0) };
  const CriterionCut::Half upper = { criterion.Upper, isExcluded, isExcluded, getKind(1) };
  const vtkIdType before = mesh.GetNumberOfSimplices();
  if (isExcluded)
  {
    cut.Execute({ lower, upper });
  }
  else
  {
    cut.Execute({ lower });
    cut.Execute({ upper });
  }
  const vtkIdType after = mesh.GetNumberOfSimplices();
  this->Report.Simplices += after - before;
  this->Empty.AddCriterion(number, criterion.Words, cut.GetArray(), before, after);
  return !this->Owner->GetAbortExecute();
}

bool TimeVaryingRun::ApplyCriteria(TimeVaryingMesh& mesh)
{
  for (std::size_t i = 0; i < this->Options.GetNumberOfCuts() && mesh.GetPoints(); ++i)
  {
    if (!this->ApplyCriterion(i, mesh))
    {
      return false;
    }
  }
  if (this->Options.GetNumberOfCuts() > 0 && mesh.GetPoints())
  {
    mesh.RemoveUnusedPoints();
  }
  return true;
}

bool TimeVaryingRun::AppendParts(const std::vector<vtkDataObject*>& outputs)
{
  for (const std::unique_ptr<TimeVaryingRun>& part : this->Parts)
  {
    std::vector<vtkSmartPointer<vtkDataObject>> grids;
    for (vtkDataObject* output : outputs)
    {
      grids.push_back(vtk::TakeSmartPointer(output->NewInstance()));
      CopyStructure(output, grids.back());
    }
    if (!part->FillOutputs(grids[0], grids[1], grids[2]))
    {
      for (const std::string& warning : part->GetWarnings())
      {
        this->Warn(warning);
      }
      return false;
    }
    for (std::size_t port = 0; port < outputs.size(); ++port)
    {
      const std::vector<vtkDataSet*> leaves = DataSetLeaves::Get(outputs[port]);
      const std::vector<vtkDataSet*> added = DataSetLeaves::Get(grids[port]);
      for (std::size_t i = 0; i < leaves.size(); ++i)
      {
        AppendGrid(added[i], leaves[i]);
      }
    }
    this->Report.AddOutput(part->Report);
    this->Empty.Add(nullptr, nullptr, part->Report.Simplices);
  }
  return true;
}

bool TimeVaryingRun::FillOutputs(
  vtkDataObject* tetrahedra, vtkDataObject* boundary, vtkDataObject* simplices)
{
  OutputLeaves tetrahedraLeaves(tetrahedra);
  OutputLeaves boundaryLeaves(boundary);
  OutputLeaves simplexLeaves(simplices);
  const ExtractionContext context = this->MakeContext();
  std::size_t bytes = 0;
  for (std::unique_ptr<Leaf>& leaf : this->Leaves)
  {
    bytes += leaf->Mesh.GetBytes();
  }
  context.UpdatePeakWorkingBytes(bytes);
  std::size_t filled = 0;
  for (std::unique_ptr<Leaf>& leaf : this->Leaves)
  {
    this->SetProgressRange(ExtractionFraction, 1.0, filled++);
    const bool isNeeded = leaf->Before != nullptr;
    leaf->Before.reset();
    if (!this->ApplyCriteria(leaf->Mesh))
    {
      return false;
    }
    this->Owner->SetProgressText("Generating the outputs");
    leaf->Mesh.ResolveTiedBoundary();
    leaf->Mesh.CleanStepVolume();
    this->Report.Simplices -=
      leaf->Mesh.RemoveOppositeSimplicesAtSteps() + leaf->Mesh.RemoveDuplicates();
    const TimeVaryingMesh& mesh = leaf->Mesh;
    ExtractionArrays::ActivateScalars(leaf->ScalarsKey.c_str(), mesh.GetArrays());
    ArrayMatch::RemoveKeys(mesh.GetArrays());
    vtkUnstructuredGrid* output = tetrahedraLeaves.GetNext(isNeeded);
    if (output && this->Options.Settings.GenerateTetrahedra &&
      !TimeVaryingOutput::FillTetrahedra(context, mesh, output, this->Report))
    {
      return false;
    }
    output = boundaryLeaves.GetNext(isNeeded);
    if (output && this->Options.HasBoundary())
    {
      TimeVaryingOutput::FillBoundary(mesh, output, this->Report);
    }
    output = simplexLeaves.GetNext(isNeeded);
    if (output && this->Options.Settings.GenerateSimplices)
    {
      TimeVaryingOutput::FillSimplices(mesh, output);
    }
    this->Report.ArraysInterpolated =
      std::max(this->Report.ArraysInterpolated, mesh.GetArrays()->GetNumberOfArrays());
    for (const std::string& key : mesh.GetSkippedArrays())
    {
      this->Warn((key[0] == ArrayMatch::KeyMark ? "A point array without a name"
                                                : "Point array \"" + key + "\"") +
        " is skipped: a time step lacks it, or it has the name of an array that this filter "
        "creates "
        "(Time or DeltaT).");
    }
    leaf.reset();
  }
  this->Warn(ExtractionInput::CheckFolding(nullptr, this->Report.FoldedCells - this->FoldedInRows));
  for (const std::string& warning : RefinementLevels::GetWarnings(this->Report))
  {
    this->Warn(warning);
  }
  return this->AppendParts({ tetrahedra, boundary, simplices });
}

}
