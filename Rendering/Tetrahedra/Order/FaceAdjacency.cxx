// SPDX-License-Identifier: BSD-3-Clause
#include "Order/FaceAdjacency.h"

#include "Order/RadixOrder.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

namespace interlume
{

namespace
{
constexpr vtkIdType Grain = 8192;

// Returns the point ids of a face, ascending.
std::array<std::uint32_t, 3> GetSortedIds(const TetrahedraMesh& mesh, std::uint32_t face)
{
  const std::uint32_t* corners = mesh.GetCorners(face / 4);
  const std::uint32_t k = face & 3;
  std::uint32_t a = corners[k == 0 ? 1 : 0];
  std::uint32_t b = corners[k <= 1 ? 2 : 1];
  std::uint32_t c = corners[k <= 2 ? 3 : 2];
  if (a > b)
  {
    std::swap(a, b);
  }
  if (b > c)
  {
    std::swap(b, c);
  }
  if (a > b)
  {
    std::swap(a, b);
  }
  return { { a, b, c } };
}

// A face among those with the same lowest id: the other two ids, and its number.
struct Candidate
{
  std::uint64_t Rest;
  std::uint32_t Face;

  bool operator<(const Candidate& other) const
  {
    return this->Rest != other.Rest ? this->Rest < other.Rest : this->Face < other.Face;
  }
};

// Matches candidates; returns how many triangles are there more than twice.
std::uint32_t Match(std::vector<Candidate>& candidates, std::vector<std::uint32_t>& twins)
{
  std::sort(candidates.begin(), candidates.end());
  std::uint32_t nonManifold = 0;
  for (auto first = candidates.begin(); first != candidates.end();)
  {
    auto last = first;
    while (last != candidates.end() && last->Rest == first->Rest)
    {
      ++last;
    }
    if (last - first == 2)
    {
      twins[first->Face] = first[1].Face;
      twins[first[1].Face] = first->Face;
    }
    nonManifold += last - first > 2 ? 1 : 0;
    first = last;
  }
  return nonManifold;
}

// Returns the root of a tetrahedron's piece, halving the way to it.
std::uint32_t FindRoot(std::vector<std::uint32_t>& parents, std::uint32_t tetrahedron)
{
  while (parents[tetrahedron] != tetrahedron)
  {
    parents[tetrahedron] = parents[parents[tetrahedron]];
    tetrahedron = parents[tetrahedron];
  }
  return tetrahedron;
}
}

bool FaceAdjacency::Build(const TetrahedraMesh& mesh)
{
  this->Twins.clear();
  this->BoundaryFaces.clear();
  this->NonManifoldFaces = 0;
  if (mesh.Corners.size() / 4 > MaximumNumberOfTetrahedra)
  {
    return false;
  }
  const std::uint32_t faces = 4 * mesh.GetNumberOfTetrahedra();
  this->Twins.resize(faces);
  std::vector<std::uint32_t> lowest(faces);
  vtkSMPTools::For(0, faces, Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType face = first; face < last; ++face)
      {
        lowest[face] = GetSortedIds(mesh, static_cast<std::uint32_t>(face))[0];
        this->Twins[face] = None;
      }
    });

  std::vector<std::uint32_t> order(faces);
  RadixOrder radix;
  radix.Sort(lowest.data(), faces, order.data());

  std::atomic<std::uint32_t> nonManifold(0);
  vtkSMPTools::For(0, faces, Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      // The run of a lowest id belongs to the range that it begins in.
      while (first < last && first > 0 && lowest[order[first]] == lowest[order[first - 1]])
      {
        ++first;
      }
      std::vector<Candidate> candidates;
      std::uint32_t found = 0;
      for (vtkIdType i = first; i < last;)
      {
        const std::uint32_t id = lowest[order[i]];
        candidates.clear();
        for (; i < static_cast<vtkIdType>(faces) && lowest[order[i]] == id; ++i)
        {
          const auto ids = GetSortedIds(mesh, order[i]);
          candidates.push_back({ static_cast<std::uint64_t>(ids[1]) << 32 | ids[2], order[i] });
        }
        found += Match(candidates, this->Twins);
      }
      nonManifold += found;
    });
  this->NonManifoldFaces = nonManifold;
  this->ListBoundary();
  return true;
}

void FaceAdjacency::ListBoundary()
{
  for (std::size_t face = 0; face < this->Twins.size(); ++face)
  {
    if (this->Twins[face] == None)
    {
      this->BoundaryFaces.push_back(static_cast<std::uint32_t>(face));
    }
  }
}

std::uint32_t FaceAdjacency::CountComponents() const
{
  std::vector<std::uint32_t> parents(this->Twins.size() / 4);
  std::iota(parents.begin(), parents.end(), 0);
  std::uint32_t components = static_cast<std::uint32_t>(parents.size());
  for (std::size_t face = 0; face < this->Twins.size(); ++face)
  {
    // Each pair is visited once.
    const std::uint32_t twin = this->Twins[face];
    if (twin != None && twin < face)
    {
      const std::uint32_t a = FindRoot(parents, static_cast<std::uint32_t>(face / 4));
      const std::uint32_t b = FindRoot(parents, twin / 4);
      components -= a != b ? 1 : 0;
      parents[std::max(a, b)] = std::min(a, b);
    }
  }
  return components;
}

std::size_t FaceAdjacency::GetBytes() const
{
  return (this->Twins.capacity() + this->BoundaryFaces.capacity()) * sizeof(std::uint32_t);
}

}
