// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnsharedPoints_h
#define interlume_UnsharedPoints_h

#include "Arrays/PointArrays.h"
#include "Output/CrossingKey.h"
#include "Output/ExtractionPoint.h"

#include "vtkIsotable.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   UnsharedPoints
 * @brief   collects triangles whose corners become separate output points
 *
 * A small hash table caches the latest points, so that neighboring cells compute a common point
 * once. A point evicted from the table is computed again with the same result.
 */
class UnsharedPoints
{
public:
  using Index = PointArrays::Part::Index;

  /// Removes all points and triangles. Call this before each chunk.
  void Begin()
  {
    this->Number = 0;
    this->NumberOfCorners = 0;
    this->Recent.assign(std::size_t(1) << TableBits, Known());
  }

  /// Allocates capacity for the points of one more cut if needed.
  void Reserve()
  {
    if (this->Number + vtkIsotable::MaximumNumberOfSlots > this->Points.size())
    {
      this->Points.resize(2 * this->Points.size() + vtkIsotable::MaximumNumberOfSlots);
    }
  }

  /// Returns the index of a point. See CrossingLists for \a owner and \a key.
  Index Enter(vtkIdType owner, CrossingKey key)
  {
    Known& recent = this->Recent[GetHash(owner, key)];
    if (recent.Owner == owner && recent.Crossing == key)
    {
      return recent.At;
    }
    recent = { owner, key, this->Number };
    const vtkIdType far = key == CrossingKey() ? owner : key.GetFar();
    this->Points[this->Number] = { owner, far, static_cast<double>(key.GetValue()) };
    return this->Number++;
  }

  /// Adds the triangles of a cut. \a points holds the point index of each slot.
  void Add(
    const vtkIsotable::Simplex* triangles, std::size_t number, const Index* points, bool isInverted)
  {
    const std::size_t end = this->NumberOfCorners + 3 * number;
    if (end > this->Corners.size())
    {
      this->Corners.resize(2 * end);
    }
    Index* corner = this->Corners.data() + this->NumberOfCorners;
    this->NumberOfCorners = end;
    for (std::size_t t = 0; t < number; ++t, corner += 3)
    {
      const Index first = points[triangles[t][0]];
      const Index second = points[triangles[t][1]];
      corner[0] = isInverted ? second : first;
      corner[1] = isInverted ? first : second;
      corner[2] = points[triangles[t][2]];
    }
  }

  ///@{
  /// Return the points and their number.
  ExtractionPoint* GetPoints() { return this->Points.data(); }
  const ExtractionPoint* GetPoints() const { return this->Points.data(); }
  std::size_t GetNumberOfPoints() const { return this->Number; }
  ///@}
  ///@{
  /// Return the point indices of the corners, three per triangle, and their number.
  const Index* GetCorners() const { return this->Corners.data(); }
  std::size_t GetNumberOfCorners() const { return this->NumberOfCorners; }
  ///@}

private:
  static constexpr int TableBits = 9;

  // A cached point and its index.
  struct Known
  {
    vtkIdType Owner = -1;
    CrossingKey Crossing;
    Index At = 0;
  };

  static std::size_t GetHash(vtkIdType owner, CrossingKey crossing)
  {
    const auto far = static_cast<std::uint64_t>(crossing.GetFar());
    const auto value = static_cast<std::uint64_t>(crossing.GetValue());
    const std::uint64_t sum = 3 * static_cast<std::uint64_t>(owner) + far + value;
    return (0x9E3779B97F4A7C15u * sum) >> (64 - TableBits);
  }

  // Points and Corners may be larger than needed. Number and NumberOfCorners count the elements in
  // use.
  std::vector<ExtractionPoint> Points;
  std::vector<Index> Corners;
  Index Number = 0;
  std::size_t NumberOfCorners = 0;
  std::vector<Known> Recent;
};

}

#endif
