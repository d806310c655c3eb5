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
 * @brief   field on tetrahedra, voxels, hexahedra, wedges and pyramids
 *
 * Streamlines cross faces that FaceLinks matches. They end at a face without a link, for example
 * between a quadrilateral and two triangles. The links store one id per face. Fields on the same
 * mesh share them (MeshLinks).
 *
 * Cells with fewer than three dimensions are excluded.
 *
 * Build() returns an error if an array is invalid, if the grid has no cells, if a cell has an
 * unsupported type or a wrong number of points, or if a point of a cell is not finite.
 */
class UnstructuredFlowField : public FlowField
{
public:
  /// A cell, the index of its first point in the connectivity array, and its VTK type.
  struct CellLocation
  {
    vtkIdType Cell = 0;
    vtkIdType First = 0;
    int Type = 0;
  };

  UnstructuredFlowField() = default;

  Error Build(vtkUnstructuredGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays = {}, const StageProgress& progress = {});

  CellLocation GetCellLocation(vtkIdType cell) const
  {
    CellLocation location;
    location.Cell = cell;
    location.First = this->OnlyType ? cell * this->OnlySize : this->Offsets.Get(cell);
    location.Type = this->OnlyType ? this->OnlyType : this->Types[cell];
    return location;
  }
  /// Returns the same as GetCellLocation(), because all cells are available.
  CellLocation GetHeldCellLocation(vtkIdType cell) const { return this->GetCellLocation(cell); }
  /// Returns whether this process traces streamlines in a cell.
  static constexpr bool IsHere(const CellLocation&) { return true; }
  int GetShape(const CellLocation& location) const { return GetCorners(location.Type).Shape; }

  void GetPoints(const CellLocation& location, Trilinear& points) const
  {
    this->ForEachCorner(location,
      [&](int corner, vtkIdType point)
      {
        this->Positions.Get<3>(point, points.C[corner]);
        points.C[corner][3] = 0.0;
      });
  }
  void GetVectors(const CellLocation& location, Trilinear& vectors) const
  {
    this->ForEachCorner(location,
      [&](int corner, vtkIdType point)
      {
        this->GetVector(point, vectors.C[corner]);
        vectors.C[corner][3] = 0.0;
      });
  }
  /// Copies the values of a point array to the first column of \a values, and clears the other
  /// columns.
  void GetValues(int array, const CellLocation& location, Trilinear& values) const
  {
    this->ForEachCorner(location,
      [&](int corner, vtkIdType point)
      {
        values.Clear(corner);
        values.C[corner][0] = this->GetValue(array, point);
      });
  }
  const CellTree& GetTree() const { return this->Mesh->Tree; }
  /// Returns the rounding error of float positions, or 0 for double positions.
  double GetRoundingError() const
  {
    return this->Positions.GetRoundingError(this->GetLargestCoordinate());
  }

  /// Returns the faces without a neighbor, as 8 * cell + face, in ascending order.
  std::vector<vtkIdType> GetOuterFaces() const;
  /// Computes the ids of the points of a face, in cyclic order, and returns their number.
  int GetFacePoints(vtkIdType face, vtkIdType* points) const;
  /// Returns how many pairs of linked faces do not coincide exactly, and the largest gap.
  const FaceLinks::MatchGaps& GetMatchGaps() const { return this->Mesh->Gaps; }
  /// Returns the links, which fields on the same mesh may share.
  const std::shared_ptr<const MeshLinks>& GetMesh() const { return this->Mesh; }
  /// Returns the number of cell faces whose links Build() took from another field on the same mesh.
  vtkIdType GetNumberOfReusedFaceMatches() const { return this->NumberOfReusedFaceMatches; }
  const ArrayRows& GetPositions() const { return this->Positions; }

  /// Prefetches the point ids of the neighbor in round 0, and their positions and vectors in round
  /// 1.
  void Prefetch(const CellLocation& location, int face, int round) const
  {
    const vtkIdType link = this->GetLink(location.Cell, face);
    if (link >= 0)
    {
      this->PrefetchCell(this->GetCellLocation(link >> 6), round);
    }
  }

  /// Crosses a face into the neighbor. Returns false, without changes, if there is no neighbor.
  bool Cross(CellLocation& location, int face, double p[3]) const
  {
    const vtkIdType link = this->GetLink(location.Cell, face);
    if (link < 0)
    {
      return false;
    }
    this->CrossTo(this->GetCellLocation(link >> 6), link, location, face, p);
    return true;
  }

protected:
  /// Sets the arrays, cells and blanking. Returns an error if the arrays are invalid.
  Error BuildCells(
    vtkUnstructuredGrid* grid, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays);
  /// Returns an error for the first invalid cell. \a first is the global id of cell 0.
  Error FindCellError(vtkIdType first) const;
  void FindCommonType();
  CellPositions GetCellPositions() const;
  /// Computes the ids of at most eight points of a cell, in VTK's order, and returns their number.
  int GetConnectivity(vtkIdType cell, vtkIdType* points) const;
  /// Finds the links between faces with the same points, and if \a byCoordinates is true, also
  /// between faces with the same coordinates.
  void FindLinks(MeshLinks& mesh, bool byCoordinates) const;
  /// Sets the links to use.
  void Use(const std::shared_ptr<const MeshLinks>& mesh);

  /// Returns the link of a face, encoded by MeshLinks::GetLink(), or a negative number if there is
  /// no neighbor in this process.
  vtkIdType GetLink(vtkIdType cell, int face) const
  {
    return this->Links[cell * this->FacesPerCell + face];
  }
  /// Prefetches the data of a cell in this process. Prefetch() explains \a round.
  void PrefetchCell(const CellLocation& cell, int round) const
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
  /// Moves across a face to the linked cell \a next, whose type must be set.
  void CrossTo(
    const CellLocation& next, vtkIdType link, CellLocation& location, int face, double p[3]) const
  {
    const CellShape::Face& from = CellShape::Of(this->GetShape(location)).Faces[face];
    double uv[2];
    from.GetParameters(p, uv);
    FaceLinks::Map(from.NumberOfCorners, link >> 1 & 3, link & 1, uv);
    location = next;
    CellShape::Of(this->GetShape(location)).Faces[link >> 3 & 7].GetCoordinates(uv, p);
  }

private:
  // CellShape of a VTK cell type, with the VTK index of each of its corners.
  struct TypeCorners
  {
    int Shape;
    int Number;
    int Order[8];
  };
  // Returns the corners of a VTK cell type. Unsupported types have 0 corners.
  static const TypeCorners& GetCorners(int type)
  {
    static constexpr TypeCorners none = { CellShape::TETRAHEDRON, 0, {} };
    static constexpr TypeCorners known[5] = { { CellShape::TETRAHEDRON, 4, { 0, 1, 2, 3 } },
      { CellShape::HEXAHEDRON, 8, { 0, 1, 2, 3, 4, 5, 6, 7 } },
      { CellShape::HEXAHEDRON, 8, { 0, 1, 3, 2, 4, 5, 7, 6 } },
      { CellShape::WEDGE, 6, { 0, 1, 2, 3, 4, 5 } }, { CellShape::PYRAMID, 5, { 0, 1, 2, 3, 4 } } };
    return type >= FirstType && type < FirstType + 5 ? known[type - FirstType] : none;
  }
  // VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE and VTK_PYRAMID are consecutive.
  static constexpr int FirstType = 10;

  template <typename Visitor>
  void ForEachCorner(const CellLocation& location, Visitor&& visit) const
  {
    const TypeCorners& corners = GetCorners(location.Type);
    for (int corner = 0; corner < corners.Number; ++corner)
    {
      visit(corner, this->PointIds.Get(location.First + corners.Order[corner]));
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
  // VTK type and number of points that all cells share, or 0 if the cells differ.
  int OnlyType = 0;
  int OnlySize = 0;
  vtkSmartPointer<GridCells::Types> TypeArray;
  std::shared_ptr<const MeshLinks> Mesh;
  vtkIdType NumberOfReusedFaceMatches = 0;
  // Copied from Mesh.
  int FacesPerCell = 0;
  const vtkIdType* Links = nullptr;
};

}

#endif
