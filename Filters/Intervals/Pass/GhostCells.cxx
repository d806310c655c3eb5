// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/GhostCells.h"

#include "Grid/GridCellRange.h"
#include "Pass/ExtractionCleanup.h"
#include "Pass/ExtractionContext.h"
#include "Scalars/ExtractionScalars.h"

#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <atomic>
#include <set>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;

// Returns whether any value in a range of points equals an isovalue or is not finite.
bool HasTies(const ExtractionScalars& scalars, vtkIdType first, vtkIdType last)
{
  constexpr vtkIdType batchSize = 1024;
  Code codes[batchSize];
  Code all = 0;
  for (; first < last && !ExtractionValues::IsTie(all); first += batchSize)
  {
    const vtkIdType number = std::min(batchSize, last - first);
    scalars.Classify(first, number, codes);
    for (vtkIdType i = 0; i < number; ++i)
    {
      all = static_cast<Code>(all | codes[i]);
    }
  }
  return ExtractionValues::IsTie(all);
}

}

void GhostCells::Request(vtkInformation* input, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(1, output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  }
}

void GhostCells::SetBlanking(vtkDataSet* data, Blanking& blanking)
{
  blanking.SetBlanking(data);
  if (blanking.PointGhosts)
  {
    const unsigned char* marks = blanking.PointGhosts->GetPointer(0);
    const bool hidesSome = std::any_of(marks, marks + blanking.PointGhosts->GetNumberOfValues(),
      [](unsigned char mark) { return (mark & vtkDataSetAttributes::HIDDENPOINT) != 0; });
    blanking.PointGhosts = hidesSome ? blanking.PointGhosts : nullptr;
  }
}

bool GhostCells::HaveTies(const ExtractionContext& context)
{
  if (!context.CellGhosts)
  {
    return false;
  }
  const auto scalars = context.MakeScalars();
  // A quick test: few floating-point datasets contain a tie.
  std::atomic<bool> isAny{ false };
  vtkSMPTools::For(0, context.Input->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      if (!isAny && HasTies(*scalars, first, last))
      {
        isAny = true;
      }
    });
  if (!isAny)
  {
    return false;
  }
  vtkNew<vtkIdList> ids;
  const auto isTied = [&scalars](vtkIdType id) { return HasTies(*scalars, id, id + 1); };
  for (vtkIdType cell = 0; cell < context.Input->GetNumberOfCells(); ++cell)
  {
    if (IsGhost(context, cell))
    {
      context.Input->GetCellPoints(cell, ids);
      if (std::any_of(ids->begin(), ids->end(), isTied))
      {
        return true;
      }
    }
  }
  return false;
}

bool GhostCells::HaveTiesOutside(
  const ExtractionContext& context, const int dimensions[3], const GridCellRange& window)
{
  const auto scalars = context.MakeScalars();
  return window.AnyOutside(dimensions,
    [&scalars](vtkIdType first, vtkIdType last) { return HasTies(*scalars, first, last); });
}

void GhostCells::Remove(const ExtractionContext& context, ExtractionMesh& mesh)
{
  std::set<vtkIdType> withOutput;
  // Number of simplices and interior cells.
  const vtkIdType cells = mesh.ItemIds->GetNumberOfValues();
  std::vector<bool> isRemoved(static_cast<std::size_t>(cells), false);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (IsGhost(context, mesh.CellIds[cell]))
    {
      isRemoved[cell] = true;
      withOutput.insert(mesh.CellIds[cell]);
    }
  }
  std::vector<bool> isTriangleRemoved(mesh.Triangles.size(), false);
  std::transform(mesh.TriangleCellIds.begin(), mesh.TriangleCellIds.end(),
    isTriangleRemoved.begin(), [&context](vtkIdType cell) { return IsGhost(context, cell); });
  ExtractionCleanup::RemoveMarked(mesh, isRemoved, isTriangleRemoved);
  context.Report->CellsWithOutput -= static_cast<vtkIdType>(withOutput.size());
  for (vtkIdType cell = 0; cell < context.Input->GetNumberOfCells(); ++cell)
  {
    context.Report->BlankedCells += IsGhost(context, cell);
  }
}

}
