// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SliceFaces.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace interlume
{

void SliceFaces::Add(const Chunk& chunk)
{
  this->All.insert(this->All.end(), chunk.Faces.begin(), chunk.Faces.end());
}

void SliceFaces::Sort()
{
  vtkSMPTools::Sort(this->All.begin(), this->All.end());
}

bool SliceFaces::HasDuplicates() const
{
  return std::any_of(this->All.begin(), this->All.end(),
    [](const Face& face) { return face.Intersection != SliceIntersection::Ends; });
}

bool SliceFaces::IsDuplicate(const Face& face) const
{
  const auto matches = std::equal_range(this->All.begin(), this->All.end(), face);
  return std::any_of(matches.first, matches.second,
    [&face](const Face& other)
    { return other.Interval == face.Interval && other.Intersection < face.Intersection; });
}

void SliceFaces::RemoveDuplicates(Chunk& chunk) const
{
  std::vector<SliceChunk::Tetrahedron>& all = chunk.Tetrahedra;
  std::size_t numberRetained = 0;
  auto faceTetrahedron = chunk.FaceTetrahedra.begin();
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    bool isDuplicate = false;
    if (faceTetrahedron != chunk.FaceTetrahedra.end() && *faceTetrahedron == t)
    {
      isDuplicate = this->IsDuplicate(chunk.Faces[faceTetrahedron - chunk.FaceTetrahedra.begin()]);
      ++faceTetrahedron;
    }
    all[numberRetained] = all[t];
    numberRetained += isDuplicate ? 0 : 1;
  }
  all.resize(numberRetained);
}

}
