// SPDX-License-Identifier: BSD-3-Clause
#include "Software/TileBins.h"

#include "Common/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace interlume
{

namespace
{
/// Number of tetrahedra per task. It is fixed, so that lists do not depend on the number of
/// threads.
constexpr std::size_t CHUNK = 1 << 16;

/// Returns the number of tetrahedra to draw.
std::size_t GetNumber(const TetrahedraFrame& frame)
{
  return frame.Order ? frame.Order->size() : frame.Mesh->GetNumberOfTetrahedra();
}

std::size_t GetNumberOfChunks(const TetrahedraFrame& frame)
{
  return (GetNumber(frame) + CHUNK - 1) / CHUNK;
}
}

void TileBins::ProjectPoints(const TetrahedraFrame& frame)
{
  const TetrahedraMesh& mesh = *frame.Mesh;
  const TetrahedraFields& fields = *frame.Fields;
  const std::size_t points = mesh.Points.size() / 3;
  const bool hasScalars = fields.Kind == TetrahedraFields::SCALARS;
  const bool hasDeltaT = !fields.DeltaT.empty();
  this->Points.resize(points);
  ParallelFor(0, static_cast<vtkIdType>(points),
    [&](vtkIdType p)
    {
      const glm::dvec3 eye = frame.View.GetEyeCoordinates(&mesh.Points[3 * p]);
      Point& point = this->Points[p];
      point.Position = frame.View.Project(eye);
      point.Scalar = hasScalars ? fields.Scalars[p] : 0.0f;
      point.DeltaT = hasDeltaT ? fields.DeltaT[p] : 1.0f;
    });
}

TileBins::Range TileBins::GetRange(const TetrahedraFrame& frame, std::uint32_t tetrahedron) const
{
  const std::uint32_t* corners = frame.Mesh->GetCorners(tetrahedron);
  const TetrahedraView::Projected& first = this->Points[corners[0]].Position;
  double box[4] = { first.X, first.X, first.Y, first.Y };
  for (int k = 1; k < 4; ++k)
  {
    const TetrahedraView::Projected& point = this->Points[corners[k]].Position;
    box[0] = std::min(box[0], point.X);
    box[1] = std::max(box[1], point.X);
    box[2] = std::min(box[2], point.Y);
    box[3] = std::max(box[3], point.Y);
  }
  // Pixel centers are at half-integers.
  const double left = std::max(std::ceil(box[0] - 0.5), 0.0);
  const double right = std::min(std::floor(box[1] - 0.5), frame.View.GetWidth() - 1.0);
  const double bottom = std::max(std::ceil(box[2] - 0.5), 0.0);
  const double top = std::min(std::floor(box[3] - 0.5), frame.View.GetHeight() - 1.0);
  if (!(left <= right) || !(bottom <= top))
  {
    return { { 1, 0, 1, 0 } };
  }
  const auto tile = [](double pixel) { return static_cast<std::uint16_t>(pixel / SIZE); };
  return { { tile(left), tile(right), tile(bottom), tile(top) } };
}

void TileBins::FindRanges(const TetrahedraFrame& frame)
{
  this->Ranges.resize(frame.Mesh->GetNumberOfTetrahedra());
  ParallelFor(0, static_cast<vtkIdType>(this->Ranges.size()),
    [&](vtkIdType t) { this->Ranges[t] = this->GetRange(frame, static_cast<std::uint32_t>(t)); });
}

template <typename Action>
vtkIdType TileBins::VisitChunk(
  const TetrahedraFrame& frame, std::size_t chunk, const Action& action) const
{
  const std::vector<std::uint32_t>* order = frame.Order;
  const std::size_t last = std::min(GetNumber(frame), (chunk + 1) * CHUNK);
  vtkIdType drawn = 0;
  for (std::size_t i = chunk * CHUNK; i < last; ++i)
  {
    const std::uint32_t tetrahedron = order ? (*order)[i] : static_cast<std::uint32_t>(i);
    const Range& range = this->Ranges[tetrahedron];
    for (int row = range[2]; row <= range[3]; ++row)
    {
      for (int column = range[0]; column <= range[1]; ++column)
      {
        action(static_cast<std::size_t>(row) * this->Columns + column, tetrahedron);
      }
    }
    drawn += range[0] <= range[1];
  }
  return drawn;
}

std::vector<std::size_t> TileBins::CountTetrahedra(const TetrahedraFrame& frame)
{
  const std::size_t chunks = GetNumberOfChunks(frame);
  const auto tiles = static_cast<std::size_t>(this->GetNumberOfTiles());
  std::vector<std::size_t> counts(chunks * tiles, 0);
  std::vector<vtkIdType> drawn(chunks, 0);
  ParallelFor(0, static_cast<vtkIdType>(chunks), 1,
    [&](vtkIdType chunk)
    {
      std::size_t* count = &counts[chunk * tiles];
      drawn[chunk] =
        this->VisitChunk(frame, chunk, [count](std::size_t tile, std::uint32_t) { ++count[tile]; });
    });
  this->NumberDrawn = std::accumulate(drawn.begin(), drawn.end(), vtkIdType(0));
  return counts;
}

void TileBins::FindPositions(std::vector<std::size_t>& counts)
{
  const auto tiles = static_cast<std::size_t>(this->GetNumberOfTiles());
  this->Starts.assign(tiles + 1, 0);
  std::size_t sum = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile)
  {
    this->Starts[tile] = sum;
    for (std::size_t i = tile; i < counts.size(); i += tiles)
    {
      sum += std::exchange(counts[i], sum);
    }
  }
  this->Starts[tiles] = sum;
}

bool TileBins::Fill(const TetrahedraFrame& frame, const std::function<bool()>& isAborted)
{
  this->Columns = (frame.View.GetWidth() + SIZE - 1) / SIZE;
  this->Rows = (frame.View.GetHeight() + SIZE - 1) / SIZE;
  this->ProjectPoints(frame);
  if (isAborted())
  {
    return false;
  }
  this->FindRanges(frame);
  if (isAborted())
  {
    return false;
  }
  std::vector<std::size_t> positions = this->CountTetrahedra(frame);
  if (isAborted())
  {
    return false;
  }
  this->FindPositions(positions);
  this->Lists.resize(this->Starts.back());
  const auto tiles = static_cast<std::size_t>(this->GetNumberOfTiles());
  ParallelFor(0, static_cast<vtkIdType>(GetNumberOfChunks(frame)), 1,
    [&](vtkIdType chunk)
    {
      std::size_t* next = &positions[chunk * tiles];
      this->VisitChunk(frame, chunk,
        [this, next](std::size_t tile, std::uint32_t tetrahedron)
        { this->Lists[next[tile]++] = tetrahedron; });
    });
  return true;
}

std::size_t TileBins::GetBytes() const
{
  return this->Points.capacity() * sizeof(Point) + this->Ranges.capacity() * sizeof(Range) +
    this->Lists.capacity() * sizeof(std::uint32_t);
}

}
