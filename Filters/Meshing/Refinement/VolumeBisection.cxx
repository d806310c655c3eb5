// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement/VolumeBisection.h"

#include "Common/Vectors.h"
#include "TetGen/MeshingJob.h"

#include <algorithm>

namespace interlume
{

namespace
{
using Corners = std::array<int, 4>;

bool Has(const int* points, int number, int point)
{
  return std::find(points, points + number, point) != points + number;
}
}

VolumeBisection::VolumeBisection(const MeshingJob& job, TetGenSolution& mesh)
  : Job(job)
  , Mesh(mesh)
{
}

void VolumeBisection::Execute(int maximumNumberOfPoints)
{
  std::vector<int> stack;
  for (int t = 0; t < this->Mesh.GetNumberOfTetrahedra(); ++t)
  {
    if (this->IsTooLarge(t))
    {
      stack.push_back(t);
    }
  }
  if (stack.empty())
  {
    return;
  }
  this->TetrahedraOf.resize(this->Mesh.GetNumberOfPoints());
  for (std::size_t i = 0; i < this->Mesh.Tetrahedra.size(); ++i)
  {
    this->TetrahedraOf[this->Mesh.Tetrahedra[i]].push_back(static_cast<int>(i / 4));
  }
  this->TrianglesOf.resize(this->Mesh.GetNumberOfPoints());
  for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
  {
    this->TrianglesOf[this->Mesh.Triangles[i]].push_back(static_cast<int>(i / 3));
  }
  while (!stack.empty() && this->Mesh.GetNumberOfPoints() < maximumNumberOfPoints &&
    !this->Job.IsCanceled())
  {
    const int t = stack.back();
    if (!this->IsTooLarge(t))
    {
      stack.pop_back();
      continue;
    }
    const std::vector<int> changed = this->Split(this->FindTerminalEdge(t), t);
    if (changed.empty())
    {
      stack.pop_back();
    }
    for (int other : changed)
    {
      if (other != t && this->IsTooLarge(other))
      {
        stack.push_back(other);
      }
    }
  }
  this->ConnectNeighbors();
}

bool VolumeBisection::IsTooLarge(int tetrahedron) const
{
  const int* p = &this->Mesh.Tetrahedra[4 * tetrahedron];
  const double* x = this->Mesh.Points.data();
  return Vectors::SixVolumes(x + 3 * p[0], x + 3 * p[1], x + 3 * p[2], x + 3 * p[3]) / 6.0 >
    this->Job.MaximumVolume;
}

bool VolumeBisection::IsFixed(const Edge& edge) const
{
  const std::vector<int>& triangles = this->TrianglesOf[edge[0]];
  return this->Job.PreserveBoundary &&
    std::any_of(triangles.begin(), triangles.end(),
      [&](int t) { return Has(&this->Mesh.Triangles[3 * t], 3, edge[1]); });
}

bool VolumeBisection::IsShorter(const Edge& edge, const Edge& other) const
{
  const auto square = [this](const Edge& e)
  {
    const glm::dvec3 along =
      Vectors::Difference(&this->Mesh.Points[3 * e[0]], &this->Mesh.Points[3 * e[1]]);
    return glm::dot(along, along);
  };
  const double length = square(edge);
  const double otherLength = square(other);
  return length < otherLength || (length == otherLength && edge < other);
}

VolumeBisection::Edge VolumeBisection::FindLongestEdge(int tetrahedron) const
{
  const int* p = &this->Mesh.Tetrahedra[4 * tetrahedron];
  Edge longest{ { -1, -1 } };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      const Edge edge{ { std::min(p[i], p[j]), std::max(p[i], p[j]) } };
      if ((longest[0] < 0 || this->IsShorter(longest, edge)) && !this->IsFixed(edge))
      {
        longest = edge;
      }
    }
  }
  return longest;
}

VolumeBisection::Edge VolumeBisection::FindTerminalEdge(int tetrahedron) const
{
  Edge edge = this->FindLongestEdge(tetrahedron);
  for (bool isLonger = edge[0] >= 0; isLonger;)
  {
    isLonger = false;
    for (int t : this->FindAround(edge))
    {
      const Edge other = this->FindLongestEdge(t);
      if (this->IsShorter(edge, other))
      {
        edge = other;
        isLonger = true;
      }
    }
  }
  return edge;
}

std::vector<int> VolumeBisection::FindAround(const Edge& edge) const
{
  std::vector<int> around;
  for (int t : this->TetrahedraOf[edge[0]])
  {
    if (Has(&this->Mesh.Tetrahedra[4 * t], 4, edge[1]))
    {
      around.push_back(t);
    }
  }
  return around;
}

std::vector<int> VolumeBisection::Split(const Edge& edge, int tetrahedron)
{
  const bool isEdge = edge[0] >= 0;
  const std::vector<int> oldTetrahedra =
    isEdge ? this->FindAround(edge) : std::vector<int>{ tetrahedron };
  const int* p = &this->Mesh.Tetrahedra[4 * tetrahedron];
  const std::vector<int> ends =
    isEdge ? std::vector<int>(edge.begin(), edge.end()) : std::vector<int>(p, p + 4);
  glm::dvec3 point(0.0);
  for (int end : ends)
  {
    point += glm::make_vec3(&this->Mesh.Points[3 * end]) / static_cast<double>(ends.size());
  }
  const int added = this->Mesh.GetNumberOfPoints();
  std::vector<Corners> parts;
  for (int t : oldTetrahedra)
  {
    for (int end : ends)
    {
      Corners part;
      std::copy_n(&this->Mesh.Tetrahedra[4 * t], 4, part.begin());
      std::array<const double*, 4> x;
      for (int i = 0; i < 4; ++i)
      {
        part[i] = part[i] == end ? added : part[i];
        x[i] = part[i] == added ? glm::value_ptr(point) : &this->Mesh.Points[3 * part[i]];
      }
      if (!(Vectors::SixVolumes(x[0], x[1], x[2], x[3]) > 0.0))
      {
        return {};
      }
      parts.push_back(part);
    }
  }
  this->Mesh.Points.insert(
    this->Mesh.Points.end(), glm::value_ptr(point), glm::value_ptr(point) + 3);
  this->TetrahedraOf.emplace_back();
  this->TrianglesOf.emplace_back();
  for (int t : oldTetrahedra)
  {
    for (int i = 0; i < 4; ++i)
    {
      std::vector<int>& list = this->TetrahedraOf[this->Mesh.Tetrahedra[4 * t + i]];
      list.erase(std::find(list.begin(), list.end(), t));
    }
  }
  // The first new tetrahedra replace the split ones; the others are appended.
  std::vector<int> changed = oldTetrahedra;
  while (changed.size() < parts.size())
  {
    changed.push_back(this->Mesh.GetNumberOfTetrahedra());
    this->Mesh.Tetrahedra.resize(this->Mesh.Tetrahedra.size() + 4);
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    std::copy_n(parts[i].begin(), 4, &this->Mesh.Tetrahedra[4 * changed[i]]);
    for (int corner : parts[i])
    {
      this->TetrahedraOf[corner].push_back(changed[i]);
    }
  }
  if (isEdge)
  {
    this->SplitTriangles(edge, added);
  }
  return changed;
}

void VolumeBisection::SplitTriangles(const Edge& edge, int point)
{
  const std::vector<int> triangles = this->TrianglesOf[edge[0]];
  for (int t : triangles)
  {
    int* corners = &this->Mesh.Triangles[3 * t];
    if (!Has(corners, 3, edge[1]))
    {
      continue;
    }
    std::array<int, 3> half;
    std::copy_n(corners, 3, half.begin());
    std::replace(half.begin(), half.end(), edge[0], point);
    std::replace(corners, corners + 3, edge[1], point);
    std::vector<int>& list = this->TrianglesOf[edge[1]];
    list.erase(std::find(list.begin(), list.end(), t));
    this->TrianglesOf[point].push_back(t);
    const int added = static_cast<int>(this->Mesh.Markers.size());
    this->Mesh.Triangles.insert(this->Mesh.Triangles.end(), half.begin(), half.end());
    this->Mesh.Markers.push_back(this->Mesh.Markers[t]);
    for (int corner : half)
    {
      this->TrianglesOf[corner].push_back(added);
    }
  }
}

void VolumeBisection::ConnectNeighbors()
{
  struct Face
  {
    std::array<int, 3> Points;
    int Index; ///< four times the tetrahedron plus the opposite corner
  };
  std::vector<Face> faces;
  const int number = static_cast<int>(this->Mesh.Tetrahedra.size());
  for (int i = 0; i < number; ++i)
  {
    faces.push_back({ this->Mesh.GetFace(i), i });
  }
  std::sort(
    faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.Points < b.Points; });
  this->Mesh.Neighbors.assign(number, -1);
  for (std::size_t i = 1; i < faces.size(); ++i)
  {
    if (faces[i].Points == faces[i - 1].Points)
    {
      this->Mesh.Neighbors[faces[i].Index] = faces[i - 1].Index / 4;
      this->Mesh.Neighbors[faces[i - 1].Index] = faces[i].Index / 4;
    }
  }
}

}
