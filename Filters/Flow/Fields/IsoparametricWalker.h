// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IsoparametricWalker_h
#define interlume_IsoparametricWalker_h

#include "Cells/CellFinding.h"
#include "Cells/InterpolatedCell.h"
#include "Fields/CellWalker.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace interlume
{

/**
 * @class   IsoparametricWalker
 * @brief   the walker of cells of any form: structured and unstructured grids
 *
 * Position and vectors are interpolated by the same functions of p (InterpolatedCell), so that
 * nothing is inverted on the way. Only Locate needs Newton's method, in the cells that CellTree
 * finds. The cell that counts is the first one in the tree's order whose faces p is inside of;
 * without one it is the cell that p is the least outside of, where that is no more than rounding
 * (CellFinding).
 *
 * A cell that is folded, where dx/dp has no inverse, or that is turned inside out beside its
 * neighbour, may send a streamline to and fro over a face without time passing: who walks counts
 * the crossings.
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
    CellFinding found;
    if (!this->Search(x, found))
    {
      return false;
    }
    this->EnterVectors();
    std::copy(found.P, found.P + 3, p);
    return true;
  }

  /// Finds the cell as Locate does, among those that are here, all but the order. The walker then
  /// stands nowhere.
  bool Search(const double x[3], CellFinding& found)
  {
    return this->SearchFrom(x, false, found) || this->SearchFrom(x, true, found);
  }
  /// Stands in a cell of the field, wherever it stood before.
  void GoTo(vtkIdType cell)
  {
    this->Stand = this->Shared->GetPlace(cell);
    this->EnterPoints();
    this->EnterVectors();
  }

  bool IsHere() const { return this->Shared->IsHere(this->Stand); }
  const typename Field::Place& GetPlace() const { return this->Stand; }
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
  double GetLongestWorldVector(const double d[3]) const
  {
    return this->Cell.GetLongestWorldVector(d);
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
    // Another process may have what is there.
    if (this->IsHere())
    {
      this->EnterPoints();
      this->EnterVectors();
    }
    return true;
  }

  bool HasNeighbor(int face) const
  {
    typename Field::Place place = this->Stand;
    double p[3] = { 0.0, 0.0, 0.0 };
    return this->Shared->Cross(place, face, p);
  }
  FaceExtent GetFaceExtent(int face) const
  {
    FaceExtent extent = this->Cell.GetFaceExtent(face);
    extent.Bend += this->Shared->GetRounding();
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
  void EnterPoints()
  {
    this->Shared->GetPoints(this->Stand, this->Cell.GetPoints());
    this->Cell.SetPoints(this->Shared->GetShape(this->Stand));
  }
  void EnterVectors()
  {
    this->Shared->GetVectors(this->Stand, this->Cell.GetVectors());
    this->Cell.SetVectors();
  }

  // Looks for x with one start of Newton's method, or with several.
  bool SearchFrom(const double x[3], bool fromSeveral, CellFinding& found)
  {
    double leastOutside = VTK_DOUBLE_MAX;
    typename Field::Place best;
    this->Shared->GetTree().Visit(x,
      [&](vtkIdType cell)
      {
        this->Stand = this->Shared->GetHeldPlace(cell);
        const int shape = this->Shared->GetShape(this->Stand);
        this->Shared->GetPoints(this->Stand, this->Cell.GetPoints());
        if (!this->Cell.IsInBox(shape, x))
        {
          return false;
        }
        this->Cell.SetPoints(shape);
        double p[3];
        if (!this->Cell.FindPlace(x, fromSeveral, p))
        {
          return false;
        }
        const double outside = -this->Cell.GetDistance(p);
        if (outside < leastOutside && outside <= this->GetSlack(x, p))
        {
          leastOutside = outside;
          best = this->Stand;
          std::copy(p, p + 3, found.P);
        }
        return leastOutside <= 0.0;
      });
    if (leastOutside == VTK_DOUBLE_MAX)
    {
      return false;
    }
    this->Stand = best;
    this->EnterPoints();
    this->Cell.Clamp(found.P);
    found.IsFound = true;
    found.IsFromSeveral = fromSeveral;
    found.Outside = std::max(leastOutside, 0.0);
    found.Cell = best.Cell;
    return true;
  }

  // Returns how far outside of the cell rounding may put a point of it.
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
  typename Field::Place Stand;
  InterpolatedCell Cell;
};

}

#endif
