// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoupBuilder_h
#define interlume_SoupBuilder_h

#include "Output/CrossingKey.h"
#include "Output/ExtractionPoint.h"
#include "Soup/SoupPart.h"

#include "vtkIsotable.h"

#include <array>

namespace interlume
{

/**
 * @class   SoupBuilder
 * @brief   collects the triangles of cells, cut by cut
 *
 * What cells near each other have in common is computed once: a small table remembers the last
 * points. It may forget one, which is then computed again and comes out the same.
 */
class SoupBuilder
{
public:
  using Index = SoupPart::Index;

  /// Begins a part without triangles.
  void Begin()
  {
    this->Points.clear();
    this->Corners.clear();
    this->Keys.clear();
  }

  /// Returns the index of a point, which is given as in CrossingLists.
  Index Enter(vtkIdType owner, CrossingKey key)
  {
    const Key wanted{ owner, key };
    Index& recent = this->Recent[wanted.GetHash()];
    if (recent < this->Keys.size() && this->Keys[recent] == wanted)
    {
      return recent;
    }
    recent = static_cast<Index>(this->Keys.size());
    this->Keys.push_back(wanted);
    this->Points.push_back(key == CrossingKey()
        ? ExtractionPoint{ owner, owner, 0.0 }
        : ExtractionPoint{ owner, key.GetFar(), static_cast<double>(key.GetValue()) });
    return recent;
  }

  /// Adds the triangles of a cut; \a points has the index of each slot.
  void Add(
    const vtkIsotable::Simplex* triangles, std::size_t number, const Index* points, bool isInverted)
  {
    const int first = isInverted ? 1 : 0;
    const std::size_t place = this->Corners.size();
    this->Corners.resize(place + 3 * number);
    Index* corner = this->Corners.data() + place;
    for (std::size_t t = 0; t < number; ++t, corner += 3)
    {
      corner[0] = points[triangles[t][first]];
      corner[1] = points[triangles[t][1 - first]];
      corner[2] = points[triangles[t][2]];
    }
  }

  std::vector<ExtractionPoint>& GetPoints() { return this->Points; }
  const std::vector<ExtractionPoint>& GetPoints() const { return this->Points; }
  /// Returns the points of the corners, three for each triangle.
  const std::vector<Index>& GetCorners() const { return this->Corners; }

private:
  static constexpr int TableBits = 10;

  struct Key
  {
    vtkIdType Owner;
    CrossingKey Crossing;

    bool operator==(const Key& other) const
    {
      return this->Owner == other.Owner && this->Crossing == other.Crossing;
    }

    std::size_t GetHash() const
    {
      const auto owner = static_cast<std::uint64_t>(this->Owner);
      const auto far = static_cast<std::uint64_t>(this->Crossing.GetFar());
      const auto value = static_cast<std::uint64_t>(this->Crossing.GetValue());
      return (0x9E3779B97F4A7C15u * (3 * owner + far + value)) >> (64 - TableBits);
    }
  };

  std::vector<ExtractionPoint> Points;
  std::vector<Key> Keys;
  std::vector<Index> Corners;
  std::array<Index, std::size_t(1) << TableBits> Recent{};
};

}

#endif
