// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ChunkCuts_h
#define interlume_ChunkCuts_h

#include "Cuts/SlotTables.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace interlume
{

/// The tables of the cells of one step.
using ShapeTables = SlotTables<vtkIsotable>;

/**
 * @class   CellCut
 * @brief   a case as it is cut in a cell
 */
struct CellCut
{
  const vtkIsotable::Simplex* Simplices;
  std::size_t NumberOfSimplices;
  const vtkIsotable::Triangle* Triangles;
  std::size_t NumberOfTriangles;
  /// Those that the cut uses.
  const vtkIsotable::Slot* Slots;
  std::size_t NumberOfSlots;
};

/**
 * @class   ChunkCuts
 * @brief   the cases met in a chunk of cells, and the cuts of those for which their table's own
 *          does not serve
 */
class ChunkCuts
{
public:
  using Slot = vtkIsotable::Slot;

  /// A case met in a chunk.
  struct Found
  {
    Found(
      vtkIdType position, int key, std::size_t item, bool isPlain, bool isMerged, bool isInverted)
      : Position(static_cast<std::uint16_t>(position))
      , Key(static_cast<std::uint16_t>(key))
      , Item(static_cast<std::uint16_t>(item))
      , IsPlain(isPlain)
      , IsMerged(isMerged)
      , IsInverted(isInverted)
    {
    }

    /// The place of the cell, counted from the chunk's first.
    std::uint16_t Position;
    std::uint16_t Key;
    std::uint16_t Item;
    /// Whether the table's own cut serves: corners in ascending order, no two slots one point.
    bool IsPlain;
    /// Whether slots were made one.
    bool IsMerged;
    bool IsInverted;
  };

  /// What all cuts have in common.
  struct Kind
  {
    int SimplexSize;
    bool HasBoundaries;
  };

  /// The place where a cut of its own begins.
  struct Place
  {
    std::size_t Simplex = 0;
    std::size_t Triangle = 0;
  };

  /// Room for the slots that a cut uses.
  using SlotRoom = Slot[vtkIsotable::MaximumNumberOfSlots];

  static CellCut GetTableCut(const vtkIsotable::Case& what, const Kind& kind)
  {
    return { what.Simplices.data(), what.Simplices.size(), what.Boundary.data(),
      kind.HasBoundaries ? what.Boundary.size() : 0, what.Slots.data(), what.Slots.size() };
  }

  void Reserve(std::size_t cases) { this->Cases.reserve(cases); }

  /// Notes a case. Cuts are kept in the order of the cases that are not plain.
  void Add(const Found& found) { this->Cases.push_back(found); }

  ///@{
  /// Keep a cut: call Begin, add what there is in it, and call End with what Begin returned.
  Place Begin() const { return { this->Simplices.size(), this->Triangles.size() }; }
  void AddSimplex(const vtkIsotable::Simplex& simplex) { this->Simplices.push_back(simplex); }
  void AddTriangle(const vtkIsotable::Triangle& triangle) { this->Triangles.push_back(triangle); }
  void End(const Place& begin)
  {
    this->Sizes.push_back({ static_cast<std::uint8_t>(this->Simplices.size() - begin.Simplex),
      static_cast<std::uint8_t>(this->Triangles.size() - begin.Triangle) });
  }
  ///@}

  /// Returns the cut that was kept last. Any cut uses all points of the case, but for one in which
  /// slots were made one: of that only the points of simplices that keep all their points are used;
  /// their slots are put into \a slots.
  CellCut GetLast(const Place& begin, const vtkIsotable::Case& what, bool isMerged,
    const Kind& kind, SlotRoom& slots) const
  {
    return this->GetOwnCut(begin, this->Sizes.back(), what, isMerged, kind, slots);
  }

  /// Calls visit(cell, shape, found, cut) for each case, in the order in which they were added;
  /// \a first is the chunk's first cell and getShape(cell) tells its shape.
  template <typename GetShape, typename Visitor>
  void ForEach(vtkIdType first, const ShapeTables& tables, const Kind& kind, GetShape&& getShape,
    Visitor&& visit) const
  {
    auto own = this->Sizes.begin();
    Place place;
    SlotRoom slots;
    for (const Found& found : this->Cases)
    {
      const vtkIdType id = first + found.Position;
      const vtkIsotable::Shapes shape = getShape(id);
      const vtkIsotable::Case& what = tables[shape].GetCase(found.Key);
      const CellCut cut = found.IsPlain
        ? GetTableCut(what, kind)
        : this->GetOwnCut(place, *own, what, found.IsMerged, kind, slots);
      if (!found.IsPlain)
      {
        place.Simplex += own->Simplices;
        place.Triangle += own->Triangles;
        ++own;
      }
      visit(id, shape, found, cut);
    }
  }

  std::size_t GetBytes() const
  {
    return this->Cases.capacity() * sizeof(Found) + this->Sizes.capacity() * sizeof(Size) +
      this->Simplices.capacity() * sizeof(vtkIsotable::Simplex) +
      this->Triangles.capacity() * sizeof(vtkIsotable::Triangle);
  }

private:
  // The size of what a cut of its own left.
  struct Size
  {
    std::uint8_t Simplices;
    std::uint8_t Triangles;
  };

  CellCut GetOwnCut(const Place& begin, Size size, const vtkIsotable::Case& what, bool isMerged,
    const Kind& kind, SlotRoom& slots) const
  {
    CellCut cut{ this->Simplices.data() + begin.Simplex, size.Simplices,
      this->Triangles.data() + begin.Triangle, size.Triangles, what.Slots.data(),
      what.Slots.size() };
    if (!isMerged)
    {
      return cut;
    }
    cut.Slots = slots;
    cut.NumberOfSlots = 0;
    std::uint32_t used = 0;
    const auto use = [&](Slot slot)
    {
      slots[cut.NumberOfSlots] = slot;
      cut.NumberOfSlots += !((used >> slot) & 1);
      used |= std::uint32_t(1) << slot;
    };
    for (std::size_t s = 0; s < cut.NumberOfSimplices; ++s)
    {
      std::for_each_n(cut.Simplices[s].begin(), kind.SimplexSize, use);
    }
    for (std::size_t t = 0; t < cut.NumberOfTriangles; ++t)
    {
      std::for_each_n(cut.Triangles[t].begin(), 3, use);
    }
    return cut;
  }

  std::vector<Found> Cases;
  // The cuts of cases for which that of the table does not serve, one after the other.
  std::vector<Size> Sizes;
  std::vector<vtkIsotable::Simplex> Simplices;
  std::vector<vtkIsotable::Triangle> Triangles;
};

}

#endif
