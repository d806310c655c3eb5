#include "vtkUnstructuredExtraction.h"

#include "vtkCellArray.h"
#include "vtkCellCorners.h"
#include "vtkCellOrientation.h"
#include "vtkCrossingKey.h"
#include "vtkExtractionCell.h"
#include "vtkExtractionDispatch.h"
#include "vtkExtractionIndex.h"
#include "vtkExtractionScalars.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
using Code = vtkExtractionValues::Code;
using Slot = vtkIsotable::Slot;

constexpr vtkIdType ChunkSize = 256 * vtkExtractionIndex::RunLength;

// A case met in a chunk of cells.
struct Found
{
  vtkIdType Cell;
  std::int32_t Item;
  std::uint16_t Key;
  // Whether the table's own cut serves: corners in ascending order, and no two slots one point.
  bool IsPlain;
  // Otherwise where the case's own cut is in the chunk.
  std::uint32_t FirstSimplex;
  std::uint32_t FirstTriangle;
};

struct Crossing
{
  vtkIdType Owner;
  vtkCrossingKey Key;
};

// What the counting pass leaves of a chunk for the writing pass.
struct Chunk
{
  std::vector<Found> Cases;
  std::vector<Crossing> Crossings;
  // The cuts of cases for which that of the table does not serve, one after the other.
  std::vector<vtkIsotable::Simplex> CutSimplices;
  std::vector<vtkIsotable::Triangle> CutTriangles;
  vtkIdType Simplices = 0;
  vtkIdType Triangles = 0;
  vtkExtractionReport Report;
};

// The corners of a cell in the order of its table.
struct Corners
{
  vtkCellCorners What;
  vtkIdType Ids[8];
  Code Codes[8];
  Code Lowest;
  Code Highest;
};

// The ends of a crossing's edge, by slot.
struct SlotEnds
{
  Slot A;
  Slot B;
  Slot Kind;
};

// The cell array's numbers, whatever their storage.
class Connectivity
{
public:
  explicit Connectivity(vtkCellArray* cells)
  {
    this->Take(cells->GetOffsetsArray(), this->Offsets32, this->Offsets64);
    this->Take(cells->GetConnectivityArray(), this->Ids32, this->Ids64);
  }

  void GetCorners(vtkIdType cell, int number, vtkIdType* ids) const
  {
    const vtkIdType first = this->Offsets64 ? static_cast<vtkIdType>(this->Offsets64[cell])
                                            : static_cast<vtkIdType>(this->Offsets32[cell]);
    this->Ids64 ? Copy(this->Ids64 + first, number, ids) : Copy(this->Ids32 + first, number, ids);
  }

private:
  // A copy of a known length is a few moves, one of unknown length a call.
  template <typename Stored>
  static void Copy(const Stored* from, int number, vtkIdType* ids)
  {
    switch (number)
    {
      case 4:
        std::copy_n(from, 4, ids);
        break;
      case 5:
        std::copy_n(from, 5, ids);
        break;
      case 6:
        std::copy_n(from, 6, ids);
        break;
      default:
        std::copy_n(from, 8, ids);
    }
  }

  void Take(vtkDataArray* array, const vtkTypeInt32*& narrow, const vtkTypeInt64*& wide)
  {
    if (vtkTypeInt32Array* narrowArray = vtkTypeInt32Array::SafeDownCast(array))
    {
      narrow = narrowArray->GetPointer(0);
    }
    else if (vtkTypeInt64Array* wideArray = vtkTypeInt64Array::SafeDownCast(array))
    {
      wide = wideArray->GetPointer(0);
    }
    else
    {
      // Newer versions of VTK may store offsets of equal cells as a formula.
      vtkNew<vtkTypeInt64Array> copy;
      copy->DeepCopy(array);
      this->Copies.push_back(copy.GetPointer());
      wide = copy->GetPointer(0);
    }
  }

  const vtkTypeInt32* Offsets32 = nullptr;
  const vtkTypeInt64* Offsets64 = nullptr;
  const vtkTypeInt32* Ids32 = nullptr;
  const vtkTypeInt64* Ids64 = nullptr;
  std::vector<vtkSmartPointer<vtkTypeInt64Array>> Copies;
};

template <typename T>
class Extractor
{
public:
  Extractor(const vtkExtractionContext& context, vtkUnstructuredGrid* grid, const T* scalars,
    vtkExtractionMesh& mesh)
    : Context(context)
    , Values(*context.Values)
    , Scalars(scalars, *context.Values)
    , Grid(grid)
    , Cells(grid->GetCells())
    , GlobalIds(vtkIdTypeArray::SafeDownCast(grid->GetPointData()->GetGlobalIds()))
    , Mesh(mesh)
    , Orientation(grid)
    , NumberOfPoints(grid->GetNumberOfPoints())
    , NumberOfCells(grid->GetNumberOfCells())
    , SimplexSize(context.GetSimplexSize())
  {
    for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
    {
      this->CornersOfType.push_back(vtkCellCorners::Of(type));
    }
    for (int shape = 0; shape < vtkIsotable::NUMBER_OF_SHAPES; ++shape)
    {
      this->Tables[shape] =
        &vtkIsotable::Get(this->Values.GetKind(), static_cast<vtkIsotable::Shapes>(shape));
      const vtkIsotable& table = *this->Tables[shape];
      const int n = table.GetNumberOfVertices();
      const int m = table.GetNumberOfEdges();
      for (int slot = n; slot < n + 2 * m; ++slot)
      {
        const auto& edge = table.GetEdge((slot - n) % m);
        this->Ends[shape][slot] = { edge[0], edge[1], static_cast<Slot>((slot - n) / m) };
      }
    }
    if (grid->IsHomogeneous())
    {
      this->OnlyType = grid->GetCellType(0);
    }
  }

  bool Execute()
  {
    const vtkIdType chunks = (this->NumberOfCells + ChunkSize - 1) / ChunkSize;
    this->Codes.resize(this->NumberOfPoints);
    this->Used.reset(new std::atomic<std::uint8_t>[this->NumberOfPoints]());
    this->Chunks.resize(chunks);
    const bool counted =
      this->Context.Run(this->NumberOfPoints, 0.0, 0.05,
        [this](vtkIdType first, vtkIdType last)
        { this->Scalars.Classify(first, last - first, this->Codes.data() + first); }) &&
      this->Context.Run(chunks, 0.05, 0.35,
        [this](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType chunk = first; chunk < last; ++chunk)
          {
            this->CountChunk(chunk);
          }
        });
    if (!counted)
    {
      return false;
    }
    this->NumberPoints();
    this->Allocate();
    const bool written =
      this->Context.Run(this->NumberOfPoints, 0.45, 0.5,
        [this](vtkIdType first, vtkIdType last) { this->WritePoints(first, last); }) &&
      this->Context.Run(chunks, 0.5, 0.8,
        [this](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType chunk = first; chunk < last; ++chunk)
          {
            this->WriteChunk(chunk);
          }
        });
    return written;
  }

private:
  void ReadCorners(vtkIdType cell, Corners& corners) const
  {
    this->Cells.GetCorners(cell, corners.What.NumberOfCorners, corners.Ids);
    if (corners.What.Turned)
    {
      std::swap(corners.Ids[2], corners.Ids[3]);
      std::swap(corners.Ids[6], corners.Ids[7]);
    }
    Code lowest = std::numeric_limits<Code>::max();
    Code highest = 0;
    for (int v = 0; v < corners.What.NumberOfCorners; ++v)
    {
      const Code code = this->Codes[corners.Ids[v]];
      corners.Codes[v] = code;
      lowest = std::min(lowest, code);
      highest = std::max(highest, code);
    }
    corners.Lowest = lowest;
    corners.Highest = highest;
  }

  // Turns a cell by a symmetry of its shape so that its first corners are in ascending order: most
  // cells of most meshes then have their corners in the order of the table's own cut. The
  // orientation is taken from the coordinates, so a reflection does no harm.
  void TurnCorners(Corners& corners) const
  {
    vtkIdType* ids = corners.Ids;
    const auto before = [this](vtkIdType a, vtkIdType b)
    { return this->GetOrder(a) < this->GetOrder(b); };
    if (this->IsAscending(corners))
    {
      return;
    }
    switch (corners.What.Shape)
    {
      case vtkIsotable::TETRAHEDRON:
        std::sort(ids, ids + 4, before);
        break;
      case vtkIsotable::PYRAMID:
        std::rotate(ids, std::min_element(ids, ids + 4, before), ids + 4);
        if (before(ids[3], ids[1]))
        {
          std::swap(ids[1], ids[3]);
        }
        break;
      case vtkIsotable::WEDGE:
        TurnWedge(ids, before);
        break;
      default:
        TurnHexahedron(ids, before);
    }
    for (int v = 0; v < corners.What.NumberOfCorners; ++v)
    {
      corners.Codes[v] = this->Codes[corners.Ids[v]];
    }
  }

  template <typename Before>
  static void TurnWedge(vtkIdType* ids, Before&& before)
  {
    if (std::min_element(ids, ids + 6, before) - ids >= 3)
    {
      std::swap_ranges(ids, ids + 3, ids + 3);
    }
    // The same exchanges in both triangles.
    const auto order = [&](int a, int b)
    {
      if (before(ids[b], ids[a]))
      {
        std::swap(ids[a], ids[b]);
        std::swap(ids[a + 3], ids[b + 3]);
      }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
  }

  template <typename Before>
  static void TurnHexahedron(vtkIdType* ids, Before&& before)
  {
    const int corner = static_cast<int>(std::min_element(ids, ids + 8, before) - ids);
    int axes[3] = { 1, 2, 4 };
    std::sort(
      axes, axes + 3, [&](int a, int b) { return before(ids[corner ^ a], ids[corner ^ b]); });
    vtkIdType turned[8];
    for (int v = 0; v < 8; ++v)
    {
      turned[v] =
        ids[corner ^ ((v & 1) ? axes[0] : 0) ^ ((v & 2) ? axes[1] : 0) ^ ((v & 4) ? axes[2] : 0)];
    }
    std::copy_n(turned, 8, ids);
  }

  const vtkCellCorners& GetCellCorners(vtkIdType cell) const
  {
    return this
      ->CornersOfType[this->OnlyType >= 0 ? this->OnlyType : this->Grid->GetCellType(cell)];
  }

  bool IsBlanked(vtkIdType cell, const Corners& corners) const
  {
    return this->Context.IsCellBlanked(cell) ||
      (this->Context.PointGhosts &&
        std::any_of(corners.Ids, corners.Ids + corners.What.NumberOfCorners,
          [this](vtkIdType id) { return this->Context.IsPointBlanked(id); }));
  }

  // Whether a cell can give output; if not, the reason is counted.
  bool Accept(vtkIdType cell, Corners& corners, vtkExtractionReport& report) const
  {
    corners.What = this->GetCellCorners(cell);
    if (!corners.What.HasTable())
    {
      (corners.What.Kind == vtkCellCorners::LOWER_DIMENSIONAL ? report.LowerDimensionalCells
                                                              : report.UnsupportedCells) += 1;
      return false;
    }
    this->ReadCorners(cell, corners);
    if (this->Context.HasBlanking() && this->IsBlanked(cell, corners))
    {
      ++report.BlankedCells;
      return false;
    }
    if (corners.Highest == this->Values.GetNonFiniteCode())
    {
      ++report.NonFiniteCells;
      return false;
    }
    report.LinearizedCells += corners.What.Kind == vtkCellCorners::HIGHER_ORDER;
    return true;
  }

  void CountChunk(vtkIdType number)
  {
    Chunk& chunk = this->Chunks[number];
    const vtkIdType end = std::min((number + 1) * ChunkSize, this->NumberOfCells);
    Corners corners;
    for (vtkIdType first = number * ChunkSize; first < end; first += vtkExtractionIndex::RunLength)
    {
      if (this->Context.Index &&
        !this->Context.Index->IsRunActive(first / vtkExtractionIndex::RunLength))
      {
        continue;
      }
      const vtkIdType last = std::min(first + vtkExtractionIndex::RunLength, end);
      chunk.Report.CellsVisited += last - first;
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        if (this->Accept(cell, corners, chunk.Report) && this->IsNearItem(corners))
        {
          this->TurnCorners(corners);
          this->CountCell(cell, corners, chunk);
        }
      }
    }
  }

  bool IsNearItem(const Corners& corners) const
  {
    const auto& items = this->Values.GetItems();
    return std::any_of(items.begin(), items.end(),
      [&](const vtkExtractionValues::Item& item)
      { return !this->Values.IsOutside(item, corners.Lowest, corners.Highest); });
  }

  void CountCell(vtkIdType cell, const Corners& corners, Chunk& chunk)
  {
    const int base = this->Values.GetBase();
    const auto& items = this->Values.GetItems();
    const vtkIdType before = chunk.Simplices;
    for (std::size_t item = 0; item < items.size(); ++item)
    {
      if (this->Values.IsOutside(items[item], corners.Lowest, corners.Highest))
      {
        continue;
      }
      int key = 0;
      for (int v = corners.What.NumberOfCorners - 1; v >= 0; --v)
      {
        key = key * base + items[item].GetDigit(corners.Codes[v]);
      }
      const bool isPlain =
        this->IsAscending(corners) && !this->HasEqualPoints(corners, items[item]);
      this->CountCase({ cell, static_cast<std::int32_t>(item), static_cast<std::uint16_t>(key),
                        isPlain, static_cast<std::uint32_t>(chunk.CutSimplices.size()),
                        static_cast<std::uint32_t>(chunk.CutTriangles.size()) },
        corners, chunk);
    }
    chunk.Report.CellsWithOutput += chunk.Simplices != before;
  }

  // Whether two slots of a cell may be one point: by a value equal to an isovalue, or since two
  // corners are one point.
  bool HasEqualPoints(const Corners& corners, const vtkExtractionValues::Item& item) const
  {
    Code ties = item.Lower == item.Upper;
    for (int v = 0; v < corners.What.NumberOfCorners; ++v)
    {
      ties |= corners.Codes[v];
    }
    return vtkExtractionValues::IsTie(ties) ||
      (!this->IsAscending(corners) &&
        vtkExtractionCell::IsCollapsed(corners.Ids, corners.What.NumberOfCorners));
  }

  // For each slot of a case the first slot that is the same point.
  void IdentifySlots(const Corners& corners, const vtkExtractionValues::Item& item,
    const vtkIsotable::Case& what, Slot* same) const
  {
    const vtkIsotable& table = *this->Tables[corners.What.Shape];
    const bool hasEqualCorners =
      vtkExtractionCell::IsCollapsed(corners.Ids, corners.What.NumberOfCorners);
    for (const Slot slot : what.Slots)
    {
      same[slot] = vtkExtractionCell::Identify(table, item, corners.Codes, slot);
      for (Slot earlier = 0; hasEqualCorners && earlier < same[slot]; ++earlier)
      {
        if (this->IsSamePoint(corners, item, earlier, same[slot]))
        {
          same[slot] = earlier;
        }
      }
    }
  }

  bool IsSamePoint(
    const Corners& corners, const vtkExtractionValues::Item& item, Slot a, Slot b) const
  {
    const vtkIsotable& table = *this->Tables[corners.What.Shape];
    const int n = table.GetNumberOfVertices();
    if (a < n || b < n)
    {
      return a < n && b < n && corners.Ids[a] == corners.Ids[b];
    }
    vtkIdType ownerA;
    vtkIdType ownerB;
    const vtkCrossingKey keyA = this->GetCrossing(item, corners, a, ownerA);
    return keyA == this->GetCrossing(item, corners, b, ownerB) && ownerA == ownerB;
  }

  void CountCase(const Found& found, const Corners& corners, Chunk& chunk)
  {
    const vtkIsotable& table = *this->Tables[corners.What.Shape];
    const vtkIsotable::Case& what = table.GetCase(found.Key);
    const auto& item = this->Values.GetItems()[found.Item];
    if (found.IsPlain)
    {
      for (const Slot slot : what.Slots)
      {
        this->Enter(table, item, corners, slot, chunk);
      }
      chunk.Simplices += what.Simplices.size();
      chunk.Triangles += this->Context.GenerateBoundaries ? what.Boundary.size() : 0;
    }
    else
    {
      this->CutCase(what, corners, item, chunk);
      // Only the points of simplices that keep all their points are made.
      std::uint32_t used = 0;
      for (std::size_t s = found.FirstSimplex; s < chunk.CutSimplices.size(); ++s)
      {
        for (int p = 0; p < this->SimplexSize; ++p)
        {
          used |= std::uint32_t(1) << chunk.CutSimplices[s][p];
        }
      }
      for (std::size_t t = found.FirstTriangle; t < chunk.CutTriangles.size(); ++t)
      {
        for (int p = 0; p < 3; ++p)
        {
          used |= std::uint32_t(1) << chunk.CutTriangles[t][p];
        }
      }
      for (Slot slot = 0; used != 0; ++slot, used >>= 1)
      {
        if (used & 1)
        {
          this->Enter(table, item, corners, slot, chunk);
        }
      }
      chunk.Simplices += chunk.CutSimplices.size() - found.FirstSimplex;
      chunk.Triangles += chunk.CutTriangles.size() - found.FirstTriangle;
    }
    chunk.Cases.push_back(found);
  }

  // Cuts a case in the global order, with slots that are the same point made one, and keeps what
  // has not collapsed.
  void CutCase(const vtkIsotable::Case& what, const Corners& corners,
    const vtkExtractionValues::Item& item, Chunk& chunk) const
  {
    const vtkIsotable& table = *this->Tables[corners.What.Shape];
    Slot same[vtkIsotable::MaximumNumberOfSlots];
    std::iota(same, same + vtkIsotable::MaximumNumberOfSlots, Slot(0));
    const bool hasEqualPoints = this->HasEqualPoints(corners, item);
    if (hasEqualPoints)
    {
      this->IdentifySlots(corners, item, what, same);
    }
    const auto simplex = [&](const vtkIsotable::Simplex& s)
    {
      const vtkIsotable::Simplex points{ { same[s[0]], same[s[1]], same[s[2]],
        this->SimplexSize == 4 ? same[s[3]] : Slot(0) } };
      if (hasEqualPoints && vtkExtractionCell::IsCollapsed(points.data(), this->SimplexSize))
      {
        ++chunk.Report.CollapsedSimplices;
        return;
      }
      chunk.CutSimplices.push_back(points);
    };
    const auto boundary = [&](const vtkIsotable::Triangle& t)
    {
      const vtkIsotable::Triangle points{ { same[t[0]], same[t[1]], same[t[2]], t[3] } };
      if (this->Context.GenerateBoundaries && !vtkExtractionCell::IsCollapsed(points.data(), 3))
      {
        chunk.CutTriangles.push_back(points);
      }
    };
    Slot ranks[8];
    this->RankCorners(corners, ranks);
    table.Cut(what, table.GetSlotRanks(ranks), simplex, boundary);
  }

  vtkIdType GetOrder(vtkIdType point) const
  {
    return this->GlobalIds ? this->GlobalIds->GetValue(point) : point;
  }

  bool IsAscending(const Corners& corners) const
  {
    bool ascending = true;
    for (int v = 1; v < corners.What.NumberOfCorners; ++v)
    {
      ascending &= this->GetOrder(corners.Ids[v - 1]) < this->GetOrder(corners.Ids[v]);
    }
    return ascending;
  }

  void RankCorners(const Corners& corners, Slot* ranks) const
  {
    const int n = corners.What.NumberOfCorners;
    std::fill(ranks, ranks + n, Slot(0));
    for (int a = 0; a < n; ++a)
    {
      for (int b = a + 1; b < n; ++b)
      {
        // Of equal ids, in a degenerate cell, the first corner is the lower.
        const bool isLater = this->GetOrder(corners.Ids[b]) < this->GetOrder(corners.Ids[a]);
        ++ranks[isLater ? a : b];
      }
    }
  }

  // Notes that the point of a slot is needed.
  void Enter(const vtkIsotable& table, const vtkExtractionValues::Item& item,
    const Corners& corners, Slot slot, Chunk& chunk)
  {
    if (slot < table.GetNumberOfVertices())
    {
      this->Used[corners.Ids[slot]].store(1, std::memory_order_relaxed);
      return;
    }
    vtkIdType owner;
    const vtkCrossingKey key = this->GetCrossing(item, corners, slot, owner);
    chunk.Crossings.push_back({ owner, key });
  }

  vtkCrossingKey GetCrossing(const vtkExtractionValues::Item& item, const Corners& corners,
    Slot slot, vtkIdType& owner) const
  {
    const SlotEnds& ends = this->Ends[corners.What.Shape][slot];
    const vtkIdType a = corners.Ids[ends.A];
    const vtkIdType b = corners.Ids[ends.B];
    owner = std::min(a, b);
    return { std::max(a, b), ends.Kind == 0 ? item.Lower : item.Upper };
  }

  // Sorts the crossings into lists by owner, and numbers all output points.
  void NumberPoints()
  {
    std::unique_ptr<std::atomic<std::uint32_t>[]> counts(
      new std::atomic<std::uint32_t>[this->NumberOfPoints]());
    const vtkIdType chunks = static_cast<vtkIdType>(this->Chunks.size());
    const auto forEachCrossing = [this, chunks](auto&& visit)
    {
      vtkSMPTools::For(0, chunks,
        [&](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType chunk = first; chunk < last; ++chunk)
          {
            for (const Crossing& crossing : this->Chunks[chunk].Crossings)
            {
              visit(crossing);
            }
          }
        });
    };
    forEachCrossing([&counts](const Crossing& crossing)
      { counts[crossing.Owner].fetch_add(1, std::memory_order_relaxed); });
    this->ListStarts.resize(this->NumberOfPoints + 1);
    this->ListStarts[0] = 0;
    for (vtkIdType p = 0; p < this->NumberOfPoints; ++p)
    {
      this->ListStarts[p + 1] = this->ListStarts[p] + counts[p].load(std::memory_order_relaxed);
    }
    this->Lists.resize(this->ListStarts.back());
    forEachCrossing(
      [this, &counts](const Crossing& crossing)
      {
        const std::uint32_t left = counts[crossing.Owner].fetch_sub(1, std::memory_order_relaxed);
        this->Lists[this->ListStarts[crossing.Owner] + left - 1] = crossing.Key;
      });
    this->NoteWorkingBytes(this->NumberOfPoints * sizeof(counts[0]));
    for (Chunk& chunk : this->Chunks)
    {
      std::vector<Crossing>().swap(chunk.Crossings);
    }
    this->FirstCrossings.resize(this->NumberOfPoints + 1);
    vtkSMPTools::For(0, this->NumberOfPoints,
      [this](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType p = first; p < last; ++p)
        {
          const auto begin = this->Lists.begin() + this->ListStarts[p];
          const auto end = this->Lists.begin() + this->ListStarts[p + 1];
          if (end - begin > 1)
          {
            std::sort(begin, end);
            this->FirstCrossings[p] = std::unique(begin, end) - begin;
          }
          else
          {
            this->FirstCrossings[p] = end - begin;
          }
        }
      });
    vtkIdType total = 0;
    for (vtkIdType p = 0; p < this->NumberOfPoints; ++p)
    {
      total += this->Used[p].load(std::memory_order_relaxed);
      total += std::exchange(this->FirstCrossings[p], total);
    }
    this->FirstCrossings[this->NumberOfPoints] = total;
  }

  void Allocate()
  {
    vtkIdType simplices = 0;
    vtkIdType triangles = 0;
    for (Chunk& chunk : this->Chunks)
    {
      std::swap(chunk.Simplices, simplices);
      std::swap(chunk.Triangles, triangles);
      simplices += chunk.Simplices;
      triangles += chunk.Triangles;
      this->Context.Report->Add(chunk.Report);
    }
    this->Mesh.Points.resize(this->FirstCrossings.back());
    vtkNew<vtkTypeInt64Array> connectivity;
    connectivity->SetNumberOfValues(simplices * this->SimplexSize);
    this->Simplices = connectivity->GetPointer(0);
    this->Mesh.Connectivity = connectivity;
    this->Mesh.ItemIds->SetNumberOfValues(simplices);
    this->Mesh.Triangles.resize(triangles);
    this->Mesh.TriangleItemIds->SetNumberOfValues(triangles);
    this->Mesh.TriangleSides->SetNumberOfValues(triangles);
    if (this->Context.KeepCellIds)
    {
      this->Mesh.CellIds.resize(simplices);
      this->Mesh.TriangleCellIds.resize(triangles);
    }
    this->NoteWorkingBytes(this->FirstCrossings.capacity() * sizeof(vtkIdType) +
      this->Mesh.Points.capacity() * sizeof(vtkExtractionPoint));
  }

  void NoteWorkingBytes(std::size_t more) const
  {
    std::size_t bytes = more + this->Codes.capacity() * sizeof(Code) + this->NumberOfPoints +
      this->ListStarts.capacity() * sizeof(vtkIdType) +
      this->Lists.capacity() * sizeof(vtkCrossingKey);
    for (const Chunk& chunk : this->Chunks)
    {
      bytes += chunk.Cases.capacity() * sizeof(Found) +
        chunk.Crossings.capacity() * sizeof(Crossing) +
        chunk.CutSimplices.capacity() * sizeof(vtkIsotable::Simplex) +
        chunk.CutTriangles.capacity() * sizeof(vtkIsotable::Triangle);
    }
    this->Context.NoteWorkingBytes(bytes);
  }

  void WritePoints(vtkIdType first, vtkIdType last)
  {
    for (vtkIdType p = first; p < last; ++p)
    {
      vtkExtractionPoint* out = this->Mesh.Points.data() + this->FirstCrossings[p];
      if (this->Used[p].load(std::memory_order_relaxed))
      {
        out[-1] = { p, p, 0.0 };
      }
      // The next owner's grid point comes before its first crossing.
      const vtkIdType number = this->FirstCrossings[p + 1] - this->FirstCrossings[p] -
        (p + 1 < this->NumberOfPoints ? this->Used[p + 1].load(std::memory_order_relaxed) : 0);
      const vtkCrossingKey* keys = this->Lists.data() + this->ListStarts[p];
      for (vtkIdType c = 0; c < number; ++c)
      {
        out[c] = this->Scalars.Cross(p, keys[c].GetFar(), keys[c].GetValue());
      }
    }
  }

  vtkIdType GetId(const vtkIsotable& table, const vtkExtractionValues::Item& item,
    const Corners& corners, Slot slot) const
  {
    if (slot < table.GetNumberOfVertices())
    {
      return this->FirstCrossings[corners.Ids[slot]] - 1;
    }
    vtkIdType owner;
    const vtkCrossingKey key = this->GetCrossing(item, corners, slot, owner);
    const vtkCrossingKey* list = this->Lists.data() + this->ListStarts[owner];
    vtkIdType id = this->FirstCrossings[owner];
    while (*list != key)
    {
      ++list;
      ++id;
    }
    return id;
  }

  void WriteChunk(vtkIdType number)
  {
    const Chunk& chunk = this->Chunks[number];
    vtkIdType simplexId = chunk.Simplices;
    vtkIdType triangleId = chunk.Triangles;
    Corners corners;
    for (std::size_t c = 0; c < chunk.Cases.size(); ++c)
    {
      const Found& found = chunk.Cases[c];
      corners.What = this->GetCellCorners(found.Cell);
      this->ReadCorners(found.Cell, corners);
      this->TurnCorners(corners);
      if (found.IsPlain)
      {
        const vtkIsotable::Case& what = this->Tables[corners.What.Shape]->GetCase(found.Key);
        this->WriteCase(found, corners, what.Simplices.data(), what.Simplices.size(),
          what.Boundary.data(), this->Context.GenerateBoundaries ? what.Boundary.size() : 0,
          simplexId, triangleId);
      }
      else
      {
        const bool isLast = c + 1 == chunk.Cases.size();
        const std::size_t simplexEnd =
          isLast ? chunk.CutSimplices.size() : chunk.Cases[c + 1].FirstSimplex;
        const std::size_t triangleEnd =
          isLast ? chunk.CutTriangles.size() : chunk.Cases[c + 1].FirstTriangle;
        this->WriteCase(found, corners, chunk.CutSimplices.data() + found.FirstSimplex,
          simplexEnd - found.FirstSimplex, chunk.CutTriangles.data() + found.FirstTriangle,
          triangleEnd - found.FirstTriangle, simplexId, triangleId);
      }
    }
  }

  void WriteCase(const Found& found, const Corners& corners, const vtkIsotable::Simplex* simplices,
    std::size_t numberOfSimplices, const vtkIsotable::Triangle* triangles,
    std::size_t numberOfTriangles, vtkIdType& simplexId, vtkIdType& triangleId)
  {
    const vtkIsotable& table = *this->Tables[corners.What.Shape];
    const auto& item = this->Values.GetItems()[found.Item];
    const bool isInverted = this->Orientation.IsInverted(corners.What.Shape, corners.Ids);
    constexpr vtkIdType unknown = -1;
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    std::fill_n(ids, vtkIsotable::MaximumNumberOfSlots, unknown);
    const auto idOf = [&](Slot slot)
    {
      if (ids[slot] == unknown)
      {
        ids[slot] = this->GetId(table, item, corners, slot);
      }
      return ids[slot];
    };
    const int size = this->SimplexSize;
    for (std::size_t s = 0; s < numberOfSimplices; ++s, ++simplexId)
    {
      vtkTypeInt64* out = this->Simplices + simplexId * size;
      for (int p = 0; p < size; ++p)
      {
        out[p] = idOf(simplices[s][p]);
      }
      if (isInverted)
      {
        std::swap(out[0], out[1]);
      }
      this->Mesh.ItemIds->SetValue(simplexId, found.Item);
      if (this->Context.KeepCellIds)
      {
        this->Mesh.CellIds[simplexId] = found.Cell;
      }
    }
    for (std::size_t t = 0; t < numberOfTriangles; ++t, ++triangleId)
    {
      std::array<vtkIdType, 3>& out = this->Mesh.Triangles[triangleId];
      out = { { idOf(triangles[t][0]), idOf(triangles[t][1]), idOf(triangles[t][2]) } };
      if (isInverted)
      {
        std::swap(out[0], out[1]);
      }
      this->Mesh.TriangleItemIds->SetValue(triangleId, found.Item);
      this->Mesh.TriangleSides->SetValue(triangleId, triangles[t][3]);
      if (this->Context.KeepCellIds)
      {
        this->Mesh.TriangleCellIds[triangleId] = found.Cell;
      }
    }
  }

  const vtkExtractionContext& Context;
  const vtkExtractionValues& Values;
  vtkExtractionScalars<T> Scalars;
  vtkUnstructuredGrid* Grid;
  Connectivity Cells;
  vtkIdTypeArray* GlobalIds;
  vtkExtractionMesh& Mesh;
  vtkCellOrientation Orientation;
  vtkIdType NumberOfPoints;
  vtkIdType NumberOfCells;
  int SimplexSize;
  std::vector<vtkCellCorners> CornersOfType;
  // The type of all cells, or -1.
  int OnlyType = -1;
  const vtkIsotable* Tables[vtkIsotable::NUMBER_OF_SHAPES];
  SlotEnds Ends[vtkIsotable::NUMBER_OF_SHAPES][vtkIsotable::MaximumNumberOfSlots];

  std::vector<Code> Codes;
  std::unique_ptr<std::atomic<std::uint8_t>[]> Used;
  std::vector<Chunk> Chunks;
  // For each grid point the range of its crossings in Lists, and the output point of the first; the
  // grid point's own output point comes just before.
  std::vector<vtkIdType> ListStarts;
  std::vector<vtkCrossingKey> Lists;
  std::vector<vtkIdType> FirstCrossings;
  vtkTypeInt64* Simplices = nullptr;
};
}

bool vtkUnstructuredExtraction::Execute(
  const vtkExtractionContext& context, vtkUnstructuredGrid* grid, vtkExtractionMesh& mesh)
{
  if (grid->GetNumberOfCells() == 0)
  {
    return true;
  }
  return vtkExtractionDispatch::Execute(context.Scalars,
    [&](const auto* scalars)
    {
      using T = std::decay_t<decltype(*scalars)>;
      return Extractor<T>(context, grid, scalars, mesh).Execute();
    });
}
