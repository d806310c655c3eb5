// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlabTriangles_h
#define interlume_SlabTriangles_h

#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   SlabTriangles
 * @brief   triangles to draw for each slab of a sweep
 */
class SlabTriangles
{
public:
  /// Returns the coordinates (x, y, z) of the triangles' vertices, slab after slab.
  const std::vector<float>& GetVertices() const { return this->Vertices; }
  /// Returns the index of the first vertex of each slab, followed by the number of vertices.
  const std::vector<std::size_t>& GetStarts() const { return this->Starts; }
  int GetNumberOfSlabs() const { return static_cast<int>(this->Starts.size()) - 1; }
  bool IsEmpty(int slab) const
  {
    return this->Starts[static_cast<std::size_t>(slab)] ==
      this->Starts[static_cast<std::size_t>(slab) + 1];
  }

protected:
  /// Concatenates the vertices of all slabs, in parallel.
  void Join(const std::vector<std::vector<float>>& slabs);

private:
  std::vector<float> Vertices;
  std::vector<std::size_t> Starts = { 0 };
};

}

#endif
