// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TriangleIndex_h
#define interlume_TriangleIndex_h

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   TriangleIndex
 * @brief   finds triangles by their points in any order
 */
class TriangleIndex
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  TriangleIndex(const std::vector<Triangle>& triangles, vtkIdType numberOfPoints)
    : Firsts(numberOfPoints + 1, 0)
    , Entries(triangles.size())
  {
    for (const Triangle& triangle : triangles)
    {
      ++this->Firsts[*std::min_element(triangle.begin(), triangle.end())];
    }
    vtkIdType sum = 0;
    for (vtkIdType& first : this->Firsts)
    {
      sum += std::exchange(first, sum);
    }
    std::vector<vtkIdType> next(this->Firsts);
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const Triangle sorted = Sort(triangles[t]);
      this->Entries[next[sorted[0]]++] = { sorted[1], sorted[2], static_cast<vtkIdType>(t) };
    }
  }

  /// Calls \a visit with the index of each triangle with these points, in ascending order.
  template <typename Visitor>
  void ForEach(const Triangle& triangle, Visitor&& visit) const
  {
    const Triangle sorted = Sort(triangle);
    for (vtkIdType e = this->Firsts[sorted[0]]; e < this->Firsts[sorted[0] + 1]; ++e)
    {
      const Entry& entry = this->Entries[e];
      if (entry.Second == sorted[1] && entry.Last == sorted[2])
      {
        visit(entry.Index);
      }
    }
  }

private:
  struct Entry
  {
    vtkIdType Second;
    vtkIdType Last;
    vtkIdType Index;
  };

  static Triangle Sort(Triangle triangle)
  {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
  }

  // Index of the first entry of the triangles whose smallest point id is p, for each p.
  std::vector<vtkIdType> Firsts;
  std::vector<Entry> Entries;
};

}

#endif
