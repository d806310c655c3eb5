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
 * @brief   lists tetrahedra front to back by depth-first search
 *
 * It finds strongly connected components (R. Tarjan, "Depth-first search and linear graph
 * algorithms", 1972, in the variant of E. Nuutila, E. Soisalon-Soininen, "On finding the strongly
 * connected components in a directed graph", 1994), in front-to-back order. A component of several
 * tetrahedra contains cycles and is sorted by centroid. The search is iterative, with a stack on
 * the heap.
 */
class VisibilitySearch
{
public:
  /**
   * Fills \a frontToBack with all tetrahedra, each after the tetrahedra in front of it, and
   * otherwise in the order of \a centroids. Returns the number of tetrahedra in cycles.
   */
  std::uint32_t ListFrontToBack(const VisibilityGraph& graph,
    const std::vector<std::uint32_t>& centroids, std::vector<std::uint32_t>& frontToBack);

  /// Returns the memory size in bytes.
  std::size_t GetBytes() const;

private:
  struct Frame
  {
    std::uint32_t Tetrahedron;
    std::uint32_t Position;
    /// Lowest entry in Numbers of the unlisted tetrahedra that are reachable from this tetrahedron.
    std::uint32_t Lowest;
  };

  void Enter(std::uint32_t tetrahedron);
  void Search(const VisibilityGraph& graph, const std::vector<std::uint32_t>& centroids,
    std::vector<std::uint32_t>& frontToBack);
  /// Lists the component that was entered at \a root.
  void Complete(std::uint32_t root, const std::vector<std::uint32_t>& centroids,
    std::vector<std::uint32_t>& frontToBack);
  void SortByCentroid(
    const std::vector<std::uint32_t>& centroids, std::uint32_t* first, std::uint32_t* last);

  /// Step, counted from 1, at which each tetrahedron was entered; 0 before that, and Listed after
  /// it was output.
  std::vector<std::uint32_t> Numbers;
  std::uint32_t LastNumber = 0;
  std::uint32_t InCycles = 0;
  std::vector<Frame> Frames;
  /// Finished tetrahedra whose component is not complete.
  std::vector<std::uint32_t> Pending;
  /// Ranks in centroid order; empty until the first cycle is found.
  std::vector<std::uint32_t> Ranks;
};

}

#endif
