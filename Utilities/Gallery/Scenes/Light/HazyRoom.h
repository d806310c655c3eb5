// SPDX-License-Identifier: BSD-3-Clause
#ifndef HazyRoom_h
#define HazyRoom_h

#include "Gallery/Scenes/Light/ShadowScene.h"

namespace gallery
{
class Panel;
class Stage;

/**
 * Adds a panel of \a room, a `Color` of Sample(), on a dark background. Thin smoke of \a opacity in
 * a voxel fills it within \a inside, so that light can be seen on its way.
 */
Panel& AddHazyPanel(Stage& stage, vtkImageData* room, const vtkBoundingBox& inside, double opacity,
  const Lights& lights);

/**
 * The same of MakeRoom() with a robot and rings.
 */
Panel& AddHazyRoom(Stage& stage, const Lights& lights);
}

#endif
