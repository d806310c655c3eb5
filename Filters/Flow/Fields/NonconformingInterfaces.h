// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_NonconformingInterfaces_h
#define interlume_NonconformingInterfaces_h

#include "Cells/InterpolatedCell.h"
#include "Common/ParallelFor.h"
#include "Common/Vectors.h"

#include "vtkMath.h"

#include <atomic>
#include <cfloat>
#include <vector>

namespace interlume
{

/**
 * @class   NonconformingInterfaces
 * @brief   counts faces that no other face matches although there is a cell on the other side
 *
 * Streamlines end at such faces inside the grid. A face counts if another cell contains its test
 * position, which is outside the face's own cell at a distance of Step times the cell width from
 * the center of the face.
 */
struct NonconformingInterfaces
{
  vtkIdType Number = 0;
  /// Id of the cell of the first counted face, or -1 if there is none.
  vtkIdType FirstCell = -1;

  /// Counts the faces of a field whose cells may have any shape.
  template <typename Field>
  static NonconformingInterfaces Find(const Field& field)
  {
    const std::vector<vtkIdType> faces = field.GetOuterFaces();
    std::atomic<vtkIdType> number(0);
    std::atomic<vtkIdType> firstIndex(VTK_ID_MAX);
    ParallelFor(0, static_cast<vtkIdType>(faces.size()),
      [&](vtkIdType i)
      {
        const vtkIdType face = faces[static_cast<std::size_t>(i)];
        double x[3];
        if (GetPositionOutside(field, face, x) && HasCell(field, face / 8, x))
        {
          ++number;
          vtkIdType known = firstIndex;
          while (i < known && !firstIndex.compare_exchange_weak(known, i))
          {
          }
        }
      });
    NonconformingInterfaces found;
    found.Number = number;
    found.FirstCell =
      found.Number > 0 ? faces[static_cast<std::size_t>(firstIndex.load())] / 8 : vtkIdType(-1);
    return found;
  }

  /// Computes the test position outside a face. Returns false for a collapsed face, through which
  /// no streamline leaves.
  template <typename Field>
  static bool GetPositionOutside(const Field& field, vtkIdType face, double x[3])
  {
    InterpolatedCell cell;
    const typename Field::CellLocation location = field.GetCellLocation(face / 8);
    field.GetPoints(location, cell.GetPoints());
    cell.SetPoints(field.GetShape(location));
    return GetPositionOutside(cell, static_cast<int>(face % 8), x);
  }

  /// Returns whether a cell other than \a own contains x.
  template <typename Field>
  static bool HasCell(const Field& field, vtkIdType own, const double x[3])
  {
    InterpolatedCell cell;
    return field.GetTree().Visit(x,
      [&](vtkIdType other)
      {
        const typename Field::CellLocation there = field.GetHeldCellLocation(other);
        const int shape = field.GetShape(there);
        field.GetPoints(there, cell.GetPoints());
        if (there.Cell == own || !cell.IsInBox(shape, x))
        {
          return false;
        }
        cell.SetPoints(shape);
        double p[3];
        return cell.FindCellCoordinates(x, false, p) && cell.GetDistance(p) >= -1e-9;
      });
  }

private:
  static constexpr double Step = 0.02;

  static bool GetPositionOutside(const InterpolatedCell& cell, int face, double x[3])
  {
    const CellShape& shape = CellShape::Of(cell.GetShape());
    const CellShape::Face& own = shape.Faces[face];
    double faceCenter[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < own.NumberOfCorners; ++i)
    {
      double corner[3];
      cell.GetPosition(shape.Corners[own.Corners[i]], corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        faceCenter[axis] += corner[axis] / own.NumberOfCorners;
      }
    }
    const FaceExtent extent = cell.GetFaceExtent(face);
    double center[3];
    cell.GetPosition(shape.Center, center);
    vtkMath::Subtract(faceCenter, center, center);
    const double step = vtkMath::Dot(extent.Normal, center) < 0.0 ? -Step : Step;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = faceCenter[axis] + step * extent.Width * extent.Normal[axis];
    }
    return Step * extent.Width >
      64.0 * DBL_EPSILON * Vectors::SafeLength(glm::make_vec3(faceCenter));
  }
};

}

#endif
