// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/InflowFinder.h"

#include "Cells/MultilinearCell.h"
#include "Common/Blanking.h"
#include "Numerics/SpeedScale.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

namespace
{
constexpr int NumberOfSlabs = 32;
constexpr vtkIdType MaximumNumberOfCells = 262144;
/// The inflow is in the first slab with at least this fraction of the largest flow through a slab.
constexpr double MinimumFraction = 0.4;
/// An inflow in one of these first slabs is at the boundary of the field.
constexpr int BoundarySlabs = 4;
/// Axes whose flows differ by less than this fraction are tied; the first axis is used.
constexpr double TieTolerance = 1e-6;

struct Cell
{
  glm::dvec3 Low;
  glm::dvec3 High;
  /// Flow through planes perpendicular to each axis.
  glm::dvec3 Flow;
  /// Largest speed at a corner.
  double Speed = 0.0;
};

/// Computes the bounds, flow and speed of a cell, and adds the vectors at its corners to \a speeds.
/// In the flow, lengths are multiplied by \a scale.
Cell Measure(const MultilinearCell& loaded, double scale, bool isReversed, SpeedScale& speeds)
{
  Cell cell;
  const int* corners = nullptr;
  const int number = MultilinearCell::GetCorners(loaded.GetShape(), corners);
  const double volume = std::abs(loaded.GetVolume(scale));
  for (int i = 0; i < number; ++i)
  {
    speeds.Add(loaded.GetVectors()[corners[i]]);
  }
  cell.Speed = loaded.GetLargestSpeed();
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = loaded.GetPositions()[corners[0]][axis];
    double high = low;
    double velocity = 0.0;
    for (int i = 0; i < number; ++i)
    {
      const double position = loaded.GetPositions()[corners[i]][axis];
      low = std::min(low, position);
      high = std::max(high, position);
      velocity += loaded.GetVectors()[corners[i]][axis] / number;
    }
    cell.Low[axis] = low;
    cell.High[axis] = high;
    const double flow = high > low ? velocity * volume / ((high - low) * scale) : 0.0;
    cell.Flow[axis] = isReversed ? -flow : flow;
  }
  return cell;
}

/// Returns a pseudo-random cell from a group of \a stride consecutive cells. A random choice avoids
/// aliasing with grid rows.
vtkIdType Pick(vtkIdType group, vtkIdType stride, vtkIdType cells)
{
  const std::uint64_t hash = static_cast<std::uint64_t>(group) * 0x9e3779b97f4a7c15ull;
  const vtkIdType offset = static_cast<vtkIdType>((hash >> 33) % stride);
  return std::min(group * stride + offset, cells - 1);
}

/// Returns the power of 2 that scales the longest side of a field's bounds to about 1.
double GetScaleOf(vtkDataSet* field)
{
  double bounds[6];
  field->GetBounds(bounds);
  return MultilinearCell::GetScale(
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }));
}

std::vector<Cell> ReadCells(vtkDataSet* field, vtkDataArray* vectors, bool isReversed)
{
  std::vector<Cell> cells;
  SpeedScale speeds;
  Blanking blanking;
  blanking.SetBlanking(field);
  const vtkIdType number = field->GetNumberOfCells();
  const vtkIdType stride =
    std::max<vtkIdType>(1, (number + MaximumNumberOfCells - 1) / MaximumNumberOfCells);
  const double scale = GetScaleOf(field);
  MultilinearCell loaded;
  vtkNew<vtkIdList> ids;
  for (vtkIdType group = 0; group * stride < number; ++group)
  {
    const vtkIdType id = Pick(group, stride, number);
    if (blanking.IsCellBlanked(id) ||
      MultilinearCell::GetShape(field->GetCellType(id)) == MultilinearCell::NONE)
    {
      continue;
    }
    loaded.Load(field, vectors, id, ids);
    if (loaded.IsFinite())
    {
      cells.push_back(Measure(loaded, scale, isReversed, speeds));
    }
  }
  // Remove cells with fill values, which would dominate the flow.
  const FillValues fill = speeds.FindFillValues();
  if (fill.Number > 0)
  {
    cells.erase(std::remove_if(cells.begin(), cells.end(),
                  [&fill](const Cell& cell) { return cell.Speed > fill.Scale; }),
      cells.end());
  }
  return cells;
}

/// Flow through each slab along an axis, and against it.
class Profile
{
public:
  Profile(const std::vector<Cell>& cells, int axis)
    : Low(VTK_DOUBLE_MAX)
    , High(-VTK_DOUBLE_MAX)
  {
    for (const Cell& cell : cells)
    {
      this->Low = std::min(this->Low, cell.Low[axis]);
      this->High = std::max(this->High, cell.High[axis]);
    }
    const double width = (this->High - this->Low) / NumberOfSlabs;
    for (const Cell& cell : cells)
    {
      std::array<double, NumberOfSlabs>& flows = this->Flows[cell.Flow[axis] > 0.0 ? 0 : 1];
      for (int slab = this->GetSlab(cell.Low[axis]); slab <= this->GetSlab(cell.High[axis]); ++slab)
      {
        const double begin = std::max(cell.Low[axis], this->Low + slab * width);
        const double end = std::min(cell.High[axis], this->Low + (slab + 1) * width);
        flows[slab] += std::abs(cell.Flow[axis]) * (std::max(end - begin, 0.0) / width);
      }
    }
  }

  double GetMaximum(int sense) const
  {
    return *std::max_element(this->Flows[sense].begin(), this->Flows[sense].end());
  }

  /// Returns the center of the first slab, in flow direction, with at least MinimumFraction of the
  /// largest flow, if the slab is at the boundary; otherwise, the center of the slab with the
  /// largest flow.
  double FindEntry(int sense) const
  {
    const double minimum = MinimumFraction * this->GetMaximum(sense);
    int slab = sense == 0 ? 0 : NumberOfSlabs - 1;
    while (this->Flows[sense][slab] < minimum)
    {
      slab += sense == 0 ? 1 : -1;
    }
    const int first = sense == 0 ? slab : NumberOfSlabs - 1 - slab;
    if (first >= BoundarySlabs)
    {
      const auto& flows = this->Flows[sense];
      slab = static_cast<int>(std::max_element(flows.begin(), flows.end()) - flows.begin());
    }
    return this->Low + (slab + 0.5) / NumberOfSlabs * (this->High - this->Low);
  }

private:
  int GetSlab(double position) const
  {
    const double part = (position - this->Low) / (this->High - this->Low);
    return part > 0.0 ? std::min(static_cast<int>(part * NumberOfSlabs), NumberOfSlabs - 1) : 0;
  }

  double Low;
  double High;
  /// Flow through each slab along the axis, and against it.
  std::array<std::array<double, NumberOfSlabs>, 2> Flows{};
};
}

bool InflowFinder::Find(vtkDataSet* field, vtkDataArray* vectors, bool isReversed)
{
  const std::vector<Cell> cells = ReadCells(field, vectors, isReversed);
  double largestFlow = 0.0;
  int sense = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Profile profile(cells, axis);
    for (int candidate = 0; candidate < 2; ++candidate)
    {
      const double flow = profile.GetMaximum(candidate);
      if (flow > largestFlow * (1.0 + TieTolerance))
      {
        largestFlow = flow;
        sense = candidate;
        this->Axis = axis;
        this->Position = profile.FindEntry(candidate);
      }
    }
  }
  if (!(largestFlow > 0.0))
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    const int across = (this->Axis + 1 + i) % 3;
    double low = VTK_DOUBLE_MAX;
    double high = -VTK_DOUBLE_MAX;
    for (const Cell& cell : cells)
    {
      const double flow = sense == 0 ? cell.Flow[this->Axis] : -cell.Flow[this->Axis];
      if (flow > 0.0 && cell.Low[this->Axis] <= this->Position &&
        cell.High[this->Axis] >= this->Position)
      {
        low = std::min(low, cell.Low[across]);
        high = std::max(high, cell.High[across]);
      }
    }
    this->Center[i] = 0.5 * (low + high);
    this->HalfWidth[i] = 0.5 * (high - low);
  }
  return true;
}

}
