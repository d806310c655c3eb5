// SPDX-License-Identifier: BSD-3-Clause
#include "Software/TileBins.h"

#include "Common/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
/// Number of tetrahedra per task. It is fixed, so that lists do not depend on the number of
/// threads.
constexpr std::size_t CHUNK = 1 << 16;
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

void TileBins::Fill(const TetrahedraFrame& frame)
{
  this->Columns = (frame.View.GetWidth() + SIZE - 1) / SIZE;
  this->Rows = (frame.View.GetHeight() + SIZE - 1) / SIZE;
  this->ProjectPoints(frame);
  const std::size_t all = frame.Mesh->GetNumberOfTetrahedra();
  this->Ranges.resize(all);
  ParallelFor(0, static_cast<vtkIdType>(all),
    [&](vtkIdType t) { this->Ranges[t] = this->GetRange(frame, static_cast<std::uint32_t>(t)); });

  const std::vector<std::uint32_t>* order = frame.Order;
  const std::size_t number = order ? order->size() : all;
  const std::size_t chunks = (number + CHUNK - 1) / CHUNK;
  const auto tiles = static_cast<std::size_t>(this->GetNumberOfTiles());
  // counts[chunk * tiles + tile] is first the number of the chunk's tetrahedra in the tile, and
  // later the position in Lists of the next one.
  std::vector<std::size_t> counts(chunks * tiles, 0);
  std::vector<vtkIdType> drawn(chunks, 0);
  const auto visit = [&](std::size_t chunk, auto&& action)
  {
    const std::size_t last = std::min(number, (chunk + 1) * CHUNK);
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
      drawn[chunk] += range[0] <= range[1];
    }
  };
  ParallelFor(0, static_cast<vtkIdType>(chunks), 1,
    [&](vtkIdType chunk)
    {
      std::size_t* count = &counts[chunk * tiles];
      visit(chunk, [count](std::size_t tile, std::uint32_t) { ++count[tile]; });
    });
  this->NumberDrawn = 0;
  for (vtkIdType& chunkCount : drawn)
  {
    this->NumberDrawn += chunkCount;
    chunkCount = 0;
  }
  this->Starts.assign(tiles + 1, 0);
  std::size_t sum = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile)
  {
    this->Starts[tile] = sum;
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    {
      std::size_t& count = counts[chunk * tiles + tile];
      sum += count;
      count = sum - count;
    }
  }
  this->Starts[tiles] = sum;
  this->Lists.resize(sum);
  ParallelFor(0, static_cast<vtkIdType>(chunks), 1,
    [&](vtkIdType chunk)
    {
      std::size_t* next = &counts[chunk * tiles];
      visit(chunk,
        [this, next](std::size_t tile, std::uint32_t tetrahedron)
        { this->Lists[next[tile]++] = tetrahedron; });
    });
}

std::size_t TileBins::GetBytes() const
{
  return this->Points.capacity() * sizeof(Point) + this->Ranges.capacity() * sizeof(Range) +
    this->Lists.capacity() * sizeof(std::uint32_t);
}

}
