// SPDX-License-Identifier: BSD-3-Clause
#ifndef Shapes_h
#define Shapes_h

#include "vtkPolyData.h" // complete type, for copies of shapes
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

/**
 * Closed surfaces with outward normals, used as parts of models.
 */
namespace interlume
{

using Position3 = std::array<double, 3>;

/// A point of a profile: distance from the axis and height.
using ProfilePoint = std::array<double, 2>;

/**
 * Revolves a profile around the z-axis. The surface is closed if the profile is closed or starts
 * and ends on the axis.
 * @param smooth If true, the profile is a cardinal spline through its points, otherwise a polyline.
 * @param sharp  Angle in degrees above which an edge stays sharp.
 */
vtkSmartPointer<vtkPolyData> Revolve(
  const std::vector<ProfilePoint>& profile, bool smooth, double sharp = 35.0);

/**
 * Returns a capped tube along a spline through \a points, with a radius for each point.
 */
vtkSmartPointer<vtkPolyData> MakeTube(
  const std::vector<Position3>& points, const std::vector<double>& radii);

/**
 * Returns a box around the origin with rounded edges and corners.
 */
vtkSmartPointer<vtkPolyData> MakeRoundedBox(const Position3& lengths, double radius);

/**
 * Returns a plate centered at z = 0. The outline is a counterclockwise polygon in the x-y plane.
 */
vtkSmartPointer<vtkPolyData> MakePlate(
  const std::vector<std::array<double, 2>>& outline, double thickness);

/**
 * Returns a copy that is rotated about x, then y, then z by \a degrees, and then translated.
 */
vtkSmartPointer<vtkPolyData> MoveShape(
  vtkPolyData* shape, const Position3& offset, const Position3& degrees = { { 0.0, 0.0, 0.0 } });

/**
 * Combines all shapes into one surface.
 */
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& shapes);

}

#endif
