// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CycleOrder_h
#define interlume_CycleOrder_h

#include "Order/VisibilityGraph.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   CycleOrder
 * @brief   front to back where tetrahedra hide one another in a cycle
 *
 * Finds the strongly connected components (R. Tarjan, "Depth-first search and linear graph
 * algorithms", 1972), which come out front to back; each of more than one tetrahedron is a cycle or
 * several, and is put out in the order of its centroids. The search is iterative: its stack is in
 * the heap.
 */
class CycleOrder
{
public:
  /**
   * Appends to \a frontToBack all tetrahedra that are not in it yet, as \a isDone says on entry;
   * whatever is in front of a tetrahedron that is in it has to be in it too. Returns how many are
   * in cycles.
   */
  std::uint32_t Append(const VisibilityGraph& graph, const std::vector<std::uint32_t>& centroids,
    std::vector<unsigned char>& isDone, std::vector<std::uint32_t>& frontToBack);

private:
  struct Frame
  {
    std::uint32_t Tetrahedron;
    std::uint32_t Position;
  };

  void Enter(std::uint32_t tetrahedron);
  void Search(const VisibilityGraph& graph, std::vector<unsigned char>& isDone,
    std::vector<std::uint32_t>& frontToBack);
  void SortByCentroid(std::uint32_t* first, std::uint32_t* last);

  const std::vector<std::uint32_t>* Centroids = nullptr;
  // The time at which each was entered, from 1 on, and the least such time that it leads to.
  std::vector<std::uint32_t> Numbers;
  std::vector<std::uint32_t> Lowest;
  std::uint32_t LastNumber = 0;
  std::uint32_t InCycles = 0;
  std::vector<Frame> Frames;
  // The tetrahedra entered whose component is not complete.
  std::vector<std::uint32_t> Pending;
  // The places in the order of centroids, once they are needed.
  std::vector<std::uint32_t> Ranks;
};

}

#endif
