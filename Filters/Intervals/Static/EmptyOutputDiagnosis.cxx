// SPDX-License-Identifier: BSD-3-Clause
#include "Static/EmptyOutputDiagnosis.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/ArrayCheck.h"

#include "vtkAlgorithm.h"
#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <sstream>

namespace interlume
{

namespace
{
constexpr std::size_t MaximumItemsNamed = 3;

struct Pieces
{
  int Piece = 0;
  int Number = 1;
};

// Returns the piece that the pipeline requested from a filter.
Pieces GetPieces(vtkAlgorithm* owner)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  Pieces pieces;
  vtkInformation* request = owner->GetOutputInformation(0);
  if (request->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    pieces.Number = request->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    pieces.Piece = request->Get(Pipeline::UPDATE_PIECE_NUMBER());
  }
  return pieces;
}

// Returns whether the input has cells of at least the given dimension.
bool HasCells(vtkDataSet* input, int dimension)
{
  int dimensions[3];
  if (ExtractionArrays::GetRowDimensions(input, dimensions))
  {
    return std::count(dimensions, dimensions + 3, 1) <= 3 - dimension;
  }
  vtkNew<vtkGenericCell> kind;
  int last = -1;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const int type = input->GetCellType(cell);
    if (type != last)
    {
      kind->SetCellType(type);
      last = type;
      if (kind->GetCellDimension() >= dimension)
      {
        return true;
      }
    }
  }
  return false;
}

template <typename Item, typename Write>
std::string Join(const std::vector<Item>& items, const char* name, Write&& write)
{
  std::ostringstream words;
  words << "the " << name << (items.size() == 1 ? " " : "s ");
  for (std::size_t i = 0; i < std::min(items.size(), MaximumItemsNamed); ++i)
  {
    words << (i > 0 ? ", " : "");
    write(words, items[i]);
  }
  if (items.size() > MaximumItemsNamed)
  {
    words << ", and " << items.size() - MaximumItemsNamed << " more";
  }
  return words.str();
}
}

void EmptyOutputDiagnosis::Range::Add(vtkDataArray* array)
{
  if (array && array->GetNumberOfTuples() > 0)
  {
    double range[2];
    array->GetFiniteRange(range, 0);
    // Without a finite value, the range is inverted.
    if (range[0] <= range[1])
    {
      this->Minimum = std::min(this->Minimum, range[0]);
      this->Maximum = std::max(this->Maximum, range[1]);
    }
  }
}

void EmptyOutputDiagnosis::Add(vtkDataSet* input, vtkDataArray* scalars, vtkIdType simplices)
{
  this->Simplices += simplices;
  this->SimplicesLeft += simplices;
  if (this->Simplices > 0)
  {
    this->Inputs.clear();
    this->Scalars.clear();
  }
  else
  {
    if (input)
    {
      this->Inputs.emplace_back(input);
    }
    if (scalars)
    {
      this->Scalars.emplace_back(scalars);
      this->ScalarsName = (scalars->GetName() ? "the " : "") + ArrayCheck::Describe(scalars);
    }
  }
}

void EmptyOutputDiagnosis::Look()
{
  for (vtkDataSet* input : this->Inputs)
  {
    this->Cells += input->GetNumberOfCells();
    this->HasPoints = this->HasPoints || input->GetNumberOfPoints() > 0;
    this->HasSuitableCells = this->HasSuitableCells || HasCells(input, this->MinimumDimension);
  }
  for (vtkDataArray* scalars : this->Scalars)
  {
    this->Values.Add(scalars);
  }
  this->Inputs.clear();
  this->Scalars.clear();
}

void EmptyOutputDiagnosis::AddCriterion(std::size_t number, const std::string& words,
  vtkDataArray* array, vtkIdType before, vtkIdType after)
{
  this->SimplicesLeft += after - before;
  if (before > 0 && after == 0)
  {
    this->Criteria.resize(std::max(this->Criteria.size(), number + 1));
    this->Criteria[number].Words = words;
    this->Criteria[number].Before.Add(array);
  }
}

bool EmptyOutputDiagnosis::IsUnreported(vtkAlgorithm* owner) const
{
  return !this->IsExplained && this->SimplicesLeft == 0 && !owner->GetAbortExecute();
}

bool EmptyOutputDiagnosis::IsUnexplained(vtkAlgorithm* owner) const
{
  return this->IsUnreported(owner) && GetPieces(owner).Number <= 1;
}

std::string EmptyOutputDiagnosis::Explain(
  vtkAlgorithm* owner, const std::string& unset, const std::string& sought)
{
  if (!this->IsUnreported(owner))
  {
    return std::string();
  }
  const Pieces pieces = GetPieces(owner);
  if (!unset.empty())
  {
    return pieces.Piece == 0 ? unset : std::string();
  }
  return pieces.Number <= 1 ? this->ExplainFromData(sought) : std::string();
}

std::string EmptyOutputDiagnosis::ExplainFromData(const std::string& sought)
{
  std::ostringstream why;
  if (!this->Criteria.empty())
  {
    // The last criterion with an empty result is decisive, since its input was not empty.
    const Criterion& last = this->Criteria.back();
    why << last.Words << " excludes all cells; before it, the array ";
    if (last.Before.IsEmpty())
    {
      why << "has no finite value.";
    }
    else
    {
      why << "ranges from " << last.Before.Minimum << " to " << last.Before.Maximum << ".";
    }
    return why.str();
  }
  this->Look();
  if (!this->HasPoints)
  {
    return "the input has no points.";
  }
  if (this->Cells == 0)
  {
    return "the input has points but no cells.";
  }
  if (!this->HasSuitableCells)
  {
    why << "none of the input's " << this->Cells
        << (this->MinimumDimension == 2
               ? " cells is two- or three-dimensional. Lines and points have no interior."
               : " cells is three-dimensional. Surfaces, lines and points have no interior.");
    return why.str();
  }
  if (this->Values.IsEmpty())
  {
    why << this->ScalarsName << " has no finite value.";
  }
  else
  {
    why << "no cell intersects " << sought << "; " << this->ScalarsName << " ranges from "
        << this->Values.Minimum << " to " << this->Values.Maximum
        << ". Blanked, hidden and ghost cells, and cells with NaN or infinite values or "
           "coordinates, are skipped.";
  }
  return why.str();
}

std::string EmptyOutputDiagnosis::Describe(const std::vector<vtkIntervalList::Interval>& intervals)
{
  return Join(intervals, "interval",
    [](std::ostream& words, const vtkIntervalList::Interval& one)
    { words << "[" << one[0] << ", " << one[1] << "]"; });
}

std::string EmptyOutputDiagnosis::Describe(const std::vector<double>& values)
{
  return Join(values, "value", [](std::ostream& words, double value) { words << value; });
}

}
