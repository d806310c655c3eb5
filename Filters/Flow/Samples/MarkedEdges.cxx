// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/MarkedEdges.h"

#include "Cells/MultilinearCell.h"
#include "Common/Vectors.h"

#include "vtkPoints.h"

#include <algorithm>
#include <numeric>

namespace interlume
{

void MarkedEdges::Build(std::vector<Edge> edges, vtkPoints* points)
{
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  this->Edges = std::move(edges);

  this->Starts.assign(static_cast<std::size_t>(points->GetNumberOfPoints()) + 1, 0);
  double bounds[6];
  points->GetBounds(bounds);
  const double scale = MultilinearCell::GetScale(
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }));
  std::vector<double> lengths;
  lengths.reserve(this->Edges.size());
  for (const Edge& edge : this->Edges)
  {
    ++this->Starts[static_cast<std::size_t>(edge[0]) + 1];
    double a[3];
    double b[3];
    points->GetPoint(edge[0], a);
    points->GetPoint(edge[1], b);
    // Scaling avoids overflow and underflow of squares. A NaN length becomes 0 because it would
    // violate the strict weak ordering of the sort below.
    const glm::dvec3 offset = scale * Vectors::Difference(b, a);
    const double length = glm::dot(offset, offset);
    lengths.push_back(length > 0.0 ? length : 0.0);
  }
  std::partial_sum(this->Starts.begin(), this->Starts.end(), this->Starts.begin());

  std::vector<std::size_t> order(this->Edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&lengths](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
  this->Ranks.resize(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank)
  {
    this->Ranks[order[rank]] = static_cast<vtkIdType>(rank);
  }
}

vtkIdType MarkedEdges::Find(vtkIdType a, vtkIdType b) const
{
  const Edge edge = Make(a, b);
  if (static_cast<std::size_t>(edge[1]) + 1 >= this->Starts.size())
  {
    return -1;
  }
  const auto index = static_cast<std::size_t>(edge[0]);
  const auto first = this->Edges.begin() + this->Starts[index];
  const auto last = this->Edges.begin() + this->Starts[index + 1];
  const auto found = std::lower_bound(first, last, edge);
  return found != last && *found == edge ? found - this->Edges.begin() : -1;
}

}
