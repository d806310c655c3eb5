// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SpaceTimeTable_h
#define interlume_SpaceTimeTable_h

#include "Cases/CasePieces.h"
#include "Cases/CellSymmetries.h"
#include "Hulls/Polytope.h"

#include "InterlumeIsotablesModule.h"
#include "vtkIsotable.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace interlume
{

/**
 * @class   SpaceTimeTable
 * @brief   the interval table of a four-dimensional cell, whose cases are made at run time
 *
 * For the four-dimensional cube there are 3^16 cases, of which a smooth field visits some ten
 * thousand. The first thread that requests a case makes it for all threads; a reference remains
 * valid as long as the table. Cases that a symmetry of the cell takes into each
 * other are of one kind (the 384 symmetries of the cube leave a few hundred), and share its convex
 * pieces; only they need a convex hull.
 *
 * A case is keyed in base 3, and its points are slots, as in vtkIsotable: vertices, lower
 * crossings, upper crossings. Convex pieces are cut by pulling in the order of vtkIsotable.
 * Case::Simplices is the cut for ascending vertex ranks, as structured grids have it; Cut() does
 * any other. Simplices have the orientation of CasePatch, and their order depends on the key
 * alone.
 *
 * @sa vtkIsotable CasePieces CellSymmetries
 */
class INTERLUMEISOTABLES_EXPORT SpaceTimeTable
{
public:
  using Slot = CasePieces::Slot;
  using Simplex = CasePieces::Simplex;
  /// The pieces of all cases that are one up to symmetry.
  using Kind = CasePieces;
  static constexpr int MaximumNumberOfVertices = 16;
  static constexpr int MaximumNumberOfSlots = 96;
  using RankArray = std::array<std::uint16_t, MaximumNumberOfSlots>;

  struct Case
  {
    /// The simplices of the cut in ascending vertex order.
    std::vector<Simplex> Simplices;
    /// The slots in use, increasing.
    std::vector<Slot> Slots;
    /// The pieces that any other cut is made from, moved by a symmetry of the cell.
    const Kind* Pieces;
    int Symmetry;
  };

  /**
   * Returns the table of the prism of a three-dimensional cell with time, shared by all users in
   * the process. With n vertices of the cell in the order of vtkIsotable (VTK_TETRA, VTK_PYRAMID,
   * VTK_WEDGE, VTK_VOXEL), vertex v < n is v at the first time, v + n at the second. The edges are
   * those of the cell at the first time, those at the second, then the n along time.
   */
  static SpaceTimeTable& Get(vtkIsotable::Shapes shape);

  /// Makes an empty table for a four-dimensional cell with at most 16 vertices, 96 slots, and
  /// coordinates from -32 to 32.
  explicit SpaceTimeTable(const Polytope& cell);
  ~SpaceTimeTable();
  SpaceTimeTable(const SpaceTimeTable&) = delete;
  void operator=(const SpaceTimeTable&) = delete;

  const Polytope& GetCell() const { return this->Cell; }
  int GetNumberOfVertices() const { return static_cast<int>(this->Cell.Vertices.size()); }
  int GetNumberOfEdges() const { return static_cast<int>(this->Edges.size()); }
  /// Returns the two vertices of an edge, the smaller first.
  const std::array<Slot, 2>& GetEdge(int edge) const { return this->Edges[edge]; }

  /**
   * Returns the case of \a key, 0 <= key < 3^vertices. Loops over many cells go through a Reader.
   */
  const Case& GetCase(std::uint32_t key);

  /// Returns the order of slots for vertex ranks 0 ... n-1.
  RankArray GetSlotRanks(const Slot* vertexRanks) const;

  /**
   * Cuts a case in the order given, calling simplex(const Simplex&).
   */
  template <typename Visitor>
  void Cut(const Case& what, const RankArray& ranks, Visitor&& simplex) const
  {
    this->CutPieces(
      *what.Pieces, what.Symmetry, ranks, [](Slot slot) { return slot; }, simplex);
  }

  /// Cuts a case in which slots are one point, as vtkIsotable::CutMerged does it.
  template <typename Visitor>
  void CutMerged(
    const Case& what, const RankArray& ranks, const Slot* same, Visitor&& simplex) const
  {
    this->CutPieces(
      *what.Pieces, what.Symmetry, ranks, [same](Slot slot) { return same[slot]; }, simplex);
  }

  /**
   * Cuts the solids of a case whose slots all have a bit of \a sides in common, see
   * CasePieces::PullSides.
   */
  template <typename SolidVisitor, typename PolygonVisitor>
  void CutSides(const Case& what, const RankArray& ranks, const Slot* same,
    const std::uint8_t* sides, SolidVisitor&& solid, PolygonVisitor&& polygon) const
  {
    const LabelArray labels = this->MakeLabels(
      *what.Pieces, what.Symmetry, ranks, [same](Slot slot) { return same[slot]; }, sides);
    what.Pieces->PullSides(
      labels.data(), this->Symmetries.Get()[what.Symmetry].Reverses, solid, polygon);
  }

  ///@{
  /**
   * The numbers of lookups so far and of those that found their case made, without those of readers
   * that still exist; the numbers of cases and kinds held, and the bytes of both.
   */
  std::uint64_t GetNumberOfLookups() const { return this->Lookups; }
  std::uint64_t GetNumberOfHits() const { return this->Lookups - this->Misses; }
  std::uint64_t GetNumberOfCases() const { return this->Cases.Number; }
  std::uint64_t GetNumberOfKinds() const { return this->Kinds.Number; }
  std::uint64_t GetBytes() const { return this->Bytes; }
  ///@}

  /**
   * Gives one thread access to a table, which must outlive the reader. A reader remembers the cases
   * it met last, so that meeting them again takes no lock and touches no memory that other threads
   * write. It counts for itself, and adds its counts to those of the table when it is destroyed.
   */
  class Reader
  {
  public:
    explicit Reader(SpaceTimeTable& table);
    ~Reader();
    Reader(const Reader&) = delete;
    void operator=(const Reader&) = delete;

    const Case& GetCase(std::uint32_t key)
    {
      ++this->Lookups;
      Entry& entry = this->Entries[(key * 2654435761u) >> (32 - EntryBits)];
      if (entry.Known == nullptr || entry.Key != key)
      {
        entry = { key, &this->Table->FindCase(key, this->Misses) };
      }
      return *entry.Known;
    }

    /// The numbers of lookups so far, and of those that made their case.
    std::uint64_t GetNumberOfLookups() const { return this->Lookups; }
    std::uint64_t GetNumberOfCasesMade() const { return this->Misses; }

  private:
    static constexpr int EntryBits = 12;
    struct Entry
    {
      std::uint32_t Key = 0;
      const Case* Known = nullptr;
    };

    SpaceTimeTable* Table;
    std::unique_ptr<Entry[]> Entries;
    std::uint64_t Lookups = 0;
    std::uint64_t Misses = 0;
  };

private:
  // A map that many threads fill; what it holds stays where it is.
  template <typename Value>
  class Shelf
  {
  public:
    template <typename Maker>
    const Value& Find(std::uint32_t key, Maker&& make)
    {
      Shard& shard = this->Shards[(key * 2654435761u) >> 26];
      std::lock_guard<std::mutex> lock(shard.Mutex);
      std::unique_ptr<const Value>& known = shard.Values[key];
      if (!known)
      {
        known = make();
        this->Number.fetch_add(1, std::memory_order_relaxed);
      }
      return *known;
    }

    std::atomic<std::uint64_t> Number{ 0 };

  private:
    static constexpr int NumberOfShards = 64;
    struct Shard
    {
      std::mutex Mutex;
      std::unordered_map<std::uint32_t, std::unique_ptr<const Value>> Values;
    };
    std::array<Shard, NumberOfShards> Shards;
  };

  using LabelArray = std::array<CasePieces::Label, MaximumNumberOfSlots>;

  // Makes the labels of the slots of a case; \a sides may be null.
  template <typename Rename>
  LabelArray MakeLabels(const Kind& pieces, int symmetry, const RankArray& ranks,
    const Rename& rename, const std::uint8_t* sides) const
  {
    const CellSymmetries::Symmetry& moved = this->Symmetries.Get()[symmetry];
    LabelArray labels;
    for (const Slot slot : pieces.GetSlots())
    {
      const Slot name = rename(moved.Slots[slot]);
      labels[slot] = { ranks[name], name, sides ? sides[moved.Slots[slot]] : std::uint8_t(0) };
    }
    return labels;
  }

  template <typename Rename, typename Visitor>
  void CutPieces(const Kind& pieces, int symmetry, const RankArray& ranks, const Rename& rename,
    Visitor&& simplex) const
  {
    const LabelArray labels = this->MakeLabels(pieces, symmetry, ranks, rename, nullptr);
    pieces.Pull(labels.data(), this->Symmetries.Get()[symmetry].Reverses, simplex);
  }

  const Case& FindCase(std::uint32_t key, std::uint64_t& misses);
  std::unique_ptr<const Case> MakeCase(std::uint32_t key);
  std::unique_ptr<const Kind> MakeKind(std::uint32_t key);

  Polytope Cell;
  Polytope Lifted;
  CellSymmetries Symmetries;
  std::vector<std::array<Slot, 2>> Edges;
  RankArray Ascending;
  Shelf<Kind> Kinds;
  Shelf<Case> Cases;
  std::atomic<std::uint64_t> Lookups{ 0 };
  std::atomic<std::uint64_t> Misses{ 0 };
  std::atomic<std::uint64_t> Bytes{ 0 };
};

}

#endif
