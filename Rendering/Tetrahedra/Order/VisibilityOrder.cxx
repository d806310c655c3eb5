// SPDX-License-Identifier: BSD-3-Clause
#include "Order/VisibilityOrder.h"

#include "Order/FaceAdjacency.h"

namespace interlume
{

bool VisibilityOrder::Build(const TetrahedraMesh& mesh)
{
  this->Twins = FaceAdjacency::FindTwins(mesh);
  if (this->Twins.size() != mesh.Corners.size())
  {
    return false;
  }
  this->Sides.Build(mesh, this->Twins);
  return true;
}

bool VisibilityOrder::Compute(const TetrahedraMesh& mesh, const ViewRays& rays,
  std::vector<std::uint32_t>& frontToBack, const std::function<bool()>& isAborted)
{
  const auto stops = [&isAborted]() { return isAborted && isAborted(); };
  if (stops() || !this->Centroid.Compute(mesh, rays.Viewpoint, this->Centroids, isAborted))
  {
    return false;
  }
  this->Sides.Compute(mesh, rays.Viewpoint, this->InFront);
  if (stops())
  {
    return false;
  }
  this->Gaps.Compute(mesh, this->Sides, rays);
  if (stops())
  {
    return false;
  }
  VisibilityGraph graph;
  graph.InFront = this->InFront.data();
  graph.Twins = this->Twins.data();
  if (this->Gaps.GetNumberOfRelations() > 0)
  {
    graph.GapOffsets = this->Gaps.GetOffsets().data();
    graph.Gaps = this->Gaps.GetInFront().data();
  }
  this->InCycles = this->Search.ListFrontToBack(graph, this->Centroids, frontToBack);
  return true;
}

std::size_t VisibilityOrder::GetBytes() const
{
  return this->Sides.GetBytes() + this->Centroid.GetBytes() + this->Gaps.GetBytes() +
    this->Search.GetBytes() + this->InFront.capacity() +
    (this->Twins.capacity() + this->Centroids.capacity()) * sizeof(std::uint32_t);
}

}
