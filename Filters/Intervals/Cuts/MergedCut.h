// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MergedCut_h
#define interlume_MergedCut_h

#include "Scalars/ExtractionValues.h"

#include "vtkIsotable.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   MergedCut
 * @brief   cut of a table case in a cell where several slots are the same point
 *
 * Slots of the same point are merged before the case is cut. Simplices that then contain a point
 * twice are removed, and so are pairs with the same points and opposite orientation. Therefore the
 * faces of the remaining simplices match those in the neighbor cells, and degenerate pieces leave
 * no simplices.
 *
 * In an interval of zero width, a cell is output if all its values equal the bound. Any other cell
 * contributes only those of its faces where all values equal the bound. These faces are reversed
 * because the region that they bound is in the neighbor cell.
 */
class MergedCut
{
public:
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;
  using Slot = vtkIsotable::Slot;
  using Simplex = vtkIsotable::Simplex;
  using Triangle = vtkIsotable::Triangle;

  /// Returns true if two slots of a case are the same point. \a same maps each slot to the slot
  /// that represents its point.
  static bool IsNeeded(const vtkIsotable::Case& what, const Slot* same);

  /// Triangulates case \a what of \a table, with the points ordered by \a ranks. Adds boundary
  /// triangles only if \a hasSides is true.
  void Make(const vtkIsotable& table, const Item& item, const Code* codes,
    const vtkIsotable::Case& what, const vtkIsotable::RankArray& ranks, const Slot* same,
    bool hasSides);

  const std::vector<Simplex>& GetSimplices() const { return this->Simplices; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// Returns true if the points of a tetrahedron or triangle all lie in one face of the cell. The
  /// neighbor cell at this face may have the same simplex with opposite orientation.
  bool IsInFace(const vtkIsotable& table, const Simplex& simplex)
  {
    if (this->FaceTable != &table)
    {
      this->FindFaces(table);
    }
    // The fourth slot of a triangle is unused.
    const Slot last = simplex[table.GetSimplexSize() - 1];
    return (this->FacesOf[simplex[0]] & this->FacesOf[simplex[1]] & this->FacesOf[simplex[2]] &
             this->FacesOf[last]) != 0;
  }
  /// Returns the number of simplices removed from the case.
  vtkIdType GetNumberOfCollapsedSimplices() const { return this->NumberCollapsed; }

private:
  void FindFaces(const vtkIsotable& table);
  void AddSides(const vtkIsotable& table, const Item& item, const Code* codes,
    const vtkIsotable::RankArray& ranks, const Slot* same);

  std::vector<Simplex> Simplices;
  std::vector<Triangle> Triangles;
  vtkIdType NumberCollapsed = 0;
  // Cached results of FindFaces(): the last table, the vertices of each face as a bit mask, and the
  // faces that contain each slot as a bit mask.
  const vtkIsotable* FaceTable = nullptr;
  std::vector<unsigned> Faces;
  std::array<std::uint8_t, vtkIsotable::MaximumNumberOfSlots> FacesOf{};
};

}

#endif
