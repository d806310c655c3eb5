// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceWalkers_h
#define ReferenceWalkers_h

#include "Support/AnalyticFlows/ReferenceFlow.h"

#include "Fields/CellWalker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace reference
{

/**
 * @class   SingleCellWalker
 * @brief   cell walker through a flow, with a single cell that is all of space or a box
 *
 * The local coordinates p are equal to the position x.
 */
class SingleCellWalker : public interlume::CellWalker
{
public:
  explicit SingleCellWalker(const Flow& flow)
    : Field(&flow)
  {
  }
  SingleCellWalker(const Flow& flow, const std::array<double, 6>& bounds)
    : Field(&flow)
    , HasBounds(true)
    , Bounds(bounds)
  {
  }

  bool Locate(const double x[3], double p[3])
  {
    std::copy(x, x + 3, p);
    for (int face = 0; face < this->GetNumberOfFaces(); ++face)
    {
      if (this->GetFaceDistance(face, p) < 0.0)
      {
        return false;
      }
    }
    return true;
  }
  vtkIdType GetCell() const { return 0; }
  bool IsFinite() const { return true; }
  void GetVelocity(const double p[3], double rate[3]) const { this->Field->Velocity(p, rate); }
  void GetJacobian(const double p[3], double jacobian[9]) const
  {
    this->Field->Gradient(p, jacobian);
  }
  void GetPosition(const double p[3], double x[3]) const { std::copy(p, p + 3, x); }
  void GetWorldVector(const double*, const double d[3], double w[3]) const
  {
    std::copy(d, d + 3, w);
  }
  void GetVelocityGradient(const double p[3], double gradient[9]) const
  {
    this->Field->Gradient(p, gradient);
  }
  int GetNumberOfFaces() const { return this->HasBounds ? 6 : 0; }
  double GetFaceDistance(int face, const double p[3]) const
  {
    const auto at = static_cast<std::size_t>(face);
    const std::size_t axis = at / 2;
    const double inside = face % 2 == 0 ? p[axis] - this->Bounds[at] : this->Bounds[at] - p[axis];
    return inside / (this->Bounds[2 * axis + 1] - this->Bounds[2 * axis]);
  }
  bool Cross(int, double*) { return false; }
  int GetDomainFace(int face) const { return face; }
  void GetDomainParameters(int face, const double p[3], double uv[2]) const
  {
    const int axis = face / 2;
    uv[0] = this->GetFaceDistance(axis == 0 ? 2 : 0, p);
    uv[1] = this->GetFaceDistance(axis == 2 ? 2 : 4, p);
  }
  double Interpolate(int array, const double p[3]) const { return this->Field->Array(array, p); }

private:
  const Flow* Field;
  bool HasBounds = false;
  std::array<double, 6> Bounds{};
};

/**
 * @struct  BoxGrid
 * @brief   regular grid of boxes, some of which may be missing or have nonfinite vectors
 */
struct BoxGrid
{
  Position Origin{};
  Position Spacing{ 1.0, 1.0, 1.0 };
  std::array<int, 3> Cells{ 1, 1, 1 };
  /// Return whether a cell is part of the grid, and whether its vectors are finite. If empty, this
  /// is the case for all cells.
  std::function<bool(const std::array<int, 3>& cell)> IsCell;
  std::function<bool(const std::array<int, 3>& cell)> IsFinite;
  /// Constant velocity of each cell. If empty, the velocity of the flow is used.
  std::function<Position(const std::array<int, 3>& cell)> CellVelocity;
  /// If true, the velocity is interpolated trilinearly between the eight corners of each box.
  /// Otherwise, the flow is evaluated directly.
  bool IsInterpolated = false;
};

/**
 * @class   BoxWalker
 * @brief   cell walker through a flow on a BoxGrid; local coordinates p are from 0 to 1 in each box
 */
class BoxWalker : public interlume::CellWalker
{
public:
  BoxWalker(const Flow& flow, const BoxGrid& grid)
    : Field(&flow)
    , Grid(&grid)
  {
  }

  bool Locate(const double x[3], double p[3])
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double at = (x[i] - this->Grid->Origin[i]) / this->Grid->Spacing[i];
      if (!(at >= 0.0 && at <= this->Grid->Cells[i]))
      {
        return false;
      }
      this->Cell[i] = std::min(static_cast<int>(at), this->Grid->Cells[i] - 1);
      p[i] = at - this->Cell[i];
    }
    this->EvaluateCorners();
    return this->IsCellInGrid();
  }
  vtkIdType GetCell() const
  {
    return this->Cell[0] +
      static_cast<vtkIdType>(this->Grid->Cells[0]) *
      (this->Cell[1] + static_cast<vtkIdType>(this->Grid->Cells[1]) * this->Cell[2]);
  }
  bool IsFinite() const { return !this->Grid->IsFinite || this->Grid->IsFinite(this->Cell); }
  void GetVelocity(const double p[3], double rate[3]) const
  {
    this->GetWorldVelocity(p, rate);
    for (std::size_t i = 0; i < 3; ++i)
    {
      rate[i] /= this->Grid->Spacing[i];
    }
  }
  void GetJacobian(const double p[3], double jacobian[9]) const
  {
    this->GetVelocityGradient(p, jacobian);
    for (std::size_t i = 0; i < 9; ++i)
    {
      jacobian[i] *= this->Grid->Spacing[i % 3] / this->Grid->Spacing[i / 3];
    }
  }
  void GetPosition(const double p[3], double x[3]) const
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      x[i] = this->Grid->Origin[i] + (this->Cell[i] + p[i]) * this->Grid->Spacing[i];
    }
  }
  void GetWorldVector(const double*, const double d[3], double w[3]) const
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      w[i] = d[i] * this->Grid->Spacing[i];
    }
  }
  void GetVelocityGradient(const double p[3], double gradient[9]) const
  {
    if (!this->Grid->IsInterpolated)
    {
      double x[3];
      this->GetPosition(p, x);
      this->Field->Gradient(x, gradient);
      return;
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      // The velocity is linear along each axis, so the difference between opposite faces is exact.
      double low[3] = { p[0], p[1], p[2] };
      double high[3] = { p[0], p[1], p[2] };
      low[j] = 0.0;
      high[j] = 1.0;
      double below[3];
      double above[3];
      this->GetWorldVelocity(low, below);
      this->GetWorldVelocity(high, above);
      for (std::size_t i = 0; i < 3; ++i)
      {
        gradient[3 * i + j] = (above[i] - below[i]) / this->Grid->Spacing[j];
      }
    }
  }
  int GetNumberOfFaces() const { return 6; }
  double GetFaceDistance(int face, const double p[3]) const
  {
    return face % 2 == 0 ? p[face / 2] : 1.0 - p[face / 2];
  }
  bool Cross(int face, double p[3])
  {
    const auto axis = static_cast<std::size_t>(face / 2);
    const int step = face % 2 == 0 ? -1 : 1;
    const std::array<int, 3> before = this->Cell;
    this->Cell[axis] += step;
    if (this->Cell[axis] < 0 || this->Cell[axis] >= this->Grid->Cells[axis] ||
      !this->IsCellInGrid())
    {
      this->Cell = before;
      return false;
    }
    p[axis] -= step;
    this->EvaluateCorners();
    return true;
  }
  int GetDomainFace(int face) const
  {
    const auto axis = static_cast<std::size_t>(face / 2);
    const int last = face % 2 == 0 ? 0 : this->Grid->Cells[axis] - 1;
    return this->Cell[axis] == last ? face : -1;
  }
  void GetDomainParameters(int face, const double p[3], double uv[2]) const
  {
    const int axis = face / 2;
    const std::size_t others[2] = { axis == 0 ? 1U : 0U, axis == 2 ? 1U : 2U };
    for (int i = 0; i < 2; ++i)
    {
      uv[i] = (this->Cell[others[i]] + p[others[i]]) / this->Grid->Cells[others[i]];
    }
  }
  double Interpolate(int array, const double p[3]) const
  {
    double x[3];
    this->GetPosition(p, x);
    return this->Field->Array(array, x);
  }

private:
  bool IsCellInGrid() const { return !this->Grid->IsCell || this->Grid->IsCell(this->Cell); }

  void EvaluateCorners()
  {
    for (int corner = 0; this->Grid->IsInterpolated && corner < 8; ++corner)
    {
      const double p[3] = { static_cast<double>(corner & 1), static_cast<double>(corner >> 1 & 1),
        static_cast<double>(corner >> 2) };
      double x[3];
      this->GetPosition(p, x);
      this->Field->Velocity(x, this->Corners[corner]);
    }
  }

  void GetWorldVelocity(const double p[3], double v[3]) const
  {
    if (this->Grid->CellVelocity)
    {
      const Position velocity = this->Grid->CellVelocity(this->Cell);
      std::copy(velocity.begin(), velocity.end(), v);
      return;
    }
    if (!this->Grid->IsInterpolated)
    {
      double x[3];
      this->GetPosition(p, x);
      this->Field->Velocity(x, v);
      return;
    }
    std::fill(v, v + 3, 0.0);
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      for (int i = 0; i < 3; ++i)
      {
        weight *= corner >> i & 1 ? p[i] : 1.0 - p[i];
      }
      for (int i = 0; i < 3; ++i)
      {
        v[i] += weight * this->Corners[corner][i];
      }
    }
  }

  const Flow* Field;
  const BoxGrid* Grid;
  std::array<int, 3> Cell{};
  double Corners[8][3] = {};
};

}

#endif
