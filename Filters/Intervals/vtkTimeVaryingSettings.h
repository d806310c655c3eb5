// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeVaryingSettings_h
#define vtkTimeVaryingSettings_h

#include <array>  // for the flags
#include <limits> // for the last step

/**
 * @class   vtkTimeVaryingSettings
 * @brief   settings of vtkTimeVaryingIntervalVolume, without the intervals
 *
 * The filter derives from this struct so that VTK's setter macros apply to its members and all
 * settings can be passed to an execution together. Each setting is documented at its setter in the
 * filter.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
struct vtkTimeVaryingSettings
{
  /// Kind of boundary to which a cell of port 1 belongs. On the surfaces, the scalar equals the
  /// lower or upper bound: either at the first or last time step (triangles), or at any time
  /// (tetrahedra). In the volumes (tetrahedra), the scalar is in the interval at the first or last
  /// time step.
  enum BoundaryKinds
  {
    LOWER_SURFACE_AT_START = 0,
    UPPER_SURFACE_AT_START = 1,
    LOWER_SURFACE_AT_END = 2,
    UPPER_SURFACE_AT_END = 3,
    LOWER_SURFACE_IN_TIME = 4,
    UPPER_SURFACE_IN_TIME = 5,
    VOLUME_AT_START = 6,
    VOLUME_AT_END = 7,
    NUMBER_OF_BOUNDARY_KINDS = 8
  };

  /// Configuration of the five projected points of a 4-simplex, as in C. Zhang, dissertation, Ohio
  /// State 2006, figures 3.12 and 3.15. The classes, with their numbers of tetrahedra in
  /// parentheses, are: five points in convex position (6), one point inside the hull of the other
  /// four (4), four coplanar points in convex position (4), four coplanar points of which one is
  /// inside the triangle of the other three (3), three collinear points (2), two coincident points
  /// (1).
  enum SimplexClasses
  {
    CLASS_1 = 10,
    CLASS_2 = 20,
    CLASS_3A = 31,
    CLASS_3B = 32,
    CLASS_4 = 40,
    CLASS_5 = 50
  };

  /// What a cell of port 2 contributes to the interval volume at a time step: its faces that lie in
  /// the time step, nothing, or the entire cell, which is then a tetrahedron stored with its last
  /// point repeated.
  enum PartsAtStep
  {
    FACES_AT_STEP = 0,
    NOTHING_AT_STEP = 1,
    TETRAHEDRON_AT_STEP = 2
  };

  int TimeStepRange[2] = { 0, std::numeric_limits<int>::max() };
  int TimeStepStride = 1;
  double ProjectionDirection[4] = { 0.0, 0.0, 0.0, 1.0 };
  bool GenerateTetrahedra = true;
  bool GenerateSimplices = false;
  std::array<bool, NUMBER_OF_BOUNDARY_KINDS> GenerateBoundary{};
};

#endif
