// SPDX-License-Identifier: BSD-3-Clause
#include "Convolution/SurfaceRefinement.h"

#include "Common/Vectors.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace interlume
{

namespace
{
using Triangle = std::array<vtkIdType, 3>;

/// Maximum number of passes, each of which halves long edges.
constexpr int MaximumPasses = 30;

Triangle GetTriangle(vtkPolyData* surface, vtkIdType cell)
{
  vtkIdType number = 0;
  const vtkIdType* points = nullptr;
  surface->GetPolys()->GetCellAtId(cell, number, points);
  return { { points[0], points[1], points[2] } };
}

double GetEdgeLength(vtkPoints* points, vtkIdType a, vtkIdType b)
{
  double ends[2][3];
  points->GetPoint(a, ends[0]);
  points->GetPoint(b, ends[1]);
  return Vectors::SafeLength(Vectors::Difference(ends[0], ends[1]));
}

/// Longest edge of a triangle, and the ratio of its area to the square of that edge.
struct Size
{
  double Length = 0.0;
  double Area = 0.0;
};

Size Measure(vtkPoints* points, const Triangle& triangle)
{
  double corners[3][3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    points->GetPoint(triangle[i], corners[i]);
  }
  Size size;
  for (std::size_t i = 0; i < 3; ++i)
  {
    size.Length = std::max(
      size.Length, Vectors::SafeLength(Vectors::Difference(corners[(i + 1) % 3], corners[i])));
  }
  if (size.Length > 0.0)
  {
    size.Area = 0.5 *
      glm::length(glm::cross(Vectors::Difference(corners[1], corners[0]) / size.Length,
        Vectors::Difference(corners[2], corners[0]) / size.Length));
  }
  return size;
}

/// Estimates the number of triangles that divide those with edges above \a length. If edges are
/// halved k times, a right triangle with equal legs, whose area ratio is 1/4, becomes 4^k
/// triangles, and a triangle without area becomes 2^k.
double EstimateNumber(const std::vector<Size>& sizes, double length)
{
  double number = 0.0;
  for (const Size& size : sizes)
  {
    if (size.Length > length)
    {
      const double parts = std::exp2(std::ceil(std::log2(size.Length / length)));
      number += parts + std::min(4.0 * size.Area, 1.0) * parts * parts;
    }
  }
  return number;
}

/// Midpoints of the edges that are longer than a limit.
class Midpoints
{
public:
  Midpoints(vtkPoints* points, vtkPointData* data, double length)
    : Points(points)
    , Data(data)
    , Length(length)
  {
  }

  /// Adds the midpoint of an edge if the edge is too long. The lower id comes first, so that the
  /// midpoint does not depend on the triangle.
  void Add(vtkIdType a, vtkIdType b)
  {
    const Edge edge(std::min(a, b), std::max(a, b));
    const double length = GetEdgeLength(this->Points, a, b);
    if (length > this->Length && std::isfinite(length) &&
      this->Ids.emplace(edge, this->Points->GetNumberOfPoints()).second)
    {
      double first[3];
      double second[3];
      this->Points->GetPoint(edge.first, first);
      this->Points->GetPoint(edge.second, second);
      const vtkIdType id = this->Points->InsertNextPoint(0.5 * first[0] + 0.5 * second[0],
        0.5 * first[1] + 0.5 * second[1], 0.5 * first[2] + 0.5 * second[2]);
      for (int i = 0; i < this->Data->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* array = this->Data->GetAbstractArray(i);
        array->InterpolateTuple(id, edge.first, array, edge.second, array, 0.5);
      }
    }
  }
  bool IsEmpty() const { return this->Ids.empty(); }
  /// Returns the midpoint of an edge, or -1 if the edge remains.
  vtkIdType Find(vtkIdType a, vtkIdType b) const
  {
    const auto found = this->Ids.find({ std::min(a, b), std::max(a, b) });
    return found == this->Ids.end() ? -1 : found->second;
  }

private:
  using Edge = std::pair<vtkIdType, vtkIdType>;
  struct Hash
  {
    std::size_t operator()(const Edge& edge) const
    {
      return static_cast<std::size_t>(edge.first) * 0x9e3779b97f4a7c15u +
        static_cast<std::size_t>(edge.second);
    }
  };

  vtkPoints* Points;
  vtkPointData* Data;
  double Length;
  std::unordered_map<Edge, vtkIdType, Hash> Ids;
};

/// Calls \a visit for each part of a triangle.
template <typename Visit>
void Cut(const Triangle& triangle, const Midpoints& midpoints, const Visit& visit)
{
  Triangle cuts;
  for (std::size_t i = 0; i < 3; ++i)
  {
    cuts[i] = midpoints.Find(triangle[i], triangle[(i + 1) % 3]);
  }
  const auto number = std::count_if(cuts.begin(), cuts.end(), [](vtkIdType id) { return id >= 0; });
  // Start at a corner so that the first edge is cut and, of two cuts, the last edge is not.
  std::size_t first = 0;
  while (number > 0 && !(cuts[first] >= 0 && (number != 2 || cuts[(first + 2) % 3] < 0)))
  {
    ++first;
  }
  std::rotate(cuts.begin(), cuts.begin() + first, cuts.end());
  Triangle p = triangle;
  std::rotate(p.begin(), p.begin() + first, p.end());
  switch (number)
  {
    case 0:
      visit(p);
      break;
    case 1:
      visit({ { p[0], cuts[0], p[2] } });
      visit({ { cuts[0], p[1], p[2] } });
      break;
    case 2:
      visit({ { cuts[0], p[1], cuts[1] } });
      visit({ { p[0], cuts[0], cuts[1] } });
      visit({ { p[0], cuts[1], p[2] } });
      break;
    default:
      for (std::size_t i = 0; i < 3; ++i)
      {
        visit({ { p[i], cuts[i], cuts[(i + 2) % 3] } });
      }
      visit(cuts);
  }
}

/// Part of a triangle of the input.
struct Part
{
  Triangle Corners;
  vtkIdType Cell;
};
using Parts = std::vector<Part>;

/// Cuts all triangles with long edges at the midpoints of these edges. Returns false if there are
/// none.
bool CutOnce(vtkPoints* points, vtkPointData* data, double length, Parts& parts)
{
  Midpoints midpoints(points, data, length);
  for (const Part& part : parts)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      midpoints.Add(part.Corners[i], part.Corners[(i + 1) % 3]);
    }
  }
  if (midpoints.IsEmpty())
  {
    return false;
  }
  Parts smaller;
  for (const Part& part : parts)
  {
    Cut(part.Corners, midpoints,
      [&](const Triangle& corners) {
        smaller.push_back({ corners, part.Cell });
      });
  }
  parts = std::move(smaller);
  return true;
}
}

SurfaceRefinement::SurfaceRefinement(vtkDataSet* surface)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputDataObject(surface);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  this->Triangles = filter->GetOutput();
}

double SurfaceRefinement::FindLength(double length, vtkIdType maximumTriangles) const
{
  constexpr double smallestGrowth = 1.02;
  constexpr double largestExcess = 1e12;
  std::vector<Size> sizes;
  for (vtkIdType cell = 0; cell < this->Triangles->GetNumberOfPolys(); ++cell)
  {
    const Size size = Measure(this->Triangles->GetPoints(), GetTriangle(this->Triangles, cell));
    if (std::isfinite(size.Length))
    {
      sizes.push_back(size);
    }
  }
  const auto getExcess = [&](double limit)
  { return EstimateNumber(sizes, limit) / static_cast<double>(maximumTriangles); };
  for (double excess = getExcess(length); excess > 1.0; excess = getExcess(length))
  {
    length *= std::max(smallestGrowth, std::pow(std::min(excess, largestExcess), 0.25));
  }
  return length;
}

vtkSmartPointer<vtkPolyData> SurfaceRefinement::Divide(double length) const
{
  vtkNew<vtkPoints> points;
  points->DeepCopy(this->Triangles->GetPoints());
  auto refined = vtkSmartPointer<vtkPolyData>::New();
  vtkPointData* data = refined->GetPointData();
  data->InterpolateAllocate(this->Triangles->GetPointData(), points->GetNumberOfPoints());
  data->CopyData(this->Triangles->GetPointData(), 0, points->GetNumberOfPoints(), 0);
  Parts parts;
  for (vtkIdType cell = 0; cell < this->Triangles->GetNumberOfPolys(); ++cell)
  {
    parts.push_back({ GetTriangle(this->Triangles, cell), cell });
  }
  bool isCut = true;
  for (int pass = 0; isCut && pass < MaximumPasses; ++pass)
  {
    isCut = CutOnce(points, data, length, parts);
  }
  vtkNew<vtkCellArray> cells;
  vtkCellData* cellData = refined->GetCellData();
  cellData->CopyAllocate(this->Triangles->GetCellData(), static_cast<vtkIdType>(parts.size()));
  for (const Part& part : parts)
  {
    const vtkIdType cell = cells->InsertNextCell(3, part.Corners.data());
    cellData->CopyData(this->Triangles->GetCellData(), part.Cell, cell);
  }
  refined->SetPoints(points);
  refined->SetPolys(cells);
  refined->GetFieldData()->PassData(this->Triangles->GetFieldData());
  return refined;
}

}
