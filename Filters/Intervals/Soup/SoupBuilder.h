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
    this->Number = 0;
    this->Corners.clear();
  }

  /// Makes sure that the points of one cut more find room.
  void Reserve()
  {
    if (this->Number + vtkIsotable::MaximumNumberOfSlots > this->Points.size())
    {
      this->Points.resize(2 * this->Points.size() + vtkIsotable::MaximumNumberOfSlots);
      this->Keys.resize(this->Points.size());
    }
  }

  /// Returns the index of a point, which is given as in CrossingLists.
  Index Enter(vtkIdType owner, CrossingKey key)
  {
    Index& recent = this->Recent[GetHash(owner, key)];
    const Index at = recent;
    if (at < this->Number && this->Keys[at].Owner == owner && this->Keys[at].Crossing == key)
    {
      return at;
    }
    recent = this->Number++;
    this->Keys[recent].Owner = owner;
    this->Keys[recent].Crossing = key;
    const bool isCrossing = key != CrossingKey();
    ExtractionPoint& point = this->Points[recent];
    point.Near = owner;
    point.Far = isCrossing ? key.GetFar() : owner;
    point.Weight = static_cast<double>(key.GetValue());
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

  ///@{
  /// Return the points and their number.
  ExtractionPoint* GetPoints() { return this->Points.data(); }
  const ExtractionPoint* GetPoints() const { return this->Points.data(); }
  std::size_t GetNumberOfPoints() const { return this->Number; }
  ///@}
  /// Returns the points of the corners, three for each triangle.
  const std::vector<Index>& GetCorners() const { return this->Corners; }

private:
  static constexpr int TableBits = 10;

  struct Key
  {
    vtkIdType Owner;
    CrossingKey Crossing;
  };

  static std::size_t GetHash(vtkIdType owner, CrossingKey crossing)
  {
    const auto far = static_cast<std::uint64_t>(crossing.GetFar());
    const auto value = static_cast<std::uint64_t>(crossing.GetValue());
    const std::uint64_t sum = 3 * static_cast<std::uint64_t>(owner) + far + value;
    return (0x9E3779B97F4A7C15u * sum) >> (64 - TableBits);
  }

  // There is room for more than the points that there are.
  std::vector<ExtractionPoint> Points;
  std::vector<Key> Keys;
  Index Number = 0;
  std::vector<Index> Corners;
  std::array<Index, std::size_t(1) << TableBits> Recent{};
};

}

#endif
