#ifndef vtkIsotableCache_h
#define vtkIsotableCache_h

#include "InterlumeIsotablesModule.h" // for the export macro
#include "vtkIsotablePolytope.h"      // for the cell

#include <atomic>        // for the statistics
#include <cstdint>       // for the slots
#include <memory>        // for the cases
#include <mutex>         // for the shards
#include <unordered_map> // for the cases
#include <vector>        // for the simplices

/**
 * @class   vtkIsotableCache
 * @brief   an interval table too large to fill: its cases are made at run time and kept
 *
 * For the four-dimensional cube there are 3^16 cases, of which a smooth field visits some ten
 * thousand. A case is made once, by the thread that first asks for it, and shared by all threads; a
 * reference stays valid as long as the cache.
 *
 * A case is keyed in base 3 as in vtkIsotable. Its simplices have dimension + 1 slots each, slots
 * as in vtkIsotable (vertices, lower crossings, upper crossings), one after the other. The order of
 * the points is that of vtkIsotable with ascending vertex ranks.
 *
 * @sa vtkIsotable
 */
class INTERLUMEISOTABLES_EXPORT vtkIsotableCache
{
public:
  using Slot = std::uint8_t;
  using Case = std::vector<Slot>;

  /// For cells of up to five dimensions and 20 vertices.
  explicit vtkIsotableCache(const vtkIsotablePolytope& cell);
  ~vtkIsotableCache();

  /// The cache of the four-dimensional cube, shared by all users in the process.
  static vtkIsotableCache& GetHypercube();

  const vtkIsotablePolytope& GetCell() const { return this->Cell; }
  /// For each edge of the lifted cell its place in the order.
  const std::vector<int>& GetPointRanks() const { return this->PointRanks; }

  /// The case of \a key, 0 <= key < 3^vertices.
  const Case& GetCase(std::uint32_t key);

  ///@{
  /**
   * Lookups so far, those that found their case made, cases held, and their bytes.
   */
  std::uint64_t GetNumberOfLookups() const { return this->Lookups; }
  std::uint64_t GetNumberOfHits() const { return this->Lookups - this->Misses; }
  std::uint64_t GetNumberOfCases() const { return this->Misses; }
  std::uint64_t GetBytes() const { return this->Bytes; }
  ///@}

private:
  Case MakeCase(std::uint32_t key) const;

  static constexpr int NumberOfShards = 64;
  struct Shard
  {
    std::mutex Mutex;
    std::unordered_map<std::uint32_t, std::unique_ptr<const Case>> Cases;
  };

  vtkIsotablePolytope Cell;
  vtkIsotablePolytope Lifted;
  std::vector<int> PointRanks;
  std::unique_ptr<Shard[]> Shards;
  std::atomic<std::uint64_t> Lookups{ 0 };
  std::atomic<std::uint64_t> Misses{ 0 };
  std::atomic<std::uint64_t> Bytes{ 0 };
};

#endif
