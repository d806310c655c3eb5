// SPDX-License-Identifier: BSD-3-Clause
#ifndef HazyRoom_h
#define HazyRoom_h

#include "Gallery/Scenes/Light/ShadowScene.h"

namespace gallery
{
class Panel;
class Stage;

/**
 * Adds a panel of \a room, an image created by Sample(), on a dark background. Thin smoke within
 * \a inside makes light beams visible. \a opacity is the opacity of the smoke per voxel.
 */
Panel& AddHazyPanel(Stage& stage, vtkImageData* room, const vtkBoundingBox& inside, double opacity,
  const Lights& lights);

/**
 * As above, but the room is MakeRoom() with a robot and rings.
 */
Panel& AddHazyRoom(Stage& stage, double opacity, const Lights& lights);
}

#endif
