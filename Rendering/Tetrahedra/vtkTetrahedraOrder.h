#ifndef vtkTetrahedraOrder_h
#define vtkTetrahedraOrder_h

#include "vtkCentroidOrder.h"
#include "vtkTetrahedraMesh.h"
#include "vtkTetrahedraView.h"
#include "vtkVisibilityOrder.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

/**
 * @class   vtkTetrahedraOrder
 * @brief   the order a picture is drawn in, kept while the view is the same
 */
class vtkTetrahedraOrder
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
   * The order from front to back, or null for none. Returns false from WasComputed() where it is
   * that of the call before.
   */
  const std::vector<std::uint32_t>* Compute(
    Kinds kind, const vtkTetrahedraMesh& mesh, const vtkTetrahedraView& view);

  /**
   * The order by layers, the highest priority first; within one, as they are.
   */
  const std::vector<std::uint32_t>* ComputeLayers(
    const std::vector<int>& layers, const std::map<int, double>& priorities);

  bool WasComputed() const { return this->Computed; }
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /// Of the last order of visibility.
  vtkIdType GetCycles() const;
  vtkIdType GetGaps() const;
  bool HasAdjacency() const { return this->Visibility != nullptr; }
  std::size_t GetBytes() const;

private:
  Kinds Kind = NONE;
  bool Computed = false;
  vtkTetrahedraView View;
  std::map<int, double> Priorities;
  int NumberOfLayers = 0;
  std::vector<std::uint32_t> Order;
  vtkCentroidOrder Centroid;
  /// Made when it is first asked for.
  std::unique_ptr<vtkVisibilityOrder> Visibility;
};

#endif
