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
 * @brief   triangles with texture coordinates from the polygons and strips of a dataset
 *
 * Points within a tolerance of each other become one vertex, identified by its first point.
 * Therefore a texture seam is not a border of the surface. Each corner keeps the texture
 * coordinates of its point.
 *
 * Vertices are points multiplied by Scale, a power of 2 that scales the diagonal of the bounds to
 * about 1. This avoids overflow of products of four lengths.
 */
class TerminationTriangles
{
public:
  /**
   * Reads the dataset. \a tolerance is relative to the diagonal of the bounds. In periodic
   * directions, the texture coordinates of a triangle are shifted to within half a period of those
   * of its first corner. Returns an error if the dataset is not a surface with texture coordinates.
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
  /// Id of the first point of each vertex.
  std::vector<vtkIdType> PointIds;
  /// Bounds of the points that belong to triangles.
  double Bounds[6];
  /// Diagonal of the bounds, multiplied by Scale.
  double Diagonal = 0.0;
  /// Number of triangles of zero area, and of polygons that cannot be triangulated.
  vtkIdType NumberOfDegenerateTriangles = 0;

private:
  using Polygon = std::array<vtkIdType, 3>;

  Error FindTriangles(vtkPolyData* data, std::vector<Polygon>& polygons);
  void Weld(vtkPolyData* data, const std::vector<bool>& isUsed, double tolerance);

  /// Index of the vertex of each point, or -1 if the point is not used.
  std::vector<int> VertexIds;
};

}

#endif
