// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VisibilitySearch_h
#define interlume_VisibilitySearch_h

#include "Order/VisibilityGraph.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   VisibilitySearch
 * @brief   lists tetrahedra front to back by a depth-first search
 *
 * Finds the strongly connected components (R. Tarjan, "Depth-first search and linear graph
 * algorithms", 1972, as E. Nuutila, E. Soisalon-Soininen, "On finding the strongly connected
 * components in a directed graph", 1994), which come out front to back. A component of more than
 * one tetrahedron is one cycle or several, and is listed in the order of its centroids. The search
 * is iterative: its stack is in the heap.
 */
class VisibilitySearch
{
public:
  /**
   * Fills \a frontToBack with all tetrahedra, each after those in front of it. Among the orders
   * that do so it follows \a centroids. Returns the number of tetrahedra in cycles.
   */
  std::uint32_t List(const VisibilityGraph& graph, const std::vector<std::uint32_t>& centroids,
    std::vector<std::uint32_t>& frontToBack);

  /// Returns the bytes held.
  std::size_t GetBytes() const;

private:
  struct Frame
  {
    std::uint32_t Tetrahedron;
    std::uint32_t Position;
    /// The least number of a tetrahedron that this one leads to, of those that are not listed.
    std::uint32_t Lowest;
  };

  void Enter(std::uint32_t tetrahedron);
  void Search(const VisibilityGraph& graph, const std::vector<std::uint32_t>& centroids,
    std::vector<std::uint32_t>& frontToBack);
  /// Lists a component, whose first tetrahedron is \a root.
  void Complete(std::uint32_t root, const std::vector<std::uint32_t>& centroids,
    std::vector<std::uint32_t>& frontToBack);
  void SortByCentroid(
    const std::vector<std::uint32_t>& centroids, std::uint32_t* first, std::uint32_t* last);

  /// The step at which each tetrahedron was entered, from 1 on; 0 before, Listed after.
  std::vector<std::uint32_t> Numbers;
  std::uint32_t LastNumber = 0;
  std::uint32_t InCycles = 0;
  std::vector<Frame> Frames;
  /// The tetrahedra left whose component is not complete.
  std::vector<std::uint32_t> Pending;
  /// The positions in the order of centroids; empty until there is a cycle.
  std::vector<std::uint32_t> Ranks;
};

}

#endif
