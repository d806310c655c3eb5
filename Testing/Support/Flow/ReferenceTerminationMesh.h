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

  /// The same as a dataset.
  vtkSmartPointer<vtkPolyData> MakeData() const;
  /// Enlarged around the origin, then moved.
  TexturedMesh Placed(const SurfaceScale& scale) const;
};

/// A grid over (u,v), 0 to 1, of points that a function gives; the borders' points are all there,
/// those of seams twice. Triangles without area are left out.
TexturedMesh MakeGridMesh(
  int columns, int rows, const std::function<Vector(double, double)>& position);

/// A closed mesh from points and triangles; texture coordinates are made up.
TexturedMesh MakeSolid(
  const std::vector<Vector>& points, const std::vector<std::array<int, 3>>& triangles);

TexturedMesh MakeTetrahedron();
/// A cube with a thin spike on every face: concave edges, sharp edges and sharp tips.
TexturedMesh MakeStar();

/// Places where the sign is hard: near corners and edges, outward along the plane of each face.
std::vector<Vector> HardPlaces(const TexturedMesh& mesh);

/// Distance from the nearest of all triangles: the foot in its plane where it is inside, else the
/// nearest of its sides.
double NearestDistance(const TexturedMesh& mesh, const Vector& x);
/// How often the mesh goes around a point: the solid angles of its triangles over 4 pi (A. van
/// Oosterom, J. Strackee, 1983).
double WindingNumber(const TexturedMesh& mesh, const Vector& x);

}

#endif
