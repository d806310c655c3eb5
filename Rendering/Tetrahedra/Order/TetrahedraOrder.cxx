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

const std::vector<std::uint32_t>* TetrahedraOrder::Compute(
  Kinds kind, const TetrahedraMesh& mesh, const TetrahedraView& view)
{
  this->Computed = false;
  if (kind == NONE)
  {
    this->Reset();
    return nullptr;
  }
  if (kind == this->Kind && view == this->View)
  {
    return &this->Order;
  }
  this->Computed = true;
  this->Kind = kind;
  this->View = view;
  if (kind == CENTROID)
  {
    this->Visibility.reset();
    this->Centroid.Compute(mesh, view.GetRays().Viewpoint, this->Order);
    return &this->Order;
  }
  if (!this->Visibility)
  {
    this->Visibility = std::make_unique<VisibilityOrder>();
    this->Visibility->Build(mesh);
  }
  this->Visibility->Compute(mesh, view.GetRays(), this->Order);
  return &this->Order;
}

const std::vector<std::uint32_t>* TetrahedraOrder::ComputeLayerOrder(
  const std::vector<int>& layers, const std::map<int, double>& priorities)
{
  this->Computed = false;
  if (this->Kind == LAYERS && priorities == this->Priorities)
  {
    return &this->Order;
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
  return &this->Order;
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
