// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraOrder_h
#define interlume_TetrahedraOrder_h

#include "Mesh/TetrahedraMesh.h"
#include "Order/CentroidOrder.h"
#include "Order/VisibilityOrder.h"
#include "View/TetrahedraView.h"

#include <cstdint>
#include <functional>
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
   * Computes the order, front to back. WasComputed() then returns false if the order was cached.
   * Returns false, without an order, if \a isAborted returned true. It is called between stages.
   */
  bool Compute(Kinds kind, const TetrahedraMesh& mesh, const TetrahedraView& view,
    const std::function<bool()>& isAborted = nullptr);

  /**
   * Sorts the tetrahedra by descending priority of their layers. Within a layer, tetrahedra are
   * in mesh order.
   */
  void ComputeLayerOrder(const std::vector<int>& layers, const std::map<int, double>& priorities);

  /// Returns the order, or null for NONE.
  const std::vector<std::uint32_t>* Get() const
  {
    return this->Kind == NONE ? nullptr : &this->Order;
  }

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
  /// Fills Order. Returns false if the computation was aborted.
  bool Sort(const TetrahedraMesh& mesh, const std::function<bool()>& isAborted);

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
