// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OutsideFaces_h
#define interlume_OutsideFaces_h

#include "Cells/CellShape.h"
#include "Cells/Trilinear.h"
#include "Fields/FaceLinks.h"
#include "Streams/RankExchange.h"

#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/// A face on the outside of a part, as eight times its cell in the whole and its number there, and
/// the shape and corners of that cell.
struct OutsideFace
{
  vtkIdType Face = -1;
  int Shape = CellShape::HEXAHEDRON;
  double Cell[8][3] = {};

  template <typename Field>
  static OutsideFace Of(const Field& field, vtkIdType face)
  {
    OutsideFace outside;
    outside.Face = face;
    const typename Field::Place place = field.GetPlace(face / 8);
    outside.Shape = field.GetShape(place);
    Trilinear points;
    field.GetPoints(place, points);
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
 * @class   OutsideFaces
 * @brief   faces on the outside of parts that lead to cells of other processes, by their corners
 *
 * Faces are the same as FaceLinks has it for the whole.
 */
class OutsideFaces
{
public:
  /// Takes the faces of this process. \a positions are those of its points. Collective: faces of
  /// other processes that may be the same as one of them follow them.
  OutsideFaces(std::vector<OutsideFace>&& own, const ArrayRows& positions, RankExchange& exchange);

  /// Finds the links of the own faces to any; Face of a link is an index, -1 without one.
  /// \a isMerged: corners at the same coordinates are the same point. Not for no faces.
  void FindLinks(bool isMerged);

  const OutsideFace& Get(vtkIdType i) const { return this->Faces[static_cast<std::size_t>(i)]; }
  const std::vector<OutsideFace>& GetAll() const { return this->Faces; }
  /// Returns the links of all faces; those of the own ones are right.
  const std::vector<FaceLinks::Link>& GetLinks() const { return this->Links; }
  /// Returns the joins of those own faces that come before their partner.
  FaceLinks::Joins GetJoins() const;

private:
  void Share(RankExchange& exchange);

  std::size_t NumberOfOwn;
  std::vector<OutsideFace> Faces;
  std::vector<FaceLinks::Link> Links;
  const ArrayRows& Positions;
};

}

#endif
