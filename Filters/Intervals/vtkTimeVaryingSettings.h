// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeVaryingSettings_h
#define vtkTimeVaryingSettings_h

#include <array>  // for the flags
#include <limits> // for the last step

/**
 * @class   vtkTimeVaryingSettings
 * @brief   what vtkTimeVaryingIntervalVolume can be told besides intervals, with its defaults
 *
 * The filter is made of them, so that VTK's macros for setters serve them, and hands them on as a
 * whole. Each is documented at its setter there.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
struct vtkTimeVaryingSettings
{
  /// What a cell of port 1 is a part of: f equals the lower or upper bound at the start or the end
  /// (triangles) or at any time (tetrahedra); f is in the interval at the start or the end
  /// (tetrahedra).
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

  /// How the five projected points of a 4-simplex lie (figures 3.12 and 3.15 of the source), and in
  /// how many tetrahedra: no point inside the hull (6), one inside (4), four in a plane, the thick
  /// point within (4), or one of them inside the triangle of the others (3), three in a line (2),
  /// two in one place (1).
  enum SimplexClasses
  {
    CLASS_1 = 10,
    CLASS_2 = 20,
    CLASS_3A = 31,
    CLASS_3B = 32,
    CLASS_4 = 40,
    CLASS_5 = 50
  };

  /// What a cell of port 2 is of the interval volume at a time step: its faces there, nothing, or
  /// all that it is, a tetrahedron there whose last point it has twice.
  enum PartsAtStep
  {
    FACES_AT_STEP = 0,
    NOTHING_AT_STEP = 1,
    TETRAHEDRON_AT_STEP = 2
  };

  int TimeStepRange[2] = { 0, std::numeric_limits<int>::max() };
  double ProjectionDirection[4] = { 0.0, 0.0, 0.0, 1.0 };
  bool GenerateTetrahedra = true;
  bool GenerateSimplices = false;
  std::array<bool, NUMBER_OF_BOUNDARY_KINDS> GenerateBoundary{};
};

#endif
