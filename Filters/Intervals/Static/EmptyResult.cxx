// SPDX-License-Identifier: BSD-3-Clause
#include "Static/EmptyResult.h"

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
constexpr std::size_t MostItemsNamed = 3;

struct Pieces
{
  int Own = 0;
  int Number = 1;
};

// Returns the pieces that a pipeline has asked a filter for.
Pieces GetPieces(vtkAlgorithm* owner)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  Pieces pieces;
  vtkInformation* asked = owner->GetOutputInformation(0);
  if (asked->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    pieces.Number = asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    pieces.Own = asked->Get(Pipeline::UPDATE_PIECE_NUMBER());
  }
  return pieces;
}

bool HasSolidCells(vtkDataSet* input)
{
  int dimensions[3];
  if (ExtractionArrays::GetRowDimensions(input, dimensions))
  {
    return *std::min_element(dimensions, dimensions + 3) > 1;
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
      if (kind->GetCellDimension() == 3)
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
  for (std::size_t i = 0; i < std::min(items.size(), MostItemsNamed); ++i)
  {
    words << (i > 0 ? ", " : "");
    write(words, items[i]);
  }
  if (items.size() > MostItemsNamed)
  {
    words << ", and " << items.size() - MostItemsNamed << " more";
  }
  return words.str();
}
}

void EmptyResult::Range::Add(vtkDataArray* array)
{
  if (array && array->GetNumberOfTuples() > 0)
  {
    double range[2];
    array->GetFiniteRange(range, 0);
    this->Least = std::min(this->Least, range[0]);
    this->Largest = std::max(this->Largest, range[1]);
  }
}

void EmptyResult::Add(vtkDataSet* input, vtkDataArray* scalars, vtkIdType simplices)
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

void EmptyResult::Look()
{
  for (vtkDataSet* input : this->Inputs)
  {
    this->Cells += input->GetNumberOfCells();
    this->HasPoints = this->HasPoints || input->GetNumberOfPoints() > 0;
    this->HasSolidCells = this->HasSolidCells || interlume::HasSolidCells(input);
  }
  for (vtkDataArray* scalars : this->Scalars)
  {
    this->Values.Add(scalars);
  }
  this->Inputs.clear();
  this->Scalars.clear();
}

void EmptyResult::AddCriterion(std::size_t number, const std::string& words, vtkDataArray* array,
  vtkIdType before, vtkIdType after)
{
  this->SimplicesLeft += after - before;
  if (before > 0 && after == 0)
  {
    this->Criteria.resize(std::max(this->Criteria.size(), number + 1));
    this->Criteria[number].Words = words;
    this->Criteria[number].Before.Add(array);
  }
}

bool EmptyResult::IsSilent(vtkAlgorithm* owner) const
{
  return !this->IsExplained && this->SimplicesLeft == 0 && !owner->GetAbortExecute();
}

bool EmptyResult::IsUnexplained(vtkAlgorithm* owner) const
{
  return this->IsSilent(owner) && GetPieces(owner).Number <= 1;
}

std::string EmptyResult::Explain(
  vtkAlgorithm* owner, const std::string& unset, const std::string& sought)
{
  if (!this->IsSilent(owner))
  {
    return std::string();
  }
  const Pieces pieces = GetPieces(owner);
  if (!unset.empty())
  {
    return pieces.Own == 0 ? unset : std::string();
  }
  return pieces.Number <= 1 ? this->ExplainByData(sought) : std::string();
}

std::string EmptyResult::ExplainByData(const std::string& sought)
{
  std::ostringstream why;
  if (!this->Criteria.empty())
  {
    // The last criterion counts, since what the others had left came to it.
    const Criterion& last = this->Criteria.back();
    why << last.Words << " leaves nothing; in what it cuts the array goes from "
        << last.Before.Least << " to " << last.Before.Largest << ".";
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
  if (!this->HasSolidCells)
  {
    why << "none of the input's " << this->Cells
        << " cells is three-dimensional; a surface, lines or points have no such region.";
    return why.str();
  }
  if (this->Values.IsEmpty())
  {
    why << this->ScalarsName << " has no finite value.";
  }
  else
  {
    why << "no cell that counts meets " << sought << "; " << this->ScalarsName << " goes from "
        << this->Values.Least << " to " << this->Values.Largest
        << ". (Blanked, hidden and ghost cells, and those with values or coordinates that are not "
           "finite, do not count.)";
  }
  return why.str();
}

std::string EmptyResult::Describe(const std::vector<vtkIntervalList::Interval>& intervals)
{
  return Join(intervals, "interval",
    [](std::ostream& words, const vtkIntervalList::Interval& one)
    { words << "[" << one[0] << ", " << one[1] << "]"; });
}

std::string EmptyResult::Describe(const std::vector<double>& values)
{
  return Join(values, "value", [](std::ostream& words, double value) { words << value; });
}

}
