// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Sightline_h
#define interlume_Sightline_h

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   Sightline
 * @brief   the places where one line of sight enters and leaves a mesh
 */
class Sightline
{
public:
  struct Event
  {
    double Depth;
    /// The face, which breaks ties.
    std::uint32_t Face;
    bool IsEntry;

    bool operator<(const Event& other) const
    {
      return this->Depth != other.Depth ? this->Depth < other.Depth : this->Face < other.Face;
    }
  };
  /// A tetrahedron that is in front of another.
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
   * Sorts the events of a line of sight and appends a relation from each exit to the next entry.
   * Depths that differ by no more than \a tolerance may change places so that entries and exits
   * alternate, and ways through the mesh that are no longer than that are left out: the line passes
   * an edge or a corner there. The line begins inside where exits are in the majority.
   */
  static void Relate(Event* first, Event* last, double tolerance, std::vector<Relation>& relations);
};

}

#endif
