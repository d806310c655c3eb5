// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingBoundary_h
#define interlume_TimeVaryingBoundary_h

#include "TimeVarying/TimeVaryingMesh.h"
#include "TimeVarying/TimeVaryingSlots.h"

#include "vtkTimeVaryingSettings.h"

#include <utility>

namespace interlume
{

/**
 * @class   TimeVaryingBoundary
 * @brief   the faces of a 4-simplex that lie on a boundary, from the sides of its points
 *
 * A cell of the table lies on one side of each of its facets, so that a tetrahedron whose points
 * are all lower crossings, or all at the first step, is on the boundary and belongs to one
 * 4-simplex. Triangles are those of the tetrahedra at the first or last step.
 */
class TimeVaryingBoundary
{
public:
  using Slot = TimeVaryingSlots::Slot;
  using Simplex = TimeVaryingSlots::Simplex;
  using Kinds = vtkTimeVaryingSettings::BoundaryKinds;

  /**
   * Calls visit(kind, slots, number) for each boundary cell that \a mesh wants, of a 4-simplex that
   * has no two slots that are one point. For a positively oriented 4-simplex, tetrahedra at a step
   * and triangles come out oriented as those of vtkIntervalVolume, tetrahedra in time outward.
   */
  template <typename Visitor>
  static void ForEach(const TimeVaryingSlots& slots, const Simplex& points,
    const TimeVaryingMesh& mesh, Visitor&& visit)
  {
    const unsigned lower = slots.GetPointsOn(TimeVaryingSlots::LOWER, points);
    const unsigned upper = slots.GetPointsOn(TimeVaryingSlots::UPPER, points);
    const unsigned start = slots.GetPointsOn(TimeVaryingSlots::START, points);
    const unsigned end = slots.GetPointsOn(TimeVaryingSlots::END, points);
    const auto give = [&](int kind, const int* face, int number)
    {
      Slot ids[4];
      for (int k = 0; k < number; ++k)
      {
        ids[k] = points[face[k]];
      }
      if (mesh.IsWanted(kind))
      {
        visit(kind, ids, number);
      }
    };
    for (int i = 0; i < 5; ++i)
    {
      int face[4];
      for (int k = 0, n = 0; k < 5; ++k)
      {
        if (k != i)
        {
          face[n++] = k;
        }
      }
      const bool isAtEnd = HasAll(end, face, 4);
      // The face without point i is outward in even places; a simplex lasts until one at the end.
      if (isAtEnd ? i % 2 == 0 : i % 2 == 1)
      {
        std::swap(face[0], face[1]);
      }
      if (HasAll(lower, face, 4))
      {
        give(Kinds::LOWER_SURFACE_IN_TIME, face, 4);
      }
      if (HasAll(upper, face, 4))
      {
        give(Kinds::UPPER_SURFACE_IN_TIME, face, 4);
      }
      if (isAtEnd || HasAll(start, face, 4))
      {
        give(isAtEnd ? Kinds::VOLUME_AT_END : Kinds::VOLUME_AT_START, face, 4);
        GiveTriangles(
          lower, face, isAtEnd ? Kinds::LOWER_SURFACE_AT_END : Kinds::LOWER_SURFACE_AT_START, give);
        GiveTriangles(
          upper, face, isAtEnd ? Kinds::UPPER_SURFACE_AT_END : Kinds::UPPER_SURFACE_AT_START, give);
      }
    }
  }

private:
  static bool HasAll(unsigned side, const int* face, int number)
  {
    bool all = true;
    for (int k = 0; k < number; ++k)
    {
      all = all && ((side >> face[k]) & 1);
    }
    return all;
  }

  // Gives the triangles of a tetrahedron on one side, outward.
  template <typename Give>
  static void GiveTriangles(unsigned side, const int* face, int kind, Give&& give)
  {
    constexpr int outward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    for (const auto& corners : outward)
    {
      const int triangle[3] = { face[corners[0]], face[corners[1]], face[corners[2]] };
      if (HasAll(side, triangle, 3))
      {
        give(kind, triangle, 3);
      }
    }
  }
};

}

#endif
