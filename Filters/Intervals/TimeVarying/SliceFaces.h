// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceFaces_h
#define interlume_SliceFaces_h

#include "TimeVarying/SliceChunk.h"
#include "TimeVarying/SlicedSimplex.h"

#include <array>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   SliceFaces
 * @brief   the tetrahedra of a slice whose points are all vertices at the value
 *
 * Of one interval, what begins at the value is given by what ends there, and a tetrahedron by
 * either: each is to be in the slice once.
 */
class SliceFaces
{
public:
  struct Face
  {
    /// Its points in the global order.
    std::array<vtkIdType, 4> Ids;
    /// Intervals may overlap, and each has its own slice.
    vtkIdType Interval;
    SliceMeeting How;

    bool operator<(const Face& other) const { return this->Ids < other.Ids; }
  };

  /// A chunk with its faces, in the order of the cells, and which of its tetrahedra they are.
  struct Chunk : SliceChunk
  {
    std::vector<Face> Faces;
    std::vector<std::size_t> Places;
  };

  void Add(const Chunk& chunk);
  /// Sorts all that were added.
  void Sort();

  /// Returns whether any may be given by another.
  bool HasGiven() const;
  /// Leaves out the tetrahedra of a chunk that others give; all are sorted.
  void LeaveOutGiven(Chunk& chunk) const;

private:
  bool IsGiven(const Face& face) const;

  std::vector<Face> All;
};

}

#endif
