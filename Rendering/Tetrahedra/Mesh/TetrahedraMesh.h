// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraMesh_h
#define interlume_TetrahedraMesh_h

#include "Common/Vectors.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace interlume
{

/**
 * The camera in mesh coordinates.
 */
struct Viewpoint
{
  bool IsParallel = false;
  /// Camera position in perspective projection.
  glm::dvec3 Eye{};
  /// Unit view direction, from the camera into the scene.
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 };
};

/**
 * The tetrahedra to draw. Points have coordinates from -1 to 1; Origin + Scale * point is the
 * position in the input. The mesh contains no tetrahedra without volume and no NaN.
 */
struct TetrahedraMesh
{
  glm::dvec3 Origin{};
  double Scale = 1.0;
  /// Three coordinates for each point.
  std::vector<double> Points;
  /// Four point ids for each tetrahedron, in either orientation.
  std::vector<std::uint32_t> Corners;
  /// Index of the input cell of each tetrahedron; empty if cells and tetrahedra have the same
  /// indices.
  std::vector<std::uint32_t> Cells;
  /// Number of input cells that each tetrahedron represents; above 1 for a sample of the input.
  int CellStride = 1;

  std::uint32_t GetNumberOfTetrahedra() const
  {
    return static_cast<std::uint32_t>(this->Corners.size() / 4);
  }
  const double* GetPoint(std::uint32_t id) const
  {
    return &this->Points[3 * static_cast<std::size_t>(id)];
  }
  /// Returns the signed distance of a point from a plane with a unit normal.
  double GetDistance(const glm::dvec4& plane, std::uint32_t id) const
  {
    const double* point = this->GetPoint(id);
    return plane.x * point[0] + plane.y * point[1] + plane.z * point[2] + plane.w;
  }
  /// Returns true if a point is more than \a tolerance behind a plane.
  bool HasPointBehind(const glm::dvec4& plane, double tolerance) const;
  /// Returns the largest distance of a point from the origin; 0 if there are no points.
  double GetRadius() const;
  ///@{
  /// Return six times the signed volume.
  double GetVolumeTimesSix(std::uint32_t tetrahedron) const
  {
    return this->GetVolumeTimesSix(this->GetCorners(tetrahedron));
  }
  double GetVolumeTimesSix(const std::uint32_t* corners) const
  {
    const double* o = this->GetPoint(corners[0]);
    double e[3][3];
    for (int k = 0; k < 3; ++k)
    {
      const double* p = this->GetPoint(corners[k + 1]);
      for (int i = 0; i < 3; ++i)
      {
        e[k][i] = p[i] - o[i];
      }
    }
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
      e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
      e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  }
  ///@}
  const std::uint32_t* GetCorners(std::uint32_t tetrahedron) const
  {
    return &this->Corners[4 * static_cast<std::size_t>(tetrahedron)];
  }
};

}

#endif
