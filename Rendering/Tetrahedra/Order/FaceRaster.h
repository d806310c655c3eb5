// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceRaster_h
#define interlume_FaceRaster_h

#include "Common/Vectors.h"
#include "View/FrameProjection.h"

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   FaceRaster
 * @brief   finds the pixels whose view rays intersect a triangle, and their depths
 *
 * It works in homogeneous coordinates (M. Olano, T. Greer, "Triangle scan conversion using 2D
 * homogeneous coordinates", 1997), so triangles need not be clipped at the camera plane. Each edge
 * function is computed from the corner with the lower point id to the other corner. Adjacent
 * triangles therefore round their shared edge in the same way, and a closed surface has no cracks.
 */
class FaceRaster
{
public:
  /// \a corners are in image coordinates; \a ids are their point ids.
  FaceRaster(const FrameProjection& projection, const std::array<glm::dvec3, 3>& corners,
    const std::array<std::uint32_t, 3>& ids);

  /// Return the bounding rectangle of the pixels.
  FrameProjection::Range GetColumns() const { return this->Columns; }
  FrameProjection::Range GetRows() const { return this->Rows; }

  /**
   * Calls visit(column, depth, isFront) for the pixels of the triangle in a row, from left to
   * right. isFront is true if the corners appear counterclockwise. Depths are positive in
   * perspective.
   */
  template <typename Visit>
  void VisitRow(int row, const Visit& visit) const;

private:
  struct Edge
  {
    // X x + Y y + One is positive inside a counterclockwise triangle.
    double X;
    double Y;
    double One;
  };

  static Edge MakeEdge(
    const glm::dvec3& a, std::uint32_t idA, const glm::dvec3& b, std::uint32_t idB);
  void FindBoundingRectangle(const std::array<glm::dvec3, 3>& corners);
  double FindDepth(double x, double y) const;

  const FrameProjection& Projection;
  Edge Edges[3];
  glm::dvec3 Normal;
  double Offset;
  double MinimumDepth;
  double MaximumDepth;
  FrameProjection::Range Columns{ 0, -1 };
  FrameProjection::Range Rows{ 0, -1 };
};

inline double FaceRaster::FindDepth(double x, double y) const
{
  return this->Projection.IsParallel()
    ? (this->Offset - this->Normal[0] * x - this->Normal[1] * y) / this->Normal[2]
    : this->Offset / (this->Normal[0] * x + this->Normal[1] * y + this->Normal[2]);
}

template <typename Visit>
void FaceRaster::VisitRow(int row, const Visit& visit) const
{
  const double y = this->Projection.GetY(row);
  const double starts[3] = { this->Edges[0].Y * y + this->Edges[0].One,
    this->Edges[1].Y * y + this->Edges[1].One, this->Edges[2].Y * y + this->Edges[2].One };
  for (int column = this->Columns.First; column <= this->Columns.Last; ++column)
  {
    const double x = this->Projection.GetX(column);
    int positive = 0;
    for (int e = 0; e < 3; ++e)
    {
      const double side = this->Edges[e].X * x + starts[e];
      positive += side > 0.0 ? 1 : 0;
    }
    if (positive == 0 || positive == 3)
    {
      const double depth = this->FindDepth(x, y);
      // If the triangle crosses the camera plane, skip pixels at which it is behind the camera. The
      // computed depth is inaccurate if the triangle is nearly edge-on, so clamp it to the depths
      // of the corners.
      if (this->MinimumDepth > 0.0 || this->Projection.IsParallel() || depth > 0.0)
      {
        const double bounded = depth < this->MinimumDepth ? this->MinimumDepth
          : depth > this->MaximumDepth                    ? this->MaximumDepth
                                                          : depth;
        visit(column, bounded, positive == 3);
      }
    }
  }
}

}

#endif
