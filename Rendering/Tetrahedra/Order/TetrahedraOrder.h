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
 * @brief   the order a picture is drawn in, kept while the view is the same
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
   * Forgets everything: the mesh is another one.
   */
  void Reset();

  /**
   * Forgets an order by layers: others are in them.
   */
  void ResetLayers();

  /**
   * Returns the order from front to back, or null for none. WasComputed() returns false where the
   * order is that of the call before.
   */
  const std::vector<std::uint32_t>* Compute(
    Kinds kind, const TetrahedraMesh& mesh, const TetrahedraView& view);

  /**
   * Returns the order by layers, the highest priority first; within one, as they are.
   */
  const std::vector<std::uint32_t>* ComputeLayers(
    const std::vector<int>& layers, const std::map<int, double>& priorities);

  /// Sorts the names of layers, the highest priority first.
  static void SortLayers(std::vector<int>& layers, const std::map<int, double>& priorities);

  bool WasComputed() const { return this->Computed; }
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /// Return the counts of the last order of visibility.
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
  /// The order of visibility, made when it is first asked for, kept until another order is.
  std::unique_ptr<VisibilityOrder> Visibility;
};

}

#endif
