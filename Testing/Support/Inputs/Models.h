// SPDX-License-Identifier: BSD-3-Clause
#ifndef Models_h
#define Models_h

#include "Support/Inputs/Shapes.h"

#include <vector>

/**
 * Things of everyday as polygons, by formulas and a few numbers of their own: every part is closed,
 * with normals outwards, and stands on z = 0 where nothing else is said.
 */
namespace interlume
{

/// A part of one colour.
struct ModelPart
{
  vtkSmartPointer<vtkPolyData> Shape;
  std::array<double, 3> Color{};
  /// Strength of its highlight, 0 to 1.
  double Gloss = 0.1;
};

using Model = std::vector<ModelPart>;

/// A mushroom, as high as it is said, whose cap has that radius; its stem leans by \a lean of its
/// height along x.
Model MakeMushroom(double height, double capRadius, double lean = 0.0);

/// A teapot of 1.6 from the handle to the spout, which points along x, and 0.95 high.
Model MakeTeapot();

/// A dart of length 1 whose tip is at the origin, and which comes from -x.
Model MakeDart();

/// An airliner of length 1 along x, its nose at 1, with wings from y = -0.5 to 0.5, up is z.
Model MakeAirplane();

/// A desk of 1.2 x 0.6 and 0.72 high, with drawers on its right, seen from -y.
Model MakeDesk();

/// A chair 0.46 wide and 0.9 high that is sat on towards +y.
Model MakeChair();

/// A lamp 0.48 high, whose shade is open below, over (0.2, 0, 0.32).
Model MakeLamp();

/// Three books upon each other and a mug beside them.
Model MakeBooks();
Model MakeMug();

/// All parts moved by MoveShape().
Model Move(const Model& model, const Place3& offset, const Place3& degrees = { { 0.0, 0.0, 0.0 } });
Model& Append(Model& model, const Model& more);

}

#endif
