// SPDX-License-Identifier: BSD-3-Clause
#include "Shells/CollapsedPoints.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace interlume
{

namespace
{
using Position = std::array<double, 3>;

/// Returns the lowest id of the points at the position of each point, or an empty list if all
/// positions are distinct.
std::vector<vtkIdType> FindCoincident(vtkDataSet* input)
{
  const vtkIdType number = input->GetNumberOfPoints();
  std::vector<Position> x(static_cast<std::size_t>(number));
  std::vector<vtkIdType> order(x.size());
  std::iota(order.begin(), order.end(), 0);
  for (vtkIdType p = 0; p < number; ++p)
  {
    input->GetPoint(p, x[p].data());
  }
  std::sort(order.begin(), order.end(),
    [&x](vtkIdType a, vtkIdType b) { return x[a] < x[b] || (x[a] == x[b] && a < b); });
  std::vector<vtkIdType> first(x.size());
  bool isDistinct = true;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isSame = i > 0 && x[order[i]] == x[order[i - 1]];
    first[order[i]] = isSame ? first[order[i - 1]] : order[i];
    isDistinct = isDistinct && !isSame;
  }
  return isDistinct ? std::vector<vtkIdType>() : first;
}

vtkIdType FindRoot(std::vector<vtkIdType>& parents, vtkIdType point)
{
  while (parents[point] != point)
  {
    parents[point] = parents[parents[point]];
    point = parents[point];
  }
  return point;
}
}

std::vector<vtkIdType> CollapsedPoints::Find(vtkDataSet* input, const std::vector<vtkIdType>& cells,
  const FaceTriangulation::Order& isBefore, vtkIdType& number)
{
  // Images and rectilinear grids have distinct points.
  const std::vector<vtkIdType> first =
    input->IsA("vtkPointSet") ? FindCoincident(input) : std::vector<vtkIdType>();
  if (first.empty())
  {
    return {};
  }
  std::vector<vtkIdType> parents(first.size());
  std::iota(parents.begin(), parents.end(), 0);
  vtkNew<vtkIdList> ids;
  std::vector<vtkIdType> points;
  const auto isValid = [&first](vtkIdType p)
  { return p >= 0 && p < static_cast<vtkIdType>(first.size()); };
  for (vtkIdType cell : cells)
  {
    input->GetCellPoints(cell, ids);
    points.assign(ids->begin(), ids->end());
    if (!std::all_of(points.begin(), points.end(), isValid))
    {
      continue; // an error that CellShell reports
    }
    std::sort(points.begin(), points.end(),
      [&first](vtkIdType a, vtkIdType b) { return first[a] < first[b]; });
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      vtkIdType a = FindRoot(parents, points[i - 1]);
      vtkIdType b = FindRoot(parents, points[i]);
      if (first[points[i]] == first[points[i - 1]] && a != b)
      {
        if (isBefore(b, a))
        {
          std::swap(a, b);
        }
        parents[b] = a;
        ++number;
      }
    }
  }
  if (number == 0)
  {
    return {};
  }
  for (std::size_t p = 0; p < parents.size(); ++p)
  {
    parents[p] = FindRoot(parents, static_cast<vtkIdType>(p));
  }
  return parents;
}

}
