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
 * @brief   field on a structured grid of hexahedra
 *
 * Outer faces that coincide (FaceLinks), for example along the cut of an O- or C-grid, form a seam.
 * Streamlines continue across seams.
 *
 * For a partition, Build() only sets the points and arrays. The caller must call BuildTree() and
 * SetSeams().
 *
 * Build() returns an error if an array is invalid, if the grid has no three-dimensional cells, or
 * if a point of the field is not finite.
 */
class StructuredFlowField : public IndexedFlowField
{
public:
  StructuredFlowField() = default;

  using IndexedFlowField::GetCellLocation;

  Error Build(vtkStructuredGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {},
    const FieldPartition* part = nullptr);

  int GetShape(const CellLocation&) const { return CellShape::HEXAHEDRON; }
  void GetPoints(const CellLocation& location, Trilinear& points) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Positions.Get<3>(this->GetCorner(location, corner), points.C[corner]);
      points.C[corner][3] = 0.0;
    }
  }
  const CellTree& GetTree() const { return this->Tree; }
  /// Returns the rounding error of float positions, or 0 for double positions.
  double GetRoundingError() const
  {
    return this->Positions.GetRoundingError(this->GetLargestCoordinate());
  }

  /// Prefetches the positions and vectors of the cell across a face, except at the corners on the
  /// face.
  void Prefetch(const CellLocation& location, int face) const
  {
    this->ForEachNeighborCorner(location, face,
      [this](vtkIdType point)
      {
        this->Positions.Prefetch<3>(point);
        this->PrefetchVector(point);
      });
  }

  /// Crosses a face into the neighbor. Returns false, without changes, if there is no neighbor.
  bool Cross(CellLocation& location, int face, double p[3]) const
  {
    if (this->Step(location, face))
    {
      p[face >> 1] = face & 1 ? 0.0 : 1.0;
      return true;
    }
    return !this->Seams.empty() && this->IsOutside(location, face) &&
      this->CrossSeam(location, face, p);
  }
  /// Returns the outer faces that are not on a seam, as 8 * cell + face, in ascending order.
  std::vector<vtkIdType> GetOuterFaces() const
  {
    return this->RemoveSeamFaces(this->GetBoundaryFaces());
  }
  /// Returns how many pairs of linked faces do not coincide exactly, and the largest gap.
  const FaceLinks::MatchGaps& GetMatchGaps() const { return this->Gaps; }

  /// Returns whether a streamline leaves the grid through a face.
  bool IsDomainFace(const CellLocation& location, int face) const
  {
    return this->IsOutside(location, face) &&
      (this->Seams.empty() || !this->FindSeam(location.Cell, face));
  }

protected:
  /// A face on a seam and its link. Face and Link.Face are 8 * cell + face.
  struct Seam
  {
    vtkIdType Face;
    FaceLinks::Link Link;
  };

  /// Builds a tree of the cells for which \a isCounted returns true, or of all cells if \a
  /// isCounted is empty.
  void BuildTree(const std::function<bool(const CellLocation&)>& isCounted = {},
    const CellTree::Unite& unite = {});
  /// Returns the outer faces of the cells with indices from \a first to \a last, in ascending
  /// order.
  std::vector<vtkIdType> GetBoundaryFaces(const int first[3], const int last[3]) const;
  std::vector<vtkIdType> RemoveSeamFaces(std::vector<vtkIdType> faces) const;
  /// Returns the seams among the faces \a own. links[i] is the link of own[i]; its Face is an index
  /// into \a all, or -1 if there is no link.
  static std::vector<Seam> GetSeams(const std::vector<vtkIdType>& own,
    const std::vector<vtkIdType>& all, const std::vector<FaceLinks::Link>& links);
  /// Sets the seams, which must be sorted by face.
  void SetSeams(std::vector<Seam>&& seams, const FaceLinks::MatchGaps& gaps)
  {
    this->Seams = std::move(seams);
    this->Gaps = gaps;
  }
  const ArrayRows& GetPositions() const { return this->Positions; }

private:
  std::vector<vtkIdType> GetBoundaryFaces() const;
  CellPositions GetCellPositions(
    const std::function<bool(const CellLocation&)>& isCounted = {}) const;
  int GetFacePoints(vtkIdType face, vtkIdType* points) const;
  void FindSeams();
  const Seam* FindSeam(vtkIdType cell, int face) const;
  bool CrossSeam(CellLocation& location, int face, double p[3]) const;

  ArrayRows Positions;
  CellTree Tree;
  // Sorted by face.
  std::vector<Seam> Seams;
  FaceLinks::MatchGaps Gaps;
};

}

#endif
