// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OpenInterfaces_h
#define interlume_OpenInterfaces_h

#include "Cells/InterpolatedCell.h"
#include "Common/Vectors.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <cfloat>
#include <vector>

namespace interlume
{

/**
 * @class   OpenInterfaces
 * @brief   counts the outer faces that have a cell beyond them: it has no face that fits, and
 * streamlines end there
 *
 * The place that is looked at is a fiftieth of the cell's width beyond its middle.
 */
struct OpenInterfaces
{
  vtkIdType Number = 0;
  /// The cell of the first of these faces; -1 without one.
  vtkIdType FirstCell = -1;

  /// Counts the faces in a field of cells of any form.
  template <typename Field>
  static OpenInterfaces Find(const Field& field)
  {
    const std::vector<vtkIdType> faces = field.GetOuterFaces();
    std::atomic<vtkIdType> number(0);
    std::atomic<vtkIdType> least(VTK_ID_MAX);
    vtkSMPTools::For(0, static_cast<vtkIdType>(faces.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const vtkIdType face = faces[static_cast<std::size_t>(i)];
          double x[3];
          if (GetPlaceBeyond(field, face, x) && HasCell(field, face / 8, x))
          {
            ++number;
            vtkIdType known = least;
            while (i < known && !least.compare_exchange_weak(known, i))
            {
            }
          }
        }
      });
    OpenInterfaces found;
    found.Number = number;
    found.FirstCell =
      found.Number > 0 ? faces[static_cast<std::size_t>(least.load())] / 8 : vtkIdType(-1);
    return found;
  }

  /// Computes the place to look at beyond a face. Returns false where the face has collapsed, so
  /// that nothing leaves by it.
  template <typename Field>
  static bool GetPlaceBeyond(const Field& field, vtkIdType face, double x[3])
  {
    InterpolatedCell cell;
    const typename Field::Place place = field.GetPlace(face / 8);
    field.GetPoints(place, cell.GetPoints());
    cell.SetPoints(field.GetShape(place));
    return GetPlaceBeyond(cell, static_cast<int>(face % 8), x);
  }

  /// Returns whether a cell that is not \a own holds x.
  template <typename Field>
  static bool HasCell(const Field& field, vtkIdType own, const double x[3])
  {
    InterpolatedCell cell;
    return field.GetTree().Visit(x,
      [&](vtkIdType other)
      {
        const typename Field::Place there = field.GetHeldPlace(other);
        const int shape = field.GetShape(there);
        field.GetPoints(there, cell.GetPoints());
        if (there.Cell == own || !cell.IsInBox(shape, x))
        {
          return false;
        }
        cell.SetPoints(shape);
        double p[3];
        return cell.FindPlace(x, false, p) && cell.GetDistance(p) >= -1e-9;
      });
  }

private:
  static constexpr double Step = 0.02;

  static bool GetPlaceBeyond(const InterpolatedCell& cell, int face, double x[3])
  {
    const CellShape& shape = CellShape::Of(cell.GetShape());
    const CellShape::Face& own = shape.Faces[face];
    double middle[3] = { 0.0, 0.0, 0.0 };
    for (int i = 0; i < own.NumberOfCorners; ++i)
    {
      double corner[3];
      cell.GetPosition(shape.Corners[own.Corners[i]], corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] += corner[axis] / own.NumberOfCorners;
      }
    }
    const FaceExtent extent = cell.GetFaceExtent(face);
    double centre[3];
    cell.GetPosition(shape.Centre, centre);
    vtkMath::Subtract(middle, centre, centre);
    const double step = vtkMath::Dot(extent.Normal, centre) < 0.0 ? -Step : Step;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = middle[axis] + step * extent.Width * extent.Normal[axis];
    }
    return Step * extent.Width > 64.0 * DBL_EPSILON * Vectors::SafeLength(glm::make_vec3(middle));
  }
};

}

#endif
