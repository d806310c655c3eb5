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
 * @brief   a case as it is cut in a cell of which slots are the same point
 *
 * Slots that are one point are made one before the case is cut; simplices that have a point twice
 * afterwards are left out, and so are pairs with the same points and opposite orientation. So the
 * faces of what is left are those of the cell's neighbours, and a piece that has no volume leaves
 * none.
 *
 * An interval of zero width has the cells that are equal to its value throughout, and of any other
 * cell only the sides that are: reversed, since what they bound lies beyond.
 */
class MergedCut
{
public:
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;
  using Slot = vtkIsotable::Slot;
  using Simplex = vtkIsotable::Simplex;
  using Triangle = vtkIsotable::Triangle;

  /// Returns whether two of the slots of a case are one point. \a same has for each slot the one
  /// that it goes by.
  static bool IsNeeded(const vtkIsotable::Case& what, const Slot* same);

  /// Cuts case \a what of \a table in the order of \a ranks; triangles only where \a hasSides.
  void Make(const vtkIsotable& table, const Item& item, const Code* codes,
    const vtkIsotable::Case& what, const vtkIsotable::RankArray& ranks, const Slot* same,
    bool hasSides);

  const std::vector<Simplex>& GetSimplices() const { return this->Simplices; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// Whether the points of a tetrahedron, or of a contour's triangle, are all in one face of the
  /// cell. The neighbour there may have the same one turned over.
  bool IsInFace(const vtkIsotable& table, const Simplex& simplex)
  {
    if (this->TableOfFaces != &table)
    {
      this->FindFaces(table);
    }
    // The fourth slot of a triangle is unused.
    const Slot last = simplex[table.GetKind() == vtkIsotable::INTERVAL ? 3 : 2];
    return (this->FacesOf[simplex[0]] & this->FacesOf[simplex[1]] & this->FacesOf[simplex[2]] &
             this->FacesOf[last]) != 0;
  }
  /// Returns how many fewer simplices there are than in the case.
  vtkIdType GetNumberCollapsed() const { return this->NumberCollapsed; }

private:
  void FindFaces(const vtkIsotable& table);
  void AddSides(const vtkIsotable& table, const Item& item, const Code* codes,
    const vtkIsotable::RankArray& ranks, const Slot* same);

  std::vector<Simplex> Simplices;
  std::vector<Triangle> Triangles;
  vtkIdType NumberCollapsed = 0;
  // The table last asked for faces, the vertices of each of its faces, as bits, and for each slot
  // the faces that it is in, as bits.
  const vtkIsotable* TableOfFaces = nullptr;
  std::vector<unsigned> Faces;
  std::array<std::uint8_t, vtkIsotable::MaximumNumberOfSlots> FacesOf{};
};

}

#endif
