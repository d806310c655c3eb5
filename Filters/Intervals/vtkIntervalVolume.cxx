// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalVolume.h"

#include "Arrays/ExtractionArrays.h"
#include "Grid/InteriorCellFilter.h"
#include "Output/BlockPool.h"
#include "Pass/CriterionRange.h"
#include "Pass/ExtractionIndex.h"
#include "Static/DataSetLeaves.h"
#include "Static/Extraction.h"
#include "Static/ExtractionInput.h"
#include "Static/ExtractionRun.h"
#include "Static/SurfaceCells.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkIntervalVolume);

vtkIntervalVolume::vtkIntervalVolume()
  : Index(vtkSmartPointer<interlume::ExtractionIndex>::New())
{
  this->SetNumberOfOutputPorts(2);
  interlume::ExtractionReport().CopyTo(this->Report);
}

vtkIntervalVolume::~vtkIntervalVolume() = default;

interlume::Error vtkIntervalVolume::CheckParameters(vtkDataSet* input) const
{
  return interlume::ExtractionInput::CheckIntervals(this->GetIntervals())
    .Then([&] { return this->CheckCriteria(input); });
}

int vtkIntervalVolume::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::ExtractionIndex* const index =
    this->Index->BeginExecution(this->UseValueIndex, this->GetPreviewCellLimit() > 0);
  interlume::ExtractionRun run(this, this->GetCriteriaArrayNames(), index,
    this->GetPreviewCellLimit(), this->GetSizeWarningLimit());
  run.GetEmptyOutputDiagnosis().SetMinimumDimension(this->SurfaceCells == NEVER ? 3 : 2);
  this->BeginMemory();
  interlume::DataSetLeaves::ForEach(this, inputs, outputs,
    [&](vtkDataSet* input, const std::vector<vtkUnstructuredGrid*>& grids)
    { this->ExtractFrom(input, run, grids[0], grids[1]); });
  this->EndMemory(run.GetReport());
  run.Finish({ this->GetIntervals(), this->DescribeIntervals(),
               this->GetNumberOfIntervals() == 0 ? "no interval is set." : "" },
    this->GetReportBalance(), this->GetWarnOnEmptyOutput(), this->Report);
  return 1;
}

void vtkIntervalVolume::ExtractFrom(vtkDataSet* input, interlume::ExtractionRun& run,
  vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary)
{
  if (input->GetNumberOfPoints() == 0 || this->GetNumberOfIntervals() == 0)
  {
    return;
  }
  vtkDataArray* scalars = run.FindScalars(input, [&] { return this->CheckParameters(input); });
  if (!scalars)
  {
    return;
  }
  const interlume::BlockPool::Use use(this->Memory.get());
  const auto found = interlume::SurfaceCells::FindDimensions(input);
  const bool hasSurfaces = found.HasSurfaces &&
    (this->SurfaceCells == ALWAYS || (this->SurfaceCells == WITHOUT_SOLIDS && !found.HasSolids));
  const bool isMixed = hasSurfaces && found.HasSolids;
  const double begin = this->GetProgressShift();
  const double scale = this->GetProgressScale();
  this->SetProgressShiftScale(begin, isMixed ? 0.5 * scale : scale);
  bool completed = this->ExtractCells(
    hasSurfaces && !isMixed ? 2 : 3, isMixed, input, scalars, run, output, boundary);
  if (completed && isMixed)
  {
    vtkNew<vtkUnstructuredGrid> surfaces;
    vtkNew<vtkUnstructuredGrid> lines;
    this->SetProgressShiftScale(begin + 0.5 * scale, 0.5 * scale);
    completed = this->ExtractCells(2, isMixed, input, scalars, run, surfaces, lines);
    if (completed)
    {
      interlume::SurfaceCells::Append(
        { surfaces.GetPointer() }, { lines.GetPointer() }, output, boundary);
    }
  }
  for (vtkUnstructuredGrid* grid : { output, boundary })
  {
    if (completed)
    {
      interlume::ExtractionArrays::ActivateScalars(scalars->GetName(), grid->GetPointData());
    }
    else
    {
      grid->Initialize();
    }
    // Restore the field data of the outputs, which criteria or an abort may have cleared.
    grid->GetFieldData()->ShallowCopy(input->GetFieldData());
  }
}

bool vtkIntervalVolume::ExtractCells(int dimension, bool isMixed, vtkDataSet* input,
  vtkDataArray* scalars, interlume::ExtractionRun& run, vtkUnstructuredGrid* output,
  vtkUnstructuredGrid* boundary)
{
  const int criteria = this->GetNumberOfCriteria();
  const bool isUnion = criteria > 0 && this->GetCriteriaOperation() == UNION;
  const bool isDifference = criteria > 0 && this->GetCriteriaOperation() == DIFFERENCE;
  const int passes = isUnion ? 2 * criteria + 1 : criteria + 1;
  this->SetProgressShiftScale(this->GetProgressShift(), this->GetProgressScale() / passes);
  this->SetProgressText("Extracting the intervals");
  interlume::InteriorCellPass interiorPass;
  interlume::InteriorCellPass* const whole =
    this->KeepInteriorCells && dimension == 3 && !isDifference ? &interiorPass : nullptr;
  bool completed =
    this->ExtractIntervals(dimension, isMixed, input, scalars, run, whole, output, boundary);
  // In a mixed dataset, the first of two extractions has added the input already.
  const bool isAdded = isMixed && dimension == 2;
  run.GetEmptyOutputDiagnosis().Add(
    isAdded ? nullptr : input, isAdded ? nullptr : scalars, output->GetNumberOfCells());
  if (isUnion)
  {
    completed = completed && this->AppendCriteria(dimension, input, scalars, run, output, boundary);
  }
  for (int number = 0; completed && !isUnion && number < criteria; ++number)
  {
    const vtkIdType before = output->GetNumberOfCells();
    vtkSmartPointer<vtkDataArray> array =
      output->GetPointData()->GetArray(this->GetCriteria()[number].ArrayName.c_str());
    completed = this->ApplyCriterion(dimension, number, isDifference, run, whole, output, boundary);
    run.GetEmptyOutputDiagnosis().AddCriterion(
      number, this->DescribeCriterion(number), array, before, output->GetNumberOfCells());
  }
  if (completed)
  {
    run.GetReport().Passes = passes;
  }
  return completed;
}

bool vtkIntervalVolume::AppendCriteria(int dimension, vtkDataSet* input, vtkDataArray* scalars,
  interlume::ExtractionRun& run, vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary)
{
  const int criteria = this->GetNumberOfCriteria();
  std::vector<interlume::CriterionRange> ranges;
  for (const Criterion& criterion : this->GetCriteria())
  {
    ranges.push_back({ { input->GetPointData()->GetArray(criterion.ArrayName.c_str()) },
      criterion.Lower, criterion.Upper });
  }
  const vtkSmartPointer<vtkDataSet> overlapping = interlume::ExtractionInput::HideCells(input,
    [&ranges](vtkIdList* points)
    {
      return std::none_of(ranges.begin(), ranges.end(),
        [points](const interlume::CriterionRange& range)
        { return range.Overlaps(points->GetPointer(0), points->GetNumberOfIds()); });
    });
  interlume::Extraction extraction;
  std::vector<vtkIntervalList::Interval> intervals = this->GetIntervals();
  extraction.SkippedConstants = interlume::ExtractionValues::TakeConstants(intervals);
  const interlume::ExtractionValues values = interlume::ExtractionValues::ForComplement(intervals);
  interlume::ExtractionReport report;
  extraction.Owner = this;
  extraction.Values = &values;
  extraction.IdName = "IntervalId";
  extraction.Dimension = dimension;
  extraction.OutputPointsPrecision = this->GetOutputPointsPrecision();
  vtkNew<vtkUnstructuredGrid> rest;
  this->StartPass("Extracting the cells that satisfy a criterion");
  bool completed = extraction.Execute(overlapping, scalars, rest, nullptr, report);
  interlume::SurfaceCells::Grids parts;
  interlume::SurfaceCells::Grids boundaries;
  for (int number = 0; completed && number < criteria; ++number)
  {
    rest->GetCellData()->GetArray("IntervalId")->Fill(-1);
    parts.push_back(vtkSmartPointer<vtkUnstructuredGrid>::New());
    boundaries.push_back(vtkSmartPointer<vtkUnstructuredGrid>::New());
    parts.back()->ShallowCopy(rest);
    completed =
      this->ApplyCriterion(dimension, number, false, run, nullptr, parts.back(), boundaries.back());
    if (completed && number + 1 < criteria)
    {
      completed = this->ApplyCriterion(dimension, number, true, run, nullptr, rest, nullptr);
    }
  }
  for (vtkUnstructuredGrid* part : parts)
  {
    run.GetEmptyOutputDiagnosis().Add(nullptr, nullptr, part->GetNumberOfCells());
    run.GetSizeWarning().Add(static_cast<double>(part->GetNumberOfCells()),
      1024.0 * static_cast<double>(part->GetActualMemorySize()),
      "Use narrower ranges of criteria or a coarser input.",
      dimension == 2 ? "triangles" : "tetrahedra");
  }
  if (completed)
  {
    interlume::SurfaceCells::Append(parts, boundaries, output, boundary);
  }
  return completed;
}

void vtkIntervalVolume::StartPass(const std::string& text)
{
  this->SetProgressText(text.c_str());
  const double scale = this->GetProgressScale();
  this->SetProgressShiftScale(this->GetProgressShift() + scale, scale);
}

void vtkIntervalVolume::BeginMemory()
{
  if (!this->ReuseMemory)
  {
    this->Memory.reset();
    return;
  }
  if (!this->Memory)
  {
    this->Memory = std::make_unique<interlume::BlockPool>();
  }
  this->Memory->BeginExecution();
}

void vtkIntervalVolume::EndMemory(interlume::ExtractionReport& report)
{
  if (this->Memory)
  {
    this->Memory->EndExecution();
    report.ReusedBytes = static_cast<vtkIdType>(this->Memory->GetBytesReused());
    report.IdleBytes = static_cast<vtkIdType>(this->Memory->GetBytesIdle());
  }
}

bool vtkIntervalVolume::ExtractIntervals(int dimension, bool isMixed, vtkDataSet* input,
  vtkDataArray* scalars, interlume::ExtractionRun& run, interlume::InteriorCellPass* whole,
  vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary)
{
  for (const Criterion& criterion : this->GetCriteria())
  {
    if (whole && this->GetCriteriaOperation() == INTERSECTION)
    {
      whole->ExcludePointsOutside(input->GetPointData()->GetArray(criterion.ArrayName.c_str()),
        criterion.Lower, criterion.Upper);
    }
  }
  const interlume::ExtractionValues values =
    interlume::ExtractionValues::ForIntervals(this->GetIntervals());
  interlume::ExtractionReport report;
  interlume::Extraction extraction;
  extraction.Owner = this;
  extraction.Values = &values;
  extraction.Warning = &run.GetSizeWarning();
  extraction.Index = run.GetIndex();
  extraction.IdName = "IntervalId";
  extraction.Dimension = dimension;
  extraction.IsMixed = isMixed;
  extraction.OutputPointsPrecision = this->GetOutputPointsPrecision();
  extraction.GenerateBoundaries = this->GenerateBoundaries;
  extraction.GenerateOriginArrays =
    this->GenerateOriginArrays && this->GetCriteria().empty() && !run.IsCoarse();
  extraction.InteriorPass = whole;
  const bool completed = extraction.Execute(input, scalars, output, boundary, report);
  run.Add(input, dimension, this->GetOutputPointsPrecision(), report);
  return completed;
}

bool vtkIntervalVolume::ApplyCriterion(int dimension, int number, bool isInverted,
  interlume::ExtractionRun& run, interlume::InteriorCellPass* whole, vtkUnstructuredGrid* grid,
  vtkUnstructuredGrid* boundary)
{
  const Criterion& criterion = this->GetCriteria()[number];
  this->StartPass("Cutting at the criterion on " + criterion.ArrayName);
  vtkNew<vtkUnstructuredGrid> before;
  vtkNew<vtkUnstructuredGrid> boundaryBefore;
  before->ShallowCopy(grid);
  grid->Initialize();
  if (boundary)
  {
    boundaryBefore->ShallowCopy(boundary);
    boundary->Initialize();
  }
  const std::vector<std::array<double, 2>> range = { { { criterion.Lower, criterion.Upper } } };
  const interlume::ExtractionValues values = isInverted
    ? interlume::ExtractionValues::ForComplement(range)
    : interlume::ExtractionValues::ForIntervals(range);
  const int lowerSide = 2 * number + 2;
  interlume::ExtractionReport report;
  interlume::Extraction extraction;
  extraction.Owner = this;
  extraction.Values = &values;
  extraction.Dimension = dimension;
  extraction.KeepOrientation = true;
  extraction.InteriorPass = whole;
  extraction.GenerateBoundaries = this->GenerateBoundaries && boundary;
  extraction.InputBoundary = extraction.GenerateBoundaries ? boundaryBefore.GetPointer() : nullptr;
  // The lower bound of a criterion is the upper end of a region outside of it.
  extraction.Sides = { { lowerSide + isInverted, lowerSide + !isInverted } };
  vtkDataArray* array = before->GetPointData()->GetArray(criterion.ArrayName.c_str());
  const bool completed = extraction.Execute(before, array, grid, boundary, report);
  interlume::ExtractionReport& sum = run.GetReport();
  sum.CollapsedSimplices += report.CollapsedSimplices;
  sum.WorkingBytes = std::max(sum.WorkingBytes,
    report.WorkingBytes + 1024 * static_cast<vtkIdType>(before->GetActualMemorySize()));
  return completed;
}

void vtkIntervalVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenerateBoundaries: " << this->GenerateBoundaries << "\n";
  os << indent << "KeepInteriorCells: " << this->KeepInteriorCells << "\n";
  os << indent << "GenerateOriginArrays: " << this->GenerateOriginArrays << "\n";
  os << indent << "UseValueIndex: " << this->UseValueIndex << "\n";
  os << indent << "ReuseMemory: " << this->ReuseMemory << "\n";
  os << indent << "SurfaceCells: " << this->SurfaceCells << "\n";
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
