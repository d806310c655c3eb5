// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StructuredFlowField_h
#define interlume_StructuredFlowField_h

#include "Cells/CellShape.h"
#include "Cells/CellTree.h"
#include "Fields/CellPositions.h"
#include "Fields/FaceLinks.h"
#include "Fields/IndexedFlowField.h"

class vtkStructuredGrid;

namespace interlume
{

/**
 * @class   StructuredFlowField
 * @brief   a field on a structured grid of hexahedra
 *
 * Where faces on the outside have the same coordinates (FaceLinks), as along the cut of an O- or
 * C-grid, the grid goes on from one to the other.
 *
 * Of a part of a grid Build takes the points and the arrays alone: the tree and the seams are to be
 * made by BuildTree and SetSeams.
 *
 * Errors of Build: those of the arrays; a grid without cells of dimension 3; a point of the field
 * that is not finite.
 */
class StructuredFlowField : public IndexedFlowField
{
public:
  StructuredFlowField() = default;

  using IndexedFlowField::GetPlace;

  Error Build(vtkStructuredGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {},
    const FieldPart* part = nullptr);

  int GetShape(const Place&) const { return CellShape::HEXAHEDRON; }
  void GetPoints(const Place& place, Trilinear& points) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Positions.Get<3>(this->GetCorner(place, corner), points.C[corner]);
      points.C[corner][3] = 0.0;
    }
  }
  const CellTree& GetTree() const { return this->Tree; }
  /// Returns the error that rounding to floats may have made in positions; 0 for doubles.
  double GetRounding() const { return this->Positions.GetRounding(this->GetLargestCoordinate()); }

  /// Prefetches the positions and vectors that the neighbour has and the cell has not.
  void Prefetch(const Place& place, int face) const
  {
    this->ForEachCornerBeyond(place, face,
      [this](vtkIdType point)
      {
        this->Positions.Prefetch<3>(point);
        this->PrefetchVector(point);
      });
  }

  /// Crosses a face into the neighbour. Returns false, and changes nothing, where there is none.
  bool Cross(Place& place, int face, double p[3]) const
  {
    if (this->Step(place, face))
    {
      p[face >> 1] = face & 1 ? 0.0 : 1.0;
      return true;
    }
    return !this->Seams.empty() && this->IsOutside(place, face) && this->CrossSeam(place, face, p);
  }
  /// Returns the faces on the outside that are no seam, as eight times their cell and their number
  /// there, ascending.
  std::vector<vtkIdType> GetOuterFaces() const
  {
    return this->WithoutSeams(this->GetOutsideFaces());
  }
  /// Returns the joins of the seams, each pair once.
  const FaceLinks::Joins& GetJoins() const { return this->Joins; }

  /// Returns whether a streamline leaves the grid there.
  bool IsDomainFace(const Place& place, int face) const
  {
    return this->IsOutside(place, face) &&
      (this->Seams.empty() || !this->FindSeam(place.Cell, face));
  }

protected:
  /// A seam. A face is eight times its cell, and its number there.
  struct Seam
  {
    vtkIdType Face;
    FaceLinks::Link Link;
  };

  /// Makes the tree of those cells that \a isCounted is true of.
  void BuildTree(
    const std::function<bool(const Place&)>& isCounted = {}, const CellTree::Unite& unite = {});
  /// Returns the faces on the outside of the cells with indices from first to last, ascending.
  std::vector<vtkIdType> GetOutsideFaces(const int first[3], const int last[3]) const;
  std::vector<vtkIdType> WithoutSeams(std::vector<vtkIdType> faces) const;
  /// Returns the seams among the faces \a own: link i is of the i-th, and to one of \a all by its
  /// index there.
  static std::vector<Seam> GetSeams(const std::vector<vtkIdType>& own,
    const std::vector<vtkIdType>& all, const std::vector<FaceLinks::Link>& links);
  /// Takes the seams, by ascending face.
  void SetSeams(std::vector<Seam>&& seams, const FaceLinks::Joins& joins)
  {
    this->Seams = std::move(seams);
    this->Joins = joins;
  }
  const ArrayRows& GetPositions() const { return this->Positions; }

private:
  std::vector<vtkIdType> GetOutsideFaces() const;
  CellPositions GetCellPositions(const std::function<bool(const Place&)>& isCounted = {}) const;
  int GetFacePoints(vtkIdType face, vtkIdType* points) const;
  void FindSeams();
  const Seam* FindSeam(vtkIdType cell, int face) const;
  bool CrossSeam(Place& place, int face, double p[3]) const;

  ArrayRows Positions;
  CellTree Tree;
  // The seams by ascending face.
  std::vector<Seam> Seams;
  FaceLinks::Joins Joins;
};

}

#endif
