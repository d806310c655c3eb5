// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceTiling.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"

#include <algorithm>
#include <cmath>

namespace reference
{

namespace
{

using Key = std::array<int, 3>;
using Face = std::vector<Key>;

/// Sorts the corners of a convex face counterclockwise around \a normal.
void Sort(Face& face, const Key& normal)
{
  double center[3] = { 0, 0, 0 };
  for (const Key& key : face)
  {
    for (int a = 0; a < 3; ++a)
    {
      center[a] += static_cast<double>(key[a]) / static_cast<double>(face.size());
    }
  }
  double u[3];
  for (int a = 0; a < 3; ++a)
  {
    u[a] = face[0][a] - center[a];
  }
  const double v[3] = { normal[1] * u[2] - normal[2] * u[1], normal[2] * u[0] - normal[0] * u[2],
    normal[0] * u[1] - normal[1] * u[0] };
  const double ratio = std::sqrt(
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
  auto angle = [&](const Key& key)
  {
    double x = 0;
    double y = 0;
    for (int a = 0; a < 3; ++a)
    {
      x += (key[a] - center[a]) * u[a];
      y += (key[a] - center[a]) * v[a] / ratio;
    }
    return std::atan2(y, x);
  };
  std::sort(
    face.begin(), face.end(), [&](const Key& a, const Key& b) { return angle(a) < angle(b); });
}

/// Returns the faces of a truncated octahedron. Its corners are all permutations of (0, +-1, +-2).
std::vector<Face> TruncatedOctahedron()
{
  std::vector<Key> corners;
  for (int x = -2; x <= 2; ++x)
  {
    for (int y = -2; y <= 2; ++y)
    {
      for (int z = -2; z <= 2; ++z)
      {
        if (std::abs(x) + std::abs(y) + std::abs(z) == 3 && x * y * z == 0 &&
          x * x + y * y + z * z == 5)
        {
          corners.push_back({ x, y, z });
        }
      }
    }
  }
  std::vector<Face> faces;
  auto addFace = [&](const Key& normal, int distance)
  {
    Face face;
    for (const Key& c : corners)
    {
      if (c[0] * normal[0] + c[1] * normal[1] + c[2] * normal[2] == distance)
      {
        face.push_back(c);
      }
    }
    Sort(face, normal);
    faces.push_back(face);
  };
  for (int sign = -1; sign <= 1; sign += 2)
  {
    addFace({ sign, 0, 0 }, 2);
    addFace({ 0, sign, 0 }, 2);
    addFace({ 0, 0, sign }, 2);
    for (int y = -1; y <= 1; y += 2)
    {
      for (int z = -1; z <= 1; z += 2)
      {
        addFace({ sign, y, z }, 3);
      }
    }
  }
  return faces;
}

/// Returns the faces of a hexagonal prism, in integer coordinates. The hexagon is regular after
/// scaling y by sqrt(3).
std::vector<Face> HexagonalPrism()
{
  constexpr int hexagon[6][2] = { { 2, 0 }, { 1, 1 }, { -1, 1 }, { -2, 0 }, { -1, -1 }, { 1, -1 } };
  Face lower;
  Face upper;
  std::vector<Face> faces;
  for (int i = 0; i < 6; ++i)
  {
    const int* a = hexagon[i];
    const int* b = hexagon[(i + 1) % 6];
    lower.insert(lower.begin(), Key{ a[0], a[1], 0 });
    upper.push_back({ a[0], a[1], 1 });
    faces.push_back({ { a[0], a[1], 0 }, { b[0], b[1], 0 }, { b[0], b[1], 1 }, { a[0], a[1], 1 } });
  }
  faces.push_back(lower);
  faces.push_back(upper);
  return faces;
}

void AddTranslated(MeshBuilder& builder, const std::vector<Face>& faces, const Key& center,
  const std::array<double, 3>& scale)
{
  std::vector<std::vector<vtkIdType>> ids;
  for (const Face& face : faces)
  {
    ids.emplace_back();
    for (const Key& c : face)
    {
      ids.back().push_back(
        builder.FindOrAddPoint({ center[0] + c[0], center[1] + c[1], center[2] + c[2] }, scale));
    }
  }
  builder.AddPolyhedron(ids);
}

}

vtkSmartPointer<vtkUnstructuredGrid> MakeHoneycomb(const std::array<int, 3>& cells)
{
  MeshBuilder builder;
  const std::vector<Face> faces = HexagonalPrism();
  for (const auto& [k, j, i] : AllIndices(cells[2], cells[1], cells[0]))
  {
    // Every other column is shifted by half a hexagon.
    AddTranslated(builder, faces, { 3 * i, 2 * j + i % 2, k }, { 0.5, 0.5 * std::sqrt(3.0), 1 });
  }
  return builder.GetMesh();
}

vtkSmartPointer<vtkUnstructuredGrid> MakeKelvinTiling(const std::array<int, 3>& cells)
{
  MeshBuilder builder;
  const std::vector<Face> faces = TruncatedOctahedron();
  for (const auto& [k, j, i] : AllIndices(2 * cells[2], cells[1], cells[0]))
  {
    const int shift = k % 2 == 0 ? 0 : 2;
    AddTranslated(builder, faces, { 4 * i + shift, 4 * j + shift, 2 * k }, { 0.25, 0.25, 0.25 });
  }
  return builder.GetMesh();
}

}
