// SPDX-License-Identifier: BSD-3-Clause
#include "Static/RefinementLevels.h"

#include "Output/ExtractionReport.h"
#include "Common/ArrayCheck.h"
#include "Common/Blanking.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
using Index = std::array<int, 3>;
using Position = std::array<double, 3>;

// Bit 6 marks a covered cell. Bits 0 to 5 mark the faces of a cell (-x, +x, -y, ...).
constexpr unsigned char Covered = 1 << 6;

// One image of an AMR level, with a mark for each cell.
class Block
{
public:
  explicit Block(vtkImageData* image)
    : Image(image)
  {
    this->Ghosts.SetBlanking(image);
    int extent[6];
    image->GetExtent(extent);
    double origin[3];
    image->GetOrigin(origin);
    image->GetSpacing(this->Spacing.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Cells[axis] = extent[2 * axis + 1] - extent[2 * axis];
      this->Base[axis] = origin[axis] + this->Spacing[axis] * extent[2 * axis];
    }
  }

  bool IsSolid() const
  {
    return *std::min_element(this->Cells.begin(), this->Cells.end()) > 0 &&
      *std::min_element(this->Spacing.begin(), this->Spacing.end()) > 0.0;
  }

  vtkImageData* GetImage() const { return this->Image; }

  bool IsFinerThan(const Block& other) const
  {
    constexpr double ratio = 0.75;
    return this->Spacing[0] < ratio * other.Spacing[0];
  }

  // Marks the cells covered by a finer block, and the faces between uncovered cells and that block.
  void Mark(const Block& finer)
  {
    Index first;
    Index last;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double begin = (finer.Base[axis] - this->Base[axis]) / this->Spacing[axis];
      const double length = finer.Cells[axis] * finer.Spacing[axis] / this->Spacing[axis];
      // Include the adjacent cell on each side, and one more to allow for rounding errors.
      first[axis] = static_cast<int>(std::max(0.0, std::floor(begin) - 2.0));
      last[axis] =
        static_cast<int>(std::min<double>(this->Cells[axis], std::ceil(begin + length) + 2.0));
      if (first[axis] >= last[axis])
      {
        return;
      }
    }
    this->Marks.resize(static_cast<std::size_t>(this->Image->GetNumberOfCells()), 0);
    Index at;
    for (at[2] = first[2]; at[2] < last[2]; ++at[2])
    {
      for (at[1] = first[1]; at[1] < last[1]; ++at[1])
      {
        for (at[0] = first[0]; at[0] < last[0]; ++at[0])
        {
          this->MarkCell(at, finer);
        }
      }
    }
  }

  // Counts the marked cells that intersect an interval, and the marked faces that an isovalue
  // intersects.
  void Count(vtkDataArray* scalars, const std::vector<vtkIntervalList::Interval>& intervals,
    ExtractionReport& report) const
  {
    for (std::size_t cell = 0; cell < this->Marks.size(); ++cell)
    {
      const unsigned char marks = this->Marks[cell];
      if (marks & Covered)
      {
        const std::array<double, 2> range =
          this->GetRange(static_cast<vtkIdType>(cell), -1, scalars);
        report.CoveredCells += std::any_of(intervals.begin(), intervals.end(),
          [&](const auto& one) { return range[0] <= one[1] && one[0] <= range[1]; });
        continue;
      }
      for (int face = 0; face < 6; ++face)
      {
        if (marks & (1 << face))
        {
          const auto range = this->GetRange(static_cast<vtkIdType>(cell), face, scalars);
          const auto crosses = [&](double value) { return range[0] < value && value < range[1]; };
          report.LevelFaces += std::any_of(intervals.begin(), intervals.end(),
            [&](const auto& one) { return crosses(one[0]) || crosses(one[1]); });
        }
      }
    }
  }

private:
  vtkIdType GetCell(const Index& at) const
  {
    return at[0] + this->Cells[0] * (at[1] + static_cast<vtkIdType>(this->Cells[1]) * at[2]);
  }

  // Returns whether a position is in a cell that is not blanked.
  bool Holds(const Position& x) const
  {
    Index at;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double index = (x[axis] - this->Base[axis]) / this->Spacing[axis];
      if (!(index >= 0.0 && index < this->Cells[axis]))
      {
        return false;
      }
      at[axis] = static_cast<int>(index);
    }
    return !this->Ghosts.IsCellBlanked(this->GetCell(at));
  }

  void MarkCell(const Index& at, const Block& finer)
  {
    const vtkIdType cell = this->GetCell(at);
    if (this->Ghosts.IsCellBlanked(cell))
    {
      return;
    }
    // The center of the cell, shifted so that it is not on a face of a finer cell.
    constexpr double offset = 0.25;
    Position center;
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] =
        this->Base[axis] + this->Spacing[axis] * (at[axis] + 0.5) + offset * finer.Spacing[axis];
    }
    if (finer.Holds(center))
    {
      this->Marks[cell] |= Covered;
      return;
    }
    for (int face = 0; face < 6; ++face)
    {
      const int axis = face / 2;
      const int side = face % 2;
      Position outside = center;
      outside[axis] = this->Base[axis] + this->Spacing[axis] * (at[axis] + side) +
        (2 * side - 1) * offset * finer.Spacing[axis];
      if (finer.Holds(outside))
      {
        this->Marks[cell] |= static_cast<unsigned char>(1 << face);
      }
    }
  }

  // Returns the scalar range of a cell, or of one of its faces if \a face >= 0. The range is empty
  // if a scalar is not finite.
  std::array<double, 2> GetRange(vtkIdType cell, int face, vtkDataArray* scalars) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const vtkIdType row = cell / this->Cells[0];
    const vtkIdType at[3] = { cell % this->Cells[0], row % this->Cells[1], row / this->Cells[1] };
    std::array<double, 2> range = { { infinity, -infinity } };
    for (int corner = 0; corner < 8; ++corner)
    {
      if (face >= 0 && ((corner >> (face / 2)) & 1) != face % 2)
      {
        continue;
      }
      const vtkIdType point = at[0] + (corner & 1) +
        (this->Cells[0] + 1) *
          (at[1] + ((corner >> 1) & 1) + (this->Cells[1] + 1) * (at[2] + (corner >> 2)));
      const double value = scalars->GetComponent(point, 0);
      if (!std::isfinite(value))
      {
        return { { infinity, -infinity } };
      }
      range = { { std::min(range[0], value), std::max(range[1], value) } };
    }
    return range;
  }

  vtkImageData* Image;
  Blanking Ghosts;
  Index Cells;
  Position Base;
  Position Spacing;
  std::vector<unsigned char> Marks;
};

std::vector<Block> FindBlocks(vtkCompositeDataSet* levels)
{
  std::vector<Block> blocks;
  const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(levels->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    vtkImageData* image = vtkImageData::SafeDownCast(at->GetCurrentDataObject());
    if (image && Block(image).IsSolid())
    {
      blocks.emplace_back(image);
    }
  }
  return blocks;
}
}

void RefinementLevels::Count(vtkDataObject* input,
  const std::vector<vtkIntervalList::Interval>& intervals, CellArrayConversion& conversion,
  ExtractionReport& report)
{
  vtkCompositeDataSet* levels = vtkCompositeDataSet::SafeDownCast(input);
  if (intervals.empty() || !levels ||
    !(levels->IsA("vtkUniformGridAMR") || levels->IsA("vtkOverlappingAMR")))
  {
    return;
  }
  std::vector<Block> blocks = FindBlocks(levels);
  for (Block& block : blocks)
  {
    for (const Block& other : blocks)
    {
      if (other.IsFinerThan(block))
      {
        block.Mark(other);
      }
    }
    vtkDataArray* scalars = vtkDataArray::SafeDownCast(conversion.Select(block.GetImage()).Array);
    if (scalars && !ArrayCheck::FindPointError(block.GetImage(), scalars, 1))
    {
      block.Count(scalars, intervals, report);
    }
  }
}

std::vector<std::string> RefinementLevels::GetWarnings(const ExtractionReport& report)
{
  std::vector<std::string> warnings;
  if (report.CoveredCells > 0)
  {
    warnings.push_back(std::to_string(report.CoveredCells) +
      " cells of AMR levels are covered by a finer level but not blanked. Both levels are "
      "extracted there. Blank the covered cells first (vtkAMRUtilities::BlankCells).");
  }
  if (report.LevelFaces > 0)
  {
    warnings.push_back("Two AMR levels meet at " + std::to_string(report.LevelFaces) +
      " faces that an isovalue intersects. Each level is extracted separately, so surfaces have "
      "gaps there. For closed surfaces, resample the levels to one image (vtkResampleToImage).");
  }
  return warnings;
}

}
