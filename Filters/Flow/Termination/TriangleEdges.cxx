// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TriangleEdges.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <tuple>

namespace interlume
{

void TriangleEdges::Connect(const TerminationTriangles& mesh)
{
  struct HalfEdge
  {
    int Lower;
    int Upper;
    int Index;
  };
  std::vector<HalfEdge> halves;
  const int number = static_cast<int>(mesh.Triangles.size());
  for (int i = 0; i < 3 * number; ++i)
  {
    const int* corners = mesh.Triangles[i / 3].Corners;
    const auto ends = std::minmax(corners[i % 3], corners[(i + 1) % 3]);
    halves.push_back({ ends.first, ends.second, i });
  }
  std::sort(halves.begin(), halves.end(),
    [](const HalfEdge& a, const HalfEdge& b)
    { return std::tie(a.Lower, a.Upper, a.Index) < std::tie(b.Lower, b.Upper, b.Index); });
  *this = TriangleEdges();
  this->EdgeIds.resize(halves.size());
  for (std::size_t i = 0; i < halves.size(); ++i)
  {
    const int triangle = halves[i].Index / 3;
    if (i == 0 || halves[i].Lower != halves[i - 1].Lower || halves[i].Upper != halves[i - 1].Upper)
    {
      this->Faces.push_back(0);
      this->Triangles.push_back({ { triangle, -1 } });
    }
    if (++this->Faces.back() == 2)
    {
      this->Triangles.back()[1] = triangle;
    }
    this->EdgeIds[halves[i].Index] = this->GetNumberOfEdges() - 1;
  }
  this->NumberOfBorderEdges = std::count(this->Faces.begin(), this->Faces.end(), 1);
  this->NumberOfBranchingEdges =
    std::count_if(this->Faces.begin(), this->Faces.end(), [](int faces) { return faces > 2; });
}

Error TriangleEdges::OrientPart(
  const TerminationTriangles& mesh, int first, std::vector<signed char>& turns) const
{
  const auto goesUp = [&mesh](int triangle, int i)
  {
    const int* corners = mesh.Triangles[triangle].Corners;
    return corners[i] < corners[(i + 1) % 3];
  };
  std::vector<int> part = { first };
  turns[first] = 0;
  bool isClosed = true;
  for (std::size_t next = 0; next < part.size(); ++next)
  {
    const int triangle = part[next];
    for (int i = 0; i < 3; ++i)
    {
      const int edge = this->GetEdge(triangle, i);
      if (this->Faces[edge] != 2)
      {
        isClosed = false;
        continue;
      }
      const auto& pair = this->Triangles[edge];
      const int other = pair[0] == triangle ? pair[1] : pair[0];
      int j = 0;
      while (this->GetEdge(other, j) != edge)
      {
        ++j;
      }
      const bool agree = goesUp(triangle, i) != goesUp(other, j);
      const signed char turn = agree ? turns[triangle] : 1 - turns[triangle];
      if (turns[other] < 0)
      {
        turns[other] = turn;
        part.push_back(other);
      }
      else if (turns[other] != turn)
      {
        const int* corners = mesh.Triangles[triangle].Corners;
        return "the mesh is one-sided: its triangles cannot be oriented consistently at the edge "
               "from point " +
          std::to_string(mesh.PointIds[corners[i]]) + " to point " +
          std::to_string(mesh.PointIds[corners[(i + 1) % 3]]);
      }
    }
  }
  double volume = 0.0;
  std::size_t turned = 0;
  for (int triangle : part)
  {
    const glm::dvec3& origin = mesh.GetCorner(first, 0);
    const double signedVolume = glm::determinant(glm::dmat3(mesh.GetCorner(triangle, 0) - origin,
      mesh.GetCorner(triangle, 1) - origin, mesh.GetCorner(triangle, 2) - origin));
    volume += turns[triangle] ? -signedVolume : signedVolume;
    turned += turns[triangle];
  }
  if (isClosed ? volume < 0.0 : 2 * turned > part.size())
  {
    for (int triangle : part)
    {
      turns[triangle] = 1 - turns[triangle];
    }
  }
  return {};
}

Error TriangleEdges::Orient(TerminationTriangles& mesh)
{
  const int number = static_cast<int>(mesh.Triangles.size());
  std::vector<signed char> turns(number, -1);
  for (int triangle = 0; triangle < number; ++triangle)
  {
    if (Error error = turns[triangle] < 0 ? this->OrientPart(mesh, triangle, turns) : Error())
    {
      return error;
    }
  }
  for (int i = 0; i < number; ++i)
  {
    if (turns[i])
    {
      TerminationTriangles::Triangle& triangle = mesh.Triangles[i];
      std::swap(triangle.Corners[1], triangle.Corners[2]);
      std::swap(triangle.Texture[1], triangle.Texture[2]);
      std::swap(this->EdgeIds[3 * i], this->EdgeIds[3 * i + 2]);
    }
  }
  return {};
}

}
