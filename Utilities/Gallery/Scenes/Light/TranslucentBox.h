// SPDX-License-Identifier: BSD-3-Clause
#ifndef TranslucentBox_h
#define TranslucentBox_h

#include "Gallery/Scenes/Light/ShadowScene.h"

#include "vtkVector.h"

class vtkActor;

namespace gallery
{
class Stage;

/**
 * Light in a translucent box that is surrounded by thin air.
 */
struct TranslucentBox
{
  vtkVector3d Lengths;
  /// Around the vertical.
  double Degrees;
  /// Extinctions per unit of length.
  double Extinction;
  double AirExtinction;
};

/// The edges of a box around the origin, turned around the vertical.
vtkSmartPointer<vtkActor> MakeBoxFrame(const vtkVector3d& lengths, double degrees);

/**
 * Adds two panels of \a box around the origin: without attenuation of \a beams, and with it.
 * The air is 3 units long, 2 units high and wide.
 */
ShadowPair AddTranslucentBox(Stage& stage, const TranslucentBox& box, const Lights& beams);
}

#endif
