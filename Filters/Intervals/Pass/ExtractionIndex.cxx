// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/ExtractionIndex.h"

#include "Common/ParallelFor.h"
#include "Scalars/ExtractionDispatch.h"
#include "Scalars/ExtractionValues.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkObjectFactory.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace interlume
{

vtkStandardNewMacro(ExtractionIndex);

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Extends a range to include a value if it is finite. Converting a 64-bit integer to double may
// round it, but never past an isovalue, since isovalues are doubles.
template <typename T>
void Extend(std::array<double, 2>& range, T value)
{
  const double number = static_cast<double>(value);
  if (std::isfinite(number))
  {
    range[0] = std::min(range[0], number);
    range[1] = std::max(range[1], number);
  }
}
}

constexpr vtkIdType ExtractionIndex::BlockSize[3];

ExtractionIndex::ExtractionIndex() = default;

ExtractionIndex::~ExtractionIndex() = default;

ExtractionIndex* ExtractionIndex::BeginExecution(bool isUsed, bool isPreview)
{
  if (isPreview)
  {
    if (!this->Previews)
    {
      this->Previews = vtkSmartPointer<ExtractionIndex>::New();
    }
    return this->Previews->BeginExecution(true, false);
  }
  this->Previews = nullptr;
  const auto removeUnused = [](auto& cached)
  {
    for (auto entry = cached.begin(); entry != cached.end();)
    {
      entry = std::exchange(entry->second.IsUsed, false) ? std::next(entry) : cached.erase(entry);
    }
  };
  removeUnused(this->Known);
  removeUnused(this->LinearGrids);
  removeUnused(this->SurfaceGrids);
  removeUnused(this->CoarseGrids);
  removeUnused(this->ConvertedArrays);
  return isUsed ? this : nullptr;
}

bool ExtractionIndex::Select(
  vtkDataSet* input, vtkDataArray* scalars, const int* dimensions, int dimension)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Cells[axis] = dimensions ? dimensions[axis] - 1 : 0;
    this->Blocks[axis] = (this->Cells[axis] + BlockSize[axis] - 1) / BlockSize[axis];
  }
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(input);
  const vtkMTimeType cellTime = grid ? grid->GetCells()->GetMTime() : 0;
  Ranges& ranges = this->Known[{ scalars, dimension }];
  this->Selected = &ranges;
  if (ranges.ScalarTime != scalars->GetMTime() || ranges.CellTime != cellTime ||
    ranges.Cells != this->Cells)
  {
    ranges = Ranges();
    ranges.ScalarTime = scalars->GetMTime();
    ranges.CellTime = cellTime;
    ranges.Cells = this->Cells;
    ranges.IsUsed = true;
    return false;
  }
  ranges.IsUsed = true;
  if (ranges.Blocks.empty())
  {
    ExtractionDispatch::Execute(scalars,
      [&](const auto* data)
      {
        if (dimensions)
        {
          this->BuildStructured(data, ranges);
        }
        else
        {
          this->BuildRuns(input, data, ranges);
        }
        return true;
      });
  }
  return true;
}

template <typename T>
void ExtractionIndex::BuildStructured(const T* scalars, Ranges& ranges) const
{
  const vtkIdType nx = this->Cells[0] + 1;
  const vtkIdType ny = this->Cells[1] + 1;
  ranges.Blocks.resize(this->Blocks[0] * this->Blocks[1] * this->Blocks[2]);
  ParallelFor(0, this->Blocks[1] * this->Blocks[2],
    [&](vtkIdType row)
    {
      const vtkIdType j0 = (row % this->Blocks[1]) * BlockSize[1];
      const vtkIdType k0 = (row / this->Blocks[1]) * BlockSize[2];
      const vtkIdType j1 = std::min(j0 + BlockSize[1], this->Cells[1]);
      const vtkIdType k1 = std::min(k0 + BlockSize[2], this->Cells[2]);
      for (vtkIdType block = 0; block < this->Blocks[0]; ++block)
      {
        const vtkIdType i0 = block * BlockSize[0];
        const vtkIdType i1 = std::min(i0 + BlockSize[0], this->Cells[0]);
        std::array<double, 2> range{ { Infinity, -Infinity } };
        for (vtkIdType k = k0; k <= k1; ++k)
        {
          for (vtkIdType j = j0; j <= j1; ++j)
          {
            const T* values = scalars + (j + k * ny) * nx;
            for (vtkIdType i = i0; i <= i1; ++i)
            {
              Extend(range, values[i]);
            }
          }
        }
        ranges.Blocks[row * this->Blocks[0] + block] = range;
      }
    });
}

template <typename T>
void ExtractionIndex::BuildRuns(vtkDataSet* input, const T* scalars, Ranges& ranges) const
{
  const vtkIdType cells = input->GetNumberOfCells();
  ranges.Blocks.resize((cells + RunLength - 1) / RunLength);
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPTools::For(0, static_cast<vtkIdType>(ranges.Blocks.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      vtkIdList* points = lists.Local();
      for (vtkIdType run = first; run < last; ++run)
      {
        std::array<double, 2> range{ { Infinity, -Infinity } };
        const vtkIdType end = std::min((run + 1) * RunLength, cells);
        for (vtkIdType cell = run * RunLength; cell < end; ++cell)
        {
          input->GetCellPoints(cell, points);
          for (vtkIdType p = 0; p < points->GetNumberOfIds(); ++p)
          {
            Extend(range, scalars[points->GetId(p)]);
          }
        }
        ranges.Blocks[run] = range;
      }
    });
}

void ExtractionIndex::Activate(const ExtractionValues& values)
{
  const auto& blocks = this->Selected->Blocks;
  this->Active.resize(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    this->Active[b] = values.Overlaps(blocks[b][0], blocks[b][1]);
  }
  this->ActiveRows.clear();
  for (std::size_t b = 0; this->Blocks[0] > 0 && b < blocks.size(); b += this->Blocks[0])
  {
    const auto row = this->Active.begin() + b;
    this->ActiveRows.push_back(std::find(row, row + this->Blocks[0], 1) != row + this->Blocks[0]);
  }
}

bool ExtractionIndex::IsRowActive(vtkIdType cellRow) const
{
  const vtkIdType j = (cellRow % this->Cells[1]) / BlockSize[1];
  const vtkIdType k = (cellRow / this->Cells[1]) / BlockSize[2];
  return this->ActiveRows[j + k * this->Blocks[1]] != 0;
}

double ExtractionIndex::GetActiveFraction() const
{
  const auto active = std::count(this->ActiveRows.begin(), this->ActiveRows.end(), 1);
  return static_cast<double>(active) / static_cast<double>(this->ActiveRows.size());
}

void ExtractionIndex::GetActiveSpans(vtkIdType cellRow, std::vector<Span>& spans) const
{
  const vtkIdType j = (cellRow % this->Cells[1]) / BlockSize[1];
  const vtkIdType k = (cellRow / this->Cells[1]) / BlockSize[2];
  const unsigned char* row = this->Active.data() + (j + k * this->Blocks[1]) * this->Blocks[0];
  for (vtkIdType block = 0; block < this->Blocks[0]; ++block)
  {
    const vtkIdType first = block * BlockSize[0];
    const vtkIdType last = std::min(first + BlockSize[0], this->Cells[0]);
    if (row[block] && !spans.empty() && spans.back()[1] == first)
    {
      spans.back()[1] = last;
    }
    else if (row[block])
    {
      spans.push_back({ { first, last } });
    }
  }
}

std::size_t ExtractionIndex::GetBytes() const
{
  std::size_t bytes = 0;
  for (const auto& known : this->Known)
  {
    bytes += known.second.Blocks.capacity() * sizeof(std::array<double, 2>);
  }
  return bytes;
}

}
