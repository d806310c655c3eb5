// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IsoparametricWalker_h
#define interlume_IsoparametricWalker_h

#include "Cells/CellSearchResult.h"
#include "Cells/InterpolatedCell.h"
#include "Fields/CellWalker.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace interlume
{

/**
 * @class   IsoparametricWalker
 * @brief   walker for cells of any shape, in structured and unstructured grids
 *
 * Positions and vectors are interpolated with the same functions of p (InterpolatedCell), so
 * tracing does not invert the mapping from p to x. Only Locate() does, using Newton's method in the
 * cells found by CellTree. Locate() enters the first cell in the tree that contains the point. If
 * no cell does, it enters the nearest cell, provided that the point is outside only by rounding
 * error.
 *
 * Folded cells, where dx/dp is singular, and cells that are inverted relative to their neighbors
 * can cause endless crossings without progress in time. Therefore callers limit the number of
 * crossings.
 */
template <typename FieldType>
class IsoparametricWalker : public CellWalker
{
public:
  using Field = FieldType;

  explicit IsoparametricWalker(const Field* field)
    : Shared(field)
  {
  }

  const Field& GetField() const { return *this->Shared; }

  bool Locate(const double x[3], double p[3])
  {
    CellSearchResult found;
    if (!this->Search(x, found))
    {
      return false;
    }
    this->LoadVectors();
    std::copy(found.P, found.P + 3, p);
    return true;
  }

  bool LocateNearby(const double x[3], double p[3])
  {
    constexpr int maximumCrossings = 3;
    bool canCross = true;
    for (int i = 0; canCross && this->Cell.FindCellCoordinatesNear(x, p); ++i)
    {
      const int face = this->GetNearestFace(p);
      if (this->GetFaceDistance(face, p) >= 0.0)
      {
        return true;
      }
      canCross = i < maximumCrossings && this->Cross(face, p);
    }
    return this->Locate(x, p);
  }

  /// Finds the cell that Locate() would enter, among the cells in this process. Call GoTo() to
  /// enter the cell; until then, the walker is in no cell.
  bool Search(const double x[3], CellSearchResult& found)
  {
    return this->SearchFrom(x, false, found) || this->SearchFrom(x, true, found);
  }
  /// Enters a cell of the field, which need not be a neighbor of the current cell.
  void GoTo(vtkIdType cell)
  {
    this->Stand = this->Shared->GetCellLocation(cell);
    this->LoadPoints();
    this->LoadVectors();
  }

  bool IsHere() const { return this->Shared->IsHere(this->Stand); }
  const typename Field::CellLocation& GetCellLocation() const { return this->Stand; }
  vtkIdType GetCell() const { return this->Stand.Cell; }
  bool IsFinite() const { return this->Cell.IsFinite(); }

  void GetVelocity(const double p[3], double rate[3]) const { this->Cell.GetVelocity(p, rate); }
  void GetJacobian(const double p[3], double jacobian[9]) const
  {
    this->Cell.GetJacobian(p, jacobian);
  }
  void GetPosition(const double p[3], double x[3]) const { this->Cell.GetPosition(p, x); }
  void GetWorldVector(const double p[3], const double d[3], double w[3]) const
  {
    this->Cell.GetWorldVector(p, d, w);
  }
  bool IsAffine() const { return this->Cell.IsAffine(); }
  double GetMaximumWorldLength(const double d[3]) const
  {
    return this->Cell.GetMaximumWorldLength(d);
  }
  void GetVelocityGradient(const double p[3], double gradient[9]) const
  {
    this->Cell.GetVelocityGradient(p, gradient);
  }

  bool IsBox() const { return this->Cell.GetShape() == CellShape::HEXAHEDRON; }
  int GetNumberOfFaces() const { return this->Cell.GetNumberOfFaces(); }
  double GetFaceDistance(int face, const double p[3]) const
  {
    return this->Cell.GetFace(face).GetDistance(p);
  }

  bool Cross(int face, double p[3])
  {
    if (!this->Shared->Cross(this->Stand, face, p))
    {
      return false;
    }
    // The cell may belong to another process, whose data is not available.
    if (this->IsHere())
    {
      this->LoadPoints();
      this->LoadVectors();
    }
    return true;
  }

  bool HasNeighbor(int face) const
  {
    typename Field::CellLocation location = this->Stand;
    double p[3] = { 0.0, 0.0, 0.0 };
    return this->Shared->Cross(location, face, p);
  }
  FaceExtent GetFaceExtent(int face) const
  {
    FaceExtent extent = this->Cell.GetFaceExtent(face);
    extent.Bend += this->Shared->GetRoundingError();
    return extent;
  }

  double Interpolate(int array, const double p[3]) const
  {
    Trilinear values;
    this->Shared->GetValues(array, this->Stand, values);
    CellShape::Fit(this->Cell.GetShape(), values);
    double value[3];
    this->Cell.Evaluate(values, p, value);
    return value[0];
  }

protected:
  void LoadPoints()
  {
    this->Shared->GetPoints(this->Stand, this->Cell.GetPoints());
    this->Cell.SetPoints(this->Shared->GetShape(this->Stand));
  }
  void LoadVectors()
  {
    this->Shared->GetVectors(this->Stand, this->Cell.GetVectors());
    this->Cell.SetVectors();
  }

  // Searches for x with Newton's method, from one or several starting points per cell.
  bool SearchFrom(const double x[3], bool fromSeveral, CellSearchResult& found)
  {
    double smallestOutside = VTK_DOUBLE_MAX;
    typename Field::CellLocation best;
    this->Shared->GetTree().Visit(x,
      [&](vtkIdType cell)
      {
        this->Stand = this->Shared->GetHeldCellLocation(cell);
        const int shape = this->Shared->GetShape(this->Stand);
        this->Shared->GetPoints(this->Stand, this->Cell.GetPoints());
        if (!this->Cell.IsInBox(shape, x))
        {
          return false;
        }
        this->Cell.SetPoints(shape);
        double p[3];
        if (!this->Cell.FindCellCoordinates(x, fromSeveral, p))
        {
          return false;
        }
        const double outside = -this->Cell.GetDistance(p);
        if (outside < smallestOutside && outside <= this->GetSlack(x, p))
        {
          smallestOutside = outside;
          best = this->Stand;
          std::copy(p, p + 3, found.P);
        }
        return smallestOutside <= 0.0;
      });
    if (smallestOutside == VTK_DOUBLE_MAX)
    {
      return false;
    }
    this->Stand = best;
    this->LoadPoints();
    this->Cell.Clamp(found.P);
    found.IsFound = true;
    found.IsFromSeveral = fromSeveral;
    found.Outside = std::max(smallestOutside, 0.0);
    found.Cell = best.Cell;
    return true;
  }

  // Returns the face that is closest to p or, if p is outside the cell, behind which p is farthest.
  int GetNearestFace(const double p[3]) const
  {
    int nearest = 0;
    for (int face = 1; face < this->GetNumberOfFaces(); ++face)
    {
      nearest = this->GetFaceDistance(face, p) < this->GetFaceDistance(nearest, p) ? face : nearest;
    }
    return nearest;
  }

  // Returns how far outside the cell rounding errors may move p, in local coordinates.
  double GetSlack(const double x[3], const double p[3]) const
  {
    const double largest = std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
    double shortest = VTK_DOUBLE_MAX;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double along[3] = { axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0,
        axis == 2 ? 1.0 : 0.0 };
      double w[3];
      this->Cell.GetWorldVector(p, along, w);
      const double length = std::hypot(w[0], w[1], w[2]);
      shortest = length > 0.0 ? std::min(shortest, length) : shortest;
    }
    return std::min(1e-12 + 32.0 * DBL_EPSILON * largest / shortest, 1e-6);
  }

  const Field* Shared;
  typename Field::CellLocation Stand;
  InterpolatedCell Cell;
};

}

#endif
