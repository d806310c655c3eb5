// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_WholeFaces_h
#define interlume_WholeFaces_h

#include "Cuts/ExtractionCell.h"
#include "Grid/CellCorners.h"
#include "Grid/CellOrientation.h"
#include "Grid/CornerOrder.h"
#include "Grid/WholeCells.h"
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
 * @class   WholeFaces
 * @brief   the faces of cells that are passed on whole, cut into triangles as their neighbours are
 *
 * It is for the first pass, before points are given up and cells renamed. Any number of threads may
 * visit.
 */
class WholeFaces
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /// A face of three or four points in no order; the fourth of a triangle is -1.
  using Polygon = std::array<vtkIdType, 4>;

  /**
   * Returns the number of quadrilaterals, not planar, where a whole cell meets tetrahedra, in the
   * first pass's mesh, whose coordinates are \a points. There a whole cell's face is one surface
   * through four points, and the tetrahedra's are two triangles.
   */
  static vtkIdType CountWarped(
    const ExtractionContext& context, const ExtractionMesh& mesh, vtkPoints* points);

  WholeFaces(const ExtractionContext& context, const ExtractionMesh& mesh)
    : Context(context)
    , Mesh(mesh)
    , Grid(vtkUnstructuredGrid::SafeDownCast(context.Input))
    , Order(context.Input->GetPointData())
    , Orientation(context.Input)
  {
  }

  /// Calls visit(triangle, polygon) for each triangle of a whole cell's faces, outward, with the
  /// face that it is of; both have the output's ids. A face of a polyhedron that has more than four
  /// points is triangles.
  template <typename Visitor>
  void Visit(vtkIdType cell, const vtkIdType* ids, int number, Visitor&& visit) const
  {
    const CellCorners corners = CellCorners::Of(this->Mesh.WholeTypes[cell]);
    if (corners.Kind == CellCorners::POLYHEDRAL)
    {
      this->VisitParts(cell, ids, number, visit);
      return;
    }
    vtkIdType points[8];
    vtkIdType outputs[8];
    TurnCorners(corners, ids, number, outputs);
    std::transform(outputs, outputs + number, points,
      [this](vtkIdType id) { return this->Mesh.Points[id].Near; });
    this->VisitCell(corners.Shape, points, outputs, number, visit);
  }

  /// Returns whether isSought(polygon) for any face of a whole cell, which takes less time than to
  /// visit its triangles; always for a polyhedron.
  template <typename Predicate>
  bool HasFace(vtkIdType cell, const vtkIdType* ids, int number, Predicate&& isSought) const
  {
    const CellCorners corners = CellCorners::Of(this->Mesh.WholeTypes[cell]);
    if (corners.Kind == CellCorners::POLYHEDRAL)
    {
      return true;
    }
    vtkIdType outputs[8];
    TurnCorners(corners, ids, number, outputs);
    bool isFound = false;
    const vtkIsotable& table = vtkIsotable::Get(vtkIsotable::INTERVAL, corners.Shape);
    table.ForEachSide(table.GetCase(ExtractionCell::GetKeyInside(number)),
      [&](const vtkIsotable::Slot* slots, int size)
      { isFound = isFound || isSought(MakePolygon(outputs, slots, size)); });
    return isFound;
  }

private:
  // Gives the corners in the order of the cell's table.
  static void TurnCorners(
    const CellCorners& corners, const vtkIdType* ids, int number, vtkIdType* turned)
  {
    for (int v = 0; v < number; ++v)
    {
      turned[v] = ids[corners.Turned ? v ^ ((v >> 1) & 1) : v];
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
      // Corners in rows ascend.
      std::iota(ranks, ranks + number, vtkIsotable::Slot(0));
    }
    const bool isInverted = this->Orientation.IsInverted(shape, points);
    table.CutSides(table.GetCase(ExtractionCell::GetKeyInside(number)), table.GetSlotRanks(ranks),
      [&](vtkIsotable::Slot a, vtkIsotable::Slot b, vtkIsotable::Slot c,
        const vtkIsotable::Slot* slots, int size)
      {
        const Triangle triangle{ { outputs[a], outputs[isInverted ? c : b],
          outputs[isInverted ? b : c] } };
        visit(triangle, MakePolygon(outputs, slots, size));
      });
  }

  // Visits the faces of the cells that stand for a polyhedron but those at the mean of its points.
  template <typename Visitor>
  void VisitParts(vtkIdType cell, const vtkIdType* ids, int number, Visitor&& visit) const
  {
    const vtkIdType first = this->Mesh.CellIds[this->Mesh.Simplices.GetNumber() + cell];
    const vtkIdType end = this->Context.Whole->GetEndOfParts(first);
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
  // The input where it is not in rows; else null.
  vtkUnstructuredGrid* Grid;
  CornerOrder Order;
  CellOrientation Orientation;
};

}

#endif
