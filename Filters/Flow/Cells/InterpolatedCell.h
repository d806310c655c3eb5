// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InterpolatedCell_h
#define interlume_InterpolatedCell_h

#include "Cells/CellShape.h"
#include "Cells/FaceExtent.h"
#include "Cells/InverseJacobian.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace interlume
{

/**
 * @class   InterpolatedCell
 * @brief   evaluates position, velocity and their derivatives in a cell of any CellShape
 *
 * With the interpolants x(p) and v(p) of the cell, dp/dt = (dx/dp)^-1 v. If x(p) is affine up to
 * rounding error, for example in tetrahedra, voxels and parallelepipeds, the inverse is applied
 * once to the coefficients of v. Otherwise it is computed at each p.
 */
class InterpolatedCell
{
public:
  ///@{
  /// Values at the corners. Fill the points and call SetPoints, then fill the vectors and call
  /// SetVectors.
  Trilinear& GetPoints() { return this->Points; }
  Trilinear& GetVectors() { return this->Vectors; }
  void SetPoints(int shape);
  void SetVectors();
  ///@}

  /// Returns true if \a x is in the slightly enlarged bounding box of the corners. Call it before
  /// SetPoints.
  bool IsInBox(int shape, const double x[3]) const;

  int GetShape() const { return this->Shape; }
  const CellShape::Face& GetFace(int face) const { return CellShape::Of(this->Shape).Faces[face]; }
  /// Returns the extent of a face in world units.
  FaceExtent GetFaceExtent(int face) const;
  int GetNumberOfFaces() const { return CellShape::Of(this->Shape).NumberOfFaces; }
  bool IsFinite() const { return this->HasFiniteVectors; }

  void GetVelocity(const double p[3], double rate[3]) const
  {
    switch (this->Form)
    {
      case LINEAR:
        this->Vectors.EvaluateLinear(p, rate);
        return;
      case AFFINE:
        this->Vectors.Evaluate(p, rate);
        return;
      default:
        double inverse[3][3];
        this->GetInverse(p, inverse);
        double velocity[3];
        this->Evaluate(this->Vectors, p, velocity);
        InverseJacobian::Multiply(inverse, velocity, rate);
    }
  }

  void GetJacobian(const double p[3], double jacobian[9]) const;

  void GetPosition(const double p[3], double x[3]) const { this->Evaluate(this->Points, p, x); }

  void GetWorldVector(const double p[3], const double d[3], double w[3]) const
  {
    double columns[3][4];
    this->EvaluateDerivatives(this->Points, p, columns);
    InverseJacobian::Combine(columns, d, w);
  }

  /// IsAffine returns true if dx/dp is constant in the cell. GetLongestWorldVector returns an upper
  /// bound on the length of w from GetWorldVector(p, e, w), for p in the cell and |e[i]| <= d[i].
  bool IsAffine() const { return this->Form != CURVED; }
  double GetMaximumWorldLength(const double d[3]) const;

  void GetVelocityGradient(const double p[3], double gradient[9]) const;

  /// Evaluates a polynomial at p. CellShape::Fit must have computed it for this cell's shape.
  void Evaluate(const Trilinear& polynomial, const double p[3], double value[3]) const
  {
    if (this->Shape == CellShape::PYRAMID)
    {
      double r;
      double s;
      const double w = GetPyramidRatios(p, r, s);
      const double product = w * r * s;
      const auto& c = polynomial.C;
      for (int i = 0; i < 3; ++i)
      {
        value[i] = c[0][i] + p[0] * c[1][i] + p[1] * c[2][i] + p[2] * c[4][i] + product * c[3][i];
      }
      return;
    }
    polynomial.Evaluate(p, value);
  }

  /**
   * Finds the coordinates p of \a x by Newton's method, starting at the center of the cell or, more
   * slowly, from several points. Returns false if the method does not converge. p may be outside
   * the cell.
   */
  bool FindCellCoordinates(const double x[3], bool fromSeveral, double p[3]) const;
  /// The same, starting at p.
  bool FindCellCoordinatesNear(const double x[3], double p[3]) const
  {
    const double start[3] = { p[0], p[1], p[2] };
    return this->FindCellCoordinatesFrom(start, x, p);
  }

  /// Returns the smallest distance to a face, in parametric coordinates. It is negative outside.
  double GetDistance(const double p[3]) const;
  /// Projects a point that is slightly outside some faces onto these faces.
  void Clamp(double p[3]) const;

private:
  enum Forms
  {
    LINEAR,
    AFFINE,
    CURVED
  };

  // Returns 1 - z and computes VTK's parametric coordinates r and s of a pyramid.
  static double GetPyramidRatios(const double p[3], double& r, double& s)
  {
    const double w = 1.0 - p[2];
    const double divisor = std::max(w, 1e-100);
    r = std::min(std::max(p[0] / divisor, -1.0), 2.0);
    s = std::min(std::max(p[1] / divisor, -1.0), 2.0);
    return w;
  }

  void EvaluateDerivatives(
    const Trilinear& polynomial, const double p[3], double columns[3][4]) const
  {
    if (this->Shape == CellShape::PYRAMID)
    {
      double r;
      double s;
      GetPyramidRatios(p, r, s);
      const auto& c = polynomial.C;
      for (int i = 0; i < 4; ++i)
      {
        columns[0][i] = c[1][i] + s * c[3][i];
        columns[1][i] = c[2][i] + r * c[3][i];
        columns[2][i] = c[4][i] + r * s * c[3][i];
      }
      return;
    }
    polynomial.EvaluateDerivatives(p, columns);
  }

  void GetInverse(const double p[3], double inverse[3][3]) const
  {
    double columns[3][4];
    this->EvaluateDerivatives(this->Points, p, columns);
    InverseJacobian::Invert(columns, inverse);
  }

  void EvaluateSecondDerivatives(
    const Trilinear& polynomial, const double p[3], double second[3][3][3]) const;
  bool FindCellCoordinatesFrom(const double start[3], const double x[3], double p[3]) const;

  int Shape = CellShape::HEXAHEDRON;
  Forms Form = CURVED;
  bool HasFiniteVectors = false;
  Trilinear Points = {};
  // Coefficients of v, or of dp/dt if x(p) is affine.
  Trilinear Vectors = {};
};

inline void InterpolatedCell::SetPoints(int shape)
{
  this->Shape = shape;
  CellShape::Fit(shape, this->Points);
  if (shape == CellShape::TETRAHEDRON)
  {
    this->Form = LINEAR;
    return;
  }
  this->Form = CURVED;
  if (shape == CellShape::PYRAMID)
  {
    return;
  }
  auto& c = this->Points.C;
  double size = 0.0;
  double bend = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    size = std::max(
      { size, std::abs(c[0][i]), std::abs(c[1][i]), std::abs(c[2][i]), std::abs(c[4][i]) });
    bend = std::max(
      { bend, std::abs(c[3][i]), std::abs(c[5][i]), std::abs(c[6][i]), std::abs(c[7][i]) });
  }
  if (bend <= 8.0 * DBL_EPSILON * size)
  {
    this->Form = AFFINE;
    for (const int row : { 3, 5, 6, 7 })
    {
      this->Points.Clear(row);
    }
  }
}

inline void InterpolatedCell::SetVectors()
{
  auto& c = this->Vectors.C;
  double check = 0.0;
  const int corners = CellShape::Of(this->Shape).NumberOfCorners;
  for (int corner = 0; corner < corners; ++corner)
  {
    // The sum becomes NaN if a component is not finite.
    check += 0.0 * c[corner][0] + 0.0 * c[corner][1] + 0.0 * c[corner][2];
  }
  this->HasFiniteVectors = check == 0.0;
  CellShape::Fit(this->Shape, this->Vectors);
  if (this->Form != CURVED)
  {
    const double anywhere[3] = { 0.0, 0.0, 0.0 };
    double inverse[3][3];
    this->GetInverse(anywhere, inverse);
    for (auto& row : c)
    {
      InverseJacobian::Multiply(inverse, row, row);
    }
  }
}

}

#endif
