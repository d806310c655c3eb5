// SPDX-License-Identifier: BSD-3-Clause
#include "Order/TetrahedraOrder.h"

#include <algorithm>

namespace interlume
{

void TetrahedraOrder::Reset()
{
  this->Kind = NONE;
  this->Order.clear();
  this->Visibility.reset();
}

void TetrahedraOrder::ResetLayers()
{
  this->Kind = this->Kind == LAYERS ? NONE : this->Kind;
}

bool TetrahedraOrder::Compute(Kinds kind, const TetrahedraMesh& mesh, const TetrahedraView& view,
  const std::function<bool()>& isAborted)
{
  this->Computed = false;
  if (kind == NONE)
  {
    this->Reset();
    return true;
  }
  if (kind == this->Kind && view == this->View)
  {
    return true;
  }
  this->Computed = true;
  this->Kind = kind;
  this->View = view;
  if (!this->Sort(mesh, isAborted))
  {
    this->Kind = NONE;
    return false;
  }
  return true;
}

bool TetrahedraOrder::Sort(const TetrahedraMesh& mesh, const std::function<bool()>& isAborted)
{
  const ViewRays& rays = this->View.GetRays();
  if (this->Kind == CENTROID)
  {
    this->Visibility.reset();
    return this->Centroid.Compute(mesh, rays.Viewpoint, this->Order, isAborted);
  }
  if (!this->Visibility)
  {
    this->Visibility = std::make_unique<VisibilityOrder>();
    this->Visibility->Build(mesh);
  }
  return this->Visibility->Compute(mesh, rays, this->Order, isAborted);
}

void TetrahedraOrder::ComputeLayerOrder(
  const std::vector<int>& layers, const std::map<int, double>& priorities)
{
  this->Computed = false;
  if (this->Kind == LAYERS && priorities == this->Priorities)
  {
    return;
  }
  this->Computed = true;
  this->Kind = LAYERS;
  this->Visibility.reset();
  this->Priorities = priorities;
  // Collect the members of each layer, then concatenate the layers by descending priority.
  std::map<int, std::vector<std::uint32_t>> members;
  for (std::size_t t = 0; t < layers.size(); ++t)
  {
    members[layers[t]].push_back(static_cast<std::uint32_t>(t));
  }
  std::vector<int> layerIds;
  layerIds.reserve(members.size());
  for (const auto& layer : members)
  {
    layerIds.push_back(layer.first);
  }
  SortLayers(layerIds, priorities);
  this->Order.clear();
  for (int layerId : layerIds)
  {
    this->Order.insert(this->Order.end(), members[layerId].begin(), members[layerId].end());
  }
  this->NumberOfLayers = static_cast<int>(layerIds.size());
}

void TetrahedraOrder::SortLayers(std::vector<int>& layers, const std::map<int, double>& priorities)
{
  const auto priority = [&priorities](int layer)
  {
    const auto found = priorities.find(layer);
    return found == priorities.end() ? static_cast<double>(layer) : found->second;
  };
  std::sort(layers.begin(), layers.end(),
    [&priority](int a, int b)
    {
      const double first = priority(a);
      const double second = priority(b);
      return first != second ? first > second : a > b;
    });
}

vtkIdType TetrahedraOrder::GetCycles() const
{
  return this->Visibility ? this->Visibility->GetNumberOfTetrahedraInCycles() : 0;
}

vtkIdType TetrahedraOrder::GetGaps() const
{
  return this->Visibility ? this->Visibility->GetNumberOfGapRelations() : 0;
}

std::size_t TetrahedraOrder::GetBytes() const
{
  return this->Order.capacity() * sizeof(std::uint32_t) + this->Centroid.GetBytes() +
    (this->Visibility ? this->Visibility->GetBytes() : 0);
}

}
