// SPDX-License-Identifier: BSD-3-Clause
#include "Order/FaceAdjacency.h"

#include "Common/ParallelFor.h"
#include "Order/RadixSorter.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <utility>

namespace interlume
{

namespace
{
constexpr vtkIdType FaceGrain = 8192;

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

// A face in a group of faces with the same lowest point id: its other two point ids, and its index.
struct Candidate
{
  std::uint64_t Rest;
  std::uint32_t Face;

  bool operator<(const Candidate& other) const
  {
    return this->Rest != other.Rest ? this->Rest < other.Rest : this->Face < other.Face;
  }
};

// Sets the twins of the faces that occur exactly twice.
void Match(std::vector<Candidate>& candidates, std::vector<std::uint32_t>& twins)
{
  std::sort(candidates.begin(), candidates.end());
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
    first = last;
  }
}
}

std::vector<std::uint32_t> FaceAdjacency::FindTwins(const TetrahedraMesh& mesh)
{
  if (mesh.Corners.size() / 4 > MaximumNumberOfTetrahedra)
  {
    return {};
  }
  const std::uint32_t faces = 4 * mesh.GetNumberOfTetrahedra();
  std::vector<std::uint32_t> twins(faces, None);
  std::vector<std::uint32_t> lowest(faces);
  ParallelFor(0, faces, FaceGrain,
    [&](vtkIdType face)
    { lowest[face] = GetSortedIds(mesh, static_cast<std::uint32_t>(face))[0]; });

  std::vector<std::uint32_t> order(faces);
  RadixSorter radix;
  radix.Sort(lowest.data(), faces, order.data());

  vtkSMPTools::For(0, faces, FaceGrain,
    [&](vtkIdType first, vtkIdType last)
    {
      // A group of faces with the same lowest point id is processed in the range in which it
      // begins.
      while (first < last && first > 0 && lowest[order[first]] == lowest[order[first - 1]])
      {
        ++first;
      }
      std::vector<Candidate> candidates;
      for (vtkIdType i = first; i < last;)
      {
        const std::uint32_t id = lowest[order[i]];
        candidates.clear();
        for (; i < static_cast<vtkIdType>(faces) && lowest[order[i]] == id; ++i)
        {
          const auto ids = GetSortedIds(mesh, order[i]);
          candidates.push_back({ static_cast<std::uint64_t>(ids[1]) << 32 | ids[2], order[i] });
        }
        Match(candidates, twins);
      }
    });
  return twins;
}

}
