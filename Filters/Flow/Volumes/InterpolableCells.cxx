// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/InterpolableCells.h"

#include "Common/Batches.h"
#include "Common/Blanking.h"
#include "Samples/ImplicitFlowArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Values in place of a surface id: a corner has no result, or corners have different ids.
constexpr int NoResult = -1;
constexpr int Different = -2;

int Unite(int a, int b)
{
  return a == NoResult || b == NoResult ? NoResult : a == b ? a : Different;
}

// Classifies cells by the surface ids and parameters of their corners. Each thread needs its own
// object.
class Classifier
{
public:
  Classifier(const ImplicitFlowArrays& arrays, const InterpolableCells::Limits& limits)
    : Arrays(arrays)
    , Limits(limits)
    , HasTimeLimit(limits.MaximumTimeJump > 0.0)
  {
  }

  int GetId(vtkIdType point) const
  {
    return this->Arrays.IsReached(point) ? this->Arrays.GetId(point) : NoResult;
  }

  // Returns the kind of a cell. \a id is the result of Unite() for all corners. \a canCross is true
  // if the parameters of the extracted simplices can be unwrapped.
  template <typename Ids>
  unsigned char GetKind(int id, const Ids* corners, vtkIdType number, bool canCross)
  {
    if (id < 0)
    {
      return id == NoResult ? InterpolableCells::WITHOUT_RESULT
                            : InterpolableCells::BETWEEN_SURFACES;
    }
    if (this->Arrays.HasSides() && this->Arrays.IsAcrossSurface(corners, number))
    {
      return InterpolableCells::ACROSS_SURFACE;
    }
    if (this->HasTimeLimit &&
      this->Arrays.GetTimeJump(corners, number) > this->Limits.MaximumTimeJump)
    {
      return InterpolableCells::TIME_JUMP;
    }
    if (id != this->LastId)
    {
      this->LastId = id;
      this->Periodicity = this->Arrays.GetPeriodicity(id);
      const auto found = this->Limits.Seams.find(id);
      this->IsContinued = found == this->Limits.Seams.end() ? std::array<bool, 2>() : found->second;
    }
    unsigned char kind = 0;
    for (int direction = 0; direction < 2; ++direction)
    {
      if (!this->Periodicity[direction])
      {
        continue;
      }
      const auto spread = [&](auto&& parameter)
      {
        double lowest = parameter(corners[0]);
        double highest = lowest;
        for (vtkIdType c = 1; c < number; ++c)
        {
          const double value = parameter(corners[c]);
          lowest = std::min(lowest, value);
          highest = std::max(highest, value);
        }
        return highest - lowest;
      };
      const auto asIs = [&](vtkIdType p) { return this->Arrays.GetParameters(p)[direction]; };
      if (!(spread(asIs) > 0.5))
      {
        continue;
      }
      if (!this->IsContinued[direction] || !canCross)
      {
        return InterpolableCells::ON_SEAM;
      }
      kind |= direction == 0 ? InterpolableCells::ACROSS_U : InterpolableCells::ACROSS_V;
      if (spread([&](vtkIdType p) { return InterpolableCells::Unwrap(asIs(p)); }) > 0.5)
      {
        kind |= InterpolableCells::AROUND_POLE;
      }
    }
    return kind;
  }

private:
  const ImplicitFlowArrays& Arrays;
  const InterpolableCells::Limits& Limits;
  bool HasTimeLimit;
  int LastId = NoResult;
  std::array<bool, 2> Periodicity{};
  std::array<bool, 2> IsContinued{};
};

// Array that receives the kinds of cells, and the array of the cells' ghost types.
struct Output
{
  vtkUnsignedCharArray* Ghosts;
  unsigned char* Kinds;

  // Blanked cells are not classified.
  bool IsBlanked(vtkIdType cell) const
  {
    return Blanking{ this->Ghosts, nullptr }.IsCellBlanked(cell);
  }
};

// Classifies the cells of rows \a first to \a last - 1 of a structured (i, j, k) grid.
void ClassifyRows(
  Classifier& classifier, const int* dimensions, vtkIdType first, vtkIdType last, Output output)
{
  const vtkIdType nx = dimensions[0];
  const vtkIdType layer = nx * dimensions[1];
  const vtkIdType rowsOfLayer = dimensions[1] - 1;
  for (vtkIdType row = first; row < last; ++row)
  {
    const vtkIdType firstPoint = row / rowsOfLayer * layer + row % rowsOfLayer * nx;
    const auto getColumn = [&](vtkIdType p)
    {
      return Unite(Unite(classifier.GetId(p), classifier.GetId(p + nx)),
        Unite(classifier.GetId(p + layer), classifier.GetId(p + layer + nx)));
    };
    int before = getColumn(firstPoint);
    for (vtkIdType i = 0; i + 1 < nx; ++i)
    {
      const vtkIdType cell = row * (nx - 1) + i;
      const vtkIdType p = firstPoint + i;
      const int column = getColumn(p + 1);
      const vtkIdType corners[8] = { p, p + 1, p + nx, p + nx + 1, p + layer, p + layer + 1,
        p + layer + nx, p + layer + nx + 1 };
      output.Kinds[cell] =
        output.IsBlanked(cell) ? 0 : classifier.GetKind(Unite(before, column), corners, 8, true);
      before = column;
    }
  }
}

void ClassifyCells(Classifier& classifier, vtkUnstructuredGrid* grid, vtkIdList* list,
  vtkIdType first, vtkIdType last, Output output)
{
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    grid->GetCells()->GetCellAtId(cell, list);
    const vtkIdType number = list->GetNumberOfIds();
    const vtkIdType* corners = list->GetPointer(0);
    if (number == 0 || output.IsBlanked(cell))
    {
      output.Kinds[cell] = 0;
      continue;
    }
    int id = classifier.GetId(corners[0]);
    for (vtkIdType c = 1; c < number; ++c)
    {
      id = Unite(id, classifier.GetId(corners[c]));
    }
    output.Kinds[cell] =
      classifier.GetKind(id, corners, number, grid->GetCellType(cell) != VTK_POLYHEDRON);
  }
}

bool GetDimensions(vtkDataSet* data, int dimensions[3])
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(dimensions);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    rectilinear->GetDimensions(dimensions);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    structured->GetDimensions(dimensions);
  }
  else
  {
    return false;
  }
  return true;
}
}

bool InterpolableCells::Find(vtkDataSet* data, const ImplicitFlowArrays& arrays,
  const Limits& limits, vtkAlgorithm* owner, double start, double end)
{
  const vtkIdType cells = data->GetNumberOfCells();
  this->CellKinds.assign(cells, 0);
  this->Counts.fill(0);
  int dimensions[3] = { 0, 0, 0 };
  const bool hasRows = GetDimensions(data, dimensions);
  if (cells == 0 || (hasRows && *std::min_element(dimensions, dimensions + 3) < 2))
  {
    return true;
  }
  const Output output{ data->GetCellGhostArray(), this->CellKinds.data() };
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPThreadLocal<KindCounts> counts(KindCounts{});
  const vtkIdType cellsPerItem = hasRows ? dimensions[0] - 1 : 1;
  const auto classify = [&](vtkIdType first, vtkIdType last)
  {
    Classifier classifier(arrays, limits);
    if (hasRows)
    {
      ClassifyRows(classifier, dimensions, first, last, output);
    }
    else
    {
      ClassifyCells(classifier, grid, lists.Local(), first, last, output);
    }
    KindCounts& own = counts.Local();
    for (vtkIdType cell = first * cellsPerItem; cell < last * cellsPerItem; ++cell)
    {
      ++own[this->CellKinds[cell]];
    }
  };
  if (!Batches::Run(cells / cellsPerItem, owner, start, end, classify))
  {
    return false;
  }
  for (const auto& own : counts)
  {
    for (std::size_t kind = 0; kind < own.size(); ++kind)
    {
      this->Counts[kind] += own[kind];
    }
  }
  return true;
}

vtkIdType InterpolableCells::Count(unsigned char kinds) const
{
  vtkIdType sum = 0;
  for (std::size_t kind = 0; kind < this->Counts.size(); ++kind)
  {
    sum += (kind & kinds) ? this->Counts[kind] : 0;
  }
  return sum;
}

}
