// SPDX-License-Identifier: BSD-3-Clause
#ifndef Models_h
#define Models_h

#include "Support/Inputs/Shapes.h"

#include <vector>

/**
 * Polygonal models of everyday objects. Every part is a closed surface with outward normals. Models
 * stand on z = 0 unless stated otherwise.
 */
namespace interlume
{

/// A part of a model, with a single color.
struct ModelPart
{
  vtkSmartPointer<vtkPolyData> Shape;
  std::array<double, 3> Color{};
  /// Specular coefficient, 0 to 1.
  double Gloss = 0.1;
};

using Model = std::vector<ModelPart>;

/// Returns a mushroom of the given height and cap radius. The top of the stem is shifted along x by
/// \a lean times the height.
Model MakeMushroom(double height, double capRadius, double lean = 0.0);

/// Returns a teapot with the spout toward +x. It is 1.6 long and 0.95 high.
Model MakeTeapot();

/// Returns a dart of length 1 along x. The tip is at the origin, the shaft at negative x.
Model MakeDart();

/// Returns an airliner of length 1 along x, with the nose at x = 1 and z up. The wings extend from
/// y = -0.5 to 0.5.
Model MakeAirplane();

/// Returns a desk of size 1.2 x 0.6 x 0.72. The drawers are on the right, as seen from -y.
Model MakeDesk();

/// Returns a chair, 0.46 wide and 0.9 high, that faces +y.
Model MakeChair();

/// Returns a lamp of height 0.48. The shade is above (0.2, 0, 0.32) and open below.
Model MakeLamp();

/// Return a stack of three books, and a mug.
Model MakeBooks();
Model MakeMug();

/// Applies MoveShape() to all parts.
Model Move(
  const Model& model, const Position3& offset, const Position3& degrees = { { 0.0, 0.0, 0.0 } });
Model& Append(Model& model, const Model& more);

}

#endif
