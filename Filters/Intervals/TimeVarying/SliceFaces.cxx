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

bool SliceFaces::HasGiven() const
{
  return std::any_of(this->All.begin(), this->All.end(),
    [](const Face& face) { return face.How != SliceMeeting::Ends; });
}

bool SliceFaces::IsGiven(const Face& face) const
{
  const auto alike = std::equal_range(this->All.begin(), this->All.end(), face);
  return std::any_of(alike.first, alike.second,
    [&face](const Face& other) { return other.Interval == face.Interval && other.How < face.How; });
}

void SliceFaces::LeaveOutGiven(Chunk& chunk) const
{
  std::vector<SliceChunk::Tetrahedron>& all = chunk.Tetrahedra;
  std::size_t kept = 0;
  auto place = chunk.Places.begin();
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    bool isGiven = false;
    if (place != chunk.Places.end() && *place == t)
    {
      isGiven = this->IsGiven(chunk.Faces[place - chunk.Places.begin()]);
      ++place;
    }
    all[kept] = all[t];
    kept += isGiven ? 0 : 1;
  }
  all.resize(kept);
}

}
