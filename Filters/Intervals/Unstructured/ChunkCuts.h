// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ChunkCuts_h
#define interlume_ChunkCuts_h

#include "Cuts/SlotTables.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace interlume
{

/// The case tables for cells at a single time step, one table per shape.
using ShapeTables = SlotTables<vtkIsotable>;

/**
 * @class   CellCut
 * @brief   the simplices and boundary triangles that one case produces in a cell
 */
struct CellCut
{
  const vtkIsotable::Simplex* Simplices;
  std::size_t NumberOfSimplices;
  const vtkIsotable::Triangle* Triangles;
  std::size_t NumberOfTriangles;
  /// The slots that the cut uses.
  const vtkIsotable::Slot* Slots;
  std::size_t NumberOfSlots;
};

/**
 * @class   ChunkCuts
 * @brief   the cases of a chunk of cells, and the cuts that are not stored in the case tables
 */
class ChunkCuts
{
public:
  using Slot = vtkIsotable::Slot;

  /// The case of a cell in the chunk.
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

    /// Index of the cell in the chunk.
    std::uint16_t Position;
    std::uint16_t Key;
    std::uint16_t Item;
    /// If true, the cut stored in the table applies: the corner ids are in ascending order and all
    /// slots are distinct points.
    bool IsPlain;
    /// If true, slots of the same point were merged.
    bool IsMerged;
    bool IsInverted;
  };

  /// Properties that all cuts of an extraction share.
  struct Kind
  {
    int SimplexSize;
    bool HasBoundaries;
  };

  /// Indices of the first simplex and triangle of a stored cut.
  struct CutStart
  {
    std::size_t Simplex = 0;
    std::size_t Triangle = 0;
  };

  using SlotBuffer = Slot[vtkIsotable::MaximumNumberOfSlots];

  static CellCut GetTableCut(const vtkIsotable::Case& what, const Kind& kind)
  {
    return { what.Simplices.data(), what.Simplices.size(), what.Boundary.data(),
      kind.HasBoundaries ? what.Boundary.size() : 0, what.Slots.data(), what.Slots.size() };
  }

  void Reserve(std::size_t cases) { this->Cases.reserve(cases); }

  /// Adds a case. The cuts of the cases that are not plain must be stored in the same order.
  void Add(const Found& found) { this->Cases.push_back(found); }

  ///@{
  /// Store a cut: call Begin(), add the simplices and triangles, and call End() with the result of
  /// Begin().
  CutStart Begin() const { return { this->Simplices.size(), this->Triangles.size() }; }
  void AddSimplex(const vtkIsotable::Simplex& simplex) { this->Simplices.push_back(simplex); }
  void AddTriangle(const vtkIsotable::Triangle& triangle) { this->Triangles.push_back(triangle); }
  void End(const CutStart& begin)
  {
    this->Sizes.push_back({ static_cast<std::uint8_t>(this->Simplices.size() - begin.Simplex),
      static_cast<std::uint8_t>(this->Triangles.size() - begin.Triangle) });
  }
  ///@}

  /// Returns the cut stored last. If slots were merged, the cut uses only the points of the
  /// remaining simplices, and their slots are written to \a slots. Otherwise it uses all points of
  /// the case.
  CellCut GetLast(const CutStart& begin, const vtkIsotable::Case& what, bool isMerged,
    const Kind& kind, SlotBuffer& slots) const
  {
    return this->GetOwnCut(begin, this->Sizes.back(), what, isMerged, kind, slots);
  }

  /// Calls visit(cell, shape, found, cut) for each case in the order of addition. \a first is the
  /// id of the first cell of the chunk, and getShape(cell) returns the shape of a cell.
  template <typename GetShape, typename Visitor>
  void ForEach(vtkIdType first, const ShapeTables& tables, const Kind& kind, GetShape&& getShape,
    Visitor&& visit) const
  {
    auto own = this->Sizes.begin();
    CutStart start;
    SlotBuffer slots;
    for (const Found& found : this->Cases)
    {
      const vtkIdType id = first + found.Position;
      const vtkIsotable::Shapes shape = getShape(id);
      const vtkIsotable::Case& what = tables[shape].GetCase(found.Key);
      const CellCut cut = found.IsPlain
        ? GetTableCut(what, kind)
        : this->GetOwnCut(start, *own, what, found.IsMerged, kind, slots);
      if (!found.IsPlain)
      {
        start.Simplex += own->Simplices;
        start.Triangle += own->Triangles;
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
  // Number of simplices and triangles of a stored cut.
  struct Size
  {
    std::uint8_t Simplices;
    std::uint8_t Triangles;
  };

  CellCut GetOwnCut(const CutStart& begin, Size size, const vtkIsotable::Case& what, bool isMerged,
    const Kind& kind, SlotBuffer& slots) const
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
  // The stored cuts, concatenated in the order of their cases.
  std::vector<Size> Sizes;
  std::vector<vtkIsotable::Simplex> Simplices;
  std::vector<vtkIsotable::Triangle> Triangles;
};

}

#endif
