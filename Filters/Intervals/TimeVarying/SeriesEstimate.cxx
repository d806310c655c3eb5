// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SeriesEstimate.h"

#include "Common/Blanking.h"
#include "Pass/GhostCells.h"
#include "Static/DataSetLeaves.h"
#include "TimeVarying/TimeVaryingRun.h"

#include "vtkAlgorithm.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

namespace interlume
{

namespace
{
// Number of sampled cells: a fraction of all cells, within bounds. The lower bound determines the
// accuracy, and the upper bound the memory.
constexpr vtkIdType CellsPerSampledCell = 25;
constexpr vtkIdType MinimumSample = 6000;
constexpr vtkIdType MaximumSample = 50000;
// Number of sampled slabs for each distance.
constexpr int SampledSlabs = 6;

vtkTimeVaryingSettings GetTetrahedraSettings(vtkTimeVaryingSettings settings)
{
  settings.GenerateTetrahedra = true;
  settings.GenerateSimplices = false;
  settings.GenerateBoundary = {};
  return settings;
}

vtkIdType GetNumberOfCells(const std::vector<vtkDataSet*>& leaves)
{
  return std::accumulate(leaves.begin(), leaves.end(), vtkIdType(0),
    [](vtkIdType sum, vtkDataSet* leaf) { return sum + (leaf ? leaf->GetNumberOfCells() : 0); });
}

// Returns the value at a position, interpolated linearly, or the first or last value outside.
double Interpolate(const std::map<int, double>& values, int at)
{
  const auto after = values.lower_bound(at);
  if (after == values.end())
  {
    return values.rbegin()->second;
  }
  if (after == values.begin() || after->first == at)
  {
    return after->second;
  }
  const auto before = std::prev(after);
  const double weight =
    static_cast<double>(at - before->first) / static_cast<double>(after->first - before->first);
  return before->second + weight * (after->second - before->second);
}

bool IsSkipped(const Blanking& blanking, vtkIdType cell, vtkIdList* ids)
{
  return blanking.IsCellBlanked(cell) ||
    std::any_of(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfIds(),
      [&blanking](vtkIdType point) { return blanking.IsPointBlanked(point); });
}
}

SeriesEstimate::SeriesEstimate(vtkAlgorithm* owner,
  const std::vector<vtkIntervalList::Interval>& intervals, const vtkTimeVaryingSettings& settings,
  const std::vector<double>& times)
  : Conversion(owner, 1)
  , Intervals(intervals)
  , Settings(GetTetrahedraSettings(settings))
  , Times(times)
{
}

std::vector<SeriesEstimate::Pair> SeriesEstimate::FindPairs(int distance) const
{
  const int last = this->GetLastStep();
  const int slabs = std::min(SampledSlabs, last);
  std::vector<Pair> pairs;
  // All distances use the same first steps, so that few steps are read.
  for (int i = 0; i < slabs; ++i)
  {
    const int at = (2 * i + 1) * last / (2 * slabs);
    if (at + distance <= last)
    {
      pairs.push_back({ at, at + distance });
    }
    else if (at - distance >= 0)
    {
      pairs.push_back({ at - distance, at });
    }
  }
  return pairs.empty() ? std::vector<Pair>{ { 0, distance } } : pairs;
}

bool SeriesEstimate::Read(const std::vector<int>& distances, const StepReader& read)
{
  std::set<int> steps;
  for (const int distance : distances)
  {
    for (const Pair& pair : this->FindPairs(distance))
    {
      steps.insert({ pair.First, pair.Second });
    }
  }
  // Read all steps even if one is invalid, because other processes may read them together.
  bool isValid = true;
  for (const int step : steps)
  {
    vtkDataObject* data = read(step);
    const std::vector<vtkDataSet*> leaves = DataSetLeaves::Get(data);
    if (this->Values.empty() && isValid)
    {
      this->SampleCells(leaves);
    }
    isValid = isValid && data && this->SampleValues(step, leaves);
  }
  if (!isValid)
  {
    return false;
  }
  for (const int distance : distances)
  {
    std::map<int, double>& sizes = this->SlabSizes[distance];
    for (const Pair& pair : this->FindPairs(distance))
    {
      sizes[pair.First] = this->CountTetrahedra(pair);
    }
    this->MeanSizes[distance] = std::accumulate(sizes.begin(), sizes.end(), 0.0,
                                  [](double sum, const auto& size) { return sum + size.second; }) /
      static_cast<double>(sizes.size());
  }
  return true;
}

void SeriesEstimate::SampleCells(const std::vector<vtkDataSet*>& leaves)
{
  const vtkIdType cells = GetNumberOfCells(leaves);
  const vtkIdType samples =
    std::min(cells, std::clamp(cells / CellsPerSampledCell, MinimumSample, MaximumSample));
  this->CellsPerSample =
    samples > 0 ? static_cast<double>(cells) / static_cast<double>(samples) : 1.0;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  this->Cells->SetPoints(points);
  this->Cells->AllocateEstimate(samples, 8);
  // Index of the next sample, and of the first cell of the leaf, counted over all leaves.
  vtkIdType next = 0;
  vtkIdType begin = 0;
  for (vtkDataSet* leaf : leaves)
  {
    this->Points.emplace_back();
    Blanking blanking;
    if (leaf)
    {
      GhostCells::SetBlanking(leaf, blanking);
    }
    const vtkIdType end = begin + (leaf ? leaf->GetNumberOfCells() : 0);
    for (; next < samples; ++next)
    {
      // Vary the position within the stretch of cells that a sample represents. At a constant
      // position, all samples of an image could be in the same few columns.
      const double shift = samples == cells ? 0.0 : std::fmod(0.6180339887498949 * next, 1.0);
      const auto cell = std::min(cells - 1,
        static_cast<vtkIdType>(this->CellsPerSample * (static_cast<double>(next) + shift)));
      if (cell >= end)
      {
        break;
      }
      this->SampleCell(leaf, cell - begin, blanking);
    }
    begin = end;
  }
}

// Copies a cell with its own points, in the order of the ids in the grid, which determines how the
// cell is split.
void SeriesEstimate::SampleCell(vtkDataSet* leaf, vtkIdType cell, const Blanking& blanking)
{
  vtkNew<vtkIdList> ids;
  leaf->GetCellPoints(cell, ids);
  if (IsSkipped(blanking, cell, ids))
  {
    return;
  }
  std::vector<vtkIdType> sorted(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfIds());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  const vtkIdType before = this->Cells->GetNumberOfPoints();
  for (const vtkIdType id : sorted)
  {
    this->Cells->GetPoints()->InsertNextPoint(leaf->GetPoint(id));
  }
  std::vector<vtkIdType>& points = this->Points.back();
  points.insert(points.end(), sorted.begin(), sorted.end());
  const auto map = [&sorted, before](vtkIdList* list, vtkIdType at)
  {
    const auto found = std::lower_bound(sorted.begin(), sorted.end(), list->GetId(at));
    list->SetId(at, before + std::distance(sorted.begin(), found));
  };
  const int type = leaf->GetCellType(cell);
  if (auto* grid = type == VTK_POLYHEDRON ? vtkUnstructuredGrid::SafeDownCast(leaf) : nullptr)
  {
    // A face stream contains the number of faces and, for each face, its number of points and ids.
    grid->GetFaceStream(cell, ids);
    for (vtkIdType at = 1; at < ids->GetNumberOfIds(); at += ids->GetId(at) + 1)
    {
      for (vtkIdType p = 1; p <= ids->GetId(at); ++p)
      {
        map(ids, at + p);
      }
    }
  }
  else
  {
    for (vtkIdType p = 0; p < ids->GetNumberOfIds(); ++p)
    {
      map(ids, p);
    }
  }
  this->Cells->InsertNextCell(type, ids);
}

bool SeriesEstimate::SampleValues(int step, const std::vector<vtkDataSet*>& leaves)
{
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->Allocate(this->Cells->GetNumberOfPoints());
  if (leaves.size() != this->Points.size())
  {
    return false;
  }
  for (std::size_t number = 0; number < leaves.size(); ++number)
  {
    const std::vector<vtkIdType>& points = this->Points[number];
    if (points.empty())
    {
      continue;
    }
    if (!leaves[number])
    {
      return false;
    }
    const CellArrayConversion::Selection selection = this->Conversion.Select(leaves[number]);
    auto* scalars = vtkDataArray::SafeDownCast(selection.Array);
    if (!scalars || selection.Association != vtkDataObject::FIELD_ASSOCIATION_POINTS ||
      scalars->GetNumberOfTuples() <= *std::max_element(points.begin(), points.end()))
    {
      return false;
    }
    for (const vtkIdType point : points)
    {
      values->InsertNextValue(scalars->GetComponent(point, 0));
    }
  }
  this->Conversion.Clear();
  this->Values[step] = values;
  return true;
}

double SeriesEstimate::CountTetrahedra(const Pair& slab) const
{
  // Receives the progress.
  vtkNew<vtkAlgorithm> owner;
  owner->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  TimeVaryingRun run(owner, this->Intervals,
    TimeVaryingOptions(this->Settings, vtkAlgorithm::SINGLE_PRECISION, false), { 0, 1 },
    { this->Times[slab.First], this->Times[slab.Second] }, 0);
  for (const int step : { slab.First, slab.Second })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    grid->ShallowCopy(this->Cells);
    grid->GetPointData()->SetScalars(this->Values.at(step));
    TimeVaryingRun::Results result;
    if (run.AddStep(grid, result) || result != TimeVaryingRun::DONE)
    {
      return 0.0;
    }
  }
  vtkNew<vtkUnstructuredGrid> outputs[3];
  if (!run.FillOutputs(outputs[0], outputs[1], outputs[2]))
  {
    return 0.0;
  }
  return this->CellsPerSample * static_cast<double>(outputs[0]->GetNumberOfCells());
}

double SeriesEstimate::GetSlabSize(int distance, int step) const
{
  return Interpolate(this->SlabSizes.at(distance), step);
}

double SeriesEstimate::GetSize(int stride) const
{
  const int last = this->GetLastStep();
  const int rest = last % stride;
  return last / stride * Interpolate(this->MeanSizes, stride) +
    (rest > 0 ? Interpolate(this->MeanSizes, rest) : 0.0);
}

}
