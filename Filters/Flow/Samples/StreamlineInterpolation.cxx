// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/StreamlineInterpolation.h"

#include "Common/ParallelFor.h"

#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace interlume
{

namespace
{
constexpr int Nodes = 4;
/// Maximum spacing of the samples that are advected first. A larger value would save few additional
/// streamlines.
constexpr int MaximumStride = 4;
/// Factor by which halving the spacing reduces the error of cubic interpolation where second
/// derivatives jump.
constexpr double ErrorReduction = 4.0;
/// Weights of four nodes in cubic interpolation at the midpoints of the three intervals between
/// them.
constexpr double Weights[Nodes - 1][Nodes] = { { 0.3125, 0.9375, -0.3125, 0.0625 },
  { -0.0625, 0.5625, 0.5625, -0.0625 }, { 0.0625, -0.3125, 0.9375, 0.3125 } };
}

bool StreamlineInterpolation::GetDimensions(vtkDataSet* samples, int dimensions[3])
{
  if (auto* image = vtkImageData::SafeDownCast(samples))
  {
    image->GetDimensions(dimensions);
    return true;
  }
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(samples))
  {
    rectilinear->GetDimensions(dimensions);
    return true;
  }
  if (auto* structured = vtkStructuredGrid::SafeDownCast(samples))
  {
    structured->GetDimensions(dimensions);
    return true;
  }
  return false;
}

StreamlineInterpolation::StreamlineInterpolation(
  const int dimensions[3], const SampleResults& results, Measure measure, Seams seams)
  : Dimensions{ { dimensions[0], dimensions[1], dimensions[2] } }
  , Known(results)
  , Compare(std::move(measure))
  , FindSeams(std::move(seams))
{
  int shortest = std::numeric_limits<int>::max();
  for (const int points : this->Dimensions)
  {
    shortest = points > 1 ? std::min(shortest, points) : shortest;
  }
  while (this->First < MaximumStride && shortest != std::numeric_limits<int>::max() &&
    (shortest - 1) / (2 * this->First) + 1 >= Nodes)
  {
    this->First *= 2;
  }
}

StreamlineInterpolation::Ids StreamlineInterpolation::GetFirst() const
{
  Ids ids;
  for (int k = 0; k < this->Dimensions[2]; k += this->First)
  {
    for (int j = 0; j < this->Dimensions[1]; j += this->First)
    {
      for (int i = 0; i < this->Dimensions[0]; i += this->First)
      {
        ids.push_back(this->GetId({ { i, j, k } }));
      }
    }
  }
  return ids;
}

bool StreamlineInterpolation::Next()
{
  this->SetStride(this->Stride == 0 ? this->First : this->Stride / 2);
  return this->Stride > 1;
}

StreamlineInterpolation::Ids StreamlineInterpolation::GetSamplesToAdvect()
{
  this->VisitBlocks(
    [this](std::size_t block)
    {
      SampleResult result;
      const Index at = this->GetBlock(block);
      const bool isKnown = this->IsVerified(at) &&
        this->VisitMidpoints(
          at, [&](const Index& midpoint) { return this->Predict(midpoint, this->Stride, result); });
      this->Marks[block] = isKnown ? GOOD : NOT_GOOD;
    });
  const bool isAny = this->HasGoodBlock();
  Ids ids;
  this->VisitNewSamples(
    [&](const Index& at)
    {
      if (!isAny || this->IsCenter(at) || !this->IsInMarkedBlocks(at, GOOD))
      {
        ids.push_back(this->GetId(at));
      }
    });
  return ids;
}

StreamlineInterpolation::Ids StreamlineInterpolation::CheckCenters()
{
  Ids ids;
  if (!this->HasGoodBlock())
  {
    return ids;
  }
  std::vector<double> errors(this->Marks.size(), 0.0);
  this->VisitBlocks(
    [&](std::size_t block)
    {
      if (this->Marks[block] == GOOD)
      {
        errors[block] = this->GetError(this->GetCenter(this->GetBlock(block)), this->Stride);
        this->Marks[block] = errors[block] <= 1.0 ? GOOD : REFUTED;
      }
    });
  for (std::size_t block = 0; block < errors.size(); ++block)
  {
    if (this->Marks[block] == GOOD)
    {
      ++this->Checks;
      this->LargestError = std::max(this->LargestError, errors[block]);
      this->SumOfErrors += errors[block];
    }
  }
  this->VisitNewSamples(
    [&](const Index& at)
    {
      if (!this->IsCenter(at) && this->IsInMarkedBlocks(at, REFUTED) &&
        !this->IsInMarkedBlocks(at, GOOD))
      {
        ids.push_back(this->GetId(at));
      }
    });
  return ids;
}

void StreamlineInterpolation::VisitInterpolated(
  const std::function<void(vtkIdType id, const SampleResult& result)>& visit)
{
  if (!this->HasGoodBlock())
  {
    return;
  }
  this->VisitNewSamples(
    [&](const Index& at)
    {
      SampleResult result;
      if (!this->IsCenter(at) && this->IsInMarkedBlocks(at, GOOD) &&
        this->Predict(at, this->Stride, result))
      {
        visit(this->GetId(at), result);
      }
    });
}

bool StreamlineInterpolation::HasGoodBlock() const
{
  return std::find(this->Marks.begin(), this->Marks.end(), GOOD) != this->Marks.end();
}

vtkIdType StreamlineInterpolation::GetId(const Index& at) const
{
  return at[0] +
    this->Dimensions[0] * (at[1] + this->Dimensions[1] * static_cast<vtkIdType>(at[2]));
}

StreamlineInterpolation::Index StreamlineInterpolation::GetBlock(std::size_t block) const
{
  const auto x = static_cast<std::size_t>(this->Blocks[0]);
  const auto y = static_cast<std::size_t>(this->Blocks[1]);
  return { { static_cast<int>(block % x), static_cast<int>(block / x % y),
    static_cast<int>(block / (x * y)) } };
}

StreamlineInterpolation::Index StreamlineInterpolation::GetCenter(const Index& block) const
{
  Index at;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    at[axis] = this->Stride * block[axis] + (this->Dimensions[axis] > 1 ? this->Stride / 2 : 0);
  }
  return at;
}

bool StreamlineInterpolation::IsCenter(const Index& at) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (this->Dimensions[axis] > 1 && at[axis] % this->Stride == 0)
    {
      return false;
    }
  }
  return true;
}

void StreamlineInterpolation::SetStride(int stride)
{
  this->Stride = stride;
  std::size_t number = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Blocks[axis] = this->Dimensions[axis] > 1 ? (this->Dimensions[axis] - 1) / stride : 1;
    number *= static_cast<std::size_t>(this->Blocks[axis]);
  }
  this->Marks.assign(number, NOT_GOOD);
}

template <typename Visit>
void StreamlineInterpolation::VisitBlocks(Visit&& visit) const
{
  ParallelFor(0, static_cast<vtkIdType>(this->Marks.size()),
    [&](vtkIdType block) { visit(static_cast<std::size_t>(block)); });
}

template <typename Visit>
bool StreamlineInterpolation::VisitMidpoints(const Index& block, Visit&& visit) const
{
  const int half = this->Stride / 2;
  const auto getLast = [this](std::size_t axis) { return this->Dimensions[axis] > 1 ? 2 : 0; };
  for (int k = 0; k <= getLast(2); ++k)
  {
    for (int j = 0; j <= getLast(1); ++j)
    {
      for (int i = 0; i <= getLast(0); ++i)
      {
        const bool isNew = ((i | j | k) & 1) != 0;
        if (isNew &&
          !visit(Index{ { this->Stride * block[0] + half * i, this->Stride * block[1] + half * j,
            this->Stride * block[2] + half * k } }))
        {
          return false;
        }
      }
    }
  }
  return true;
}

template <typename Visit>
void StreamlineInterpolation::VisitNewSamples(Visit&& visit) const
{
  const int half = this->Stride / 2;
  for (int k = 0; k < this->Dimensions[2]; k += half)
  {
    for (int j = 0; j < this->Dimensions[1]; j += half)
    {
      for (int i = 0; i < this->Dimensions[0]; i += half)
      {
        if (i % this->Stride != 0 || j % this->Stride != 0 || k % this->Stride != 0)
        {
          visit(Index{ { i, j, k } });
        }
      }
    }
  }
}

bool StreamlineInterpolation::IsInMarkedBlocks(const Index& at, unsigned char minimumMark) const
{
  Index first;
  Index last;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int block = at[axis] / this->Stride;
    const bool isBetween = at[axis] % this->Stride != 0;
    first[axis] = isBetween ? block : std::max(0, block - 1);
    last[axis] = isBetween ? block : std::min(block, this->Blocks[axis] - 1);
    if (last[axis] >= this->Blocks[axis] || this->Blocks[axis] == 0)
    {
      return false;
    }
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        const std::size_t block = static_cast<std::size_t>(i) +
          static_cast<std::size_t>(this->Blocks[0]) *
            (static_cast<std::size_t>(j) +
              static_cast<std::size_t>(this->Blocks[1]) * static_cast<std::size_t>(k));
        if (this->Marks[block] < minimumMark)
        {
          return false;
        }
      }
    }
  }
  return true;
}

bool StreamlineInterpolation::Predict(const Index& at, int stride, SampleResult& result) const
{
  Index first;
  Index nodes;
  int known[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    first[axis] = at[axis] / stride;
    known[axis] = (this->Dimensions[axis] - 1) / stride + 1;
    nodes[axis] = at[axis] % stride != 0 ? Nodes : 1;
    if (nodes[axis] > 1 && (known[axis] < Nodes || first[axis] + 1 >= known[axis]))
    {
      return false;
    }
  }
  if (!this->ReachSameSurface(first, nodes, stride))
  {
    return false;
  }
  // Try the four nodes centered on the midpoint first, then, near another surface or the end of the
  // grid, nodes that are shifted to one side.
  for (const int z : { 1, 0, 2 })
  {
    for (const int y : { 1, 0, 2 })
    {
      for (const int x : { 1, 0, 2 })
      {
        const int interval[3] = { x, y, z };
        constexpr double One[1] = { 1.0 };
        const double* weights[3] = { One, One, One };
        Index begin = first;
        bool isThere = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          if (nodes[axis] > 1)
          {
            begin[axis] -= interval[axis];
            weights[axis] = Weights[interval[axis]];
            isThere = isThere && begin[axis] >= 0 && begin[axis] + Nodes <= known[axis];
          }
          else
          {
            isThere = isThere && interval[axis] == 1;
          }
        }
        if (isThere && this->Interpolate(begin, nodes, weights, stride, result))
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool StreamlineInterpolation::ReachSameSurface(
  const Index& first, const Index& nodes, int stride) const
{
  const int own =
    this->Known.Id[this->GetId({ { stride * first[0], stride * first[1], stride * first[2] } })];
  for (int corner = 0; corner < 8; ++corner)
  {
    Index at;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int step = nodes[axis] > 1 ? corner >> axis & 1 : 0;
      at[axis] = stride * (first[axis] + step);
    }
    const vtkIdType id = this->GetId(at);
    if (this->Known.Status[id] != vtkFlowStatus::REACHED_SURFACE || this->Known.Id[id] != own)
    {
      return false;
    }
  }
  return true;
}

bool StreamlineInterpolation::Interpolate(const Index& first, const Index& nodes,
  const double* const weights[3], int stride, SampleResult& result) const
{
  result = SampleResult();
  double low[2] = { 0.0, 0.0 };
  double high[2] = { 0.0, 0.0 };
  bool isFirst = true;
  for (int k = 0; k < nodes[2]; ++k)
  {
    for (int j = 0; j < nodes[1]; ++j)
    {
      for (int i = 0; i < nodes[0]; ++i)
      {
        const vtkIdType id = this->GetId(
          { { stride * (first[0] + i), stride * (first[1] + j), stride * (first[2] + k) } });
        const double* uv = this->Known.Parameters + 2 * id;
        if (this->Known.Status[id] != vtkFlowStatus::REACHED_SURFACE ||
          (!isFirst && this->Known.Id[id] != result.Id))
        {
          return false;
        }
        const double weight = weights[0][i] * weights[1][j] * weights[2][k];
        for (int c = 0; c < 2; ++c)
        {
          low[c] = isFirst ? uv[c] : std::min(low[c], uv[c]);
          high[c] = isFirst ? uv[c] : std::max(high[c], uv[c]);
          result.Parameters[c] += weight * uv[c];
        }
        result.Time += weight * this->Known.Time[id];
        result.Id = this->Known.Id[id];
        isFirst = false;
      }
    }
  }
  const std::array<bool, 2> isPeriodic = this->FindSeams(result.Id);
  bool isOnSurface = result.Time >= 0.0;
  for (std::size_t c = 0; c < 2; ++c)
  {
    isOnSurface = isOnSurface && result.Parameters[c] >= 0.0 && result.Parameters[c] <= 1.0 &&
      !(isPeriodic[c] && high[c] - low[c] > 0.5);
  }
  return isOnSurface;
}

double StreamlineInterpolation::GetError(const Index& at, int stride) const
{
  SampleResult guess;
  return this->Predict(at, stride, guess) ? this->GetError(at, guess)
                                          : std::numeric_limits<double>::infinity();
}

double StreamlineInterpolation::GetError(const Index& at, const SampleResult& guess) const
{
  const vtkIdType id = this->GetId(at);
  return this->Known.Status[id] == vtkFlowStatus::REACHED_SURFACE && this->Known.Id[id] == guess.Id
    ? this->Compare(guess, this->Known.Parameters + 2 * id, this->Known.Time[id])
    : std::numeric_limits<double>::infinity();
}

bool StreamlineInterpolation::IsVerified(const Index& block) const
{
  const int wide = 2 * this->Stride;
  const auto getLast = [this](std::size_t axis) { return this->Dimensions[axis] > 1 ? 1 : 0; };
  bool isPredicted = false;
  for (int k = 0; k <= getLast(2); ++k)
  {
    for (int j = 0; j <= getLast(1); ++j)
    {
      for (int i = 0; i <= getLast(0); ++i)
      {
        const Index at = { { this->Stride * (block[0] + i), this->Stride * (block[1] + j),
          this->Stride * (block[2] + k) } };
        const bool isBetween = at[0] % wide != 0 || at[1] % wide != 0 || at[2] % wide != 0;
        SampleResult guess;
        if (isBetween && this->Predict(at, wide, guess))
        {
          isPredicted = true;
          if (this->GetError(at, guess) > ErrorReduction)
          {
            return false;
          }
        }
      }
    }
  }
  // If no corner was predicted, a small error at the center is not sufficient: errors along
  // different axes may cancel there.
  return isPredicted;
}

}
