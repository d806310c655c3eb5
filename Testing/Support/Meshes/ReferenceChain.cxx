// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceChain.h"

#include <map>
#include <set>

namespace reference
{

std::vector<OrientedSimplex<3>> FacesOf(const std::vector<Tetrahedron>& tetrahedra)
{
  std::vector<OrientedSimplex<3>> faces;
  faces.reserve(4 * tetrahedra.size());
  for (const Tetrahedron& t : tetrahedra)
  {
    faces.emplace_back(Triangle{ t[0], t[2], t[1] });
    faces.emplace_back(Triangle{ t[0], t[1], t[3] });
    faces.emplace_back(Triangle{ t[1], t[2], t[3] });
    faces.emplace_back(Triangle{ t[0], t[3], t[2] });
  }
  return faces;
}

std::vector<OrientedSimplex<3>> ToOrientedSimplices(const std::vector<Triangle>& triangles)
{
  return { triangles.begin(), triangles.end() };
}

std::vector<OrientedSimplex<2>> EdgesOf(const std::vector<Triangle>& triangles)
{
  std::vector<OrientedSimplex<2>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.emplace_back(std::array<vtkIdType, 2>{ t[i], t[(i + 1) % 3] });
    }
  }
  return edges;
}

bool VerticesAreManifold(const std::vector<Triangle>& triangles)
{
  // The link of a point consists of the opposite edges of its triangles. It is one path or one
  // cycle if it is connected and no point has more than two neighbors.
  std::map<vtkIdType, std::map<vtkIdType, std::vector<vtkIdType>>> links;
  for (const Triangle& t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = t[(i + 1) % 3];
      const vtkIdType b = t[(i + 2) % 3];
      links[t[i]][a].push_back(b);
      links[t[i]][b].push_back(a);
    }
  }
  for (const auto& [point, link] : links)
  {
    std::set<vtkIdType> reached = { link.begin()->first };
    std::vector<vtkIdType> front = { link.begin()->first };
    while (!front.empty())
    {
      const vtkIdType at = front.back();
      front.pop_back();
      for (vtkIdType next : link.at(at))
      {
        if (reached.insert(next).second)
        {
          front.push_back(next);
        }
      }
    }
    if (reached.size() != link.size())
    {
      return false;
    }
    for (const auto& [id, neighbors] : link)
    {
      if (neighbors.size() > 2)
      {
        return false;
      }
    }
  }
  return true;
}

}
