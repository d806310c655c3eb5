// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/MergedCut.h"

#include "Cuts/CoincidentSlots.h"
#include "Output/OppositePairs.h"

#include <algorithm>
#include <cstddef>

namespace interlume
{

namespace
{
// Returns the table from which the faces of a cell with the given number of vertices are read if
// \a table is a contour table, which does not contain them.
const vtkIsotable& GetIntervalTable(const vtkIsotable& table, int vertices)
{
  if (table.GetKind() == vtkIsotable::INTERVAL)
  {
    return table;
  }
  int shape = 0;
  while (vtkIsotable::Get(vtkIsotable::INTERVAL, static_cast<vtkIsotable::Shapes>(shape))
           .GetNumberOfVertices() != vertices)
  {
    ++shape;
  }
  return vtkIsotable::Get(vtkIsotable::INTERVAL, static_cast<vtkIsotable::Shapes>(shape));
}
}

bool MergedCut::IsNeeded(const vtkIsotable::Case& what, const Slot* same)
{
  return std::any_of(
    what.Slots.begin(), what.Slots.end(), [same](Slot slot) { return same[slot] != slot; });
}

void MergedCut::Make(const vtkIsotable& table, const Item& item, const Code* codes,
  const vtkIsotable::Case& what, const vtkIsotable::RankArray& ranks, const Slot* same,
  bool hasSides)
{
  this->Simplices.clear();
  this->Triangles.clear();
  const Code* const end = codes + table.GetNumberOfVertices();
  if (item.IsFlat && std::any_of(codes, end, [&item](Code code) { return code != item.First; }))
  {
    if (hasSides)
    {
      this->AddSides(table, item, codes, ranks, same);
    }
  }
  else
  {
    const int size = table.GetSimplexSize();
    table.CutMerged(
      what, ranks, same,
      [this, size](const Simplex& simplex)
      {
        if (!CoincidentSlots::IsCollapsed(simplex.data(), size))
        {
          this->Simplices.push_back(simplex);
        }
      },
      [this, hasSides, size](const Triangle& triangle)
      {
        if (hasSides && !CoincidentSlots::IsCollapsed(triangle.data(), size - 1))
        {
          this->Triangles.push_back(triangle);
        }
      });
    if (size == 4)
    {
      OppositePairs::Remove<4>(this->Simplices);
      OppositePairs::Remove<3>(this->Triangles);
    }
    else
    {
      OppositePairs::Remove<3>(this->Simplices);
      OppositePairs::Remove<2>(this->Triangles);
    }
  }
  // The cut may have more simplices than the case if its slot order differs from the table's.
  const std::size_t left = std::min(this->Simplices.size(), what.Simplices.size());
  this->NumberCollapsed = static_cast<vtkIdType>(what.Simplices.size() - left);
}

void MergedCut::AddSides(const vtkIsotable& table, const Item& item, const Code* codes,
  const vtkIsotable::RankArray& ranks, const Slot* same)
{
  const int vertices = table.GetNumberOfVertices();
  const Code tie = item.First;
  const Slot side = *std::min_element(codes, codes + vertices) < tie ? 0 : 1;
  table.CutSides(table.GetCase(CoincidentSlots::GetAllInsideKey(vertices)), ranks,
    [&](Slot a, Slot b, Slot c, const Slot* polygon, int number)
    {
      if (std::all_of(polygon, polygon + number, [&](Slot vertex) { return codes[vertex] == tie; }))
      {
        const Triangle triangle{ { same[b], same[a], same[c], side } };
        if (!CoincidentSlots::IsCollapsed(triangle.data(), table.GetSimplexSize() - 1))
        {
          this->Triangles.push_back(triangle);
        }
      }
    });
}

void MergedCut::FindFaces(const vtkIsotable& table)
{
  const int vertices = table.GetNumberOfVertices();
  const int edges = table.GetNumberOfEdges();
  this->FaceTable = &table;
  this->Faces.clear();
  const vtkIsotable& intervalTable = GetIntervalTable(table, vertices);
  intervalTable.CutSides(intervalTable.GetCase(CoincidentSlots::GetAllInsideKey(vertices)),
    vtkIsotable::RankArray{},
    [this](Slot, Slot, Slot, const Slot* polygon, int number)
    {
      unsigned face = 0;
      std::for_each(polygon, polygon + number, [&face](Slot vertex) { face |= 1u << vertex; });
      // CutSides() visits each face once per triangle.
      if (this->Faces.empty() || this->Faces.back() != face)
      {
        this->Faces.push_back(face);
      }
    });
  for (int slot = 0; slot < vertices + 2 * edges; ++slot)
  {
    unsigned support = 1u << slot;
    if (slot >= vertices)
    {
      const auto& ends = table.GetEdge((slot - vertices) % edges);
      support = (1u << ends[0]) | (1u << ends[1]);
    }
    unsigned faces = 0;
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      faces |= (support & ~this->Faces[f]) == 0 ? 1u << f : 0u;
    }
    this->FacesOf[slot] = static_cast<std::uint8_t>(faces);
  }
}

}
