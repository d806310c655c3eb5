// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ViewRayEvents_h
#define interlume_ViewRayEvents_h

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   ViewRayEvents
 * @brief   the points at which a view ray enters and exits a mesh
 */
class ViewRayEvents
{
public:
  struct Event
  {
    double Depth;
    /// The face that the ray crosses. Events with equal depths are sorted by face.
    std::uint32_t Face;
    bool IsEntry;

    bool operator<(const Event& other) const
    {
      return this->Depth != other.Depth ? this->Depth < other.Depth : this->Face < other.Face;
    }
  };
  /// Two tetrahedra, one in front of the other.
  struct Relation
  {
    std::uint32_t Back;
    std::uint32_t Front;

    bool operator<(const Relation& other) const
    {
      return this->Back != other.Back ? this->Back < other.Back : this->Front < other.Front;
    }
    bool operator==(const Relation& other) const
    {
      return this->Back == other.Back && this->Front == other.Front;
    }
  };

  /**
   * Sorts the events of a view ray and appends a relation from each exit to the next entry. Events
   * whose depths differ by at most \a tolerance may be swapped so that entries and exits alternate.
   * Ray segments in the mesh that are at most \a tolerance long are ignored, because they occur
   * where the ray touches an edge or a corner. The ray starts inside the mesh if there are more
   * exits than entries.
   */
  static void Relate(Event* first, Event* last, double tolerance, std::vector<Relation>& relations);
};

}

#endif
