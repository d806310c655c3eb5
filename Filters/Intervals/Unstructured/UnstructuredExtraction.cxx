// SPDX-License-Identifier: BSD-3-Clause
#include "Unstructured/UnstructuredExtraction.h"

#include "Pass/ExtractionStages.h"
#include "Unstructured/CellCutter.h"
#include "Unstructured/CellReader.h"
#include "Unstructured/InteriorCells.h"
#include "Unstructured/UnsharedTriangles.h"

#include "vtkUnstructuredGrid.h"

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace interlume
{

namespace
{
using Chunk = UnstructuredChunk;
using Cell = TableCell<1>;
using Item = ExtractionValues::Item;

// Prefetch distance in cells.
constexpr int CellsAhead = 4;

// Buffers of a thread.
struct Local
{
  UnsharedPoints Unshared;
  MergedCut Merged;
  std::vector<vtkIdType> Points;
};

// Writes the cuts of a chunk to the mesh, one after another.
class CutWriter
{
public:
  CutWriter(const ShapeTables& tables, Chunk& chunk, MergedCut& merged, ExtractionMesh& mesh)
    : Tables(tables)
    , TheChunk(chunk)
    , Merged(merged)
    , Mesh(mesh)
    , Simplex(chunk.Simplices)
    , Triangle(chunk.Triangles)
  {
  }

  void Write(vtkIdType cell, vtkIsotable::Shapes shape, const ChunkCuts::Found& found,
    const CellCut& cut, const vtkIdType* ids)
  {
    if (found.IsMerged)
    {
      this->NoteTied(shape, cut);
    }
    this->Mesh.Simplices.Write(
      this->Simplex, cut.Simplices, cut.NumberOfSimplices, ids, found.IsInverted);
    this->Mesh.SetSimplexOrigins(this->Simplex, cut.NumberOfSimplices, found.Item, cell);
    this->Simplex += static_cast<vtkIdType>(cut.NumberOfSimplices);
    for (std::size_t t = 0; t < cut.NumberOfTriangles; ++t, ++this->Triangle)
    {
      const vtkIsotable::Triangle& points = cut.Triangles[t];
      this->Mesh.WriteTriangle(this->Triangle,
        { { ids[points[0]], ids[points[1]], ids[points[2]] } }, found.IsInverted, found.Item,
        points[3], cell);
    }
  }

private:
  // Records the simplices and boundary triangles of a cell with merged slots, which must be
  // compared with those of the neighbor cells.
  void NoteTied(vtkIsotable::Shapes shape, const CellCut& cut)
  {
    for (std::size_t t = 0; t < cut.NumberOfTriangles; ++t)
    {
      this->TheChunk.TiedTriangles.push_back(this->Triangle + static_cast<vtkIdType>(t));
    }
    for (std::size_t s = 0; s < cut.NumberOfSimplices; ++s)
    {
      if (this->Merged.IsInFace(this->Tables[shape], cut.Simplices[s]))
      {
        this->TheChunk.TiedSimplices.push_back(this->Simplex + static_cast<vtkIdType>(s));
      }
    }
  }

  const ShapeTables& Tables;
  Chunk& TheChunk;
  MergedCut& Merged;
  ExtractionMesh& Mesh;
  vtkIdType Simplex;
  vtkIdType Triangle;
};

template <typename Stored>
class CellPass : public ExtractionStages<CellPass<Stored>, Local>
{
  using Frame = ExtractionStages<CellPass<Stored>, Local>;

public:
  static constexpr std::array<double, 4> Progress = { { 0.05, 0.4, 0.5, 0.8 } };

  CellPass(const ExtractionContext& context, vtkUnstructuredGrid* grid, const Stored* offsets,
    const Stored* ids, ExtractionMesh& mesh)
    : Frame(context)
    , Scalars(context.MakeScalars())
    , Reader(context, grid, offsets, ids)
    , Cutter(context, Reader.GetOrder())
    , Unshared(context, Reader, Cutter, *Scalars)
    , Mesh(mesh)
    , NumberOfCells(grid->GetNumberOfCells())
    , KeepsNodes(context.Values->GetKind() == vtkIsotable::CONTOUR)
    , Chunks((grid->GetNumberOfCells() + Chunk::Size - 1) / Chunk::Size)
  {
    if (context.InteriorFilter)
    {
      this->Interior.emplace(context, this->Reader);
    }
    if (!context.Unshared || context.IncludeGhostCells)
    {
      this->Points.emplace(this->Reader.GetNumberOfPoints(), this->KeepsNodes);
    }
  }

  vtkIdType GetNumberOfParts() const { return static_cast<vtkIdType>(this->Chunks.size()); }

  bool Classify()
  {
    return this->Reader.Classify(*this->Scalars) &&
      (!this->Interior || this->Interior->FindRanges(this->NumberOfCells));
  }

  void CountPart(vtkIdType number, Local& local)
  {
    Chunk& chunk = this->Chunks[number];
    CrossingLists::Arena* const arena = this->Points ? &this->Points->GetArena() : nullptr;
    const vtkIdType begin = number * Chunk::Size;
    const vtkIdType end = std::min(begin + Chunk::Size, this->NumberOfCells);
    const vtkIdType passed = this->Interior ? this->Interior->GetFirstPassedCell() : end;
    std::uint16_t near[Chunk::Size];
    const int numberNear =
      this->Reader.FindIntersectedCells(begin, end, passed, near, chunk.Report);
    chunk.Cuts.Reserve(numberNear);
    if (!arena)
    {
      local.Unshared.Begin();
    }
    Cell cell;
    for (int c = 0; c < numberNear; ++c)
    {
      if (c + CellsAhead < numberNear)
      {
        this->Reader.Prefetch(begin + near[c + CellsAhead]);
      }
      const vtkIdType id = begin + near[c];
      if (this->Interior &&
        this->Interior->Count(id, near[c], chunk, *this->Points, *arena, local.Points))
      {
        continue;
      }
      this->Reader.Read(id, cell);
      if (arena || !this->Unshared.CountPlain(cell, near[c], chunk, local.Unshared))
      {
        this->CountCell(cell, near[c], chunk, arena, local);
      }
    }
    if (!arena)
    {
      this->Unshared.Interpolate(local.Unshared, chunk);
    }
  }

  bool Settle()
  {
    if (!this->EnterTiedPoints())
    {
      return false;
    }
    if (this->Points)
    {
      this->Points->MakePoints(*this->Scalars, this->Mesh.Points);
      this->Reader.GetOrder().SortMidpointEnds(
        this->Mesh.Points.GetData(), this->Mesh.Points.GetSize());
    }
    std::size_t bytes = this->Reader.GetBytes() + (this->Points ? this->Points->GetBytes() : 0) +
      this->Mesh.Points.GetBytes();
    for (const Chunk& chunk : this->Chunks)
    {
      bytes += chunk.GetBytes();
    }
    this->Context.UpdatePeakWorkingBytes(bytes);
    this->Reader.FreeCodesAndMarks();
    return true;
  }

  void Allocate()
  {
    vtkIdType simplices = 0;
    vtkIdType triangles = 0;
    vtkIdType interior = 0;
    vtkIdType interiorIds = 0;
    for (Chunk& chunk : this->Chunks)
    {
      // Replace the counts of the chunk with the totals of all previous chunks.
      const auto sum = [](vtkIdType& count, vtkIdType& total)
      {
        std::swap(count, total);
        total += count;
      };
      sum(chunk.Simplices, simplices);
      sum(chunk.Triangles, triangles);
      sum(chunk.Interior, interior);
      sum(chunk.InteriorIds, interiorIds);
      this->Context.Report->Add(chunk.Report);
    }
    this->Mesh.Allocate(static_cast<vtkIdType>(this->Mesh.Points.GetSize()), simplices,
      this->Context.GetSimplexSize(), triangles, this->Context.KeepCellIds, interior, interiorIds);
    if (!this->Points)
    {
      this->Mesh.Simplices.NumberConsecutively();
      this->Context.Unshared->Allocate(3 * simplices);
    }
  }

  void WritePart(vtkIdType number, Local& local)
  {
    Chunk& chunk = this->Chunks[number];
    if (!this->Points)
    {
      this->WriteUnshared(number * Chunk::Size, chunk);
      return;
    }
    CutWriter writer(this->Cutter.GetTables(), chunk, local.Merged, this->Mesh);
    auto node = chunk.Nodes.begin();
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    Cell cell;
    this->Cutter.ForEachCut(number * Chunk::Size, this->Reader.GetCells(), chunk.Cuts,
      [&](
        vtkIdType id, vtkIsotable::Shapes shape, const ChunkCuts::Found& found, const CellCut& cut)
      {
        if (this->KeepsNodes)
        {
          for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
          {
            ids[cut.Slots[s]] = (*node++)->Id;
          }
        }
        else
        {
          this->Reader.ReadCornersIfNeeded(id, cell);
          this->FindIds(cell, this->Values.GetItems()[found.Item], cut, ids);
        }
        writer.Write(id, shape, found, cut, ids);
      });
    if (this->Interior)
    {
      this->Interior->Write(number * Chunk::Size, chunk, *this->Points, this->Mesh, local.Points);
    }
  }

  void Finish()
  {
    for (const Chunk& chunk : this->Chunks)
    {
      this->Mesh.TiedTriangles.insert(
        this->Mesh.TiedTriangles.end(), chunk.TiedTriangles.begin(), chunk.TiedTriangles.end());
      this->Mesh.TiedSimplices.insert(
        this->Mesh.TiedSimplices.end(), chunk.TiedSimplices.begin(), chunk.TiedSimplices.end());
    }
  }

private:
  void CountCell(
    Cell& cell, vtkIdType position, Chunk& chunk, CrossingLists::Arena* arena, Local& local)
  {
    const auto [minimum, maximum] = this->Reader.ReadCodes(cell);
    const bool isInverted = this->Reader.IsInverted(cell);
    const vtkIdType before = chunk.GetOutput();
    const auto& items = this->Values.GetItems();
    for (std::size_t number = 0; number < items.size(); ++number)
    {
      const Item& item = items[number];
      if (this->Values.IsOutside(item, minimum, maximum))
      {
        continue;
      }
      if (this->Interior && this->Interior->IsInside(cell.Id, item, minimum, maximum))
      {
        this->Interior->Enter(
          cell.Id, position, number, chunk, *this->Points, *arena, local.Points);
        continue;
      }
      ChunkCuts::SlotBuffer slots;
      CellCut cut;
      const ChunkCuts::Found found = this->Cutter.Cut(cell, number, position, isInverted,
        local.Merged, chunk.Cuts, slots, cut, chunk.Report.CollapsedSimplices);
      if (arena)
      {
        this->EnterCut(cell, item, cut, chunk, *arena);
      }
      else
      {
        this->Unshared.Add(cell, item, cut, found, local.Merged, local.Unshared);
      }
      chunk.Simplices += static_cast<vtkIdType>(cut.NumberOfSimplices);
      chunk.Triangles += static_cast<vtkIdType>(cut.NumberOfTriangles);
      chunk.Cuts.Add(found);
    }
    this->Reader.CountOutput(cell, chunk.GetOutput() != before, chunk.Report);
  }

  // Enters the points of a cut.
  void EnterCut(const Cell& cell, const Item& item, const CellCut& cut, Chunk& chunk,
    CrossingLists::Arena& arena)
  {
    for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
    {
      vtkIdType owner;
      const CrossingKey key = this->Cutter.GetTables().GetPoint(cell, item, cut.Slots[s], owner);
      const CrossingLists::Node* node = this->Points->Enter(owner, key, arena);
      if (this->KeepsNodes)
      {
        chunk.Nodes.push_back(node);
      }
    }
  }

  // If triangles have to be compared with those of neighbor cells, enters the points of all cuts,
  // unless they were entered during counting. Returns false if the user aborted.
  bool EnterTiedPoints()
  {
    if (this->Points || !this->Unshared.HasTiedFaces())
    {
      return true;
    }
    this->Points.emplace(this->Reader.GetNumberOfPoints(), this->KeepsNodes);
    return this->ForEachPart(this->GetNumberOfParts(), 0.4, 0.5,
      [this](vtkIdType number, Local&)
      {
        CrossingLists::Arena& arena = this->Points->GetArena();
        Chunk& chunk = this->Chunks[number];
        Cell cell;
        this->Cutter.ForEachCut(number * Chunk::Size, this->Reader.GetCells(), chunk.Cuts,
          [&](vtkIdType id, vtkIsotable::Shapes, const ChunkCuts::Found& found, const CellCut& cut)
          {
            this->Reader.ReadCornersIfNeeded(id, cell);
            this->EnterCut(cell, this->Values.GetItems()[found.Item], cut, chunk, arena);
          });
      });
  }

  // Writes the triangles of a chunk if triangles share no points.
  void WriteUnshared(vtkIdType begin, Chunk& chunk)
  {
    this->Context.Unshared->Write(chunk.Unshared, 3 * chunk.Simplices);
    chunk.Unshared = PointArrays::Part();
    if (this->Mesh.HasSeveralItems || this->Context.KeepCellIds)
    {
      vtkIdType simplex = chunk.Simplices;
      this->Cutter.ForEachCut(begin, this->Reader.GetCells(), chunk.Cuts,
        [&](vtkIdType id, vtkIsotable::Shapes, const ChunkCuts::Found& found, const CellCut& cut)
        {
          this->Mesh.SetSimplexOrigins(simplex, cut.NumberOfSimplices, found.Item, id);
          simplex += static_cast<vtkIdType>(cut.NumberOfSimplices);
        });
    }
  }

  // Finds the output point id of each slot that a cut uses.
  void FindIds(const Cell& cell, const Item& item, const CellCut& cut, vtkIdType* ids) const
  {
    for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
    {
      vtkIdType owner;
      const CrossingKey key = this->Cutter.GetTables().GetPoint(cell, item, cut.Slots[s], owner);
      ids[cut.Slots[s]] = this->Points->GetId(owner, key);
    }
  }

  std::unique_ptr<ExtractionScalars> Scalars;
  CellReader<Stored> Reader;
  CellCutter Cutter;
  UnsharedTriangles<Stored> Unshared;
  // Empty if interior cells are cut too.
  std::optional<InteriorCells<Stored>> Interior;
  ExtractionMesh& Mesh;
  vtkIdType NumberOfCells;
  // If true, each chunk stores the CrossingLists nodes of its points. A contour is small compared
  // with its grid, and storing the nodes is faster than searching for the points again. For the
  // tetrahedra of an interval, the nodes would take too much memory.
  bool KeepsNodes;
  // The points that cells share. Empty if every triangle has its own points.
  std::optional<CrossingLists> Points;
  std::vector<Chunk> Chunks;
};
}

bool UnstructuredExtraction::Execute(
  const ExtractionContext& context, vtkUnstructuredGrid* grid, ExtractionMesh& mesh)
{
  if (grid->GetNumberOfCells() == 0)
  {
    return true;
  }
  return VisitCellArrays(grid,
    [&](const auto* offsets, const auto* ids)
    {
      CellPass<std::decay_t<decltype(*ids)>> pass(context, grid, offsets, ids, mesh);
      return pass.Execute(pass.GetNumberOfParts());
    });
}

}
