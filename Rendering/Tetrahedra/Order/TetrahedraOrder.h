// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraOrder_h
#define interlume_TetrahedraOrder_h

#include "Mesh/TetrahedraMesh.h"
#include "Order/CentroidOrder.h"
#include "Order/VisibilityOrder.h"
#include "View/TetrahedraView.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace interlume
{

/**
 * @class   TetrahedraOrder
 * @brief computes and caches the drawing order of tetrahedra
 */
class TetrahedraOrder
{
public:
  enum Kinds
  {
    NONE,
    CENTROID,
    VISIBILITY,
    LAYERS
  };

  /**
   * Clears all cached data. Call it when the mesh changes.
   */
  void Reset();

  /**
   * Clears the layer order. Call it when the layers change.
   */
  void ResetLayers();

  /**
   * Returns the order, front to back, or null for NONE. WasComputed() then returns false if the
   * order was cached.
   */
  const std::vector<std::uint32_t>* Compute(
    Kinds kind, const TetrahedraMesh& mesh, const TetrahedraView& view);

  /**
   * Returns the tetrahedra by descending priority of their layers. Within a layer, tetrahedra are
   * in mesh order.
   */
  const std::vector<std::uint32_t>* ComputeLayerOrder(
    const std::vector<int>& layers, const std::map<int, double>& priorities);

  /// Sorts layers by descending priority.
  static void SortLayers(std::vector<int>& layers, const std::map<int, double>& priorities);

  bool WasComputed() const { return this->Computed; }
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /// Return the number of tetrahedra in cycles and the number of relations across gaps in the last
  /// visibility order.
  vtkIdType GetCycles() const;
  vtkIdType GetGaps() const;
  bool HasAdjacency() const { return this->Visibility != nullptr; }
  std::size_t GetBytes() const;

private:
  Kinds Kind = NONE;
  bool Computed = false;
  TetrahedraView View;
  std::map<int, double> Priorities;
  int NumberOfLayers = 0;
  std::vector<std::uint32_t> Order;
  CentroidOrder Centroid;
  /// Visibility order; created on demand, and freed when another order is computed.
  std::unique_ptr<VisibilityOrder> Visibility;
};

}

#endif
