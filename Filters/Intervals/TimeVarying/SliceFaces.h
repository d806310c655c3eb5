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
 * @brief   slice tetrahedra whose points are all vertices at the slice value
 *
 * Within an interval, the same tetrahedron may come from a 4-simplex that ends at the value, from
 * one that begins there, and from a tetrahedron at the step. The slice must contain it once.
 */
class SliceFaces
{
public:
  struct Face
  {
    /// Ids of the points in the global order.
    std::array<vtkIdType, 4> Ids;
    /// Interval id. Intervals may overlap, and each has a separate slice.
    vtkIdType Interval;
    SliceIntersection Intersection;

    bool operator<(const Face& other) const { return this->Ids < other.Ids; }
  };

  /// A chunk with its faces in the order of the cells, and the tetrahedron index of each face.
  struct Chunk : SliceChunk
  {
    std::vector<Face> Faces;
    std::vector<std::size_t> FaceTetrahedra;
  };

  void Add(const Chunk& chunk);
  /// Sorts the faces. Call this after all chunks have been added.
  void Sort();

  /// Returns true if any face may be a duplicate.
  bool HasDuplicates() const;
  /// Removes the tetrahedra of a chunk that duplicate others. The faces must be sorted.
  void RemoveDuplicates(Chunk& chunk) const;

private:
  bool IsDuplicate(const Face& face) const;

  std::vector<Face> All;
};

}

#endif
