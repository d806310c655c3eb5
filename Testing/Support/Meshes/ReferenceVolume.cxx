// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceVolume.h"

#include "Support/Meshes/ReferenceSplit.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace reference
{

namespace
{

using Real = long double;
using Point = std::array<Real, 3>;

/// The position and the array values of a tetrahedron's corner.
struct Corner
{
  Point X{};
  std::vector<Real> Values;
};

using Tetrahedron = std::array<Corner, 4>;

Corner Between(const Corner& a, const Corner& b, Real weight)
{
  Corner result;
  for (int i = 0; i < 3; ++i)
  {
    result.X[i] = a.X[i] + weight * (b.X[i] - a.X[i]);
  }
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    result.Values.push_back(a.Values[i] + weight * (b.Values[i] - a.Values[i]));
  }
  return result;
}

Real AbsoluteVolume(const Tetrahedron& t)
{
  return std::abs(Determinant(t[0].X, t[1].X, t[2].X, t[3].X)) / 6;
}

/// Appends tetrahedra that fill the part of a tetrahedron where sign * (value - bound) >= 0.
void Clip(const Tetrahedron& tetrahedron, size_t array, Real bound, int sign,
  std::vector<Tetrahedron>& clipped)
{
  std::vector<const Corner*> in;
  std::vector<const Corner*> out;
  for (const Corner& corner : tetrahedron)
  {
    (sign * (corner.Values[array] - bound) >= 0 ? in : out).push_back(&corner);
  }
  auto cut = [&](int i, int j)
  {
    const Real a = in[i]->Values[array];
    const Real b = out[j]->Values[array];
    Corner corner = Between(*in[i], *out[j], (bound - a) / (b - a));
    corner.Values[array] = bound;
    return corner;
  };
  auto addPrism = [&](const std::array<Corner, 3>& lower, const std::array<Corner, 3>& upper)
  {
    clipped.push_back({ lower[0], lower[1], lower[2], upper[2] });
    clipped.push_back({ lower[0], lower[1], upper[1], upper[2] });
    clipped.push_back({ lower[0], upper[0], upper[1], upper[2] });
  };
  switch (in.size())
  {
    case 4:
      clipped.push_back(tetrahedron);
      break;
    case 3:
      addPrism({ *in[0], *in[1], *in[2] }, { cut(0, 0), cut(1, 0), cut(2, 0) });
      break;
    case 2:
      addPrism({ *in[0], cut(0, 0), cut(0, 1) }, { *in[1], cut(1, 0), cut(1, 1) });
      break;
    case 1:
      clipped.push_back({ *in[0], cut(0, 0), cut(0, 1), cut(0, 2) });
      break;
    default:
      break;
  }
}

Corner CornerOf(vtkDataSet* mesh, const std::vector<vtkDataArray*>& arrays, const MeanPoint& mean)
{
  Corner corner;
  for (int i = 0; i < 3; ++i)
  {
    corner.X[i] = MeanOf<Real>(mean, [&](vtkIdType id) { return mesh->GetPoint(id)[i]; });
  }
  for (vtkDataArray* array : arrays)
  {
    corner.Values.push_back(
      MeanOf<Real>(mean, [&](vtkIdType id) { return array->GetComponent(id, 0); }));
  }
  return corner;
}

void ForEachCornered(vtkDataSet* mesh, const std::vector<vtkDataArray*>& arrays,
  const std::function<void(const Tetrahedron&)>& function)
{
  ForEachTetrahedron(mesh,
    [&](vtkIdType, const SplitTetrahedron& split)
    {
      Tetrahedron tetrahedron;
      for (int i = 0; i < 4; ++i)
      {
        tetrahedron[i] = CornerOf(mesh, arrays, split[i]);
      }
      function(tetrahedron);
    });
}

void Measure(vtkUnstructuredGrid* grid, vtkIdType cell, TetrahedraVolume& volume)
{
  vtkIdType count;
  const vtkIdType* ids;
  grid->GetCellPoints(cell, count, ids);
  std::array<Point, 4> x;
  for (int i = 0; i < 4; ++i)
  {
    double p[3];
    grid->GetPoint(ids[i], p);
    x[i] = { p[0], p[1], p[2] };
  }
  Real longest = 0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      longest =
        std::max(longest, std::hypot(x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]));
    }
  }
  const Real signedVolume = Determinant(x[0], x[1], x[2], x[3]) / 6;
  volume.Sum += signedVolume;
  volume.SumOfAbsolute += std::abs(signedVolume);
  volume.Negative += std::max(-signedVolume, Real(0));
  volume.Inverted += signedVolume < -1e-15L * longest * longest * longest ? 1 : 0;
  ++volume.Count;
}

}

long double Determinant(const std::array<long double, 3>& a, const std::array<long double, 3>& b,
  const std::array<long double, 3>& c, const std::array<long double, 3>& d)
{
  const Point u = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const Point v = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const Point w = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
    (u[0] * v[1] - u[1] * v[0]) * w[2];
}

TetrahedraVolume MeasureTetrahedra(vtkUnstructuredGrid* grid)
{
  TetrahedraVolume volume;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    Measure(grid, cell, volume);
  }
  return volume;
}

TetrahedraVolume MeasureInterval(vtkUnstructuredGrid* grid, int interval)
{
  TetrahedraVolume volume;
  vtkDataArray* intervals = grid->GetCellData()->GetArray("IntervalId");
  for (vtkIdType cell = 0; intervals && cell < grid->GetNumberOfCells(); ++cell)
  {
    if (intervals->GetComponent(cell, 0) == interval)
    {
      Measure(grid, cell, volume);
    }
  }
  return volume;
}

long double MeshVolume(vtkDataSet* mesh)
{
  Real volume = 0;
  ForEachCornered(mesh, {}, [&](const Tetrahedron& t) { volume += AbsoluteVolume(t); });
  return volume;
}

long double ClippedVolume(vtkDataSet* mesh, const std::vector<Range>& ranges)
{
  std::vector<vtkDataArray*> arrays;
  arrays.reserve(ranges.size());
  for (const Range& range : ranges)
  {
    arrays.push_back(mesh->GetPointData()->GetArray(range.Array));
  }
  Real volume = 0;
  ForEachCornered(mesh, arrays,
    [&](const Tetrahedron& tetrahedron)
    {
      std::vector<Tetrahedron> pieces = { tetrahedron };
      for (size_t i = 0; i < ranges.size(); ++i)
      {
        for (int sign = 1; sign >= -1; sign -= 2)
        {
          std::vector<Tetrahedron> clipped;
          for (const Tetrahedron& piece : pieces)
          {
            Clip(piece, i, sign > 0 ? ranges[i].Lower : ranges[i].Upper, sign, clipped);
          }
          pieces = clipped;
        }
      }
      for (const Tetrahedron& piece : pieces)
      {
        volume += AbsoluteVolume(piece);
      }
    });
  return volume;
}

long double BoxVolumeBelow(
  const std::array<double, 3>& size, const LinearFunction& function, double value)
{
  // The plane cuts a simplex off the octant at each corner of the box. The volume is the sum of
  // their signed volumes (inclusion-exclusion).
  Real sum = 0;
  Real product = 6;
  for (int a = 0; a < 3; ++a)
  {
    product *= function.Gradient[a];
  }
  Real volume = 1;
  for (int a = 0; a < 3; ++a)
  {
    volume *= size[a];
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    Point x;
    int parity = 1;
    for (int a = 0; a < 3; ++a)
    {
      const bool upper = (corner >> a & 1) != 0;
      x[a] = upper ? size[a] : 0;
      parity = upper ? -parity : parity;
    }
    const Real height = value - function(x.data());
    // Only corners below the plane contribute. Negative gradient components need no special case:
    // mirroring an axis changes the sign of the product and of every parity.
    sum += height > 0 ? parity * height * height * height : 0;
  }
  return std::clamp(sum / product, Real(0), volume);
}

}
