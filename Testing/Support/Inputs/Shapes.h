// SPDX-License-Identifier: BSD-3-Clause
#ifndef Shapes_h
#define Shapes_h

#include "vtkPolyData.h" // whole, so that shapes can be copied
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

/**
 * Closed surfaces with normals outwards, of which models are made.
 */
namespace interlume
{

using Place3 = std::array<double, 3>;

/// A point of a profile: distance from the axis, height along it.
using ProfilePoint = std::array<double, 2>;

/**
 * Turns a profile around the z axis. A profile that begins and ends on the axis, or is closed,
 * makes a closed surface.
 * @param smooth whether the profile is a cardinal spline through its points instead of a polygon
 * @param sharp  angle in degrees above which an edge stays sharp
 */
vtkSmartPointer<vtkPolyData> Revolve(
  const std::vector<ProfilePoint>& profile, bool smooth, double sharp = 35.0);

/**
 * A tube with closed ends along a spline through \a places, with as many radii.
 */
vtkSmartPointer<vtkPolyData> MakeTube(
  const std::vector<Place3>& places, const std::vector<double>& radii);

/**
 * A box around the origin whose edges and corners are rounded.
 */
vtkSmartPointer<vtkPolyData> MakeRoundedBox(const Place3& lengths, double radius);

/**
 * A plate around z = 0, its outline a polygon of (x, y), counter-clockwise.
 */
vtkSmartPointer<vtkPolyData> MakePlate(
  const std::vector<std::array<double, 2>>& outline, double thickness);

/**
 * A copy that is turned around x, then y, then z by \a degrees, and then moved.
 */
vtkSmartPointer<vtkPolyData> MoveShape(
  vtkPolyData* shape, const Place3& offset, const Place3& degrees = { { 0.0, 0.0, 0.0 } });

/**
 * All in one.
 */
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& shapes);

}

#endif
