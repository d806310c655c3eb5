// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnstructuredFlowField_h
#define interlume_UnstructuredFlowField_h

#include "Cells/CellShape.h"
#include "Common/GridCells.h"
#include "Common/StoredIds.h"
#include "Fields/CellPositions.h"
#include "Fields/FaceLinks.h"
#include "Fields/FlowField.h"
#include "Fields/MeshLinks.h"

#include "vtkSmartPointer.h"

#include <memory>

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   UnstructuredFlowField
 * @brief   a field on tetrahedra, voxels, hexahedra, wedges and pyramids
 *
 * Streamlines go from face to face by FaceLinks. A face without a link, as between a
 * quadrilateral and two triangles, is where the field ends. Memory: a number for each face, beside
 * the grid; it is used again for the same mesh while somebody keeps it (MeshLinks).
 *
 * Cells of fewer dimensions are not part of the field.
 *
 * Errors of Build: those of the arrays; a grid without cells; a cell of another type, or with
 * another number of points; a point of a cell that is not finite.
 */
class UnstructuredFlowField : public FlowField
{
public:
  /// A cell, its first point in the list of points, and its VTK type.
  struct Place
  {
    vtkIdType Cell = 0;
    vtkIdType First = 0;
    int Type = 0;
  };

  UnstructuredFlowField() = default;

  Error Build(vtkUnstructuredGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {});

  Place GetPlace(vtkIdType cell) const
  {
    Place place;
    place.Cell = cell;
    place.First = this->OnlyType ? cell * this->OnlySize : this->Offsets.Get(cell);
    place.Type = this->OnlyType ? this->OnlyType : this->Types[cell];
    return place;
  }
  /// The same, as all cells are held.
  Place GetHeldPlace(vtkIdType cell) const { return this->GetPlace(cell); }
  /// Returns whether streamlines may go on in a cell.
  static constexpr bool IsHere(const Place&) { return true; }
  int GetShape(const Place& place) const { return GetCorners(place.Type).Shape; }

  void GetPoints(const Place& place, Trilinear& points) const
  {
    this->ForEachCorner(place,
      [&](int corner, vtkIdType point)
      {
        this->Positions.Get<3>(point, points.C[corner]);
        points.C[corner][3] = 0.0;
      });
  }
  void GetVectors(const Place& place, Trilinear& vectors) const
  {
    this->ForEachCorner(place,
      [&](int corner, vtkIdType point)
      {
        this->GetVector(point, vectors.C[corner]);
        vectors.C[corner][3] = 0.0;
      });
  }
  /// Copies the corners' values to the first column; the others become 0.
  void GetValues(int array, const Place& place, Trilinear& values) const
  {
    this->ForEachCorner(place,
      [&](int corner, vtkIdType point)
      {
        values.Clear(corner);
        values.C[corner][0] = this->GetValue(array, point);
      });
  }
  const CellTree& GetTree() const { return this->Mesh->Tree; }
  /// Returns the error that rounding to floats may have made in positions; 0 for doubles.
  double GetRounding() const { return this->Positions.GetRounding(this->GetLargestCoordinate()); }

  /// The faces without a neighbour, as eight times their cell and their number there, ascending;
  /// and the points of one such face in cyclic order, with their number.
  std::vector<vtkIdType> GetOuterFaces() const;
  int GetFacePoints(vtkIdType face, vtkIdType* points) const;
  /// Returns the joins of the links.
  const FaceLinks::Joins& GetJoins() const { return this->Mesh->Joins; }
  /// Returns what was found of the mesh, and the number of faces of cells whose links were known
  /// before.
  const std::shared_ptr<const MeshLinks>& GetMesh() const { return this->Mesh; }
  vtkIdType GetNumberOfKeptFaces() const { return this->NumberOfKeptFaces; }
  const ArrayRows& GetPositions() const { return this->Positions; }

  /// Prefetches the neighbour's list of points in round 0, their positions and vectors in round 1.
  void Prefetch(const Place& place, int face, int round) const
  {
    const vtkIdType link = this->GetLink(place.Cell, face);
    if (link >= 0)
    {
      this->PrefetchCell(this->GetPlace(link >> 6), round);
    }
  }

  /// Crosses a face into the neighbour. Returns false, and changes nothing, where there is none.
  bool Cross(Place& place, int face, double p[3]) const
  {
    const vtkIdType link = this->GetLink(place.Cell, face);
    if (link < 0)
    {
      return false;
    }
    this->CrossTo(this->GetPlace(link >> 6), link, place, face, p);
    return true;
  }

protected:
  /// Takes the arrays, the cells and what is hidden. Returns an error if the arrays cannot be used.
  Error BuildCells(
    vtkUnstructuredGrid* grid, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays);
  /// Returns an error for the first cell that cannot be used; \a first is the number of cell 0.
  Error FindCellError(vtkIdType first) const;
  void FindOnlyType();
  CellPositions GetCellPositions() const;
  /// Gives at most eight points of a cell in the order of its type, and returns how many.
  int GetStoredPoints(vtkIdType cell, vtkIdType* points) const;
  /// Finds the links between faces of the same points and, where asked for, of the same
  /// coordinates.
  void FindLinks(MeshLinks& mesh, bool byCoordinates) const;
  /// Refers to what was found of the mesh.
  void Use(const std::shared_ptr<const MeshLinks>& mesh);

  /// Returns what MeshLinks has of a face.
  vtkIdType GetLink(vtkIdType cell, int face) const
  {
    return this->Links[cell * this->FacesPerCell + face];
  }
  /// Prefetches what is in a cell, which has its place among all that are held.
  void PrefetchCell(const Place& cell, int round) const
  {
    if (round == 0)
    {
      this->PointIds.Prefetch(cell.First, cell.First + GetCorners(cell.Type).Number - 1);
      return;
    }
    this->ForEachCorner(cell,
      [this](int, vtkIdType point)
      {
        this->Positions.Prefetch<3>(point);
        this->PrefetchVector(point);
      });
    interlume::Prefetch::Read(this->Links + cell.Cell * this->FacesPerCell);
  }
  /// Goes over a face to the cell that a link leads to, of which its type is known.
  void CrossTo(const Place& next, vtkIdType link, Place& place, int face, double p[3]) const
  {
    const CellShape::Face& from = CellShape::Of(this->GetShape(place)).Faces[face];
    double uv[2];
    from.GetParameters(p, uv);
    FaceLinks::Map(from.NumberOfCorners, link >> 1 & 3, link & 1, uv);
    place = next;
    CellShape::Of(this->GetShape(place)).Faces[link >> 3 & 7].GetPlace(uv, p);
  }

private:
  // The corners of VTK's types in the order of the shape's corners.
  struct TypeCorners
  {
    int Shape;
    int Number;
    int Order[8];
  };
  // Returns the corners of a type; without corners for other types.
  static const TypeCorners& GetCorners(int type)
  {
    static constexpr TypeCorners none = { CellShape::TETRAHEDRON, 0, {} };
    static constexpr TypeCorners known[5] = { { CellShape::TETRAHEDRON, 4, { 0, 1, 2, 3 } },
      { CellShape::HEXAHEDRON, 8, { 0, 1, 2, 3, 4, 5, 6, 7 } },
      { CellShape::HEXAHEDRON, 8, { 0, 1, 3, 2, 4, 5, 7, 6 } },
      { CellShape::WEDGE, 6, { 0, 1, 2, 3, 4, 5 } }, { CellShape::PYRAMID, 5, { 0, 1, 2, 3, 4 } } };
    return type >= FirstType && type < FirstType + 5 ? known[type - FirstType] : none;
  }
  // VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID follow each other.
  static constexpr int FirstType = 10;

  template <typename Visitor>
  void ForEachCorner(const Place& place, Visitor&& visit) const
  {
    const TypeCorners& corners = GetCorners(place.Type);
    for (int corner = 0; corner < corners.Number; ++corner)
    {
      visit(corner, this->PointIds.Get(place.First + corners.Order[corner]));
    }
  }

  void ExcludeFlatCells();
  int GetCellPoints(vtkIdType cell, vtkIdType* points) const;
  void FillFaces(vtkIdType cell, FaceLinks::Block& faces) const;
  int FindFacesPerCell() const;

  ArrayRows Positions;
  StoredIds Offsets;
  StoredIds PointIds;
  const unsigned char* Types = nullptr;
  // The type of all cells where they are of one type, and how many points each has; else 0.
  int OnlyType = 0;
  int OnlySize = 0;
  vtkSmartPointer<GridCells::Types> TypeArray;
  std::shared_ptr<const MeshLinks> Mesh;
  vtkIdType NumberOfKeptFaces = 0;
  // Those of Mesh.
  int FacesPerCell = 0;
  const vtkIdType* Links = nullptr;
};

}

#endif
