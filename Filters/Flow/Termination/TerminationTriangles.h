// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TerminationTriangles_h
#define interlume_TerminationTriangles_h

#include "Common/Error.h"

#include "vtkType.h"

#include <array>
#include <vector>

#include <glm/vec3.hpp>

class vtkDataArray;
class vtkPolyData;

namespace interlume
{

/**
 * @class   TerminationTriangles
 * @brief   the polygons and strips of a dataset as triangles with texture coordinates
 *
 * Points nearer to each other than the tolerance are one vertex, known by the first of them, so
 * that a seam of the texture is no border of the surface. Each corner keeps the texture coordinates
 * of its own point.
 *
 * Vertices are the points multiplied by Scale, a power of 2 by which the diagonal is about 1, so
 * that products of four lengths are numbers at any size.
 */
class TerminationTriangles
{
public:
  /**
   * Takes the dataset; \a tolerance in parts of the bounds' diagonal. In a periodic direction the
   * coordinates of a triangle are brought within a half of its first corner's. Returns an error if
   * the dataset is no surface with texture coordinates.
   */
  Error Take(vtkPolyData* data, double tolerance, const bool isPeriodic[2]);

  const glm::dvec3& GetCorner(int triangle, int corner) const
  {
    return this->Vertices[this->Triangles[triangle].Corners[corner]];
  }

  struct Triangle
  {
    int Corners[3];
    double Texture[3][2];
  };
  std::vector<Triangle> Triangles;
  std::vector<glm::dvec3> Vertices;
  double Scale = 1.0;
  /// The point that stands for each vertex.
  std::vector<vtkIdType> PointIds;
  /// The bounds of the points in use.
  double Bounds[6];
  /// The bounds' diagonal, multiplied by Scale.
  double Diagonal = 0.0;
  /// The number of triangles without area, and of polygons that cannot be cut into triangles.
  vtkIdType NumberOfDegenerateTriangles = 0;

private:
  using Polygon = std::array<vtkIdType, 3>;

  Error FindTriangles(vtkPolyData* data, std::vector<Polygon>& polygons);
  void Weld(vtkPolyData* data, const std::vector<bool>& isUsed, double tolerance);

  /// The vertex of each point, -1 for those not in use.
  std::vector<int> VertexIds;
};

}

#endif
