// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/PixelBuckets.h"

#include <algorithm>
#include <cmath>

namespace reference
{

namespace
{

/// Pixels from Low to High, inclusive. Empty if Low is above High.
struct PixelBox
{
  std::array<int, 2> Low;
  std::array<int, 2> High;
};

/// Returns the corners of a tetrahedron at or beyond the plane at \a depth, and the intersections
/// of its edges with this plane.
std::vector<Vector> PointsInFront(
  const std::array<Vector, 4>& corners, const PixelRays& rays, Real depth)
{
  std::vector<Vector> points;
  for (int i = 0; i < 4; ++i)
  {
    const Real here = rays.GetDepth(corners[i]) - depth;
    if (here >= 0)
    {
      points.push_back(corners[i]);
    }
    for (int j = 0; j < i; ++j)
    {
      const Real there = rays.GetDepth(corners[j]) - depth;
      if ((here < 0) != (there < 0))
      {
        const Real fraction = here / (here - there);
        Vector point;
        for (int k = 0; k < 3; ++k)
        {
          point[k] = corners[i][k] + fraction * (corners[j][k] - corners[i][k]);
        }
        points.push_back(point);
      }
    }
  }
  return points;
}

PixelBox FindBox(
  const RayTetrahedron& tetrahedron, const PixelRays& rays, const std::array<int, 2>& size)
{
  PixelBox box = { size, { -1, -1 } };
  if (!tetrahedron.IsValid())
  {
    return box;
  }
  for (const Vector& point : PointsInFront(tetrahedron.GetCorners(), rays, rays.GetNear()))
  {
    if (const auto pixel = rays.Project(point))
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        const double inside = std::clamp((*pixel)[axis], -2.0, size[axis] + 2.0);
        box.Low[axis] = std::min(box.Low[axis], static_cast<int>(std::floor(inside)) - 1);
        box.High[axis] = std::max(box.High[axis], static_cast<int>(std::floor(inside)) + 1);
      }
    }
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    box.Low[axis] = std::max(box.Low[axis], 0);
    box.High[axis] = std::min(box.High[axis], size[axis] - 1);
  }
  return box;
}

template <typename Visit>
void ForEachPixel(const PixelBox& box, int width, const Visit& visit)
{
  for (int j = box.Low[1]; j <= box.High[1]; ++j)
  {
    for (int i = box.Low[0]; i <= box.High[0]; ++i)
    {
      visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
        static_cast<std::size_t>(i));
    }
  }
}

}

PixelBuckets::PixelBuckets(const std::vector<RayTetrahedron>& tetrahedra, const PixelRays& rays,
  const std::array<int, 2>& size)
  : First(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) + 1, 0)
{
  std::vector<PixelBox> boxes;
  boxes.reserve(tetrahedra.size());
  for (const RayTetrahedron& tetrahedron : tetrahedra)
  {
    boxes.push_back(FindBox(tetrahedron, rays, size));
    ForEachPixel(boxes.back(), size[0], [this](std::size_t pixel) { ++this->First[pixel + 1]; });
  }
  for (std::size_t pixel = 1; pixel < this->First.size(); ++pixel)
  {
    this->First[pixel] += this->First[pixel - 1];
  }
  this->Ids.resize(this->First.back());
  std::vector<std::size_t> next(this->First.begin(), this->First.end() - 1);
  for (std::size_t id = 0; id < boxes.size(); ++id)
  {
    ForEachPixel(boxes[id], size[0],
      [&](std::size_t pixel) { this->Ids[next[pixel]++] = static_cast<std::uint32_t>(id); });
  }
}

}
