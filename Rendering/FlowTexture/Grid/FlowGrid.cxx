// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/FlowGrid.h"

#include "Common/ArrayCheck.h"
#include "Common/ArrayRows.h"
#include "Common/ParallelFor.h"
#include "Grid/UnwrappedParameters.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace interlume
{

namespace
{
// Names and values from vtkFlowStatus, which is in a module that this one does not depend on.
constexpr const char* STATUS = "FlowStatus";
constexpr const char* ID = "TerminationId";
constexpr const char* UV = "TerminationUV";
constexpr const char* TIME = "AdvectionTime";
constexpr const char* SIDE = "TerminationSide";
constexpr const char* SURFACES = "TerminationSurfaces";
constexpr double REACHED = 0.0;
constexpr double AWAY = 2.0;
}

struct FlowGrid::Arrays
{
  ArrayRows Statuses;
  ArrayRows Ids;
  ArrayRows Parameters;
  ArrayRows Times;
  ArrayRows Sides;
  bool HasSides = false;

  static double Get(const ArrayRows& rows, vtkIdType i)
  {
    double value = 0.0;
    rows.Get<1>(i, &value);
    return value;
  }

  bool IsFinite(vtkIdType i) const
  {
    double uv[2];
    this->Parameters.Get<2>(i, uv);
    return std::isfinite(uv[0]) && std::isfinite(uv[1]) && std::isfinite(Get(this->Times, i));
  }

  bool IsReached(vtkIdType i) const { return Get(this->Statuses, i) == REACHED; }
};

Error FlowGrid::Build(vtkImageData* image)
{
  *this = FlowGrid();
  const std::pair<const char*, int> needed[] = { { STATUS, 1 }, { ID, 1 }, { UV, 2 }, { TIME, 1 } };
  for (const auto& [name, components] : needed)
  {
    if (Error error =
          ArrayCheck::MakeSentence(ArrayCheck::FindPointError(image, "input", name, components)))
    {
      return error;
    }
  }
  image->GetDimensions(this->Size.data());
  if (*std::min_element(this->Size.begin(), this->Size.end()) < 2)
  {
    return "The input has " + std::to_string(this->Size[0]) + " x " +
      std::to_string(this->Size[1]) + " x " + std::to_string(this->Size[2]) +
      " points, but at least two along each axis are required.";
  }
  vtkPointData* points = image->GetPointData();
  Arrays arrays;
  arrays.Statuses.Build(points->GetArray(STATUS));
  arrays.Ids.Build(points->GetArray(ID));
  arrays.Parameters.Build(points->GetArray(UV));
  arrays.Times.Build(points->GetArray(TIME));
  vtkAbstractArray* sides = points->GetAbstractArray(SIDE);
  arrays.HasSides = sides && !ArrayCheck::FindPointError(image, sides, 1);
  if (arrays.HasSides)
  {
    arrays.Sides.Build(points->GetArray(SIDE));
  }
  this->FindIds(arrays);
  if (this->Ids.size() > LARGEST_LABEL)
  {
    return "The samples reach " + std::to_string(this->Ids.size()) + " surfaces, but at most " +
      std::to_string(LARGEST_LABEL) + " are supported. Use fewer termination surfaces.";
  }
  this->ReadPeriodicity(image);
  this->ReadVoxels(arrays);
  UnwrappedParameters::Apply(*this);
  this->FindKinds();
  this->FindDistances();
  this->MarkInnerCells();
  return {};
}

void FlowGrid::FindIds(const Arrays& arrays)
{
  std::set<int> ids;
  int last = -1;
  for (vtkIdType i = 0; i < arrays.Statuses.GetNumber(); ++i)
  {
    if (!arrays.IsReached(i))
    {
      continue;
    }
    const int id = static_cast<int>(Arrays::Get(arrays.Ids, i));
    if (!arrays.IsFinite(i))
    {
      this->NonFinite.push_back(i);
    }
    else if (ids.empty() || id != last)
    {
      ids.insert(id);
      last = id;
    }
  }
  this->Ids.assign(ids.begin(), ids.end());
}

int FlowGrid::FindLabel(int id) const
{
  const auto found = std::lower_bound(this->Ids.begin(), this->Ids.end(), id);
  return found != this->Ids.end() && *found == id ? static_cast<int>(found - this->Ids.begin()) + 1
                                                  : 0;
}

void FlowGrid::ReadPeriodicity(vtkImageData* image)
{
  this->Periods.assign(this->Ids.size(), Periodicity{ { false, false } });
  vtkDataArray* surfaces = image->GetFieldData()->GetArray(SURFACES);
  for (vtkIdType i = 0;
       surfaces && surfaces->GetNumberOfComponents() == 3 && i < surfaces->GetNumberOfTuples(); ++i)
  {
    const int label = this->FindLabel(static_cast<int>(surfaces->GetComponent(i, 0)));
    if (label > 0)
    {
      this->Periods[static_cast<std::size_t>(label) - 1] = { { surfaces->GetComponent(i, 1) != 0.0,
        surfaces->GetComponent(i, 2) != 0.0 } };
    }
  }
}

void FlowGrid::ReadVoxels(const Arrays& arrays)
{
  const vtkIdType number = arrays.Statuses.GetNumber();
  this->Parameters.assign(2 * static_cast<std::size_t>(number), 0.0F);
  this->Times.assign(static_cast<std::size_t>(number), 0.0F);
  this->Groups.assign(static_cast<std::size_t>(number), 0);
  ParallelFor(0, number,
    [&](vtkIdType i)
    {
      if (!arrays.IsReached(i) || !arrays.IsFinite(i))
      {
        return;
      }
      double uv[2];
      arrays.Parameters.Get<2>(i, uv);
      this->Parameters[2 * i] = static_cast<float>(uv[0]);
      this->Parameters[2 * i + 1] = static_cast<float>(uv[1]);
      this->Times[i] = static_cast<float>(Arrays::Get(arrays.Times, i));
      const int label = this->FindLabel(static_cast<int>(Arrays::Get(arrays.Ids, i)));
      const double side = arrays.HasSides ? Arrays::Get(arrays.Sides, i) : 0.0;
      const int awaySide = side == AWAY ? 1 : (side == -AWAY ? 2 : 0);
      this->Groups[i] = static_cast<unsigned short>(label * NumberOfSides + awaySide);
    });
}

unsigned short FlowGrid::FindKind(const std::array<vtkIdType, 8>& corners) const
{
  const int label = this->Groups[corners[0]] / NumberOfSides;
  float lower[2] = { this->Parameters[2 * corners[0]], this->Parameters[2 * corners[0] + 1] };
  float upper[2] = { lower[0], lower[1] };
  bool isUniform = true;
  bool isSplitBySides = false;
  for (const vtkIdType corner : corners)
  {
    isUniform = isUniform && this->Groups[corner] / NumberOfSides == label;
    // Only AWAY corners have a side: their streamlines first recede from the surface.
    isSplitBySides = isSplitBySides ||
      this->Groups[corner] % NumberOfSides != this->Groups[corners[0]] % NumberOfSides;
    for (int i = 0; i < 2; ++i)
    {
      lower[i] = std::min(lower[i], this->Parameters[2 * corner + i]);
      upper[i] = std::max(upper[i], this->Parameters[2 * corner + i]);
    }
  }
  if (isUniform && label == 0)
  {
    return EMPTY;
  }
  if (isSplitBySides)
  {
    // In a cell that the surface crosses, the times of corners with and without a side differ
    // strongly. In neighboring cells, they are similar.
    float nearest = VTK_FLOAT_MAX;
    float farthest = 0.0F;
    for (const vtkIdType corner : corners)
    {
      if (this->Groups[corner] % NumberOfSides == 0)
      {
        nearest = std::min(nearest, this->Times[corner]);
      }
      else
      {
        farthest = std::max(farthest, this->Times[corner]);
      }
    }
    if (nearest < 0.5F * farthest)
    {
      return SPLIT_BY_SIDES;
    }
  }
  if (!isUniform)
  {
    return SPLIT;
  }
  const Periodicity& periods = this->Periods[static_cast<std::size_t>(label) - 1];
  const bool isAcross =
    (periods[0] && upper[0] - lower[0] > 0.5F) || (periods[1] && upper[1] - lower[1] > 0.5F);
  return static_cast<unsigned short>(isAcross ? SEAM + label : label);
}

unsigned short FlowGrid::GetSlopeCode(float slope)
{
  const double code = 2.0 * std::ceil(128.0 * (std::log2(static_cast<double>(slope)) + 128.0));
  return slope > 0.0F ? static_cast<unsigned short>(std::min(std::max(code, 2.0), 65534.0)) : 0;
}

float FlowGrid::FindSlope(const std::array<vtkIdType, 8>& corners) const
{
  // Along an axis, the derivative is a weighted mean of the differences along four parallel edges,
  // so the largest of these is a bound.
  float largest = 0.0F;
  for (int c = 0; c < 2; ++c)
  {
    float sum = 0.0F;
    for (const int step : { 1, 2, 4 })
    {
      float change = 0.0F;
      for (int i = 0; i < 8; ++i)
      {
        change = std::max(change,
          std::abs(this->Parameters[2 * corners[i | step] + c] -
            this->Parameters[2 * corners[i & ~step] + c]));
      }
      sum += change * change;
    }
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest);
}

template <typename Visit>
void FlowGrid::ForEachCell(const Visit& visit) const
{
  const vtkIdType size[3] = { this->Size[0] - 1, this->Size[1] - 1, this->Size[2] - 1 };
  ParallelFor(0, size[2],
    [&](vtkIdType k)
    {
      for (vtkIdType j = 0; j < size[1]; ++j)
      {
        for (vtkIdType i = 0; i < size[0]; ++i)
        {
          visit(i, j, k, 2 * static_cast<std::size_t>(i + size[0] * (j + size[1] * k)));
        }
      }
    });
}

void FlowGrid::FindKinds()
{
  const vtkIdType row = this->Size[0];
  const vtkIdType slice = row * this->Size[1];
  this->Cells.resize(2 * static_cast<std::size_t>(row - 1) *
    static_cast<std::size_t>(this->Size[1] - 1) * static_cast<std::size_t>(this->Size[2] - 1));
  this->ForEachCell(
    [&](vtkIdType i, vtkIdType j, vtkIdType k, std::size_t cell)
    {
      const vtkIdType a = i + row * j + slice * k;
      const std::array<vtkIdType, 8> corners{ { a, a + 1, a + row, a + row + 1, a + slice,
        a + slice + 1, a + slice + row, a + slice + row + 1 } };
      this->Cells[cell] = this->FindKind(corners);
      this->Cells[cell + 1] = GetSlopeCode(this->FindSlope(corners));
    });
  for (std::size_t i = 0; i < this->Cells.size(); i += 2)
  {
    const unsigned short kind = this->Cells[i];
    const bool isSplit = kind == SPLIT || kind == SPLIT_BY_SIDES;
    this->EmptyCells += kind == EMPTY ? 1 : 0;
    this->SplitCells += isSplit ? 1 : 0;
    this->SeamCells += kind > SEAM && kind < EMPTY ? 1 : 0;
    this->UniformCells += kind <= LARGEST_LABEL && !isSplit ? 1 : 0;
  }
  if (this->SplitCells == 0)
  {
    this->Groups.clear();
  }
}

void FlowGrid::FindDistances()
{
  if (this->EmptyCells == 0)
  {
    return;
  }
  // Forward and backward sweeps, each over the 13 preceding neighbors, compute the distance in the
  // maximum norm.
  constexpr int largest = 65000;
  const int size[3] = { this->Size[0] - 1, this->Size[1] - 1, this->Size[2] - 1 };
  const auto at = [&size](int i, int j, int k)
  { return 2 * (i + static_cast<vtkIdType>(size[0]) * (j + static_cast<vtkIdType>(size[1]) * k)); };
  for (std::size_t i = 0; i < this->Cells.size(); i += 2)
  {
    this->Cells[i] =
      this->Cells[i] == EMPTY ? static_cast<unsigned short>(largest) : this->Cells[i];
  }
  const auto visit = [&](int i, int j, int k, int direction)
  {
    unsigned short& kind = this->Cells[at(i, j, k)];
    if (kind < EMPTY)
    {
      return;
    }
    int distance = kind - EMPTY;
    for (int n = 0; n < 13; ++n)
    {
      const int x = i + direction * (n % 3 - 1);
      const int y = j + direction * (n / 3 % 3 - 1);
      const int z = k + direction * (n / 9 - 1);
      if (x >= 0 && y >= 0 && z >= 0 && x < size[0] && y < size[1] && z < size[2])
      {
        const unsigned short other = this->Cells[at(x, y, z)];
        distance = std::min(distance, other < EMPTY ? 1 : other - EMPTY + 1);
      }
    }
    kind = static_cast<unsigned short>(EMPTY + distance);
  };
  for (const int direction : { 1, -1 })
  {
    for (int k = 0; k < size[2]; ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const bool isForward = direction > 0;
          visit(isForward ? i : size[0] - 1 - i, isForward ? j : size[1] - 1 - j,
            isForward ? k : size[2] - 1 - k, direction);
        }
      }
    }
  }
}

void FlowGrid::MarkInnerCells()
{
  const vtkIdType size[3] = { this->Size[0] - 1, this->Size[1] - 1, this->Size[2] - 1 };
  this->ForEachCell(
    [&](vtkIdType i, vtkIdType j, vtkIdType k, std::size_t cell)
    {
      const unsigned short kind = this->Cells[cell];
      bool isInner = kind != SPLIT && kind <= LARGEST_LABEL;
      for (int n = 0; n < 27 && isInner; ++n)
      {
        const vtkIdType x = i + n % 3 - 1;
        const vtkIdType y = j + n / 3 % 3 - 1;
        const vtkIdType z = k + n / 9 - 1;
        const bool isInside =
          x >= 0 && y >= 0 && z >= 0 && x < size[0] && y < size[1] && z < size[2];
        isInner = !isInside ||
          this->Cells[2 * static_cast<std::size_t>(x + size[0] * (y + size[1] * z))] == kind;
      }
      this->Cells[cell + 1] |= isInner ? 1 : 0;
    });
}

}
