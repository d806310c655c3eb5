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
 * @brief   a polyline with an angle around it and a place along it that jump nowhere
 *
 * Each segment has a frame, turned from one to the next by the smallest rotation (the
 * rotation-minimising frame of a polyline). Around a bend the segments meet in the plane that
 * bisects it. The frames of two segments mirror each other there, so that the angle is the same on
 * both sides; the place along a segment is the part of the way from bisecting plane to bisecting
 * plane, which has no jump at the inside of the bend and no halt at its outside, as the arc length
 * of the nearest point has.
 *
 * A closed line has the rotation between the last and the first frame spread over its length.
 */
class TubeAxis
{
public:
  /**
   * Takes a polyline; it is closed when its last point is the first. Points in the same place as
   * the one before are left out. Returns an error if a point is not finite, if there are fewer than
   * two places, and if the line turns back on itself.
   */
  Error Build(const std::vector<glm::dvec3>& points);

  bool IsEmpty() const { return this->Segments.empty(); }
  bool IsClosed() const { return this->Closed; }
  double GetLength() const { return this->Length; }

  /// The nearest point of the line, and by how much \a x is beyond an end there: negative beyond
  /// the first, positive beyond the last, else 0.
  struct Foot
  {
    glm::dvec3 Nearest;
    double Beyond;
  };
  Foot GetFoot(const glm::dvec3& x) const;

  /// Computes u in turns, 0 to below 1, and v by length, 0 to 1 (to below 1 on a closed line).
  void GetParameters(const glm::dvec3& x, double uv[2]) const;

  /// Returns the point with these parameters, at a distance from the line.
  glm::dvec3 GetPoint(const double uv[2], double radius) const;

  /// Return the frames at the two ends, and the ends.
  const AxialFrame& GetEndFrame(bool isLast) const;
  const glm::dvec3& GetEnd(bool isLast) const
  {
    return isLast ? this->LastPoint : this->FirstPoint;
  }

  /// Computes the lower and upper bounds of x, y, z.
  void GetBounds(double bounds[6]) const;

private:
  struct Segment
  {
    glm::dvec3 Start;
    double Length;
    /// The distance of the segment's start along the line.
    double Distance;
    AxialFrame Frame;
    /// The bisecting planes at start and end lie at - w . Tilt and Length - w . Tilt along the
    /// segment, w across it.
    glm::dvec3 StartTilt;
    glm::dvec3 EndTilt;
  };

  /// Finds the nearest segment, and the nearest point's place along it.
  int FindNearest(const glm::dvec3& x, double& along) const;
  /// Computes where a point is between the bisecting planes, as distances along the segment from
  /// both.
  static void GetPlanes(const Segment& segment, const glm::dvec3& x, glm::dvec3& components,
    double& start, double& end);
  int GetNeighbor(int segment, int step) const;

  std::vector<Segment> Segments;
  /// The boxes of segments, multiplied by Scale.
  BoxTree Tree;
  /// The power of 2 by which the line's size is about 1, so that squares are numbers.
  double Scale = 1.0;
  bool Closed = false;
  double Length = 0.0;
  glm::dvec3 FirstPoint{ 0.0, 0.0, 0.0 };
  glm::dvec3 LastPoint{ 0.0, 0.0, 0.0 };
  /// The turns by which a closed line's frame is off after one round.
  double Twist = 0.0;
};

}

#endif
