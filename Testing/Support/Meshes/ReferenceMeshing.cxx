// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Checks/LargestError.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace reference
{
namespace
{

using Real3 = std::array<long double, 3>;

Real3 PointOf(vtkDataSet* data, vtkIdType id)
{
  double x[3];
  data->GetPoint(id, x);
  return { { x[0], x[1], x[2] } };
}

long double Distance(const Real3& a, const Real3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Returns the circumradius divided by the shortest edge. The circumradius is computed from the
/// products of opposite edges (Cayley).
long double RadiusEdgeRatio(const std::array<Real3, 4>& x, long double volume)
{
  const long double edges[6] = { Distance(x[0], x[1]), Distance(x[2], x[3]), Distance(x[0], x[2]),
    Distance(x[1], x[3]), Distance(x[0], x[3]), Distance(x[1], x[2]) };
  const long double a = edges[0] * edges[1];
  const long double b = edges[2] * edges[3];
  const long double c = edges[4] * edges[5];
  const long double square = (a + b + c) * (a + b - c) * (a - b + c) * (b + c - a);
  const long double radius = std::sqrt(std::max(square, 0.0L)) / (24 * volume);
  return radius / *std::min_element(edges, edges + 6);
}

struct FaceUse
{
  int Number = 0;
  int SignSum = 0; ///< +1 for each even, -1 for each odd permutation of the sorted points
  std::array<vtkIdType, 3> Points;
};

}

TetrahedraReport Inspect(vtkUnstructuredGrid* grid)
{
  TetrahedraReport report;
  std::map<std::array<vtkIdType, 3>, FaceUse> faces;
  std::vector<bool> isUsed(grid->GetNumberOfPoints(), false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) != VTK_TETRA)
    {
      continue;
    }
    ++report.Tetrahedra;
    grid->GetCellPoints(cell, ids);
    const vtkIdType* p = ids->GetPointer(0);
    std::array<Real3, 4> x;
    for (int i = 0; i < 4; ++i)
    {
      x[i] = PointOf(grid, p[i]);
      isUsed[p[i]] = true;
    }
    const long double volume = Determinant(x[0], x[1], x[2], x[3]) / 6;
    report.NotPositive += !(volume > 0);
    report.Volume += volume;
    report.LargestVolume = std::max(report.LargestVolume, static_cast<double>(volume));
    report.LargestRadiusEdgeRatio =
      std::max(report.LargestRadiusEdgeRatio, static_cast<double>(RadiusEdgeRatio(x, volume)));
    const std::array<std::array<vtkIdType, 3>, 4> outward = { { { { p[1], p[2], p[3] } },
      { { p[0], p[3], p[2] } }, { { p[0], p[1], p[3] } }, { { p[0], p[2], p[1] } } } };
    for (const auto& face : outward)
    {
      auto key = face;
      std::sort(key.begin(), key.end());
      const bool isEven = face == std::array<vtkIdType, 3>{ { key[0], key[1], key[2] } } ||
        face == std::array<vtkIdType, 3>{ { key[1], key[2], key[0] } } ||
        face == std::array<vtkIdType, 3>{ { key[2], key[0], key[1] } };
      FaceUse& use = faces[key];
      ++use.Number;
      use.SignSum += isEven ? 1 : -1;
      use.Points = face;
    }
  }
  const Real3 origin = grid->GetNumberOfPoints() > 0 ? PointOf(grid, 0) : Real3{ { 0, 0, 0 } };
  for (const auto& face : faces)
  {
    const FaceUse& use = face.second;
    report.FacesOnce += use.Number == 1;
    report.FacesTooOften += use.Number > 2;
    report.FacesTurned += use.Number == 2 && use.SignSum != 0;
    if (use.Number == 1)
    {
      report.BoundaryVolume += Determinant(origin, PointOf(grid, use.Points[0]),
                                 PointOf(grid, use.Points[1]), PointOf(grid, use.Points[2])) /
        6;
    }
  }
  report.UnusedPoints = std::count(isUsed.begin(), isUsed.end(), false);
  return report;
}

long double EnclosedVolume(vtkPolyData* surface)
{
  long double sum = 0;
  const Real3 origin = PointOf(surface, 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      sum += Determinant(origin, PointOf(surface, ids->GetId(0)), PointOf(surface, ids->GetId(i)),
               PointOf(surface, ids->GetId(i + 1))) /
        6;
    }
  }
  return sum;
}

double LinearError(vtkDataSet* data, const char* name, const LinearFunction& function)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  double error = array ? 0.0 : std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (vtkIdType p = 0; array && p < data->GetNumberOfPoints(); ++p)
  {
    double x[3];
    data->GetPoint(p, x);
    const double expected = function(x);
    reference::KeepLargest(largest, std::abs(expected));
    reference::KeepLargest(error, std::abs(array->GetComponent(p, 0) - expected));
  }
  return largest > 0.0 ? error / largest : error;
}

namespace
{

/// Adds the cells of one block of 2 x 2 boxes.
class ConcaveBlock
{
public:
  ConcaveBlock(MeshBuilder& builder, const std::array<int, 3>& corner, int turn)
    : Builder(builder)
    , Corner(corner)
    , Turn(turn)
  {
  }

  void AddPolyhedron()
  {
    // Counterclockwise around the boxes (0,0), (1,0) and (0,1). The fifth point (1,1) is the reflex
    // corner.
    const int ring[8][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 },
      { 0, 1 } };
    std::vector<std::vector<vtkIdType>> faces(2);
    for (int i = 0; i < 8; ++i)
    {
      const int* a = ring[i];
      const int* b = ring[(i + 1) % 8];
      faces[1].push_back(this->At(a[0], a[1], 1));
      faces[0].push_back(this->At(ring[7 - i][0], ring[7 - i][1], 0));
      faces.push_back({ this->At(a[0], a[1], 0), this->At(b[0], b[1], 0), this->At(b[0], b[1], 1),
        this->At(a[0], a[1], 1) });
    }
    for (auto& face : faces)
    {
      std::rotate(face.begin(), face.begin() + this->Turn % face.size(), face.end());
    }
    this->Builder.AddPolyhedron(faces);
  }

  /// Fills the fourth box and returns the number of added cells.
  int AddOther()
  {
    const std::vector<vtkIdType> c = { this->At(1, 1, 0), this->At(2, 1, 0), this->At(2, 2, 0),
      this->At(1, 2, 0), this->At(1, 1, 1), this->At(2, 1, 1), this->At(2, 2, 1),
      this->At(1, 2, 1) };
    if (this->Turn % 3 == 0)
    {
      this->Builder.AddCell(VTK_HEXAHEDRON, c);
      return 1;
    }
    if (this->Turn % 3 == 1)
    {
      // The boxes above and below must split the common faces along the same diagonal. They belong
      // to the same column, so they are wedges too.
      this->Builder.AddCell(VTK_WEDGE, { c[0], c[1], c[2], c[4], c[5], c[6] });
      this->Builder.AddCell(VTK_WEDGE, { c[0], c[2], c[3], c[4], c[6], c[7] });
      return 2;
    }
    std::array<int, 3> key = this->Corner;
    const vtkIdType center = this->Builder.FindOrAddPoint(
      { { 2 * key[0] + 3, 2 * key[1] + 3, 2 * key[2] + 1 } }, { { 0.5, 0.5, 0.5 } });
    const int sides[6][4] = { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 }, { 1, 5, 6, 2 },
      { 2, 6, 7, 3 }, { 3, 7, 4, 0 } };
    for (const auto& side : sides)
    {
      this->Builder.AddCell(
        VTK_PYRAMID, { c[side[0]], c[side[1]], c[side[2]], c[side[3]], center });
    }
    return 6;
  }

private:
  vtkIdType At(int i, int j, int k)
  {
    return this->Builder.FindOrAddPoint(
      { { 2 * (this->Corner[0] + i), 2 * (this->Corner[1] + j), 2 * (this->Corner[2] + k) } },
      { { 0.5, 0.5, 0.5 } });
  }

  MeshBuilder& Builder;
  std::array<int, 3> Corner;
  int Turn;
};

}

vtkSmartPointer<vtkUnstructuredGrid> MakeConcaveMesh(
  const std::array<int, 3>& blocks, double shift, unsigned int seed)
{
  MeshBuilder builder;
  vtkNew<vtkIntArray> kinds;
  kinds->SetName("kind");
  for (const auto& [k, j, i] : AllIndices(blocks[2], blocks[1], blocks[0]))
  {
    ConcaveBlock block(builder, { { 2 * i, 2 * j, k } }, i + j);
    block.AddPolyhedron();
    kinds->InsertNextValue(0);
    for (int added = block.AddOther(); added > 0; --added)
    {
      kinds->InsertNextValue(1);
    }
  }
  auto mesh = builder.GetMesh();
  mesh->GetCellData()->AddArray(kinds);
  std::mt19937 random(seed);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    const double size[3] = { 2.0 * blocks[0], 2.0 * blocks[1], 1.0 * blocks[2] };
    double moved[3];
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      isInside = isInside && x[axis] > 0 && x[axis] < size[axis];
      moved[axis] = x[axis] + shift * (2.0 * random() / 4294967295.0 - 1.0);
    }
    if (isInside)
    {
      mesh->GetPoints()->SetPoint(p, moved);
    }
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeEmptySurface()
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  surface->SetPoints(points);
  surface->SetPolys(vtkNew<vtkCellArray>());
  return surface;
}

void AppendBox(vtkPolyData* surface, const std::array<double, 3>& low,
  const std::array<double, 3>& high, bool inward)
{
  vtkIdType ids[8];
  for (int i = 0; i < 8; ++i)
  {
    ids[i] = surface->GetPoints()->InsertNextPoint(
      i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]);
  }
  const int sides[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& side : sides)
  {
    vtkIdType quad[4] = { ids[side[0]], ids[side[1]], ids[side[2]], ids[side[3]] };
    if (inward)
    {
      std::swap(quad[1], quad[3]);
    }
    surface->GetPolys()->InsertNextCell(4, quad);
  }
}

vtkSmartPointer<vtkPolyData> MakeGeodesicSphere(int levels)
{
  auto surface = MakeEmptySurface();
  const auto addPoint = [&surface](double x, double y, double z)
  {
    const double length = std::sqrt(x * x + y * y + z * z);
    return surface->GetPoints()->InsertNextPoint(x / length, y / length, z / length);
  };
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (const auto& [axis, i] : AllIndices(3, 4))
  {
    const double x[3] = { 0.0, i & 1 ? 1.0 : -1.0, i & 2 ? golden : -golden };
    addPoint(x[(3 - axis) % 3], x[(4 - axis) % 3], x[(5 - axis) % 3]);
  }
  using Triangle = std::array<vtkIdType, 3>;
  std::vector<Triangle> triangles;
  const auto distance = [&surface](vtkIdType a, vtkIdType b)
  { return Distance(PointOf(surface, a), PointOf(surface, b)); };
  const long double edge = distance(0, 1) * 1.001L;
  for (vtkIdType a = 0; a < 12; ++a)
  {
    for (vtkIdType b = a + 1; b < 12; ++b)
    {
      for (vtkIdType c = b + 1; c < 12; ++c)
      {
        if (distance(a, b) < edge && distance(b, c) < edge && distance(c, a) < edge)
        {
          const bool isOutward = Determinant(Real3{ { 0, 0, 0 } }, PointOf(surface, a),
                                   PointOf(surface, b), PointOf(surface, c)) > 0;
          triangles.push_back(isOutward ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } });
        }
      }
    }
  }
  for (; levels > 0; --levels)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> midpoints;
    const auto midpoint = [&](vtkIdType a, vtkIdType b)
    {
      const auto found = midpoints.emplace(std::minmax(a, b), 0);
      if (found.second)
      {
        const Real3 x = PointOf(surface, a);
        const Real3 y = PointOf(surface, b);
        found.first->second = addPoint(static_cast<double>(x[0] + y[0]),
          static_cast<double>(x[1] + y[1]), static_cast<double>(x[2] + y[2]));
      }
      return found.first->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : triangles)
    {
      const Triangle m = { { midpoint(t[0], t[1]), midpoint(t[1], t[2]), midpoint(t[2], t[0]) } };
      finer.push_back({ { t[0], m[0], m[2] } });
      finer.push_back({ { t[1], m[1], m[0] } });
      finer.push_back({ { t[2], m[2], m[1] } });
      finer.push_back(m);
    }
    triangles = finer;
  }
  for (const Triangle& t : triangles)
  {
    surface->GetPolys()->InsertNextCell({ t[0], t[1], t[2] });
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> MakeTorus(int around, int across)
{
  auto surface = MakeEmptySurface();
  const double pi = std::acos(-1.0);
  for (const auto& [i, j] : AllIndices(around, across))
  {
    const double u = 2 * pi * i / around;
    const double v = 2 * pi * j / across;
    const double radius = 1 + 0.4 * std::cos(v);
    surface->GetPoints()->InsertNextPoint(
      radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v));
  }
  for (const auto& [i, j] : AllIndices(around, across))
  {
    const vtkIdType a = i * across + j;
    const vtkIdType b = (i + 1) % around * across + j;
    const vtkIdType c = (i + 1) % around * across + (j + 1) % across;
    const vtkIdType d = i * across + (j + 1) % across;
    surface->GetPolys()->InsertNextCell({ a, b, c });
    surface->GetPolys()->InsertNextCell({ a, c, d });
  }
  return surface;
}

}
