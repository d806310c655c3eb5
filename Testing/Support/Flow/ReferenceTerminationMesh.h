// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTerminationMesh_h
#define ReferenceTerminationMesh_h

#include "Support/Flow/ReferenceTermination.h" // for points

#include "vtkSmartPointer.h" // for the dataset

#include <functional>

class vtkPolyData;

namespace reference
{

/// Triangles with texture coordinates.
struct TexturedMesh
{
  std::vector<Vector> Points;
  std::vector<std::array<double, 2>> Texture;
  std::vector<std::array<int, 3>> Triangles;

  /// Returns the mesh as a dataset.
  vtkSmartPointer<vtkPolyData> MakeData() const;
  /// Returns the mesh scaled about the origin, then translated.
  TexturedMesh GetTransformed(const SurfaceScale& scale) const;
};

/// Returns a triangulated grid over (u,v) in [0, 1]^2, with points at \a position(u, v) and texture
/// coordinates (u,v). Points where opposite borders meet, as on a seam, are duplicated. Triangles
/// without area are skipped.
TexturedMesh MakeGridMesh(
  int columns, int rows, const std::function<Vector(double, double)>& position);

/// Returns a closed mesh of points and triangles with arbitrary texture coordinates.
TexturedMesh MakeSolid(
  const std::vector<Vector>& points, const std::vector<std::array<int, 3>>& triangles);

TexturedMesh MakeTetrahedron();
/// Returns a cube with a spike on every face. It has concave edges, sharp edges and sharp tips.
TexturedMesh MakeStar();

/// Returns points where the sign of the distance is hard to determine: near corners and edges, and
/// outside each triangle, in its plane.
std::vector<Vector> MakeSignTestPoints(const TexturedMesh& mesh);

/// Returns the distance from the nearest of all triangles. The distance from a triangle is the
/// distance from its plane if the projected point is inside, otherwise from its nearest edge.
double NearestDistance(const TexturedMesh& mesh, const Vector& x);
/// Returns the winding number of the mesh around a point: the sum of the solid angles of its
/// triangles, divided by 4 pi (A. van Oosterom, J. Strackee, 1983).
double WindingNumber(const TexturedMesh& mesh, const Vector& x);

}

#endif
