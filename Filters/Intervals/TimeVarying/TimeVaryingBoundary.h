// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingBoundary_h
#define interlume_TimeVaryingBoundary_h

#include "TimeVarying/TimeVaryingMesh.h"
#include "TimeVarying/SpaceTimeSlots.h"

#include "vtkTimeVaryingSettings.h"

#include <utility>

namespace interlume
{

/**
 * @class   TimeVaryingBoundary
 * @brief   finds the boundary facets of a 4-simplex from the SpaceTimeSlots::Sides of its points
 *
 * SpaceTimeTable lifts a cell by one dimension, as in vtkIntervalVolume. The lifted cell is convex,
 * so it lies on one side of each of its facets. Therefore a tetrahedron whose points are all lower
 * crossings, or all at the first step, is on the boundary and belongs to one 4-simplex. The
 * boundary triangles are faces of the tetrahedra at the first or last step.
 */
class TimeVaryingBoundary
{
public:
  using Slot = SpaceTimeSlots::Slot;
  using Simplex = SpaceTimeSlots::Simplex;
  using Kinds = vtkTimeVaryingSettings::BoundaryKinds;

  /**
   * Calls visit(kind, slots, number) for each boundary cell of a kind that \a mesh requires, and
   * for tetrahedra at both steps if TimeVaryingMesh::HasStepVolumes(). The slots of the 4-simplex
   * must be distinct points. If the 4-simplex is positively oriented, tetrahedra at a step and
   * triangles are oriented as in vtkIntervalVolume, and tetrahedra in time are oriented outward.
   */
  template <typename Visitor>
  static void ForEach(const SpaceTimeSlots& slots, const Simplex& points,
    const TimeVaryingMesh& mesh, Visitor&& visit)
  {
    const unsigned lower = slots.GetPointsOn(SpaceTimeSlots::LOWER, points);
    const unsigned upper = slots.GetPointsOn(SpaceTimeSlots::UPPER, points);
    const unsigned start = slots.GetPointsOn(SpaceTimeSlots::START, points);
    const unsigned end = slots.GetPointsOn(SpaceTimeSlots::END, points);
    const auto emit = [&](int kind, const int* face, int number)
    {
      Slot ids[4];
      for (int k = 0; k < number; ++k)
      {
        ids[k] = points[face[k]];
      }
      if (mesh.IsRequired(kind) || (mesh.HasStepVolumes() && TimeVaryingMesh::IsVolume(kind)))
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
      // The face without point i is oriented outward for even i. Tetrahedra at the end are reversed
      // so that their volume in space is positive.
      if (isAtEnd ? i % 2 == 0 : i % 2 == 1)
      {
        std::swap(face[0], face[1]);
      }
      if (HasAll(lower, face, 4))
      {
        emit(Kinds::LOWER_SURFACE_IN_TIME, face, 4);
      }
      if (HasAll(upper, face, 4))
      {
        emit(Kinds::UPPER_SURFACE_IN_TIME, face, 4);
      }
      if (isAtEnd || HasAll(start, face, 4))
      {
        emit(isAtEnd ? Kinds::VOLUME_AT_END : Kinds::VOLUME_AT_START, face, 4);
        EmitTriangles(
          lower, face, isAtEnd ? Kinds::LOWER_SURFACE_AT_END : Kinds::LOWER_SURFACE_AT_START, emit);
        EmitTriangles(
          upper, face, isAtEnd ? Kinds::UPPER_SURFACE_AT_END : Kinds::UPPER_SURFACE_AT_START, emit);
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

  // Emits those faces of a tetrahedron that lie on the given side, oriented outward.
  template <typename Emit>
  static void EmitTriangles(unsigned side, const int* face, int kind, Emit&& emit)
  {
    constexpr int outward[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
    for (const auto& corners : outward)
    {
      const int triangle[3] = { face[corners[0]], face[corners[1]], face[corners[2]] };
      if (HasAll(side, triangle, 3))
      {
        emit(kind, triangle, 3);
      }
    }
  }
};

}

#endif
