// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InteriorFaces_h
#define interlume_InteriorFaces_h

#include "Cuts/CoincidentSlots.h"
#include "Grid/CellCorners.h"
#include "Grid/CellOrientation.h"
#include "Grid/CornerOrder.h"
#include "Grid/InteriorCellFilter.h"
#include "Pass/ExtractionContext.h"

#include "vtkIdList.h"
#include "vtkIsotable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

class vtkPoints;

namespace interlume
{

/**
 * @class   InteriorFaces
 * @brief   faces of interior cells, triangulated as in adjacent cut cells
 *
 * Use it only in the first pass, before points are removed and cells are renumbered. Visiting is
 * thread-safe.
 */
class InteriorFaces
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /// A face of three or four points in no particular order. The fourth point of a triangle is -1.
  using Polygon = std::array<vtkIdType, 4>;

  /**
   * Returns the number of non-planar quadrilaterals between an interior cell and tetrahedra in the
   * mesh of the first pass. Such a face is a bilinear surface in the interior cell, but two
   * triangles in the tetrahedra. \a points holds the coordinates of the mesh.
   */
  static vtkIdType CountNonPlanar(
    const ExtractionContext& context, const ExtractionMesh& mesh, vtkPoints* points);

  InteriorFaces(const ExtractionContext& context, const ExtractionMesh& mesh)
    : Context(context)
    , Mesh(mesh)
    , Grid(vtkUnstructuredGrid::SafeDownCast(context.Input))
    , Order(context.Input->GetPointData())
    , Orientation(context.Input)
  {
  }

  /// Calls visit(triangle, polygon) for each outward-oriented triangle of the faces of an interior
  /// cell, with the face that contains it. Both use output ids. A polyhedron face with more than
  /// four points is visited as triangles.
  template <typename Visitor>
  void Visit(vtkIdType cell, const vtkIdType* ids, int number, Visitor&& visit) const
  {
    const CellCorners corners = CellCorners::Of(this->Mesh.InteriorCellTypes[cell]);
    if (corners.Kind == CellCorners::POLYHEDRAL)
    {
      this->VisitParts(cell, ids, number, visit);
      return;
    }
    vtkIdType points[8];
    vtkIdType outputs[8];
    PermuteCorners(corners, ids, number, outputs);
    std::transform(outputs, outputs + number, points,
      [this](vtkIdType id) { return this->Mesh.Points[id].Near; });
    this->VisitCell(corners.Shape, points, outputs, number, visit);
  }

  /// Returns whether isSought(polygon) is true for any face of an interior cell. This is faster
  /// than visiting triangles. Always true for a polyhedron.
  template <typename Predicate>
  bool HasFace(vtkIdType cell, const vtkIdType* ids, int number, Predicate&& isSought) const
  {
    const CellCorners corners = CellCorners::Of(this->Mesh.InteriorCellTypes[cell]);
    if (corners.Kind == CellCorners::POLYHEDRAL)
    {
      return true;
    }
    vtkIdType outputs[8];
    PermuteCorners(corners, ids, number, outputs);
    bool isFound = false;
    const vtkIsotable& table = vtkIsotable::Get(vtkIsotable::INTERVAL, corners.Shape);
    table.ForEachSide(table.GetCase(CoincidentSlots::GetAllInsideKey(number)),
      [&](const vtkIsotable::Slot* slots, int size)
      { isFound = isFound || isSought(MakePolygon(outputs, slots, size)); });
    return isFound;
  }

private:
  // Permutes the corners to the order of the cell's isotable.
  static void PermuteCorners(
    const CellCorners& corners, const vtkIdType* ids, int number, vtkIdType* permuted)
  {
    for (int v = 0; v < number; ++v)
    {
      permuted[v] = ids[corners.Turned ? v ^ ((v >> 1) & 1) : v];
    }
  }

  static Polygon MakePolygon(const vtkIdType* outputs, const vtkIsotable::Slot* slots, int size)
  {
    Polygon polygon{ { -1, -1, -1, -1 } };
    std::transform(slots, slots + size, polygon.begin(),
      [outputs](vtkIsotable::Slot slot) { return outputs[slot]; });
    return polygon;
  }

  template <typename Visitor>
  void VisitCell(vtkIsotable::Shapes shape, const vtkIdType* points, const vtkIdType* outputs,
    int number, Visitor&& visit) const
  {
    const vtkIsotable& table = vtkIsotable::Get(vtkIsotable::INTERVAL, shape);
    vtkIsotable::Slot ranks[8];
    if (this->Grid)
    {
      this->Order.Rank(points, number, ranks);
    }
    else
    {
      // Corner ids of structured cells are ascending.
      std::iota(ranks, ranks + number, vtkIsotable::Slot(0));
    }
    const bool isInverted = this->Orientation.IsInverted(shape, points);
    table.CutSides(table.GetCase(CoincidentSlots::GetAllInsideKey(number)),
      table.GetSlotRanks(ranks),
      [&](vtkIsotable::Slot a, vtkIsotable::Slot b, vtkIsotable::Slot c,
        const vtkIsotable::Slot* slots, int size)
      {
        const Triangle triangle{ { outputs[a], outputs[isInverted ? c : b],
          outputs[isInverted ? b : c] } };
        visit(triangle, MakePolygon(outputs, slots, size));
      });
  }

  // Visits the faces of the cells that replace a polyhedron, except those that contain its center.
  template <typename Visitor>
  void VisitParts(vtkIdType cell, const vtkIdType* ids, int number, Visitor&& visit) const
  {
    const vtkIdType first = this->Mesh.CellIds[this->Mesh.Simplices.GetNumber() + cell];
    const vtkIdType end = this->Context.InteriorFilter->GetEndOfParts(first);
    vtkNew<vtkIdList> list;
    for (vtkIdType part = first; part < end; ++part)
    {
      const CellCorners corners = CellCorners::Of(this->Grid->GetCellType(part));
      this->Grid->GetCellPoints(part, list);
      vtkIdType points[8];
      vtkIdType outputs[8];
      for (int v = 0; v < corners.NumberOfCorners; ++v)
      {
        points[v] = list->GetId(corners.Turned ? v ^ ((v >> 1) & 1) : v);
        const vtkIdType* at = std::find_if(
          ids, ids + number, [&](vtkIdType id) { return this->Mesh.Points[id].Near == points[v]; });
        outputs[v] = at == ids + number ? -1 : *at;
      }
      this->VisitCell(corners.Shape, points, outputs, corners.NumberOfCorners,
        [&visit](const Triangle& triangle, const Polygon& polygon)
        {
          if (std::find(triangle.begin(), triangle.end(), -1) == triangle.end())
          {
            visit(triangle, polygon);
          }
        });
    }
  }

  const ExtractionContext& Context;
  const ExtractionMesh& Mesh;
  // The input if it is unstructured, otherwise null.
  vtkUnstructuredGrid* Grid;
  CornerOrder Order;
  CellOrientation Orientation;
};

}

#endif
