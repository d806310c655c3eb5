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
 * @brief   interval table of a four-dimensional cell, with cases computed on demand
 *
 * The four-dimensional cube has 3^16 cases. A smooth field uses about ten thousand of them. The
 * first thread that requests a case computes it for all threads. A reference to a case remains
 * valid as long as the table exists. Cases that are equal up to a symmetry of the cell share their
 * convex pieces, so a convex hull is computed only once per symmetry class. The 384 symmetries of
 * the cube reduce the cases to a few hundred classes.
 *
 * Keys and slots are as in vtkIsotable: keys in base 3, slots for vertices, lower and upper edge
 * points. Convex pieces are triangulated by pulling in the order of vtkIsotable. Case::Simplices is
 * the triangulation for ascending vertex ranks, as on structured grids. Cut() computes the
 * triangulation for other ranks. Simplices are oriented as in CasePatch::IsPositive. Their order
 * depends only on the key.
 *
 * @sa vtkIsotable CasePieces CellSymmetries
 */
class INTERLUMEISOTABLES_EXPORT SpaceTimeTable
{
public:
  using Slot = CasePieces::Slot;
  using Simplex = CasePieces::Simplex;
  /// Pieces shared by all cases of one symmetry class.
  using Kind = CasePieces;
  static constexpr int NumberOfShapes = vtkIsotable::NUMBER_OF_SOLIDS;
  static constexpr int MaximumNumberOfVertices = 16;
  static constexpr int MaximumNumberOfSlots = 96;
  using RankArray = std::array<std::uint16_t, MaximumNumberOfSlots>;

  struct Case
  {
    /// Simplices of the triangulation for ascending vertex ranks.
    std::vector<Simplex> Simplices;
    /// Slots in use, in increasing order.
    std::vector<Slot> Slots;
    /// Pieces of the symmetry class. The symmetry with index \a Symmetry maps them to this case.
    const Kind* Pieces;
    int Symmetry;
  };

  /**
   * Returns the table of the product of a three-dimensional cell and a time interval, shared by all
   * users in the process. The cell has n vertices in the order of its VTK cell (VTK_TETRA,
   * VTK_PYRAMID, VTK_WEDGE or VTK_VOXEL). Vertices v and v + n of the product are vertex v of the
   * cell at the first and at the second time, respectively. The edges of the product are the edges
   * of the cell at the first time, those at the second time, then the n edges along time.
   */
  static SpaceTimeTable& Get(vtkIsotable::Shapes shape);

  /// Creates an empty table for a four-dimensional cell with at most 16 vertices, 96 slots, and
  /// coordinates in -32 ... 32.
  explicit SpaceTimeTable(const Polytope& cell);
  ~SpaceTimeTable();
  SpaceTimeTable(const SpaceTimeTable&) = delete;
  void operator=(const SpaceTimeTable&) = delete;

  const Polytope& GetCell() const { return this->Cell; }
  int GetNumberOfVertices() const { return static_cast<int>(this->Cell.Vertices.size()); }
  int GetNumberOfEdges() const { return static_cast<int>(this->Edges.size()); }
  /// Returns the two vertices of an edge, smaller first.
  const std::array<Slot, 2>& GetEdge(int edge) const { return this->Edges[edge]; }

  /**
   * Returns the case of \a key, 0 <= key < 3^n for n vertices. Use a Reader in loops over many
   * cells.
   */
  const Case& GetCase(std::uint32_t key);

  /// Returns the ranks of the slots. \a vertexRanks is a permutation of the vertex indices.
  RankArray GetSlotRanks(const Slot* vertexRanks) const;

  /**
   * Triangulates a case in the order of \a ranks. Calls simplex(const Simplex&) for each simplex.
   */
  template <typename Visitor>
  void Cut(const Case& source, const RankArray& ranks, Visitor&& simplex) const
  {
    this->CutPieces(
      *source.Pieces, source.Symmetry, ranks, [](Slot slot) { return slot; }, simplex);
  }

  /// Triangulates a case in which some slots coincide. See vtkIsotable::CutMerged.
  template <typename Visitor>
  void CutMerged(
    const Case& source, const RankArray& ranks, const Slot* same, Visitor&& simplex) const
  {
    this->CutPieces(
      *source.Pieces, source.Symmetry, ranks, [same](Slot slot) { return same[slot]; }, simplex);
  }

  /**
   * Triangulates those solids of a case whose slots all have a bit of \a sides in common. See
   * CasePieces::TriangulateSides.
   */
  template <typename SolidVisitor, typename PolygonVisitor>
  void CutSides(const Case& source, const RankArray& ranks, const Slot* same,
    const std::uint8_t* sides, SolidVisitor&& solid, PolygonVisitor&& polygon) const
  {
    const LabelArray labels = this->MakeLabels(
      *source.Pieces, source.Symmetry, ranks, [same](Slot slot) { return same[slot]; }, sides);
    source.Pieces->TriangulateSides(
      labels.data(), this->Symmetries.Get()[source.Symmetry].Reverses, solid, polygon);
  }

  ///@{
  /**
   * Return the number of lookups and of lookups that found an existing case, the number of stored
   * cases and symmetry classes, and their size in bytes. Lookups by readers that still exist are
   * not included.
   */
  std::uint64_t GetNumberOfLookups() const { return this->Lookups; }
  std::uint64_t GetNumberOfHits() const { return this->Lookups - this->Misses; }
  std::uint64_t GetNumberOfCases() const { return this->Cases.Number; }
  std::uint64_t GetNumberOfSymmetryClasses() const { return this->Kinds.Number; }
  std::uint64_t GetBytes() const { return this->Bytes; }
  ///@}

  /**
   * Gives one thread access to a table, which must outlive the reader. A reader caches recent
   * cases, so that repeated lookups take no lock and touch no memory that other threads write. On
   * destruction, it adds its lookup counts to those of the table.
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

    /// Return the number of lookups, and of lookups that computed their case.
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
  // A concurrent map. Its values never move.
  template <typename Value>
  class ConcurrentMap
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

  // Computes the labels of the slots of a case. \a sides may be null.
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
  std::unique_ptr<const Kind> MakeClassPieces(std::uint32_t key);

  Polytope Cell;
  Polytope Lifted;
  CellSymmetries Symmetries;
  std::vector<std::array<Slot, 2>> Edges;
  RankArray Ascending;
  ConcurrentMap<Kind> Kinds;
  ConcurrentMap<Case> Cases;
  std::atomic<std::uint64_t> Lookups{ 0 };
  std::atomic<std::uint64_t> Misses{ 0 };
  std::atomic<std::uint64_t> Bytes{ 0 };
};

}

#endif
