// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PartitionBoundaryFaces_h
#define interlume_PartitionBoundaryFaces_h

#include "Cells/CellShape.h"
#include "Cells/Trilinear.h"
#include "Fields/FaceLinks.h"
#include "Streams/RankExchange.h"

#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/// Face on the boundary of a partition. The member Face is eight times the id of the face's cell in
/// the whole grid, plus the index of the face in the cell. Shape is the shape of the cell, and Cell
/// contains the positions of the cell's corners.
struct BoundaryFace
{
  vtkIdType Face = -1;
  int Shape = CellShape::HEXAHEDRON;
  double Cell[8][3] = {};

  template <typename Field>
  static BoundaryFace Of(const Field& field, vtkIdType face)
  {
    BoundaryFace outside;
    outside.Face = face;
    const typename Field::CellLocation location = field.GetCellLocation(face / 8);
    outside.Shape = field.GetShape(location);
    Trilinear points;
    field.GetPoints(location, points);
    for (int corner = 0; corner < CellShape::Of(outside.Shape).NumberOfCorners; ++corner)
    {
      std::copy_n(points.C[corner], 3, outside.Cell[corner]);
    }
    return outside;
  }

  const CellShape::Face& GetShape() const
  {
    return CellShape::Of(this->Shape).Faces[this->Face % 8];
  }
};

/**
 * @class   PartitionBoundaryFaces
 * @brief   matches faces on partition boundaries with faces of cells of other processes
 *
 * Faces match under the same rules as in FaceLinks for the whole grid.
 */
class PartitionBoundaryFaces
{
public:
  /// Sets the faces of this process, and appends faces of other processes that may match them. \a
  /// positions are the positions of this process's points. Collective.
  PartitionBoundaryFaces(
    std::vector<BoundaryFace>&& own, const ArrayRows& positions, RankExchange& exchange);

  /// Finds the matching faces of this process's faces. In a link, Face is the index of the matching
  /// face (see Get), or -1 if there is no match. If \a isMerged is true, corners with equal
  /// coordinates are the same point. There must be at least one face.
  void FindLinks(bool isMerged);

  const BoundaryFace& Get(vtkIdType i) const { return this->Faces[static_cast<std::size_t>(i)]; }
  const std::vector<BoundaryFace>& GetAll() const { return this->Faces; }
  /// Returns the links of all faces. Only the links of this process's faces are valid.
  const std::vector<FaceLinks::Link>& GetLinks() const { return this->Links; }
  /// Returns the number of this process's faces whose positions differ from those of the matching
  /// faces, and the largest difference. Each pair is counted only in the process that owns the face
  /// with the lower number.
  FaceLinks::MatchGaps GetMatchGaps() const;

private:
  void ExchangeFaces(RankExchange& exchange);

  std::size_t NumberOfOwn;
  std::vector<BoundaryFace> Faces;
  std::vector<FaceLinks::Link> Links;
  const ArrayRows& Positions;
};

}

#endif
