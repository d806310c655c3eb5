// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/MultilinearCell.h"

#include "Common/Vectors.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
// Cube corner of each point of a cell, in VTK's point order. Voxels need no table: their points are
// in the order of the cube corners.
constexpr int HexahedronCorners[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
constexpr int WedgeCorners[6] = { 0, 1, 2, 4, 5, 6 };
constexpr int PyramidCorners[5] = { 0, 1, 3, 2, 4 };
constexpr int TetrahedronCorners[4] = { 0, 1, 2, 4 };

constexpr int BoxEdges[12][2] = { { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 }, { 0, 2 }, { 1, 3 },
  { 4, 6 }, { 5, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
constexpr int WedgeEdges[9][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 4, 5 }, { 5, 6 }, { 6, 4 },
  { 0, 4 }, { 1, 5 }, { 2, 6 } };
constexpr int PyramidEdges[8][2] = { { 0, 1 }, { 1, 3 }, { 3, 2 }, { 2, 0 }, { 0, 4 }, { 1, 4 },
  { 2, 4 }, { 3, 4 } };
constexpr int TetrahedronEdges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 4 }, { 1, 2 }, { 1, 4 },
  { 2, 4 } };

// Computes the values at the cube corners that are not points of the cell.
void Extrapolate(MultilinearCell::Shapes shape, MultilinearCell::Values& values)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto add = [&values, i](int corner, int a, int b, int base)
    { values[corner][i] = values[a][i] + (values[b][i] - values[base][i]); };
    switch (shape)
    {
      case MultilinearCell::WEDGE:
        add(3, 1, 2, 0);
        add(7, 5, 6, 4);
        break;
      case MultilinearCell::PYRAMID:
        values[5][i] = values[6][i] = values[7][i] = values[4][i];
        break;
      case MultilinearCell::TETRAHEDRON:
        add(3, 1, 2, 0);
        add(5, 1, 4, 0);
        add(6, 2, 4, 0);
        add(7, 3, 4, 0);
        break;
      default:
        break;
    }
  }
}

// Nodes of two-point Gauss quadrature on [0, 1].
constexpr double GaussPoints[2] = { 0.2113248654051871, 0.7886751345948129 };
}

MultilinearCell::Shapes MultilinearCell::GetShape(int cellType)
{
  switch (cellType)
  {
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return BOX;
    case VTK_WEDGE:
      return WEDGE;
    case VTK_PYRAMID:
      return PYRAMID;
    case VTK_TETRA:
      return TETRAHEDRON;
    default:
      return NONE;
  }
}

int MultilinearCell::GetCorners(Shapes shape, const int*& corners)
{
  switch (shape)
  {
    case WEDGE:
      corners = WedgeCorners;
      return 6;
    case PYRAMID:
      corners = PyramidCorners;
      return 5;
    case TETRAHEDRON:
      corners = TetrahedronCorners;
      return 4;
    default:
      corners = HexahedronCorners;
      return 8;
  }
}

int MultilinearCell::GetEdges(Shapes shape, const int (*&edges)[2])
{
  switch (shape)
  {
    case WEDGE:
      edges = WedgeEdges;
      return 9;
    case PYRAMID:
      edges = PyramidEdges;
      return 8;
    case TETRAHEDRON:
      edges = TetrahedronEdges;
      return 6;
    default:
      edges = BoxEdges;
      return 12;
  }
}

bool MultilinearCell::IsFlat(int cellType)
{
  if (cellType == VTK_EMPTY_CELL)
  {
    return true;
  }
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(cellType));
  return cell && cell->GetCellDimension() < 3;
}

void MultilinearCell::Interpolate(const Values& values, const double p[3], double value[3])
{
  for (int i = 0; i < 3; ++i)
  {
    double lines[4];
    for (int line = 0; line < 4; ++line)
    {
      lines[line] = (1.0 - p[0]) * values[2 * line][i] + p[0] * values[2 * line + 1][i];
    }
    const double bottom = (1.0 - p[1]) * lines[0] + p[1] * lines[1];
    const double top = (1.0 - p[1]) * lines[2] + p[1] * lines[3];
    value[i] = (1.0 - p[2]) * bottom + p[2] * top;
  }
}

void MultilinearCell::Derive(const Values& values, const double p[3], double derivatives[9])
{
  for (int j = 0; j < 3; ++j)
  {
    const int a = (j + 1) % 3;
    const int b = (j + 2) % 3;
    const double weights[4] = { (1.0 - p[a]) * (1.0 - p[b]), p[a] * (1.0 - p[b]),
      (1.0 - p[a]) * p[b], p[a] * p[b] };
    for (int i = 0; i < 3; ++i)
    {
      double sum = 0.0;
      for (int edge = 0; edge < 4; ++edge)
      {
        const int corner = ((edge & 1) << a) + ((edge >> 1) << b);
        sum += weights[edge] * (values[corner + (1 << j)][i] - values[corner][i]);
      }
      derivatives[3 * i + j] = sum;
    }
  }
}

double MultilinearCell::GetExcess(Shapes shape, const double p[3])
{
  double excess = std::max({ -p[0], -p[1], -p[2] });
  switch (shape)
  {
    case WEDGE:
      return std::max({ excess, p[0] + p[1] - 1.0, p[2] - 1.0 });
    case TETRAHEDRON:
      return std::max(excess, p[0] + p[1] + p[2] - 1.0);
    default:
      return std::max({ excess, p[0] - 1.0, p[1] - 1.0, p[2] - 1.0 });
  }
}

void MultilinearCell::Load(vtkDataSet* data, vtkDataArray* vectors, vtkIdType cell, vtkIdList* ids)
{
  const int type = data->GetCellType(cell);
  this->Cell = cell;
  this->Shape = GetShape(type);
  data->GetCellPoints(cell, ids);
  const int* corners = nullptr;
  this->NumberOfPoints = GetCorners(this->Shape, corners);
  for (int point = 0; point < this->NumberOfPoints; ++point)
  {
    const vtkIdType id = ids->GetId(point);
    const int corner = type == VTK_VOXEL ? point : corners[point];
    // The point ids of a voxel are stored in the order of a hexahedron, because GetWeights uses
    // that order for both.
    this->PointIds[type == VTK_VOXEL ? corners[point] : point] = id;
    data->GetPoint(id, this->Positions[corner]);
    vectors->GetTuple(id, this->Vectors[corner]);
  }
  Extrapolate(this->Shape, this->Positions);
  Extrapolate(this->Shape, this->Vectors);
}

bool MultilinearCell::IsFinite() const
{
  const auto isFinite = [](double value) { return std::isfinite(value); };
  return std::all_of(&this->Positions[0][0], &this->Positions[0][0] + 24, isFinite) &&
    std::all_of(&this->Vectors[0][0], &this->Vectors[0][0] + 24, isFinite);
}

double MultilinearCell::GetLargestSpeed() const
{
  const int* corners = nullptr;
  const int number = GetCorners(this->Shape, corners);
  double largest = 0.0;
  for (int i = 0; i < number; ++i)
  {
    largest =
      std::max(largest, interlume::Vectors::SafeLength(glm::make_vec3(this->Vectors[corners[i]])));
  }
  return largest;
}

void MultilinearCell::GetWeights(const double p[3], double weights[8]) const
{
  if (this->Shape == TETRAHEDRON)
  {
    weights[0] = 1.0 - p[0] - p[1] - p[2];
    std::copy_n(p, 3, weights + 1);
    return;
  }
  if (this->Shape == WEDGE)
  {
    const double plane[3] = { 1.0 - p[0] - p[1], p[0], p[1] };
    for (int i = 0; i < 3; ++i)
    {
      weights[i] = plane[i] * (1.0 - p[2]);
      weights[i + 3] = plane[i] * p[2];
    }
    return;
  }
  for (int point = 0; point < 8; ++point)
  {
    const int corner = HexahedronCorners[point];
    weights[point] = 1.0;
    for (int j = 0; j < 3; ++j)
    {
      weights[point] *= (corner >> j) & 1 ? p[j] : 1.0 - p[j];
    }
  }
  if (this->Shape == PYRAMID)
  {
    weights[4] = p[2];
  }
}

bool MultilinearCell::GetGradient(const double p[3], double gradient[9]) const
{
  // At the apex of a pyramid, the gradient depends on the direction of approach, but is constant
  // along each line to the apex. The gradient on the center line is used.
  const double center[3] = { 0.5, 0.5, 0.5 };
  const bool isApex = this->Shape == PYRAMID && p[2] > 1.0 - 1e-7;
  double byParameters[9];
  double positions[9];
  Derive(this->Vectors, isApex ? center : p, byParameters);
  Derive(this->Positions, isApex ? center : p, positions);
  // Solves dv[i]/dp = (dx/dp)^T dv[i]/dx with the dual vectors of dx/dp. The cell is first scaled
  // to a size of about 1 because its volume may overflow or underflow.
  const double scale = GetScale(this->GetDiagonal());
  for (double& component : positions)
  {
    component *= scale;
  }
  const double columns[3][3] = { { positions[0], positions[3], positions[6] },
    { positions[1], positions[4], positions[7] }, { positions[2], positions[5], positions[8] } };
  double dual[3][3];
  double sizes = 1.0;
  for (int j = 0; j < 3; ++j)
  {
    vtkMath::Cross(columns[(j + 1) % 3], columns[(j + 2) % 3], dual[j]);
    sizes *= vtkMath::Norm(columns[j]);
  }
  const double determinant = vtkMath::Dot(columns[0], dual[0]);
  if (!(std::abs(determinant) > 1e-14 * sizes))
  {
    std::fill_n(gradient, 9, 0.0);
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      gradient[3 * i + k] =
        (byParameters[3 * i] * dual[0][k] + byParameters[3 * i + 1] * dual[1][k] +
          byParameters[3 * i + 2] * dual[2][k]) /
        determinant * scale;
    }
  }
  return true;
}

double MultilinearCell::GetScale(double length)
{
  // The exponent is limited so that the inverse of the power is also finite.
  return length > 0.0 && std::isfinite(length)
    ? std::ldexp(1.0, -std::clamp(std::ilogb(length), -1000, 1000))
    : 1.0;
}

double MultilinearCell::GetLength() const
{
  const double scale = GetScale(this->GetDiagonal());
  return std::cbrt(this->GetVolume(scale)) / scale;
}

double MultilinearCell::GetVolume(double scale) const
{
  const auto getDeterminant = [this, scale](double r, double s, double t)
  {
    const double p[3] = { r, s, t };
    double d[9];
    Derive(this->Positions, p, d);
    for (double& component : d)
    {
      component *= scale;
    }
    return vtkMath::Determinant3x3(d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], d[8]);
  };
  // The quadrature is exact: the determinant has degree 2 in each parameter. In wedges, it is
  // linear in the two parameters of the triangle. In tetrahedra, it is constant.
  double volume = 0.0;
  if (this->Shape == TETRAHEDRON)
  {
    volume = getDeterminant(0.0, 0.0, 0.0) / 6.0;
  }
  else
  {
    for (const double t : GaussPoints)
    {
      if (this->Shape == WEDGE)
      {
        volume += 0.25 * getDeterminant(1.0 / 3.0, 1.0 / 3.0, t);
        continue;
      }
      for (const double s : GaussPoints)
      {
        for (const double r : GaussPoints)
        {
          volume += 0.125 * getDeterminant(r, s, t);
        }
      }
    }
  }
  return std::abs(volume);
}

double MultilinearCell::GetDiagonal() const
{
  const int* corners = nullptr;
  const int number = GetCorners(this->Shape, corners);
  glm::dvec3 sides;
  for (int i = 0; i < 3; ++i)
  {
    double lower = this->Positions[0][i];
    double upper = lower;
    for (int c = 1; c < number; ++c)
    {
      lower = std::min(lower, this->Positions[corners[c]][i]);
      upper = std::max(upper, this->Positions[corners[c]][i]);
    }
    sides[i] = upper - lower;
  }
  return Vectors::SafeLength(sides);
}

}
