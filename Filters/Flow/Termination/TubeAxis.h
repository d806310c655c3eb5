// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TubeAxis_h
#define interlume_TubeAxis_h

#include "Common/Error.h"
#include "Termination/AxialFrame.h"
#include "Termination/BoxTree.h"

#include <vector>

namespace interlume
{

/**
 * @class   TubeAxis
 * @brief   polyline with continuous coordinates around it and along it
 *
 * Each segment has a frame. Frames are transported from segment to segment by the smallest rotation
 * (the rotation-minimizing frame of a polyline). At a bend, two segments meet in its bisecting
 * plane. Their frames are mirror images in that plane, so the angle is continuous. The coordinate
 * along a segment is the fraction of the distance between its two bisecting planes. Unlike the arc
 * length of the nearest point, it has no jump on the inside of a bend and no constant section on
 * the outside.
 *
 * For a closed line, the rotation between the last and the first frame is distributed over its
 * length.
 */
class TubeAxis
{
public:
  /**
   * Builds the axis from a polyline, which is closed if its first and last points coincide. A point
   * that coincides with the previous one is skipped. Returns an error if a point is not finite, if
   * there are fewer than two distinct points, or if the line turns back on itself.
   */
  Error Build(const std::vector<glm::dvec3>& points);

  bool IsEmpty() const { return this->Segments.empty(); }
  bool IsClosed() const { return this->Closed; }
  double GetLength() const { return this->Length; }

  /// Nearest point of the line, and the distance past an end: negative before the first point,
  /// positive after the last point, otherwise 0.
  struct Foot
  {
    glm::dvec3 Nearest;
    double DistancePastEnd;
  };
  Foot GetFoot(const glm::dvec3& x) const;

  /// Computes u, an angle in turns in [0,1), and v, the fraction of the length in [0,1], or [0,1)
  /// if the line is closed.
  void GetParameters(const glm::dvec3& x, double uv[2]) const;

  /// Returns the point with the parameters \a uv at distance \a radius from the line.
  glm::dvec3 GetPoint(const double uv[2], double radius) const;

  /// Return the frame at an end, and the end point.
  const AxialFrame& GetEndFrame(bool isLast) const;
  const glm::dvec3& GetEnd(bool isLast) const
  {
    return isLast ? this->LastPoint : this->FirstPoint;
  }

  /// Computes the bounds as xmin, xmax, ymin, ymax, zmin, zmax.
  void GetBounds(double bounds[6]) const;

private:
  struct Segment
  {
    glm::dvec3 Start;
    double Length;
    /// Arc length of the line up to the start of the segment.
    double Distance;
    AxialFrame Frame;
    /// The bisecting planes are at -w . StartTilt and Length - w . EndTilt along the segment, where
    /// w is the perpendicular offset from the segment.
    glm::dvec3 StartTilt;
    glm::dvec3 EndTilt;
  };

  /// Returns the index of the segment nearest to \a x. \a along is the position of \a x projected
  /// onto the segment's line. It may be outside the segment.
  int FindNearest(const glm::dvec3& x, double& along) const;
  /// Computes the components of \a x in the segment's frame, and the distances of \a x from the two
  /// bisecting planes, measured along the segment.
  static void GetPlanes(const Segment& segment, const glm::dvec3& x, glm::dvec3& components,
    double& start, double& end);
  int GetNeighbor(int segment, int step) const;

  std::vector<Segment> Segments;
  /// Bounding boxes of the segments, multiplied by Scale.
  BoxTree Tree;
  /// Power of 2 that scales the line to a size of about 1, so that squares do not overflow.
  double Scale = 1.0;
  bool Closed = false;
  double Length = 0.0;
  glm::dvec3 FirstPoint{ 0.0, 0.0, 0.0 };
  glm::dvec3 LastPoint{ 0.0, 0.0, 0.0 };
  /// Rotation between the first and the last frame of a closed line, in turns.
  double Twist = 0.0;
};

}

#endif
