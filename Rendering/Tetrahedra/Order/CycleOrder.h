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
 * several, and is put out in the order of its centroids. Iterative: its stack is in the heap.
 */
class CycleOrder
{
public:
  /**
   * Appends to \a frontToBack all tetrahedra that are not in it yet: as \a isDone says on entry. Of
   * those, whatever is in front of one that is in it is so too. Returns how many are in cycles.
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
  // When each was entered, from 1 on, and the least such number that it leads to.
  std::vector<std::uint32_t> Numbers;
  std::vector<std::uint32_t> Lowest;
  std::uint32_t LastNumber = 0;
  std::uint32_t InCycles = 0;
  std::vector<Frame> Frames;
  // Those entered whose component is not complete.
  std::vector<std::uint32_t> Pending;
  // Places in the order of centroids, once they are needed.
  std::vector<std::uint32_t> Ranks;
};

}

#endif
